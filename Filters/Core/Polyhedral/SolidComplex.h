// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SolidComplex.h
 * @brief All kept tetrahedra of all slabs as one simplicial complex, internal points lifted.
 *
 * One triangulation a level serves the slab below and the slab above, so the slabs fit together and
 * the thesis's last step (11.2.3, homogenising vertices between slabs) is not needed.
 *
 * Lifting (thesis 6.2). An internal point p of a level is moved into the slab towards the level
 * that asked for it, to the fraction t = dA / (dA + dB) of the slab: dA and dB are its distances to
 * the contours of its own level and of the one that asked (shape-based interpolation, there where
 * it is exact). The point in the plane stays: p is split into p and its lifted copy p', and the
 * space between the plane and the lifted triangles is filled with tetrahedra. So the plane still
 * shows the contours as they were, and a point that both neighbours asked for is lifted both ways.
 */
#ifndef recon_SolidComplex_h
#define recon_SolidComplex_h

#include "Polyhedral/LevelState.h"
#include "Polyhedral/SlabState.h"

#include <array>
#include <utility>
#include <vector>

namespace recon
{
/// Slabs of a stack from First up to, without, End, with the levels below, between and above them.
struct SlabRange
{
  int First;
  int End;
};

struct SolidComplex
{
  struct Vertex
  {
    Point2 Planar;
    double Height; ///< along the common normal
    int Level;     ///< whose plane the vertex lies in, or was lifted out of
    int Local; ///< index into that level's LevelTriangulation::Points, or -1: in no triangulation
    bool Lifted;
  };

  enum PartType : unsigned char
  {
    BetweenLevels, ///< a tetrahedron of the joint Voronoi diagram, or one under a lifted internal
                   ///< point
    EndCap,        ///< of a region that ends here
    Isolated       ///< of a region that nothing touches
  };

  struct Cell
  {
    std::array<int, 4> Vertices; ///< positively oriented
    /// Across the face opposite vertex k; -1: not solid there; as in SlabTetrahedra, GapTo(c) where
    /// solid that is not named here lies between this cell and c.
    std::array<int, 4> Neighbours;
    int Slab; ///< -1 and the number of levels less one: beyond the first and the last level
    PartType Part;
  };

  SlabRange Slabs{ 0, 0 };
  std::vector<Vertex> Vertices;
  std::vector<Cell> Cells;
  /// Of every slab of the range its first cell, and where those of the last one end; after them come
  /// cells beyond the first and the last level of the stack, and pyramids.
  std::vector<int> FirstCell;
  std::vector<std::pair<int, int>> Links; ///< cells that solid which is not named holds together
};

/**
 * A triangle that must be covered and has no solid on either side (the acute tip of a contour,
 * where no point can be inserted) carries a low pyramid inside its own T1 or T2 tetrahedron.
 */
SolidComplex BuildSolidComplex(
  const std::vector<LevelState>& levels, const std::vector<SlabState>& slabs);

/**
 * Of a part of the stack, which is solid up to the planes of its first and last level as if there were nothing
 * beyond. Vertices and cells have the order that they have in the complex of the whole.
 */
SolidComplex BuildSolidComplex(const std::vector<LevelState>& levels,
  const std::vector<SlabState>& slabs, const SlabRange& range);
}

#endif
