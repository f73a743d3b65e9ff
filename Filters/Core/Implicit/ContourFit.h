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
 * Three guards:
 *  1. a refined margin point is nearest to its own vertex of all contour vertices (else it moves
 * nearer);
 *  2. the second fit must keep every in-plane margin on its side, and keep the first fit's normals
 * within an angle; contours where it does not get their in-plane margins back, and it is fitted
 * again;
 *  3. with a third of the levels left out, the second fit must predict those no worse than the
 * first. Where a guard says no for the whole set, the result is that of one fit, with a line in
 * Report.
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
