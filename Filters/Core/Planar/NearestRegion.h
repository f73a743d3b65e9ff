// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NearestRegion.h
 * @brief The solid region of another level that is nearest in projection.
 */
#ifndef recon_NearestRegion_h
#define recon_NearestRegion_h

#include "Contours/ContourMapping.h"

#include <optional>
#include <vector>

namespace recon
{
struct NearestRegion
{
  int Wall = -1;       ///< contour around the region
  double Distance = 0; ///< between the borders, in the input's units
};

/**
 * The nearest of the solid regions of `level`, if any is nearer than `reach`; of equally near ones
 * the first. Regions that overlap are not meant: the distance is that of borders.
 */
std::optional<NearestRegion> FindNearestRegion(const ContourSet& contours,
  const ContourRegion& region, const std::vector<ContourRegion>& regions, const Level& level,
  double reach);
}

#endif
