// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/FitImplicitFunction.h"

#include "Base/BoundingBox.h"
#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Implicit/Solver/AvailableMemory.h"
#include "Implicit/Solver/CentreReduction.h"
#include "Implicit/Solver/DenseRbfSystem.h"
#include "Implicit/Solver/IterativeSolver.h"
#include "Implicit/Solver/SparseRbfSystem.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
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
/// Tolerance where none is given, as a part of half the values' range.
constexpr double DefaultTolerance = 1e-5;
/// Up to here the direct solver is worth its time where the iterative one does not get there.
constexpr std::size_t DirectIsBearable = 12000;
/// Part of the free memory that a fit may take.
constexpr double MemoryShare = 0.8;
/// A support radius of more than so many of the bounding box's diagonals is refused.
constexpr double LargestSupport = 100;
/// The misfit is looked at by exact sums at all constraints up to the first number, else at the
/// second: more would be a tenth of the fit, and the fast sums that the solver ended by were held
/// against exact ones themselves.
constexpr std::size_t ExactlyCheckedAll = 16000;
constexpr std::size_t ExactlyCheckedSome = 4096;

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

/// Constraints at one place become one, at the place of the first, with the mean of their values.
Constraints MergeDuplicates(const std::vector<Point3>& points, const std::vector<double>& values,
  double distance, std::vector<std::string>& report, Monitor& monitor)
{
  constexpr std::size_t PointsPerUpdate = 16384; ///< between looks at the progress and for an abort
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
    if (i % PointsPerUpdate == 0)
    {
      monitor.Update(0, "preparing the fit");
    }
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

double AllowedGigabytes(const FunctionOptions& options)
{
  return options.MaxGigabytes > 0 ? options.MaxGigabytes : MemoryShare * AvailableGigabytes();
}

double GigabytesOf(FunctionOptions::SolverType solver, std::size_t constraints)
{
  switch (solver)
  {
    case FunctionOptions::LU:
      return LUGigabytes(constraints);
    case FunctionOptions::Iterative:
      return IterativeGigabytes(constraints);
    default:
      return ProjectedGigabytes(constraints);
  }
}

/**
 * Processor seconds of a fit of n constraints. Least squares, by eye, through what ./run bench ism measures for the
 * three shapes at 1 000 to 12 000 constraints on a core of 3.7 GHz; within a fifth from 2 000 on.
 * Direct: n^3 of the factorisation, n^2 of the matrix. Iterative: n of the preconditioner, n^2 of
 * some twelve products by exact sums. Both gain 1.7 to 1.8 times by a second thread, and faster
 * cores serve both, so that they are about equal at 2 600 constraints anywhere.
 */
constexpr double DirectSecondsN3 = 7e-12;
constexpr double DirectSecondsN2 = 1.2e-8;
constexpr double IterativeSecondsN2 = 8.2e-9;
constexpr double IterativeSecondsN = 5.3e-5;
constexpr double IterativeSeconds = 0.02;

double SecondsOf(FunctionOptions::SolverType solver, std::size_t constraints)
{
  const double n = static_cast<double>(constraints);
  return solver == FunctionOptions::Iterative
    ? IterativeSeconds + n * (IterativeSecondsN + n * IterativeSecondsN2)
    : n * n * (DirectSecondsN2 + n * DirectSecondsN3);
}

void CheckMemory(
  FunctionOptions::SolverType solver, std::size_t constraints, const FunctionOptions& options)
{
  const double need = GigabytesOf(solver, constraints);
  const double allowed = AllowedGigabytes(options);
  if (need <= allowed)
  {
    return;
  }
  const bool iterative = solver == FunctionOptions::Iterative;
  throw Error(std::to_string(constraints) + " constraints need " + Text(need) +
    " GB, more than the " + Text(allowed) + " GB allowed: resample the contours" +
    (iterative ? "." : ", or choose the iterative solver."));
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

  /// Weights and polynomial; function gets Iterations and sentences.
  RbfSolution Solve(Monitor& monitor, ImplicitFunction& function) const
  {
    const std::size_t n = this->Target.size();
    if (this->Options.Kind == Kernel::Wendland)
    {
      return this->SolveDirectly(this->Options.Solver, monitor, function);
    }
    const FunctionOptions::SolverType solver = ChooseSolver(n, this->Options);
    CheckMemory(solver, n, this->Options);
    if (solver != FunctionOptions::Iterative)
    {
      return this->SolveDirectly(solver, monitor, function);
    }
    const IterativeResult result = this->SolveInSteps(monitor, function);
    const bool canBeBetter = this->Options.Solver == FunctionOptions::Automatic &&
      n <= DirectIsBearable && ProjectedGigabytes(n) <= AllowedGigabytes(this->Options);
    if (result.Converged || !canBeBetter)
    {
      return result.Solution;
    }
    function.Report.push_back("It was solved directly instead.");
    return this->SolveDirectly(FunctionOptions::Direct, monitor, function);
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
  RbfSolution SolveDirectly(
    FunctionOptions::SolverType solver, Monitor& monitor, ImplicitFunction& function) const
  {
    const auto system = this->Factorise(solver, monitor, function.Report);
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

  IterativeResult SolveInSteps(Monitor& monitor, ImplicitFunction& function) const
  {
    const auto [least, largest] = std::minmax_element(this->Target.begin(), this->Target.end());
    const double tolerance = this->Options.Tolerance > 0
      ? this->Options.Tolerance
      : DefaultTolerance * 0.5 * (*largest - *least);
    IterativeResult result = SolveIteratively(this->Problem, this->Target, tolerance, monitor);
    function.Iterations = result.Iterations;
    function.Residual = this->Problem.Lambda > 0 ? 0 : result.Misfit;
    if (!result.Converged)
    {
      function.Report.push_back("The iterative solver stopped after " +
        std::to_string(result.Iterations) + " steps at a misfit of " + Text(result.Misfit) +
        ", above the tolerance of " + Text(tolerance) +
        ", because it no longer fell: constraints contradict each other or lie too close together; "
        "merge near points, enlarge the margin distance or the tolerance.");
    }
    return result;
  }

  double SupportRadius() const
  {
    return this->Options.SupportRadius > 0 ? this->Options.SupportRadius : 0.5 * this->Ball.Scale;
  }

  std::unique_ptr<RbfSystem> Factorise(
    FunctionOptions::SolverType solver, Monitor& monitor, std::vector<std::string>& report) const
  {
    std::unique_ptr<RbfSystem> system;
    if (this->Options.Kind == Kernel::Wendland)
    {
      system = FactoriseSparse(this->Problem, monitor);
    }
    else if (solver == FunctionOptions::LU)
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

double LargestMisfit(ImplicitFunction& function, int threads, Monitor& monitor)
{
  const std::size_t n = function.Centres.size();
  const std::size_t checked = n <= ExactlyCheckedAll ? n : ExactlyCheckedSome;
  std::vector<Point3> points;
  std::vector<double> values;
  for (std::size_t k = 0; k < checked; ++k)
  {
    const std::size_t i = k * n / checked;
    points.push_back(function.Centres[i]);
    values.push_back(function.Values[i]);
  }
  const std::vector<double> f = function.Evaluate(points, threads, monitor);
  // By fast sums the iterative solver has looked at all.
  double largest = checked < n ? function.Residual : 0;
  for (std::size_t k = 0; k < checked; ++k)
  {
    // A NaN must not hide: the negated comparison takes it.
    const double misfit = std::abs(f[k] - values[k]);
    largest = !(misfit <= largest) ? misfit : largest;
  }
  if (checked < n)
  {
    function.Report.push_back("The residual was evaluated by exact sums at " +
      std::to_string(checked) + " of " + std::to_string(n) + " constraints" +
      (function.Residual > 0 ? ", by fast ones at all." : "."));
  }
  return largest;
}

void CheckOptions(const FunctionOptions& options)
{
  if (!(options.Smoothing >= 0) || !std::isfinite(options.Smoothing))
  {
    throw Error("Smoothing must be 0 or positive.");
  }
  if (!(options.Tolerance >= 0) || !std::isfinite(options.Tolerance))
  {
    throw Error("Tolerance must be positive, or 0 to have it chosen.");
  }
  if (!(options.CentreReduction >= 0) || !std::isfinite(options.CentreReduction))
  {
    throw Error("CentreReduction must be positive, or 0 to make every constraint a centre.");
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

FunctionOptions::SolverType ChooseSolver(std::size_t constraints, const FunctionOptions& options)
{
  if (options.Solver != FunctionOptions::Automatic)
  {
    return options.Solver;
  }
  const bool direct = SecondsOf(FunctionOptions::Direct, constraints) <=
      SecondsOf(FunctionOptions::Iterative, constraints) &&
    GigabytesOf(FunctionOptions::Direct, constraints) <= AllowedGigabytes(options);
  return direct ? FunctionOptions::Direct : FunctionOptions::Iterative;
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
  const double diagonal = Box3::Around(points).Diagonal();
  if (options.SupportRadius > LargestSupport * diagonal)
  {
    throw Error("SupportRadius is more than " + Text(LargestSupport) +
      " times as large as the constraints' bounding box, so that all constraints look the same: "
      "choose about a quarter of the box's diagonal, or 0.");
  }
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
    ? MergeDuplicates(points, values, distance, function.Report, monitor)
    : Constraints{ { points.front() }, { values.front() } };
  const Fitter fitter(merged, options);
  if (merged.Points.size() < 4 || fitter.Flat())
  {
    throw Error(
      "All constraints lie in one plane, where they say nothing about the space around it: add "
      "contours on other planes.");
  }

  if (options.CentreReduction > 0)
  {
    ImplicitFunction reduced = FitWithFewCentres(merged.Points, merged.Values, options, monitor);
    reduced.Report.insert(reduced.Report.begin(), function.Report.begin(), function.Report.end());
    return reduced;
  }

  SubMonitor solving(monitor, 0, 0.95);
  const RbfSolution solution = fitter.Solve(solving, function);
  fitter.ScaleBack(solution, function);
  function.Centres = merged.Points;
  function.Values = merged.Values;
  SubMonitor checking(monitor, 0.95, 1);
  function.Residual = LargestMisfit(function, options.Threads, checking);
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
  monitor.Update(1, "fitting");
  return function;
}
}
