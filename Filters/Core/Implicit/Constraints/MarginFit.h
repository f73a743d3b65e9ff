// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MarginFit.h
 * @brief One fit of margins in the contours' planes, and one of margins that the first has refined.
 */
#ifndef recon_MarginFit_h
#define recon_MarginFit_h

#include "Implicit/Constraints/RefinedMargins.h"
#include "Implicit/Solver/FitImplicitFunction.h"

namespace recon
{
/**
 * @class MarginFit
 * @brief Margins and the function that was fitted to them last.
 */
class MarginFit
{
public:
  /// Fits in-plane margins, but for those of tips (ContourTips.h). @throws Error, Aborted
  MarginFit(const ContourSet& contours, const ConstraintSet& inPlane, bool unit,
    const FunctionOptions& options, Monitor& monitor);

  /**
   * Turns the margins by a part of the way to a fit's normals (RefinedMargins.h), and fits again;
   * as long as that contradicts some of them, these are taken back, a few times at most.
   *
   * @param normals the fit that tells the normals: this one's function, or a better one.
   * @throws Error, Aborted
   */
  void Refine(const ImplicitFunction& normals, double part, Monitor& monitor);

  const RefinedMargins& Margins() const { return this->Current; }
  /// Those that were fitted last: the margins, but for what lies too near another one
  /// (NearConstraints.h). Report has sentences about that alone.
  const ConstraintSet& Constraints() const { return this->Asked; }
  const ImplicitFunction& Function() const { return this->Fitted; }

private:
  void Fit(Monitor& monitor);

  RefinedMargins Current;
  FunctionOptions Options;
  ConstraintSet Asked;
  ImplicitFunction Fitted;
};
}

#endif
