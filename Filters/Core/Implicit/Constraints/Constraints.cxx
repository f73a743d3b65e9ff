// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/Constraints.h"

#include "Base/Median.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Implicit/Constraints/CrossingMerge.h"
#include "Implicit/Constraints/NearConstraints.h"
#include "Implicit/Constraints/StepMargins.h"
#include "Implicit/Constraints/VertexMargins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace recon
{
namespace
{
/// A margin distance of less than this part of the bounding box's diagonal is refused: the system's
/// condition grows as d^-3, beyond what doubles can hold.
constexpr double LeastMarginDistance = 1e-6;
/// More contour points than this are refused before they are made.
constexpr double MostResampledPoints = 1e6;

void Append(ConstraintSet& set, const Point3& p, double value, int kind, int contour)
{
  set.Points.push_back(p);
  set.Values.push_back(value);
  set.Kind.push_back(kind);
  set.Contour.push_back(contour);
}

void AppendMargins(const std::vector<VertexMargins>& margins, bool unit, ConstraintSet& set)
{
  std::size_t missing = 0;
  for (const VertexMargins& m : margins)
  {
    Append(set, m.Vertex, 0, ConstraintSet::Boundary, m.Contour);
    if (m.InnerDistance > 0)
    {
      Append(set, m.Inner, unit ? 1 : m.InnerValue, ConstraintSet::Inner, m.Contour);
    }
    if (m.OuterDistance > 0)
    {
      Append(set, m.Outer, unit ? -1 : -m.OuterValue, ConstraintSet::Outer, m.Contour);
    }
    missing += (m.InnerDistance > 0 ? 0 : 1) + (m.OuterDistance > 0 ? 0 : 1);
  }
  set.LeftOut += missing;
  if (missing > 0)
  {
    set.Report.push_back(std::to_string(missing) +
      " margin points were left out: the contours leave no room for them.");
  }
}

/// Thesis 10.3: no margins, the corners of the bounding box are outside, by their distance to the
/// contours.
void AppendCorners(
  const ContourSet& contours, const std::vector<VertexMargins>& margins, ConstraintSet& set)
{
  for (const VertexMargins& m : margins)
  {
    Append(set, m.Vertex, 0, ConstraintSet::Boundary, m.Contour);
  }
  const Box3 box = contours.Bounds();
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point3 p{ corner & 1 ? box.High[0] : box.Low[0], corner & 2 ? box.High[1] : box.Low[1],
      corner & 4 ? box.High[2] : box.Low[2] };
    double least = std::numeric_limits<double>::infinity();
    for (const VertexMargins& m : margins)
    {
      least = std::min(least, Norm(m.Vertex - p));
    }
    Append(set, p, -least, ConstraintSet::Outer, -1);
  }
}

std::vector<double> EdgeLengths(const ContourSet& contours)
{
  std::vector<double> lengths;
  for (const Contour& contour : contours.Contours)
  {
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Point3& a = contours.Points[contour.Points[i]];
      const Point3& b = contours.Points[contour.Points[(i + 1) % contour.Points.size()]];
      lengths.push_back(Norm(b - a));
    }
  }
  return lengths;
}

void CheckResampledPoints(const ContourSet& contours, double spacing)
{
  const std::vector<double> lengths = EdgeLengths(contours);
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (spacing > 0 && length / spacing > MostResampledPoints)
  {
    throw Error("ResampleSpacing " + Text(spacing) + " would make about " + Text(length / spacing) +
      " contour points, more than the " + Text(MostResampledPoints) + " allowed: choose " +
      Text(1.01 * length / MostResampledPoints) + " or more.");
  }
}

void CheckPositive(double value, const char* name, const char* meaningOfZero)
{
  if (!(value >= 0) || !std::isfinite(value))
  {
    throw Error(
      std::string(name) + " must be positive, or 0 " + meaningOfZero + ", and a finite number.");
  }
}
}

bool AllLevelsParallel(const ContourSet& contours)
{
  return std::all_of(contours.Levels.begin(), contours.Levels.end(),
    [&contours](const Level& level) {
      return Norm(Cross(level.Frame.Normal, contours.Levels.front().Frame.Normal)) < ParallelSine;
    });
}

void CheckConstraintInput(const ContourSet& contours, const ConstraintOptions& options)
{
  CheckPositive(options.MarginDistance, "MarginDistance", "to have it chosen from the sampling");
  CheckPositive(options.ResampleSpacing, "ResampleSpacing", "to keep the points");
  CheckPositive(options.ResampleTolerance, "ResampleTolerance", "to keep the points");
  if (!(options.MergeBox >= 0 && options.MergeBox < 1))
  {
    throw Error("MergeBox must be a part, between 0 and 1, of the bounding box.");
  }
  if (contours.Contours.empty())
  {
    throw Error("There is no contour to make constraints of: give at least two closed contours.");
  }
  if (contours.Levels.size() < 2)
  {
    throw Error(
      "All contours lie in one plane, where they say nothing about the space around it: add a "
      "contour on another plane.");
  }
  CheckResampledPoints(contours, options.ResampleSpacing);
  const Box3 box = contours.Bounds();
  const double diagonal = Norm(box.High - box.Low);
  if (options.MarginDistance > 0 && options.MarginDistance < LeastMarginDistance * diagonal)
  {
    throw Error(
      "MarginDistance is less than a millionth of the contours' bounding box, where inside "
      "and outside cannot be told apart any more: choose about a third of the distance "
      "between contour points, or 0.");
  }
  if (options.MarginDistance > diagonal)
  {
    throw Error(
      "MarginDistance is larger than the contours' bounding box: choose about a third of the "
      "distance between contour points, or 0.");
  }
}

double ChooseMarginDistance(const ContourSet& contours, const ConstraintOptions& options)
{
  if (options.MarginDistance > 0)
  {
    return options.MarginDistance;
  }
  return Median(EdgeLengths(contours)) / 3;
}

ConstraintSet BuildInPlaneConstraints(
  const ContourSet& contours, const ConstraintOptions& options, Monitor& monitor)
{
  CheckConstraintInput(contours, options);
  ConstraintSet set;
  set.MarginDistance = ChooseMarginDistance(contours, options);
  SubMonitor placing(monitor, 0, 0.5);
  std::vector<VertexMargins> margins = PlaceMargins(contours, set.MarginDistance, placing);
  SubMonitor reaching(monitor, 0.5, 1);
  if (options.ReachAcrossSteps && options.Values == ConstraintOptions::Distance &&
    AllLevelsParallel(contours))
  {
    ReachAcrossSteps(contours, margins, reaching);
  }
  if (options.MergeBox > 0)
  {
    margins = MergeAtCrossings(contours, margins, options.MergeBox, set.MarginDistance, set.Report);
  }
  if (options.Mode == ConstraintOptions::Margins)
  {
    AppendMargins(margins, options.Values == ConstraintOptions::Unit, set);
  }
  else
  {
    AppendCorners(contours, margins, set);
  }
  ResolveNearConstraints(set);
  monitor.Update(1, "telling inside from outside");
  return set;
}
}
