// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/ContourFit.h"

#include "Base/NamedMonitor.h"
#include "Base/Text.h"
#include "Implicit/Constraints/ContourResampling.h"
#include "Implicit/Constraints/ContourTips.h"
#include "Implicit/Constraints/DrawnPlanesFit.h"
#include "Implicit/Constraints/LeftOutSlices.h"
#include "Implicit/Constraints/MarginFit.h"

#include <algorithm>

namespace recon
{
namespace
{
/// What ThinOut's spacing is worth, as a part of the gap between the contours: denser points cost
/// more and told little more on the sets tried. Up to the whole gap where there are more points
/// than are needed for that.
constexpr double LeastSpacingPerGap = 0.25;
constexpr double SpacingGrowth = 1.25;
constexpr std::size_t EnoughPoints = 3000;
/// Edges longer than so many gaps get points: what lies next to their middle is nearer to other
/// planes than to their ends.
constexpr double LongEdgePerGap = 2;

ConstraintOptions DistanceOptions(const ConstraintOptions& options)
{
  ConstraintOptions first = options;
  first.Values = ConstraintOptions::Distance;
  return first;
}

std::string Words(const SliceVotes& votes)
{
  return std::to_string(votes.All - votes.Better) + " of " + std::to_string(votes.All) +
    " contour points where their slice is left out.";
}

void ReportRefinement(const RefinedMargins& margins, ConstraintSet& set)
{
  const std::size_t kept = margins.Vertices() - margins.Turned() - margins.TipVertices();
  if (kept > 0)
  {
    set.Report.push_back(std::to_string(kept) + " of " + std::to_string(margins.Vertices()) +
      " contour points keep margins in their plane, because the shape is too thin there to tell "
      "its normals, or refined ones would contradict a contour.");
  }
}

/// Constraints and function of contours whose margins are refined where that is safe.
class RefinedFit
{
public:
  RefinedFit(ContourFit& fit, const ConstraintOptions& constraintOptions,
    const FunctionOptions& functionOptions)
    : Result(fit),
      Constraints(constraintOptions),
      Function(functionOptions),
      Unit(constraintOptions.Values == ConstraintOptions::Unit)
  {
  }

  void Run(Monitor& monitor)
  {
    NamedMonitor fitting(monitor, 0, 0.15, "fitting the contours");
    MarginFit first(
      this->Result.Contours, this->Result.Constraints, this->Unit, this->Function, fitting);
    this->Take(first);
    if (first.Margins().TipVertices() > 0)
    {
      this->Result.Constraints.Report.push_back(std::to_string(first.Margins().TipVertices()) +
        " points of contours that only touch the end of the solid have margins upright on their "
        "plane.");
    }
    SubMonitor refining(monitor, 0.15, 1);
    if (this->Result.Contours.Levels.size() >= LeftOutSlices::LeastLevels)
    {
      this->RefineAsSlicesSay(first, refining);
    }
    else if (!AllLevelsParallel(this->Result.Contours))
    {
      this->Refine(first, 1, refining);
    }
    else if (!this->Unit)
    {
      this->Refine(first, 0, refining);
    }
  }

private:
  void RefineAsSlicesSay(MarginFit& first, Monitor& monitor)
  {
    SubMonitor preparing(monitor, 0, 0.15);
    const LeftOutSlices slices(this->Result.Contours, this->Constraints, this->Function, preparing);
    SubMonitor judging(monitor, 0.15, 0.5);
    const SliceVotes turned = slices.Judge(MarginWay::Turned, judging);
    SubMonitor refining(monitor, 0.5, 1);
    if (turned.Pass())
    {
      this->Refine(first, this->Unit ? 1 : TurnedPart, refining);
      return;
    }
    std::vector<std::string>& report = this->Result.Constraints.Report;
    report.push_back(
      "Margins stay in the contours' planes: turned along the surface's normals, it would be "
      "farther from " +
      Words(turned));
    if (this->Unit)
    {
      return;
    }
    SubMonitor valuing(refining, 0, 0.4);
    if (slices.Judge(MarginWay::Valued, valuing).Pass())
    {
      report.push_back("Their values tell how oblique the surface is to the planes.");
      SubMonitor fitting(refining, 0.4, 1);
      this->Refine(first, 0, fitting);
      return;
    }
    SubMonitor reaching(refining, 0.4, 1);
    this->ReachIfSlicesSay(slices, reaching);
  }

  void ReachIfSlicesSay(const LeftOutSlices& slices, Monitor& monitor)
  {
    if (this->Constraints.ReachAcrossSteps || !AllLevelsParallel(this->Result.Contours))
    {
      return;
    }
    SubMonitor judging(monitor, 0, 0.5);
    const SliceVotes votes = slices.Judge(MarginWay::Reaching, judging);
    if (votes.All == 0 || !votes.Pass())
    {
      return;
    }
    ConstraintOptions options = this->Constraints;
    options.ReachAcrossSteps = true;
    SubMonitor fitting(monitor, 0.5, 1);
    const ConstraintSet reaching = BuildInPlaneConstraints(this->Result.Contours, options, fitting);
    this->Take(MarginFit(this->Result.Contours, reaching, false, this->Function, fitting));
    this->Result.Constraints.Report.push_back(
      "Margins reach across steps, where the next slice says otherwise of a place: that is nearer "
      "to " +
      std::to_string(votes.Better) + " of " + std::to_string(votes.All) +
      " contour points where their slice is left out.");
  }

