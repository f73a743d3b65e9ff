// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NeedleContours.h
 * @brief Contours so narrow that a level with them takes more points than it may have.
 *
 * Where lines cross at a small angle the even-odd rule leaves needles, which may be a little wider
 * than what is snapped together before (SnapTolerance.h). Edges that run at a distance w of each
 * other take points in the order of 1/w. So where a level cannot be had, needles at that place are
 * given up one by one.
 */
#ifndef recon_NeedleContours_h
#define recon_NeedleContours_h

#include "Contours/ContourSet.h"

#include <string>
#include <vector>

namespace recon
{
/**
 * Of the contours of a level that are narrower than a hundred thousandth of its diagonal the one
 * nearest to the place, and all that lies within it; empty where there is none.
 *
 * among: contours of the level that are there yet.
 */
std::vector<int> FindNeedle(
  const ContourSet& contours, const std::vector<int>& among, const Point2& place);

/// A line of the report for a contour that was given up.
std::string DescribeNeedle(const ContourSet& contours, int contour);
}

#endif
