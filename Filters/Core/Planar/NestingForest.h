// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NestingForest.h
 * @brief Which contour lies in which, and how each has to run (thesis 3.1).
 */
#ifndef recon_NestingForest_h
#define recon_NestingForest_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
/// The forest of a level; numbers are those of the loops.
struct NestingForest
{
  std::vector<int> Parent; ///< -1 for a root
  std::vector<int> Depth;  ///< 0 for a root
};

/// The area that a simple loop encloses, positive where it runs counterclockwise; the sign is
/// exact.
double SignedAreaOf(const std::vector<Point2>& points, const std::vector<int>& loop);

/**
 * One sweep over all loops of a level (EdgeSweep.h).
 *
 * A loop that starts at a point is inside the loop whose edge is next below it, or else shares that
 * loop's parent. Loops may touch in points, also in their leftmost ones.
 *
 * @pre loops are simple, run counterclockwise, do not cross, and meet in points that they share by
 * index
 */
NestingForest BuildNestingForest(
  const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops);
}

#endif
