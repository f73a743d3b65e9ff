// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlanarRings.h
 * @brief The rings of one level as loops of its plane.
 */
#ifndef recon_PlanarRings_h
#define recon_PlanarRings_h

#include "ContourChaining.h"
#include "ContourNotes.h"
#include "ContourPlanes.h"

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

/**
 * Projects a level; loops that are nothing any more, and all but the first of equal ones, are named
 * in notes.
 */
PlanarRings FlattenLevel(const LoopSoup& soup, const std::vector<Ring>& rings,
  const PlaneOfRings& plane, ContourNotes& notes);
}

#endif
