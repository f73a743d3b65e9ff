// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourFit.h
 * @brief Contours to constraints and function, with margins along refined normals where they are
 * safe.
 *
 * Why: a margin in the contour's plane claims that the surface stands upright on the plane. Where
 * it is oblique (the poles of a sphere) that is wrong by a lot: -5% of the volume of a 3 mm sphere.
 * One fit already knows the normals better; margins along those, fitted again, are nearer to the
 * truth.
 *
 * When it is not safe: on thin, branching, sparsely cut shapes a wrong normal feeds on itself.
 * Guards, measured on sets with a reference surface:
 *  1. a vertex whose in-plane margins had no room keeps them (RefinedMargins.h);
 *  2. a vertex whose new normal the second fit contradicts gets its in-plane margins back, and it
 * is fitted again;
 *  3. with a third of the levels left out in turn, the second fit must be nearer than the first to
 *     at least half of the vertices that it has not seen. Else the result is that of one fit, with
 * a line in Report. Contours that only touch the end of the solid are a case of their own
 * (ContourTips.h).
 */
#ifndef recon_ContourFit_h
#define recon_ContourFit_h

#include "Constraints.h"
#include "ImplicitFunction.h"

namespace recon
{
struct ContourFit
{
  ContourSet Contours; ///< resampled where that was asked for
  ConstraintSet Constraints;
  ImplicitFunction Function; ///< fitted to Constraints
};

/**
 * Resample, make constraints (algorithm 13), fit (algorithm 14), and refine where Normals is
 * Refined. BoundingBoxCorners has no margins to refine: it is fitted once.
 *
 * @throws Error as its parts do; Aborted.
 */
ContourFit FitContours(const ContourSet& contours, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor);

/// The contours that options ask for, resampled or as they are. @throws Error on contours or
/// options of no use.
ContourSet PrepareContours(const ContourSet& contours, const ConstraintOptions& options);
}

#endif
