// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StepMargins.h
 * @brief Margins that reach across steps between parallel levels
 * (ConstraintOptions::ReachAcrossSteps).
 */
#ifndef recon_StepMargins_h
#define recon_StepMargins_h

#include "Implicit/Constraints/VertexMargins.h"

namespace recon
{
/**
 * Lets margins reach across steps: where the next level says otherwise of the place that lies as
 * far from the vertex, within the level, as the next level does. There the surface lies flat and
 * between the levels, which a short margin of unit slope denies: the surface would rise upright
 * from the contour and bulge. The value is the distance to a plane that cuts the level at the
 * contour and the line to the next level where shape-based interpolation has the surface.
 *
 * @param contours levels all parallel. @param margins of PlaceMargins. @throws Aborted
 */
void ReachAcrossSteps(
  const ContourSet& contours, std::vector<VertexMargins>& margins, Monitor& monitor);
}

#endif
