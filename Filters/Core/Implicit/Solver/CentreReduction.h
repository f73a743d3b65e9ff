// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CentreReduction.h
 * @brief The same surface from fewer centres (Carr and others: Reconstruction and Representation of
 * 3D Objects with Radial Basis Functions, 2001, section 4).
 */
#ifndef recon_CentreReduction_h
#define recon_CentreReduction_h

#include "Implicit/Solver/FitImplicitFunction.h"

namespace recon
{
/**
 * Greedy: fit a few constraints spread over all, look at the misfit of all, add those that are
 * missed most, fit again, until none is missed by more than options.CentreReduction.
 *
 * @param points not all in one plane, no duplicates.
 * @returns a function whose Centres are those that it took, whose Residual is the largest misfit of
 * all, with the count in Report.
 * @throws as FitImplicitFunction does.
 */
ImplicitFunction FitWithFewCentres(const std::vector<Point3>& points,
  const std::vector<double>& values, const FunctionOptions& options, Monitor& monitor);
}

#endif
