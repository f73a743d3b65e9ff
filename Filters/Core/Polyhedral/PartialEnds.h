// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PartialEnds.h
 * @brief Parts of a region that end between two levels although the region goes on.
 *
 * A lobe of a contour that has nothing above it (a knuckle, the trochanter beside a femur's head)
 * is joined to the rest of the contour above by one flat cone, as the nearest vertices above are
 * all at one place. Where the neighbour is given points over the lobe, outside its contours, no
 * tetrahedron bridges the lobe any more: it ends by itself and can be rounded off like any other
 * end.
 *
 * The points are those of the level's own internal Voronoi skeleton that lie outside the
 * neighbour's contours and where an end reaches higher than the cone. They go into both levels:
 * into their own to be lifted, into the neighbour as external points.
 */
#ifndef recon_PartialEnds_h
#define recon_PartialEnds_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/LevelState.h"

#include <array>
#include <vector>

namespace recon
{
/// A level with its internal skeleton beside its neighbour, and the triangles that hold the points
/// of the skeleton: of its own level, and of the others or -1.
struct SkeletonSide
{
  const LevelState* Level;
  const LevelState* Behind; ///< the level on the other side, or null
  const std::vector<int>* Triangles;
  const std::vector<int>* OtherTriangles;
  const std::vector<int>* BehindTriangles; ///< empty where there is no such level
};

/// Points of the lower and of the upper level.
using EndsOfSlab = std::array<std::vector<Point2>, 2>;

/**
 * Of the lower and of the upper level the points of its skeleton at which a part of it ends in the
 * slab.
 *
 * A part that has nothing on either side stays tied to the nearer one, as it would come loose at
 * its corners otherwise. And a join that neither skeleton sees (of two regions that overlap at
 * their margins only) would be lost, so regions with such a join keep all their tetrahedra.
 */
EndsOfSlab FindPartialEnds(
  const SlabTetrahedra& slab, const SkeletonSide& lower, const SkeletonSide& upper);

/// To a level the points of the slabs below and above it, null where there is none. @returns whether there were any
bool AddPartialEnds(LevelTriangulator& level, const EndsOfSlab* below, const EndsOfSlab* above);
}

#endif
