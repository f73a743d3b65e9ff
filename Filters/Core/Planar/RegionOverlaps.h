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
 * One arrangement (Arrangement.h) of both levels' edges, each with a weight from which the faces'
 * labels follow along a sweep (EdgeSweep.h); areas are sums over the borders of equal labels. A
 * crossing is computed exactly and rounded once, so an area is right to some 1e-15 of the extent times
 * the length of its border; walls of different levels may lie upon one another.
 *
 * @pre both levels have the same frame
 * @throws Error where the levels cross in more places than the arrangement allows
 */
std::vector<RegionOverlap> MeasureRegionOverlaps(
  const ContourSet& contours, const Level& lower, const Level& upper);
}

#endif
