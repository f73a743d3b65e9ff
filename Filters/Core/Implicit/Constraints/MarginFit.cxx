// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/MarginFit.h"

#include "Base/SubMonitor.h"
#include "Implicit/Constraints/NearConstraints.h"

namespace recon
{
namespace
{
/// Fits with margins taken back, at most; then the rest stays as it is.
constexpr int MaximumTakeBacks = 3;
}

MarginFit::MarginFit(const ContourSet& contours, const ConstraintSet& inPlane, bool unit,
  const FunctionOptions& options, Monitor& monitor)
  : Current(contours, inPlane, unit),
    Options(options)
{
  this->Fit(monitor);
}

void MarginFit::Fit(Monitor& monitor)
{
  this->Asked = this->Current.Constraints();
  this->Asked.Report.clear();
  ResolveNearConstraints(this->Asked);
  this->Fitted =
    FitImplicitFunction(this->Asked.Points, this->Asked.Values, this->Options, monitor);
}

void MarginFit::Refine(const ImplicitFunction& normals, double part, Monitor& monitor)
{
  AbortMonitor stop(monitor);
  const int threads = this->Options.Threads;
  this->Current.Turn(normals, part, threads, stop);
  for (int fit = 0; fit <= MaximumTakeBacks; ++fit)
  {
    const double all = 1 + MaximumTakeBacks;
    SubMonitor fitting(monitor, fit / all, (fit + 1) / all);
    this->Fit(fitting);
    if (fit == MaximumTakeBacks || this->Current.TakeBack(this->Fitted, threads, stop) == 0)
    {
      return;
    }
  }
}
}