  void Refine(MarginFit& fit, double part, Monitor& monitor)
  {
    ImplicitFunction normals = fit.Function();
    if (this->Unit)
    {
      // Distances tell the normals better than +1 and -1 do.
      const ConstraintSet distances =
        BuildInPlaneConstraints(this->Result.Contours, DistanceOptions(this->Constraints), monitor);
      normals =
        MarginFit(this->Result.Contours, distances, false, this->Function, monitor).Function();
    }
    fit.Refine(normals, part, monitor);
    this->Take(fit);
    ReportRefinement(fit.Margins(), this->Result.Constraints);
  }

  /// Makes a fit the result; sentences that were said stay.
  void Take(const MarginFit& fit)
  {
    std::vector<std::string> report = std::move(this->Result.Constraints.Report);
    this->Result.Constraints = fit.Constraints();
    const std::vector<std::string>& more = this->Result.Constraints.Report;
    report.insert(report.end(), more.begin(), more.end());
    this->Result.Constraints.Report = std::move(report);
    this->Result.Function = fit.Function();
  }

  ContourFit& Result;
  const ConstraintOptions& Constraints;
  const FunctionOptions& Function;
  const bool Unit;
};

/// Points as dense as the gap is worth; with many points less dense, for a fit in seconds, but not
/// beyond the gap: spacing becomes what was taken.
ContourSet ThinOutByGap(const ContourSet& contours, double gap, double& spacing)
{
  ContourSet thin = ThinOut(contours, spacing);
  while (thin.Points.size() > EnoughPoints && spacing < gap)
  {
    spacing = std::min(gap, SpacingGrowth * spacing);
    thin = ThinOut(contours, spacing);
  }
  return thin;
}

/// Points on edges that are long beside the gap, which the function knows only at their ends
/// otherwise.
ContourSet WithFilledEdges(const ContourSet& contours, double gap, double spacing)
{
  FilledEdges filled = FillLongEdges(contours, LongEdgePerGap * gap, spacing, EnoughPoints);
  if (filled.Points > 0)
  {
    filled.Contours.Report.push_back(std::to_string(filled.Points) + " points were put on " +
      std::to_string(filled.Edges) + " contour edges longer than " + Text(LongEdgePerGap * gap) +
      ", twice the gap between the contours.");
  }
  return filled.Contours;
}

/// The points that options ask for, or where they ask for nothing, no more than the gap is worth.
ContourSet Resampled(const ContourSet& contours, const ConstraintOptions& options)
{
  if (options.ResampleTolerance <= 0 && options.ResampleSpacing <= 0)
  {
    const double gap = TypicalGap(contours);
    double spacing = LeastSpacingPerGap * gap;
    const ContourSet few = options.ThinOut ? ThinOutByGap(contours, gap, spacing) : contours;
    return options.FillLongEdges ? WithFilledEdges(few, gap, spacing) : few;
  }
  ContourSet resampled = contours;
  if (options.ResampleTolerance > 0)
  {
    resampled = ResampleToTolerance(resampled, options.ResampleTolerance);
  }
  return options.ResampleSpacing > 0 ? ResampleToSpacing(resampled, options.ResampleSpacing)
                                     : resampled;
}
}

ContourSet PrepareContours(const ContourSet& contours, const ConstraintOptions& options)
{
  CheckConstraintInput(contours, options);
  return Resampled(contours, options);
}

ContourFit FitContours(const ContourSet& contours, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  ContourFit fit;
  fit.Contours = PrepareContours(contours, constraintOptions);
  SubMonitor placing(monitor, 0, 0.1);
  fit.Constraints = BuildInPlaneConstraints(fit.Contours, constraintOptions, placing);
  // What preparing them had to say; the rest is the caller's.
  const std::vector<std::string>& said = fit.Contours.Report;
  const auto from = static_cast<std::ptrdiff_t>(std::min(said.size(), contours.Report.size()));
  fit.Constraints.Report.insert(fit.Constraints.Report.begin(), said.begin() + from, said.end());
  SubMonitor fitting(monitor, 0.1, 0.7);
  if (constraintOptions.Normals == ConstraintOptions::Refined &&
    constraintOptions.Mode == ConstraintOptions::Margins)
  {
    RefinedFit(fit, constraintOptions, functionOptions).Run(fitting);
  }
  else
  {
    fit.Function =
      FitImplicitFunction(fit.Constraints.Points, fit.Constraints.Values, functionOptions, fitting);
  }
  const bool canFollow = constraintOptions.FollowDrawnPlanes &&
    constraintOptions.Values == ConstraintOptions::Distance &&
    constraintOptions.Mode == ConstraintOptions::Margins &&
    functionOptions.Kind == Kernel::Triharmonic && AllLevelsParallel(contours);
  if (canFollow)
  {
    SubMonitor following(monitor, 0.7, 1);
    FollowDrawnPlanes(contours, constraintOptions, functionOptions, fit, following);
  }
  return fit;
}
}
