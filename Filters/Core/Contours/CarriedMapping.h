// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CarriedMapping.h
 * @brief Decisions of an earlier mapping, which travel with the contours, followed by what comes next.
 */
#ifndef recon_CarriedMapping_h
#define recon_CarriedMapping_h

#include "Contours/ContourMapping.h"

#include <string>
#include <vector>

namespace recon
{
/// Pairs of contours, by the ContourId that they had, and whether these are joined.
struct CarriedMapping
{
  std::vector<int> Lower;
  std::vector<int> Upper;
  std::vector<int> Joined;     ///< 0 or 1
  std::vector<int> ContourIds; ///< of every cell of the input (Contour::Source)
};

/**
 * Appends the decisions to the forced and forbidden joins, but for pairs that these name already.
 *
 * @param contours that the input became; their order may be another
 * @return a sentence for Report
 */
[[nodiscard]] std::string FollowMapping(
  const CarriedMapping& carried, const ContourSet& contours, ContourMappingOptions& options);
}

#endif
