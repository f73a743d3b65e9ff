// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EdgeTable.h
 * @brief The sides of a mesh's triangles, those that join the same two points together; of any
 * mesh, also where more than two do. HalfEdges.h is for those that are manifold.
 */
#ifndef recon_EdgeTable_h
#define recon_EdgeTable_h

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace recon
{
/// Two corners are the same point; such triangles have no sides here.
inline bool IsCollapsed(const std::array<int, 3>& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// A side of a triangle, filed under the smaller of its two points.
struct EdgeSide
{
  int High;   ///< the larger point
  int Corner; ///< 3 * triangle + k: the side from corner k to the next
};

/**
 * All sides of triangles that are not collapsed, sorted by (smaller point, larger point, corner).
 *
 * A counting sort by the smaller point leaves buckets of some six sides, which a million triangles
 * sort several times faster than in one go.
 */
struct EdgeTable
{
  std::vector<int> First; ///< a point: its bucket begins here; one entry more than points
  std::vector<EdgeSide> Sides;
};

EdgeTable SortEdges(const TriangleMesh& mesh);

/// All sides that join the same two points.
struct EdgeGroup
{
  int Low;
  int High;
  const EdgeSide* Begin;
  const EdgeSide* End;

  int Count() const { return static_cast<int>(this->End - this->Begin); }
};

/// visit(EdgeGroup) of every edge, by the smaller and then by the larger point.
template <typename Visitor>
void ForEachEdge(const EdgeTable& table, const Visitor& visit)
{
  const int points = static_cast<int>(table.First.size()) - 1;
  for (int low = 0; low < points; ++low)
  {
    const EdgeSide* const end = table.Sides.data() + table.First[low + 1];
    for (const EdgeSide* side = table.Sides.data() + table.First[low]; side != end;)
    {
      const EdgeSide* const begin = side;
      while (side != end && side->High == begin->High)
      {
        ++side;
      }
      visit(EdgeGroup{ low, begin->High, begin, side });
    }
  }
}

/// From the smaller point to the larger.
inline bool RunsUpward(const TriangleMesh& mesh, const EdgeSide& side)
{
  return mesh.Triangles[side.Corner / 3][side.Corner % 3] < side.High;
}

/// Whether its triangles run along it as often each way, or one off where they are odd.
bool IsOriented(const TriangleMesh& mesh, const EdgeGroup& edge);
}

#endif
