// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImplicitFunction.h"
#include "PointGrid.h"
#include "RbfSystem.h"
#include "SubMonitor.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

namespace recon
{
namespace
{
/// A misfit above this part of the largest value is worth a sentence.
constexpr double SuspiciousMisfit = 1e-4;
/// Points whose spread in the third direction is less than this part of the first are in one plane;
/// the spread is a square root, so rounding alone makes about 1e-8.
constexpr double FlatRatio = 1e-7;

std::string Text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string Text(const Point3& p)
{
  return "(" + Text(p[0]) + ", " + Text(p[1]) + ", " + Text(p[2]) + ")";
}

void CheckInput(const std::vector<Point3>& points, const std::vector<double>& values)
{
  if (points.size() != values.size())
  {
    throw Error("There are " + std::to_string(points.size()) + " constraint points but " +
      std::to_string(values.size()) + " values: give every point one value.");
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!std::isfinite(points[i][0] + points[i][1] + points[i][2]) || !std::isfinite(values[i]))
    {
      throw Error("Constraint " + std::to_string(i) +
        " has a coordinate or a value that is not a finite number: leave it out.");
    }
  }
}

struct Constraints
{
  std::vector<Point3> Points;
  std::vector<double> Values;
};

double DiagonalOf(const std::vector<Point3>& points)
{
  Point3 low = points.front();
  Point3 high = low;
  for (const Point3& p : points)
  {
    for (int a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  return Norm(high - low);
}

/// Constraints at one place become one, at the place of the first, with the mean of their values.
Constraints MergeDuplicates(const std::vector<Point3>& points, const std::vector<double>& values,
  double distance, std::vector<std::string>& report)
{
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double sameValue = 1e-9 * (*largest - *least);
  const PointGrid grid(points, distance);
  std::vector<char> taken(points.size(), 0);
  Constraints merged;
  std::size_t duplicates = 0;
  std::size_t contradictions = 0;
  std::string example;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (taken[i])
    {
      continue;
    }
    double sum = 0;
    double low = values[i];
    double high = values[i];
    int count = 0;
    grid.ForNear(points[i], distance,
      [&](int j, double)
      {
        if (!taken[j])
        {
          taken[j] = 1;
          sum += values[j];
          low = std::min(low, values[j]);
          high = std::max(high, values[j]);
          ++count;
        }
      });
    merged.Points.push_back(points[i]);
    merged.Values.push_back(count == 1 ? values[i] : sum / count);
    duplicates += count - 1;
    if (high - low > sameValue)
    {
      ++contradictions;
      if (example.empty())
      {
        example = Text(points[i]) + " asks for " + Text(low) + " and " + Text(high);
      }
    }
  }
  if (duplicates > 0)
  {
    report.push_back(std::to_string(duplicates) +
      " constraints lay where another one is and were merged with it.");
  }
  if (contradictions > 0)
  {
    report.push_back(std::to_string(contradictions) +
      " places ask for different values and got their mean; the first: " + example + ".");
  }
  return merged;
}

/// x -> (x - Origin) / Scale, into the unit ball.
struct UnitBall
{
  Point3 Origin{ 0, 0, 0 };
  double Scale = 1;

  explicit UnitBall(const std::vector<Point3>& points)
  {
    Point3 low = points.front();
    Point3 high = low;
    for (const Point3& p : points)
    {
      for (int a = 0; a < 3; ++a)
      {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
    }
    this->Origin = 0.5 * (low + high);
    this->Scale = 0.5 * Norm(high - low);
  }

  std::vector<Point3> Map(const std::vector<Point3>& points) const
  {
    std::vector<Point3> mapped;
    mapped.reserve(points.size());
    for (const Point3& p : points)
    {
      mapped.push_back((1 / this->Scale) * (p - this->Origin));
    }
    return mapped;
  }
};

/// A linear polynomial is determined by points that are not all in one plane, and by no others.
bool IsFlat(const std::vector<Point3>& unitPoints)
{
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Point3& p : unitPoints)
  {
    mean += Eigen::Vector3d(p[0], p[1], p[2]) / static_cast<double>(unitPoints.size());
  }
  for (const Point3& p : unitPoints)
  {
    const Eigen::Vector3d d = Eigen::Vector3d(p[0], p[1], p[2]) - mean;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[0])) <=
    FlatRatio * std::sqrt(solver.eigenvalues()[2]);
}

void CheckMemory(std::size_t constraints, const FunctionOptions& options)
{
  if (options.Kind == Kernel::Wendland)
  {
    return;
  }
  const double need = options.Solver == FunctionOptions::LU ? LUGigabytes(constraints)
                                                            : ProjectedGigabytes(constraints);
  if (need > options.MaxGigabytes)
  {
    throw Error(std::to_string(constraints) + " constraints need a matrix of " + Text(need) +
      " GB, more than the " + Text(options.MaxGigabytes) +
      " GB allowed: resample the contours, or choose the Wendland kernel.");
  }
}

/// The function in unit-ball coordinates, whose parts are then scaled back.
class Fitter
{
public:
  Fitter(const Constraints& constraints, const FunctionOptions& options)
    : Options(options),
      Ball(constraints.Points),
      Target(constraints.Values)
  {
    this->Problem.Points = this->Ball.Map(constraints.Points);
    this->Problem.Phi.Kind = options.Kind;
    this->Problem.Phi.Radius = this->SupportRadius() / this->Ball.Scale;
    this->Problem.Lambda = options.Smoothing;
    this->Problem.Threads = options.Threads;
    if (options.Kind == Kernel::Wendland)
    {
      this->Background = *std::min_element(this->Target.begin(), this->Target.end());
    }
  }

