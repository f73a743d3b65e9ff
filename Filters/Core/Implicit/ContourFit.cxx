// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContourFit.h"

#include "ContourResampling.h"
#include "ContourTips.h"
#include "RefinedMargins.h"
#include "SubMonitor.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Every how manieth level is left out in turn, how many levels that takes at least, and up to how
/// many constraints all turns are taken instead of one.
constexpr int LeaveOutEvery = 3;
constexpr std::size_t LeastLevelsToJudge = 6;
constexpr std::size_t MostConstraintsToJudgeTwice = 12000;
/// Refining must be nearer at this part of the left-out vertices. A vote, not a mean: where nothing
/// predicts the surface, at branchings, both miss by anything.
constexpr double Majority = 0.5;
/// Differences below this part of the gap between the contours decide nothing.
constexpr double TieOfGap = 0.01;
/// What ThinOut's spacing is worth, as a part of the gap between the contours: denser points cost
/// more and told little more on the sets tried. Up to the whole gap where there are more points
/// than are needed for that.
constexpr double LeastSpacingPerGap = 0.25;
constexpr double SpacingGrowth = 1.25;
constexpr std::size_t EnoughPoints = 3000;
/// Fits with margins taken back, at most; then the rest stays as it is.
constexpr int MaximumTakeBacks = 3;

/// Margins of a set of contours with the first and the second fit.
struct Refinement
{
  RefinedMargins Margins;
  ImplicitFunction First;
  ImplicitFunction Second;
};

ConstraintOptions DistanceOptions(const ConstraintOptions& options)
{
  ConstraintOptions first = options;
  first.Values = ConstraintOptions::Distance;
  return first;
}

ImplicitFunction Fit(const ConstraintSet& set, const FunctionOptions& options, Monitor& monitor)
{
  return FitImplicitFunction(set.Points, set.Values, options, monitor);
}

/// The first fit, of in-plane margins but at tips.
Refinement FitOnce(const ContourSet& contours, const ConstraintSet& inPlane, bool unit,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  Refinement refinement{ RefinedMargins(contours, inPlane, unit), {}, {} };
  refinement.First = Fit(refinement.Margins.Constraints(), functionOptions, monitor);
  return refinement;
}

/// @param normals a fit that tells the normals: the first, or a better one
void FitAgain(Refinement& refinement, const ImplicitFunction& normals,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  RefinedMargins& margins = refinement.Margins;
  margins.Turn(normals, functionOptions.Threads);
  for (int fit = 0; fit <= MaximumTakeBacks; ++fit)
  {
    const double all = 1 + MaximumTakeBacks;
    SubMonitor fitting(monitor, fit / all, (fit + 1) / all);
    refinement.Second = Fit(margins.Constraints(), functionOptions, fitting);
    if (fit == MaximumTakeBacks ||
      margins.TakeBack(refinement.Second, functionOptions.Threads) == 0)
    {
      return;
    }
  }
}

/// The levels that are, or are not, left out in a turn. Points keep their numbers.
ContourSet Part(const ContourSet& contours, int turn, bool leftOut)
{
  ContourSet part = contours;
  part.Levels.clear();
  part.Contours.clear();
  for (std::size_t l = 0; l < contours.Levels.size(); ++l)
  {
    // The first and the last level stay: beyond them nothing can be predicted.
    const bool isLeftOut =
      static_cast<int>(l % LeaveOutEvery) == turn && l > 0 && l + 1 < contours.Levels.size();
    if (isLeftOut != leftOut)
    {
      continue;
    }
    Level level = contours.Levels[l];
    for (int& c : level.Contours)
    {
      Contour contour = contours.Contours[c];
      contour.Level = static_cast<int>(part.Levels.size());
      contour.Parent = -1;
      c = static_cast<int>(part.Contours.size());
      part.Contours.push_back(contour);
    }
    part.Levels.push_back(level);
  }
  return part;
}

/// Distance, to first order, of the contours' vertices from the function's surface.
std::vector<double> Misses(
  const ImplicitFunction& function, const ContourSet& contours, int threads)
{
  std::vector<Point3> points;
  for (const Contour& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      points.push_back(contours.Points[p]);
    }
  }
  const std::vector<double> f = function.Evaluate(points, threads);
  const std::vector<Vector3> g = function.EvaluateGradients(points, threads);
  std::vector<double> misses;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    misses.push_back(std::abs(f[i]) / Norm(g[i]));
  }
  return misses;
}

struct Votes
{
  std::size_t Better = 0; ///< vertices that refining predicts better
  std::size_t All = 0;    ///< that either predicts better

  bool Pass() const
  {
    return static_cast<double>(this->Better) >= Majority * static_cast<double>(this->All);
  }
};

