// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourSubset.h
 * @brief Some of the contours of a set, on the levels that then have any.
 */
#ifndef recon_ContourSubset_h
#define recon_ContourSubset_h

#include "Contours/ContourSet.h"

namespace recon
{
/**
 * The contours that keeps(contour) says yes to. Points keep their numbers; a contour whose parent
 * may be gone has none; Depth, which side the solid is on, stays.
 */
template <typename Keeps>
ContourSet SubsetOf(const ContourSet& contours, const Keeps& keeps)
{
  ContourSet subset = contours;
  subset.Levels.clear();
  subset.Contours.clear();
  for (Level level : contours.Levels)
  {
    std::vector<int> kept;
    for (const int c : level.Contours)
    {
      if (keeps(contours.Contours[c]))
      {
        kept.push_back(static_cast<int>(subset.Contours.size()));
        subset.Contours.push_back(contours.Contours[c]);
        subset.Contours.back().Level = static_cast<int>(subset.Levels.size());
        subset.Contours.back().Parent = -1;
      }
    }
    if (!kept.empty())
    {
      level.Contours = std::move(kept);
      subset.Levels.push_back(std::move(level));
    }
  }
  return subset;
}
}

#endif
