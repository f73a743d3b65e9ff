// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RegionOverlaps.h
 * @brief Areas that the regions of two parallel levels share in projection (thesis 3.2).
 */
#ifndef recon_RegionOverlaps_h
#define recon_RegionOverlaps_h

#include "Contours/ContourSet.h"

#include <vector>

namespace recon
{
/// What the regions directly inside two contours of different levels have in common.
struct RegionOverlap
{
  int LowerContour = -1;
  int UpperContour = -1;
  double Area = 0; ///< square units
};

/**
 * Every pair of regions of the two levels whose projections overlap, sorted by lower, then upper
 * contour. A region is what lies inside its contour and outside the contours directly inside that.
 *
 * One triangulation of all edges of both levels: its faces lie in one region of either level, so
 * the areas are sums of triangles, and the cost is that of the triangulation, whatever the number
 * of regions. Apart from the arrangement of one level (Arrangement.h), which rounds its crossings:
 * here walls of different levels may lie upon one another, and all stay as they are. Crossings are
 * exact; rounding comes in where the area of a triangle is computed,
 * which is some 1e-16 of it.
 *
 * @pre both levels have the same frame
 */
std::vector<RegionOverlap> MeasureRegionOverlaps(
  const ContourSet& contours, const Level& lower, const Level& upper);
}

#endif