/// Which of one fit and two fits is nearer to the vertices of levels that neither has seen?
void Vote(const ContourSet& contours, int turn, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor, Votes& votes)
{
  const ContourSet seen = Part(contours, turn, false);
  const ContourSet unseen = Part(contours, turn, true);
  if (unseen.Contours.empty())
  {
    return;
  }
  const ConstraintSet inPlane = BuildInPlaneConstraints(seen, constraintOptions, monitor);
  SubMonitor fitting(monitor, 0, 0.4);
  Refinement refinement = FitOnce(seen, inPlane, false, functionOptions, fitting);
  SubMonitor refining(monitor, 0.4, 1);
  FitAgain(refinement, refinement.First, functionOptions, refining);
  const double tie = TieOfGap * TypicalGap(contours);
  const std::vector<double> once = Misses(refinement.First, unseen, functionOptions.Threads);
  const std::vector<double> twice = Misses(refinement.Second, unseen, functionOptions.Threads);
  for (std::size_t i = 0; i < once.size(); ++i)
  {
    // Vertices that both predict as well abstain.
    votes.Better += twice[i] < once[i] - tie ? 1 : 0;
    votes.All += std::abs(twice[i] - once[i]) > tie ? 1 : 0;
  }
}

Votes VoteAll(const ContourSet& contours, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  Votes votes;
  if (contours.Levels.size() < LeastLevelsToJudge)
  {
    return votes;
  }
  ConstraintOptions options = DistanceOptions(constraintOptions);
  // What is judged is the set as it will be fitted, so with the margins of the whole.
  options.MarginDistance = ChooseMarginDistance(contours, constraintOptions);
  const int turns = 3 * contours.Points.size() > MostConstraintsToJudgeTwice ? 1 : LeaveOutEvery;
  for (int turn = 0; turn < turns; ++turn)
  {
    SubMonitor voting(
      monitor, static_cast<double>(turn) / turns, static_cast<double>(turn + 1) / turns);
    Vote(contours, (turn + 1) % LeaveOutEvery, options, functionOptions, voting, votes);
  }
  return votes;
}

void ReportRefinement(const RefinedMargins& margins, ConstraintSet& set)
{
  const std::size_t kept = margins.Vertices() - margins.Turned() - margins.TipVertices();
  if (kept > 0)
  {
    set.Report.push_back(std::to_string(kept) + " of " + std::to_string(margins.Vertices()) +
      " contour points keep margins in their plane, because the shape is too thin there to tell "
      "its "
      "normals, or refined ones would contradict a contour.");
  }
}

/// Constraints and function of a fit that is refined where that is safe.
void FitRefined(ContourFit& fit, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  const bool unit = constraintOptions.Values == ConstraintOptions::Unit;
  SubMonitor fitting(monitor, 0, 0.2);
  Refinement refinement = FitOnce(fit.Contours, fit.Constraints, unit, functionOptions, fitting);
  if (refinement.Margins.TipVertices() > 0)
  {
    refinement.First.Report.push_back(std::to_string(refinement.Margins.TipVertices()) +
      " points of contours that only touch the end of the solid have margins upright on their "
      "plane.");
  }
  fit.Constraints = refinement.Margins.Constraints();
  fit.Function = refinement.First;
  SubMonitor judging(monitor, 0.2, 0.6);
  const Votes votes = VoteAll(fit.Contours, constraintOptions, functionOptions, judging);
  if (!votes.Pass())
  {
    fit.Constraints.Report.push_back(
      "Margins stay in the contours' planes: refined, the surface would be farther from " +
      std::to_string(votes.All - votes.Better) + " of " + std::to_string(votes.All) +
      " contour points where their slice is left out.");
    return;
  }
  SubMonitor refining(monitor, 0.6, 1);
  ImplicitFunction normals = refinement.First;
  if (unit)
  {
    // Distances tell the normals better than +1 and -1 do.
    const ConstraintSet distances =
      BuildInPlaneConstraints(fit.Contours, DistanceOptions(constraintOptions), refining);
    normals = FitOnce(fit.Contours, distances, false, functionOptions, refining).First;
  }
  FitAgain(refinement, normals, functionOptions, refining);
  fit.Constraints = refinement.Margins.Constraints();
  ReportRefinement(refinement.Margins, fit.Constraints);
  fit.Function = std::move(refinement.Second);
}

/// Points as dense as the gap is worth; with many points less dense, for a fit in seconds, but not
/// beyond the gap.
ContourSet ThinOutByGap(const ContourSet& contours)
{
  const double gap = TypicalGap(contours);
  double spacing = LeastSpacingPerGap * gap;
  ContourSet thin = ThinOut(contours, spacing);
  while (thin.Points.size() > EnoughPoints && spacing < gap)
  {
    spacing = std::min(gap, SpacingGrowth * spacing);
    thin = ThinOut(contours, spacing);
  }
  return thin;
}

/// The points that options ask for, or where they ask for nothing, no more than the gap is worth.
ContourSet Resampled(const ContourSet& contours, const ConstraintOptions& options)
{
  if (options.ResampleTolerance <= 0 && options.ResampleSpacing <= 0)
  {
    return options.ThinOut ? ThinOutByGap(contours) : contours;
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
  SubMonitor fitting(monitor, 0.1, 1);
  if (constraintOptions.Normals == ConstraintOptions::Refined &&
    constraintOptions.Mode == ConstraintOptions::Margins)
  {
    FitRefined(fit, constraintOptions, functionOptions, fitting);
  }
  else
  {
    fit.Function = Fit(fit.Constraints, functionOptions, fitting);
  }
  return fit;
}
}
