// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LoopTwins.h
 * @brief Outlines of a level that are there twice: stored with other decimals, or traced again.
 */
#ifndef recon_LoopTwins_h
#define recon_LoopTwins_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
/// A loop that says what another says already.
struct LoopTwin
{
  int Loop = -1;
  int Of = -1;
  double Apart = 0;            ///< the farthest that a point of either is from the other
  bool WithinRounding = false; ///< else it was traced again
};

/**
 * By even-odd, two outlines that are nearly the same leave a thin ring of the area between them;
 * what was meant is the area itself.
 *
 * Within rounding: both have the same points within what their decimals can tell apart, or within
 * 1e-5 of their size. Traced again: they are nearly the same area, and what is a wall and its hole
 * is ruled out, as one runs on both sides of the other, or has nearly all its points on it.
 *
 * @param units a loop: that of its last decimal, or 0 where its coordinates are as fine as they go
 * @param tracedAgain whether to look for such, too
 * @returns those to be left out, in the order of their numbers: of two, the one of finer decimals
 * stays, or else of more points, or else the first
 */
std::vector<LoopTwin> FindLoopTwins(const std::vector<Point2>& points,
  const std::vector<std::vector<int>>& loops, const std::vector<double>& units, bool tracedAgain);

/// The unit of the last decimal that numbers have, 1 to 1e-8; that of their last bit where they are
/// all of single precision; 0 for others.
double UnitOf(const std::vector<double>& numbers);
}

#endif
