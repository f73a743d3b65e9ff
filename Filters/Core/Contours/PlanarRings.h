// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlanarRings.h
 * @brief The rings of one level as loops of its plane.
 */
#ifndef recon_PlanarRings_h
#define recon_PlanarRings_h

#include "Contours/ContourChaining.h"
#include "Contours/ContourNotes.h"
#include "Contours/ContourPlanes.h"

#include <vector>

namespace recon
{
/// Points of equal planar coordinates are one point; neighbours differ.
struct PlanarRings
{
  std::vector<Point2> Points;
  std::vector<int> InputPoint; ///< a point: the first input point at these coordinates
  std::vector<std::vector<int>> Loops;
  std::vector<int> Rings; ///< a loop: the ring it is
};

/// The nearest multiple of grid, or p itself where grid is 0.
Point2 SnapToGrid(const Point2& p, double grid);

/**
 * The grid of a frame's in-plane coordinates, for points of coordinates up to `largest`.
 *
 * A tilted frame rounds: points that lie above one another no longer do, and edges that are
 * parallel turn a little, so that tetrahedra come about which are as flat as the rounding and turn
 * over on the way back to space. A grid that is coarse beside rounding and fine beside anything
 * drawn (1e-12 of the coordinates) makes such points equal again, and what is not flat thick
 * enough.
 *
 * @returns 0 for frames of coordinate axes, which round nothing.
 */
double PlanarGridOf(const PlanarFrame& frame, double largest);

/**
 * Projects a level on its grid; loops that are nothing any more, and all but the first of equal
 * ones, are named in notes.
 */
PlanarRings FlattenLevel(const LoopSoup& soup, const std::vector<Ring>& rings,
  const PlaneOfRings& plane, double grid, ContourNotes& notes);
}

#endif