  bool Flat() const { return IsFlat(this->Problem.Points); }

  RbfSolution Solve(Monitor& monitor, std::vector<std::string>& report) const
  {
    const auto system = this->Factorise(monitor, report);
    std::vector<double> right = this->Target;
    for (double& h : right)
    {
      h -= this->Background;
    }
    RbfSolution solution = system->Solve(right);
    // One step of iterative refinement: what cancels in the weights comes back for the price of one
    // product.
    const RbfSolution step = system->Solve(this->MisfitOf(solution, right));
    for (std::size_t j = 0; j < right.size(); ++j)
    {
      solution.Weights[j] += step.Weights[j];
    }
    for (int a = 0; a < 4; ++a)
    {
      solution.Polynomial[a] += step.Polynomial[a];
    }
    solution.Polynomial[0] += this->Background;
    return solution;
  }

  /// From the unit ball to the units of the input: phi(r / s) = phi(r) / s^3 for |r|^3.
  void ScaleBack(const RbfSolution& solution, ImplicitFunction& function) const
  {
    const double s = this->Ball.Scale;
    const double factor = this->Options.Kind == Kernel::Triharmonic ? 1 / (s * s * s) : 1;
    function.Phi.Kind = this->Options.Kind;
    function.Phi.Radius = this->SupportRadius();
    function.Origin = this->Ball.Origin;
    function.Polynomial = { solution.Polynomial[0], solution.Polynomial[1] / s,
      solution.Polynomial[2] / s, solution.Polynomial[3] / s };
    function.Weights = solution.Weights;
    for (double& w : function.Weights)
    {
      w *= factor;
    }
  }

private:
  double SupportRadius() const
  {
    return this->Options.SupportRadius > 0 ? this->Options.SupportRadius : 0.5 * this->Ball.Scale;
  }

  std::unique_ptr<RbfSystem> Factorise(Monitor& monitor, std::vector<std::string>& report) const
  {
    std::unique_ptr<RbfSystem> system;
    if (this->Options.Kind == Kernel::Wendland)
    {
      system = FactoriseSparse(this->Problem, monitor);
    }
    else if (this->Options.Solver == FunctionOptions::LU)
    {
      system = FactoriseLU(this->Problem, monitor);
    }
    else
    {
      system = FactoriseProjected(this->Problem, monitor);
      if (!system)
      {
        report.push_back(
          "The matrix is not positive definite to working precision, because constraints "
          "lie too close together for their spread; it was solved by LU instead.");
        system = FactoriseLU(this->Problem, monitor);
      }
    }
    if (!system)
    {
      throw Error(
        "The implicit function cannot be solved for: its matrix is singular to working "
        "precision; merge near points, enlarge the margin distance or set a little smoothing.");
    }
    return system;
  }

