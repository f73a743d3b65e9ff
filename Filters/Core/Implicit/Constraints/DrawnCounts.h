// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DrawnCounts.h
 * @brief On which drawn planes a function has another number of contours than was drawn.
 *
 * Why beside DrawnSections.h: two contours that grow together across a thin wall, or one that is cut
 * in two, change hardly any area and no deep place, so that squares as large as a cell do not see it.
 */
#ifndef recon_DrawnCounts_h
#define recon_DrawnCounts_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Implicit/ImplicitFunction.h"

#include <vector>

namespace recon
{
struct OtherCount
{
  double Height = 0; ///< of the plane, along the normal of the first level
  int Drawn = 0;
  int Traced = 0;
};

/**
 * Traces the zero set on the drawn planes. Contours of less than two squares of a cell do not count,
 * and one of up to twice that may be missing on either side: what is as small may be drawn a little
 * above that size and traced a little below.
 *
 * @param seeds points on the zero set, by which it is found @throws Aborted
 */
std::vector<OtherCount> FindOtherCounts(const ContourSet& drawn, const ImplicitFunction& function,
  const std::vector<Point3>& seeds, double cell, int threads, Monitor& monitor);
}

#endif
