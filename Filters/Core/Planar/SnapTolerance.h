// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SnapTolerance.h
 * @brief How near is one place, for the loops of a level.
 */
#ifndef recon_SnapTolerance_h
#define recon_SnapTolerance_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
/// Share of a loop's diagonal. The nearest that walls come in the sets that were measured is 1.2 of
/// it (balloondog; all others: 7.8 and more), and slivers below it cost a triangulation millions of
/// points.
constexpr double AutomaticSnapping = 1e-7;

/**
 * A tolerance for every loop, in the units of the points.
 *
 * @param wanted that of all loops; 0: each has its own, AutomaticSnapping of its diagonal, so that
 * what is small is not lost beside what is large
 *
 * In any case not below what rounding does to coordinates of this size (2^-44 of the largest).
 */
std::vector<double> SnapTolerances(
  const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, double wanted);
}

#endif
