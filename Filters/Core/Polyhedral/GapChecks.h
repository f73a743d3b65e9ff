// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file GapChecks.h
 * @brief Whether what was left out of a slab (BoundaryVoronoi.h) is solid, and inside the solid.
 */
#ifndef recon_GapChecks_h
#define recon_GapChecks_h

#include "Base/DisjointSets.h"
#include "Polyhedral/JointVoronoi.h"

#include <array>
#include <cstddef>
#include <vector>

namespace recon
{
/// Voronoi edges of both levels, by their Delaunay edges, along which nothing may be left out.
class UnsafeEdges
{
public:
  explicit UnsafeEdges(const JointCells& cells)
  {
    for (const int level : { 0, 1 })
    {
      this->Marks[level].assign(3 * cells.LevelAt(level).Triangles.size(), 0);
    }
  }

  void Mark(int level, int edge)
  {
    this->Marked += this->Marks[level][edge] == 0 ? 1 : 0;
    this->Marks[level][edge] = 1;
  }

  bool IsMarked(int level, int edge) const { return this->Marks[level][edge] != 0; }
  std::size_t Count() const { return this->Marked; }

private:
  std::array<std::vector<unsigned char>, 2> Marks;
  std::size_t Marked = 0;
};

/**
 * Marks the edges of gaps that are not as they should be. Both ends of a gap must be kept; then all
 * of it is, as kept T12 lead from it to a kept base (thesis 6.4). And where more than two faces of
 * the boundary meet in an edge between the levels, those that bound one wedge of solid are found by
 * turning around that edge through tetrahedra, none of which may be missing.
 */
void CheckGaps(const JointCells& cells, const SlabTetrahedra& slab, UnsafeEdges& unsafe);

/// Kept tetrahedra that hang together, across gaps and by Links, too.
DisjointSets PiecesOf(const SlabTetrahedra& slab);
}

#endif
