// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/LeftOutSlices.h"

#include "Base/NamedMonitor.h"
#include "Contours/ContourSubset.h"
#include "Implicit/Constraints/ContourTips.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"

#include <cmath>

namespace recon
{
namespace
{
/// Every how manieth level is left out in turn, and up to how many constraints all turns are taken
/// instead of one.
constexpr int LeaveOutEvery = 3;
constexpr std::size_t MostConstraintsForAllTurns = 12000;
/// Differences below this part of the gap between the contours decide nothing.
constexpr double TieOfGap = 0.01;

const char* NameOf(MarginWay way)
{
  switch (way)
  {
    case MarginWay::Turned:
      return "trying margins that turn with the surface";
    case MarginWay::Valued:
      return "trying margins that know how oblique it is";
    case MarginWay::Reaching:
      break;
  }
  return "trying margins that reach across steps";
}

/// The contours of the levels that are, or are not, left out in a turn.
ContourSet Part(const ContourSet& contours, int turn, bool leftOut)
{
  const int last = static_cast<int>(contours.Levels.size()) - 1;
  return SubsetOf(contours,
    [&](const Contour& contour)
    {
      const int l = contour.Level;
      return (l % LeaveOutEvery == turn && l > 0 && l < last) == leftOut;
    });
}

/// Distance, to first order, of the contours' vertices from the function's surface.
std::vector<double> Misses(
  const ImplicitFunction& function, const ContourSet& contours, int threads, Monitor& monitor)
{
  std::vector<Point3> points;
  for (const Contour& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      points.push_back(contours.Points[p]);
    }
  }
  std::vector<double> f;
  std::vector<Vector3> g;
  AbortMonitor stop(monitor);
  FunctionEvaluator(function, threads).ValuesAndGradients(points, f, g, stop);
  std::vector<double> misses;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    misses.push_back(std::abs(f[i]) / Norm(g[i]));
  }
  return misses;
}
}

LeftOutSlices::LeftOutSlices(const ContourSet& contours, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
  : Constraints(constraintOptions),
    Function(functionOptions),
    Tie(TieOfGap * TypicalGap(contours))
{
  this->Constraints.Values = ConstraintOptions::Distance;
  // What is judged is the set as it will be fitted, so with the margins of the whole.
  this->Constraints.MarginDistance = ChooseMarginDistance(contours, constraintOptions);
  const int count = 3 * contours.Points.size() > MostConstraintsForAllTurns ? 1 : LeaveOutEvery;
  for (int i = 0; i < count; ++i)
  {
    ContourSet seen = Part(contours, (i + 1) % LeaveOutEvery, false);
    ContourSet unseen = Part(contours, (i + 1) % LeaveOutEvery, true);
    if (unseen.Contours.empty())
    {
      continue;
    }
    NamedMonitor fitting = NamedMonitor::Pass(monitor, static_cast<std::size_t>(i),
      static_cast<std::size_t>(count), "fitting with slices left out");
    const ConstraintSet inPlane = BuildInPlaneConstraints(seen, this->Constraints, fitting);
    MarginFit first(seen, inPlane, false, this->Function, fitting);
    std::vector<double> misses = Misses(first.Function(), unseen, this->Function.Threads, fitting);
    this->Turns.push_back(
      { std::move(seen), std::move(unseen), std::move(first), std::move(misses) });
  }
}

std::vector<double> LeftOutSlices::MissesOf(const Turn& turn, MarginWay way, Monitor& monitor) const
{
  const int threads = this->Function.Threads;
  if (way == MarginWay::Reaching)
  {
    ConstraintOptions options = this->Constraints;
    options.ReachAcrossSteps = true;
    const ConstraintSet reaching = BuildInPlaneConstraints(turn.Seen, options, monitor);
    const MarginFit fit(turn.Seen, reaching, false, this->Function, monitor);
    return Misses(fit.Function(), turn.Unseen, threads, monitor);
  }
  MarginFit fit = turn.First;
  fit.Refine(turn.First.Function(), way == MarginWay::Turned ? TurnedPart : 0, monitor);
  return Misses(fit.Function(), turn.Unseen, threads, monitor);
}

SliceVotes LeftOutSlices::Judge(MarginWay way, Monitor& monitor) const
{
  SliceVotes votes;
  for (std::size_t t = 0; t < this->Turns.size(); ++t)
  {
    NamedMonitor fitting = NamedMonitor::Pass(monitor, t, this->Turns.size(), NameOf(way));
    const std::vector<double> misses = this->MissesOf(this->Turns[t], way, fitting);
    const std::vector<double>& plain = this->Turns[t].Misses;
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      // Vertices that both predict as well abstain.
      votes.Better += misses[i] < plain[i] - this->Tie ? 1 : 0;
      votes.All += std::abs(misses[i] - plain[i]) > this->Tie ? 1 : 0;
    }
  }
  return votes;
}
}
