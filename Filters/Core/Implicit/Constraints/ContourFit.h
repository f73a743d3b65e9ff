// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourFit.h
 * @brief Contours to constraints and function, with margins that know how the surface stands on the
 * planes where that is safe.
 *
 * Why: a margin in the contour's plane claims that the surface stands upright on the plane. Where
 * it is oblique (the poles of a sphere) that is wrong by a lot: -5% of the volume of a 3 mm sphere.
 * One fit already knows the normals better; margins refined by those (RefinedMargins.h), fitted
 * again, are nearer to the truth.
 *
 * When it is not safe: on thin, branching, sparsely cut shapes a wrong normal feeds on itself. So
 * the slices decide (LeftOutSlices.h): with a third of the levels left out in turn, margins must be
 * nearer than those in the planes to at least half of the vertices that neither has seen. The first
 * of these ways that passes is taken, else margins stay in the planes, with a line in Report:
 *  1. turned half way to the normals: nearest to the truth where slices are close enough;
 *  2. in the planes, but valued by the normals: never far from margins in the planes;
 *  3. reaching across steps, where all planes are parallel: the surface lies flat between slices.
 *
 * Where there are too few levels to leave some out: parallel ones are valued by the normals, and
 * crossing ones turned all the way, as they show one another's normals. Unit values cannot tell how
 * far a margin is, so there margins are turned all the way or not at all. Contours that only touch
 * the end of the solid are a case of their own (ContourTips.h).
 */
#ifndef recon_ContourFit_h
#define recon_ContourFit_h

#include "Implicit/Constraints/Constraints.h"
#include "Implicit/Solver/FitImplicitFunction.h"

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
