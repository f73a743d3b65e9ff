// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file HoleRule.h
 * @brief What of a level's loops is inside, by each of the rules that are in use.
 */
#ifndef recon_HoleRule_h
#define recon_HoleRule_h

#include "Contours/ContourSet.h"
#include "Planar/EvenOddRule.h"

#include <vector>

namespace recon
{
/**
 * Loops of a level made simple by a rule.
 *
 * Automatic and EvenOdd: inside is where a ray to infinity crosses loops an odd number of times.
 * Winding: inside is where the loops, in the direction in which they are given, wind around at all
 * (nonzero). Keyhole: a loop is an area by itself (by even-odd, so that what is walked twice, a
 * bridge, goes and its hole stays), and the level is the union of these areas.
 *
 * @param points, loops and snapTolerance as for ApplyEvenOddRule
 * @throws Error where the rounding of crossings does not come to rest
 */
EvenOddResult ApplyHoleRule(std::vector<Point2>& points, const std::vector<std::vector<int>>& loops,
  HoleRule rule, double snapTolerance = 0);

/// "even-odd", "winding", "keyhole".
const char* NameOf(HoleRule rule);
}

#endif
