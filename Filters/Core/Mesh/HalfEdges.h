// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file HalfEdges.h
 * @brief The half-edges of a triangle mesh, by number: three a triangle, no object each.
 */
#ifndef recon_HalfEdges_h
#define recon_HalfEdges_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * Half-edge 3t+i runs from corner i of triangle t to the next one.
 *
 * Holds a reference to the mesh, which must outlive it.
 */
class HalfEdges
{
public:
  /// @throws Error where a triangle uses a point twice or two half-edges join the same points in
  /// the same direction: an edge of more than two triangles, or neighbours oriented against each
  /// other.
  explicit HalfEdges(const TriangleMesh& mesh);

  int Count() const { return static_cast<int>(this->Opposites.size()); }
  int From(int h) const { return this->Mesh.Triangles[h / 3][h % 3]; }
  int To(int h) const { return this->From(Next(h)); }
  static int Next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  /// The same edge the other way round, or -1 at a border.
  int Opposite(int h) const { return this->Opposites[h]; }
  /// The opposite, or the next half-edge along the border.
  int Partner(int h) const;
  /// Half-edges that start at a point, in no order that matters.
  const int* BeginFrom(int point) const { return this->Outgoing.data() + this->First[point]; }
  const int* EndFrom(int point) const { return this->Outgoing.data() + this->First[point + 1]; }
  /// The connected component of each triangle; components are numbered by first triangle.
  std::vector<int> Components() const;

private:
  const TriangleMesh& Mesh;
  std::vector<int> Opposites;
  std::vector<int> Outgoing; ///< half-edges sorted by the point that they start from
  std::vector<int> First;    ///< a point: where its half-edges begin in Outgoing
};
}

#endif
