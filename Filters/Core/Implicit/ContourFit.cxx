// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContourFit.h"

#include "ContourResampling.h"
#include "PointGrid.h"
#include "SubMonitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// Cosine that the second fit's normals keep with the first's (guard 2). 0.8 lets thin parts of
/// hand_ok go, 0.95 takes from eight_15 what refining wins.
constexpr double LeastAgreement = 0.9;
/// Fits of guard 2 before it gives the set up.
constexpr int MaximumFits = 5;
/// Every how manieth level is left out (guard 3), and how many levels that takes.
constexpr int LeaveOutEvery = 3;
constexpr std::size_t LeastLevelsToJudge = 6;
/// A margin that finds no room shrinks by this, down to this part of d.
constexpr double ShrinkStep = 0.7;
constexpr double LeastMargin = 0.05;

/// A contour vertex and the numbers of its constraints; -1 where it has no such margin.
struct Vertex
{
  int Boundary = -1;
  int Inner = -1;
  int Outer = -1;
};

std::vector<Vertex> VerticesOf(const ConstraintSet& set)
{
  std::vector<Vertex> vertices;
  for (int i = 0; i < static_cast<int>(set.Points.size()); ++i)
  {
    switch (set.Kind[i])
    {
      case ConstraintSet::Boundary:
        vertices.push_back({ i, -1, -1 });
        break;
      case ConstraintSet::Inner:
        vertices.back().Inner = i;
        break;
      default:
        vertices.back().Outer = i;
        break;
    }
  }
  return vertices;
}

std::vector<Point3> PlacesOf(const ConstraintSet& set, const std::vector<Vertex>& vertices)
{
  std::vector<Point3> places;
  places.reserve(vertices.size());
  for (const Vertex& v : vertices)
  {
    places.push_back(set.Points[v.Boundary]);
  }
  return places;
}

/// One fit refined: its state between the guards.
class Refinement
{
public:
  Refinement(const ConstraintSet& inPlane, bool unit, const FunctionOptions& options)
    : InPlane(inPlane),
      Vertices(VerticesOf(inPlane)),
      Places(PlacesOf(inPlane, Vertices)),
      Unit(unit),
      Options(options)
  {
  }

  /// @returns false where guard 2 gave up; then constraints and function are those of one fit.
  bool Run(const ImplicitFunction& first, Monitor& monitor)
  {
    this->Normals = first.EvaluateGradients(this->Places, this->Options.Threads);
    this->Refined = this->InPlane;
    this->PlaceMargins();
    for (int fit = 0; fit < MaximumFits; ++fit)
    {
      SubMonitor fitting(
        monitor, static_cast<double>(fit) / MaximumFits, (fit + 1.0) / MaximumFits);
      this->Function =
        FitImplicitFunction(this->Refined.Points, this->Refined.Values, this->Options, fitting);
      if (!this->TakeBackBadContours())
      {
        return true;
      }
    }
    return false;
  }

  ConstraintSet Refined;
  ImplicitFunction Function;
  std::size_t TakenBack = 0;

private:
  void PlaceMargins()
  {
    const double d = this->InPlane.MarginDistance;
    const PointGrid grid(this->Places, d);
    for (std::size_t k = 0; k < this->Vertices.size(); ++k)
    {
      const double steep = Norm(this->Normals[k]);
      if (!(steep > 0))
      {
        continue;
      }
      const Vector3 inward = (1 / steep) * this->Normals[k];
      this->PlaceMargin(grid, static_cast<int>(k), this->Vertices[k].Inner, inward, 1);
      this->PlaceMargin(grid, static_cast<int>(k), this->Vertices[k].Outer, inward, -1);
    }
  }

