// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VertexStars.h
 * @brief The triangles around every vertex of a level, in counterclockwise order.
 */
#ifndef recon_VertexStars_h
#define recon_VertexStars_h

#include "Polyhedral/LevelTriangulation.h"

#include <vector>

namespace recon
{
/// Seen from the Voronoi diagram: the corners of every Voronoi cell, counterclockwise.
class VertexStars
{
public:
  explicit VertexStars(const LevelTriangulation& level);

  /// Triangles around v; around a vertex of the hull from the first to the last.
  int Size(int v) const { return this->First[v + 1] - this->First[v]; }
  int Triangle(int v, int i) const { return this->Triangles[this->First[v] + i]; }
  bool OnHull(int v) const { return this->Hull[v] != 0; }

  /// Of triangle i around v = (v, p, q): p, the neighbour before it, and q, the one after it.
  int Before(int v, int i) const { return this->Rim[this->First[v] + i]; }
  int After(int v, int i) const
  {
    return i + 1 < this->Size(v) ? this->Before(v, i + 1) : this->LastOfRim[v];
  }

private:
  std::vector<int> First;
  std::vector<int> Triangles;
  std::vector<int> Rim;       ///< of every triangle around a vertex the neighbour before it
  std::vector<int> LastOfRim; ///< of every vertex the neighbour after its last triangle
  std::vector<unsigned char> Hull;
};

/// Which corner of the triangle v is.
inline int CornerOf(const std::array<int, 3>& triangle, int v)
{
  return triangle[0] == v ? 0 : (triangle[1] == v ? 1 : 2);
}

/// An edge as 3 * triangle + opposite corner; the lesser of the two numbers that it has.
int CanonicalEdge(const LevelTriangulation& level, int triangle, int corner);
}

#endif