  std::vector<double> MisfitOf(const RbfSolution& solution, const std::vector<double>& right) const
  {
    ImplicitFunction unit;
    unit.Phi = this->Problem.Phi;
    unit.Centres = this->Problem.Points;
    unit.Weights = solution.Weights;
    unit.Polynomial = solution.Polynomial;
    std::vector<double> misfit = unit.Evaluate(unit.Centres, this->Options.Threads);
    for (std::size_t j = 0; j < misfit.size(); ++j)
    {
      misfit[j] = right[j] - (misfit[j] + this->Problem.Lambda * solution.Weights[j]);
    }
    return misfit;
  }

  FunctionOptions Options;
  UnitBall Ball;
  std::vector<double> Target;
  double Background = 0;
  RbfProblem Problem;
};

double LargestMisfit(const ImplicitFunction& function, int threads)
{
  const std::vector<double> f = function.Evaluate(function.Centres, threads);
  double largest = 0;
  for (std::size_t j = 0; j < f.size(); ++j)
  {
    // A NaN must not hide: the negated comparison takes it.
    const double misfit = std::abs(f[j] - function.Values[j]);
    largest = !(misfit <= largest) ? misfit : largest;
  }
  return largest;
}

void CheckOptions(const FunctionOptions& options)
{
  if (!(options.Smoothing >= 0) || !std::isfinite(options.Smoothing))
  {
    throw Error("Smoothing must be 0 or positive.");
  }
  if (!(options.SupportRadius >= 0) || !std::isfinite(options.SupportRadius))
  {
    throw Error("SupportRadius must be positive, or 0 to have it chosen.");
  }
  if (!(options.MergeTolerance >= 0 && options.MergeTolerance < 1))
  {
    throw Error(
      "The merge tolerance must be a part, between 0 and 1, of the bounding box's diagonal.");
  }
}
}

ImplicitFunction FitImplicitFunction(const std::vector<Point3>& points,
  const std::vector<double>& values, const FunctionOptions& options, Monitor& monitor)
{
  CheckOptions(options);
  CheckInput(points, values);
  if (points.size() < 4)
  {
    throw Error("An implicit function needs at least four constraints; there are " +
      std::to_string(points.size()) + ".");
  }
  const double diagonal = DiagonalOf(points);
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double range = *largest - *least;
  if (!(range > 0))
  {
    throw Error("All constraints have the value " + Text(values.front()) +
      ": at least one inside or outside constraint is needed beside those on the surface.");
  }

  ImplicitFunction function;
  const double distance = std::max(options.MergeTolerance, 1e-15) * diagonal;
  const Constraints merged = diagonal > 0
    ? MergeDuplicates(points, values, distance, function.Report)
    : Constraints{ { points.front() }, { values.front() } };
  CheckMemory(merged.Points.size(), options);
  const Fitter fitter(merged, options);
  if (merged.Points.size() < 4 || fitter.Flat())
  {
    throw Error(
      "All constraints lie in one plane, where they say nothing about the space around it: add "
      "contours on other planes.");
  }

  SubMonitor solving(monitor, 0, 0.95);
  const RbfSolution solution = fitter.Solve(solving, function.Report);
  fitter.ScaleBack(solution, function);
  function.Centres = merged.Points;
  function.Values = merged.Values;
  function.Residual = LargestMisfit(function, options.Threads);
  if (!std::isfinite(function.Residual))
  {
    throw Error(
      "The implicit function cannot be solved for: the weights are not finite; merge near points, "
      "enlarge the margin distance or set a little smoothing.");
  }
  if (options.Smoothing == 0 && function.Residual > SuspiciousMisfit * range)
  {
    function.Report.push_back("The function misses a constraint by " + Text(function.Residual) +
      ": the system is ill-conditioned; merge near points or enlarge the margin distance.");
  }
  monitor.Update(1, "solving for the weights");
  return function;
}
}