  void PlaceMargin(const PointGrid& grid, int k, int constraint, const Vector3& inward, int side)
  {
    if (constraint < 0)
    {
      return;
    }
    const double d = this->InPlane.MarginDistance;
    for (double t = d; t >= LeastMargin * d; t *= ShrinkStep)
    {
      const Point3 place = this->Places[k] + (side * t) * inward;
      const int nearest = grid.Nearest(place, t);
      // Rounding may leave the vertex itself a hair outside the radius.
      if (nearest < 0 || this->Places[nearest] == this->Places[k])
      {
        this->Refined.Points[constraint] = place;
        this->Refined.Values[constraint] = side * (this->Unit ? 1 : t);
        return;
      }
    }
  }

  bool IsBad(std::size_t k, const std::vector<double>& atMargins,
    const std::vector<Vector3>& gradients) const
  {
    const Vertex& v = this->Vertices[k];
    const double lengths = Norm(gradients[k]) * Norm(this->Normals[k]);
    return (v.Inner >= 0 && !(atMargins[v.Inner] > 0)) ||
      (v.Outer >= 0 && !(atMargins[v.Outer] < 0)) ||
      !(Dot(gradients[k], this->Normals[k]) >= LeastAgreement * lengths);
  }

  /// @returns true where a contour lost its refined margins.
  bool TakeBackBadContours()
  {
    const std::vector<double> atMargins =
      this->Function.Evaluate(this->InPlane.Points, this->Options.Threads);
    const std::vector<Vector3> gradients =
      this->Function.EvaluateGradients(this->Places, this->Options.Threads);
    const int contours =
      1 + *std::max_element(this->InPlane.Contour.begin(), this->InPlane.Contour.end());
    std::vector<char> bad(contours, 0);
    bool changed = false;
    for (std::size_t k = 0; k < this->Vertices.size(); ++k)
    {
      if (!this->IsBad(k, atMargins, gradients))
      {
        continue;
      }
      const int contour = this->InPlane.Contour[this->Vertices[k].Boundary];
      if (contour >= 0)
      {
        bad[contour] = 1;
      }
      else
      {
        // A merged point belongs to several contours: it alone goes back.
        changed = this->TakeBack(this->Vertices[k]) || changed;
      }
    }
    for (const Vertex& v : this->Vertices)
    {
      const int contour = this->InPlane.Contour[v.Boundary];
      if (contour >= 0 && bad[contour])
      {
        changed = this->TakeBack(v) || changed;
      }
    }
    return changed;
  }

  bool TakeBack(const Vertex& v)
  {
    bool changed = false;
    for (const int i : { v.Inner, v.Outer })
    {
      if (i >= 0 && this->Refined.Points[i] != this->InPlane.Points[i])
      {
        this->Refined.Points[i] = this->InPlane.Points[i];
        this->Refined.Values[i] = this->InPlane.Values[i];
        changed = true;
      }
    }
    this->TakenBack += changed ? 1 : 0;
    return changed;
  }

  const ConstraintSet& InPlane;
  std::vector<Vertex> Vertices;
  std::vector<Point3> Places;
  std::vector<Vector3> Normals;
  bool Unit;
  FunctionOptions Options;
};

