// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DrawnPlanesFit.h
 * @brief A fit that has, on the drawn planes, the sections that were drawn (DrawnSections.h).
 */
#ifndef recon_DrawnPlanesFit_h
#define recon_DrawnPlanesFit_h

#include "Implicit/Constraints/ContourFit.h"

namespace recon
{
/**
 * Adds constraints where the function is on another side than what was drawn, and fits again, until
 * it is not, or a few times; Report tells how many, and where it still is. A fit that agrees stays
 * as it is.
 *
 * @param drawn levels all parallel @throws Error, Aborted
 */
void FollowDrawnPlanes(const ContourSet& drawn, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, ContourFit& fit, Monitor& monitor);
}

#endif
