// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file HoleExplanation.h
 * @brief What was found of holes on a level, worded for people.
 */
#ifndef recon_HoleExplanation_h
#define recon_HoleExplanation_h

#include "Contours/ContourSet.h"

#include <cstddef>
#include <string>

namespace recon
{
/// How the holes of a level were drawn.
struct HoleFindings
{
  std::size_t Opposite = 0;  ///< in the direction opposite to that of the wall around
  std::size_t Same = 0;      ///< in the same direction
  std::size_t Keyholes = 0;  ///< by the contour of the wall around, which walks there and back
  std::size_t Swallowed = 0; ///< contours with solid on both sides, which are no holes by this rule
  bool ExclusiveOr = false;  ///< contours that say of themselves that they go by even-odd
};

/// "Even-odd: 2 holes (1 in the direction of the wall around it, 1 by a keyhole)."
std::string DescribeHoles(HoleRule rule, const HoleFindings& found);
}

#endif