/// The levels that are, or are not, left out for guard 3. Points keep their numbers.
ContourSet Part(const ContourSet& contours, bool leftOut)
{
  ContourSet part = contours;
  part.Levels.clear();
  part.Contours.clear();
  for (std::size_t l = 0; l < contours.Levels.size(); ++l)
  {
    // The first and the last level stay: beyond them nothing can be predicted.
    const bool isLeftOut = l % LeaveOutEvery == 1 && l + 1 < contours.Levels.size();
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

/// Mean distance, to first order, of the contours' vertices from the function's surface.
double MeanMiss(
  const ImplicitFunction& function, const ContourSet& contours, double limit, int threads)
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
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double miss = std::abs(f[i]) / Norm(g[i]);
    // Where the surface missed the place altogether the first order means nothing but "far".
    sum += miss < limit ? miss : limit;
  }
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

ConstraintOptions DistanceOptions(const ConstraintOptions& options)
{
  ConstraintOptions first = options;
  first.Values = ConstraintOptions::Distance;
  return first;
}

/// Guard 3: does refining predict levels that it has not seen no worse than one fit does?
bool RefiningPredicts(const ContourSet& contours, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  const ContourSet seen = Part(contours, false);
  const ContourSet unseen = Part(contours, true);
  if (contours.Levels.size() < LeastLevelsToJudge || unseen.Contours.empty())
  {
    return true;
  }
  const ConstraintSet inPlane = BuildInPlaneConstraints(seen, constraintOptions, monitor);
  SubMonitor fitting(monitor, 0, 0.4);
  const ImplicitFunction first =
    FitImplicitFunction(inPlane.Points, inPlane.Values, functionOptions, fitting);
  const bool unit = constraintOptions.Values == ConstraintOptions::Unit;
  Refinement refinement(inPlane, unit, functionOptions);
  SubMonitor refining(monitor, 0.4, 1);
  if (!refinement.Run(first, refining))
  {
    return false;
  }
  const double limit =
    0.1 * Norm(contours.Points.front() - contours.Points.back()) + 10 * inPlane.MarginDistance;
  return MeanMiss(refinement.Function, unseen, limit, functionOptions.Threads) <=
    MeanMiss(first, unseen, limit, functionOptions.Threads);
}

void Refine(ContourFit& fit, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  SubMonitor judging(monitor, 0, 0.4);
  if (!RefiningPredicts(fit.Contours, constraintOptions, functionOptions, judging))
  {
    fit.Constraints.Report.push_back(
      "Margins stay in the contours' planes: refined, the surface would miss "
      "contours that are left out by more.");
    return;
  }
  ImplicitFunction first = fit.Function;
  const bool unit = constraintOptions.Values == ConstraintOptions::Unit;
  if (unit)
  {
    // Distances tell the normals better than +1 and -1 do.
    SubMonitor silent(monitor, 0.4, 0.5);
    const ConstraintSet distances =
      BuildInPlaneConstraints(fit.Contours, DistanceOptions(constraintOptions), silent);
    first = FitImplicitFunction(distances.Points, distances.Values, functionOptions, silent);
  }
  Refinement refinement(fit.Constraints, unit, functionOptions);
  SubMonitor refining(monitor, 0.5, 1);
  if (!refinement.Run(first, refining))
  {
    fit.Constraints.Report.push_back(
      "Margins stay in the contours' planes: refined, they would contradict the "
      "contours.");
    return;
  }
  if (refinement.TakenBack > 0)
  {
    refinement.Refined.Report.push_back(std::to_string(refinement.TakenBack) + " of " +
      std::to_string(fit.Constraints.Points.size() / 3) +
      " contour points keep margins in their plane, because refined ones would contradict a "
      "contour.");
  }
  fit.Constraints = std::move(refinement.Refined);
  fit.Function = std::move(refinement.Function);
}
}

ContourSet PrepareContours(const ContourSet& contours, const ConstraintOptions& options)
{
  CheckConstraintInput(contours, options);
  ContourSet prepared = contours;
  if (options.ResampleTolerance > 0)
  {
    prepared = ResampleToTolerance(prepared, options.ResampleTolerance);
  }
  if (options.ResampleSpacing > 0)
  {
    prepared = ResampleToSpacing(prepared, options.ResampleSpacing);
  }
  return prepared;
}

ContourFit FitContours(const ContourSet& contours, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, Monitor& monitor)
{
  const bool refined = constraintOptions.Normals == ConstraintOptions::Refined &&
    constraintOptions.Mode == ConstraintOptions::Margins;
  ContourFit fit;
  fit.Contours = PrepareContours(contours, constraintOptions);
  SubMonitor placing(monitor, 0, 0.1);
  fit.Constraints = BuildInPlaneConstraints(fit.Contours, constraintOptions, placing);
  SubMonitor fitting(monitor, 0.1, refined ? 0.4 : 1);
  fit.Function =
    FitImplicitFunction(fit.Constraints.Points, fit.Constraints.Values, functionOptions, fitting);
  if (refined)
  {
    SubMonitor refining(monitor, 0.4, 1);
    Refine(fit, constraintOptions, functionOptions, refining);
  }
  return fit;
}
}
