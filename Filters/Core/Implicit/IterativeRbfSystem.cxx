// SPDX-License-Identifier: GPL-3.0-or-later
#include "IterativeRbfSystem.h"

#include "../Parallel.h"
#include "FastKernelSum.h"
#include "InverseCholesky.h"
#include "KernelSums.h"
#include "SubMonitor.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace recon
{
namespace
{
using Vector = std::vector<double>;

/// Conjugate gradients aim a little below the tolerance, as their own residual drifts from the
/// true one.
constexpr double AimBelow = 0.7;
/// A descent has stalled where this many steps did not halve its least residual; a fit has where a
/// restart from the true residual did not bring it down by this factor.
constexpr int PatientSteps = 60;
constexpr double LeastGain = 0.5;
constexpr int MaximumSteps = 2000;
/// Exact sums up to so many centres: there they are the faster ones (measured).
constexpr std::size_t ExactSums = 16000;
/**
 * A product's error times the step's length stays in the residual. This is the part of the aim that
 * accuracy times the sum of the step's |w_j| may take: kernels are up to 8, projecting multiplies
 * by some more, and there are tens of steps. Early steps are long and need all digits, late ones
 * few. Measured at 30 000: 0.1 is too much, 0.01 gains nothing; at 300 000, 0.004 is too much and
 * costs a second descent, 0.001 is not: errors add up over the centres.
 */
constexpr double FirstErrorShare = 0.02;
constexpr double FewCentres = 30000;

double ErrorShareOf(std::size_t centres)
{
  const double few = std::min(1.0, FewCentres / static_cast<double>(centres));
  return FirstErrorShare * few * std::sqrt(few);
}
/// Where a descent did not help, products are so much more accurate in the next, for so many times.
constexpr double Tighten = 0.1;
constexpr int MaximumFailures = 2;
constexpr double LoosestAccuracy = 1e-6;

/// Shares of the progress bar.
constexpr double Ordered = 0.05;
constexpr double Prepared = 0.3;

double Product(const Vector& a, const Vector& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}

double SumOfSizes(const Vector& a)
{
  double sum = 0;
  for (const double x : a)
  {
    sum += std::abs(x);
  }
  return sum;
}

double LargestOf(const Vector& a)
{
  double largest = 0;
  for (const double x : a)
  {
    // A NaN must not hide: the negated comparison takes it.
    largest = !(std::abs(x) <= largest) ? std::abs(x) : largest;
  }
  return largest;
}

/// Phi w at the centres: by exact sums for few of them, else by fast ones.
class KernelProduct
{
public:
  KernelProduct(const std::vector<Point3>& centres, int threads)
    : Centres(centres),
      Threads(threads)
  {
    if (centres.size() > ExactSums)
    {
      this->Fast = std::make_unique<FastKernelSum>(centres, FastKernelSum::FinestAccuracy, threads);
    }
  }

  bool IsExact() const { return !this->Fast; }

  Vector operator()(const Vector& w, double accuracy, Monitor& monitor)
  {
    if (this->Fast)
    {
      this->Fast->SetAccuracy(std::clamp(accuracy, FastKernelSum::FinestAccuracy, LoosestAccuracy));
      this->Fast->SetWeights(w, monitor);
      return this->Fast->ValuesAtCentres(monitor);
    }
    constexpr std::size_t PointsPerPiece = 64;
    const std::size_t n = this->Centres.size();
    Vector sums(n);
    ParallelFor(static_cast<int>((n + PointsPerPiece - 1) / PointsPerPiece), this->Threads,
      [&](int piece)
      {
        const std::size_t from = static_cast<std::size_t>(piece) * PointsPerPiece;
        SumKernels(Kernel{}, this->Centres, w, this->Centres.data() + from,
          std::min(PointsPerPiece, n - from), sums.data() + from);
      },
      monitor, { 0, 1, "solving for the weights" });
    return sums;
  }

private:
  const std::vector<Point3>& Centres;
  int Threads;
  std::unique_ptr<FastKernelSum> Fast;
};

InverseCholeskyOptions PreconditionerOf(const RbfProblem& problem)
{
  InverseCholeskyOptions options;
  options.Lambda = problem.Lambda;
  options.Threads = problem.Threads;
  return options;
}

/// Says how far the misfit has come on its way, on a logarithmic scale, and can be stopped anywhere
/// between.
class DescentMonitor final : public Monitor
{
public:
  DescentMonitor(Monitor& parent, double tolerance) : Parent(parent), Tolerance(tolerance) {}

  bool AbortRequested() override { return this->Parent.AbortRequested(); }

  void Tell(double misfit, int steps)
  {
    this->First = std::max(this->First, misfit);
    const double way = std::log(this->First / this->Tolerance);
    const double gone = std::log(this->First / std::max(misfit, this->Tolerance));
    this->Fraction = std::max(this->Fraction, way > 0 ? std::min(1.0, gone / way) : 1);
    std::snprintf(this->Stage, sizeof this->Stage, "solving: misfit %.2g of %.2g, step %d", misfit,
      this->Tolerance, steps);
    this->Update(0, this->Stage);
  }

protected:
  void OnProgress(double, const char*) override
  {
    this->Parent.Update(Prepared + (1 - Prepared) * this->Fraction, this->Stage);
  }

private:
  Monitor& Parent;
  double Tolerance;
  double First = 0;
  double Fraction = 0;
  char Stage[96] = "solving for the weights";
};

/// All vectors here are by rank.
class ConjugateGradients
{
public:
  ConjugateGradients(const RbfProblem& problem, const MaxMinOrder& order,
    const InverseCholesky& inverse, const Vector& h, double tolerance, Monitor& monitor)
    : ErrorShare(ErrorShareOf(h.size())),
      Lambda(problem.Lambda),
      Inverse(inverse),
      Multiply(order.Points(), problem.Threads),
      Right(h.size()),
      Tolerance(tolerance),
      Watch(monitor, tolerance)
  {
    for (std::size_t i = 0; i < h.size(); ++i)
    {
      this->Right[i] = h[order.Order()[i]];
    }
  }

  /// Descents, each from the true residual of the one before (iterative refinement).
  void Run()
  {
    this->Weights.assign(this->Right.size(), 0);
    this->Best = this->Weights;
    this->BestResidual = this->Right;
    this->Misfit = LargestOf(this->Inverse.Project(this->Right));
    double aim = AimBelow * this->Tolerance;
    int failures = 0;
    while (this->Misfit > this->Tolerance && this->Steps < MaximumSteps)
    {
      const double before = this->Misfit;
      this->Weights = this->Best;
      this->Descend(this->Inverse.Project(this->BestResidual), aim);
      this->Judge();
      aim *= AimBelow;
      if (this->Misfit > LeastGain * before)
      {
        this->ErrorShare *= Tighten;
        ++failures;
      }
      if (failures > (this->Multiply.IsExact() ? 0 : MaximumFailures))
      {
        break;
      }
    }
  }

  Vector Best;         ///< weights
  Vector BestResidual; ///< h less all but the polynomial
  double Misfit = 0;
  int Steps = 0;

private:
  /// The true residual; weights that are better than the best so far take their place.
  void Judge()
  {
    Vector truth = this->Product(this->Weights, FastKernelSum::FinestAccuracy);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      truth[i] = this->Right[i] - truth[i];
    }
    const double misfit = LargestOf(this->Inverse.Project(truth));
    if (misfit < this->Misfit)
    {
      this->Misfit = misfit;
      this->Best = this->Weights;
      this->BestResidual = std::move(truth);
    }
  }

  Vector Product(const Vector& w, double accuracy)
  {
    Vector y = this->Multiply(w, accuracy, this->Watch);
    for (std::size_t i = 0; i < y.size(); ++i)
    {
      y[i] += this->Lambda * w[i];
    }
    return y;
  }

  /// Steps until the residual r, projected, is below the aim or stalls. The preconditioner and the
  /// products are not exact to the last digit: beta is Polak's and Ribiere's, which forgives that.
  void Descend(Vector r, double aim)
  {
    Vector direction(r.size(), 0);
    Vector previous(r.size(), 0);
    double previousProduct = 1;
    double alpha = 1; // as the preconditioner is meant
    double least = LargestOf(r);
    int leastAt = this->Steps;
    for (double misfit = least; misfit > aim && this->Steps < MaximumSteps;)
    {
      this->Watch.Tell(misfit, this->Steps);
      const Vector z = this->Inverse.Apply(r, this->Watch);
      const double product = recon::Product(r, z);
      const double beta = (product - recon::Product(previous, z)) / previousProduct;
      for (std::size_t i = 0; i < z.size(); ++i)
      {
        direction[i] = z[i] + beta * direction[i];
      }
      previous = r;
      previousProduct = product;

      const double accuracy = this->ErrorShare * aim / (alpha * SumOfSizes(direction));
      const Vector y = this->Inverse.Project(this->Product(direction, accuracy));
      alpha = recon::Product(direction, r) / recon::Product(direction, y);
      // Not positive: what is left of the residual is rounding.
      if (!(alpha > 0) || !std::isfinite(alpha))
      {
        return;
      }
      for (std::size_t i = 0; i < y.size(); ++i)
      {
        this->Weights[i] += alpha * direction[i];
        r[i] -= alpha * y[i];
      }
      ++this->Steps;
      misfit = LargestOf(r);
      if (misfit < LeastGain * least)
      {
        least = misfit;
        leastAt = this->Steps;
      }
      if (this->Steps - leastAt > PatientSteps || !std::isfinite(misfit))
      {
        return;
      }
    }
  }

  double ErrorShare;
  double Lambda;
  const InverseCholesky& Inverse;
  KernelProduct Multiply;
  Vector Right;
  Vector Weights;
  double Tolerance;
  DescentMonitor Watch;
};
}

IterativeResult SolveIteratively(
  const RbfProblem& problem, const std::vector<double>& h, double tolerance, Monitor& monitor)
{
  SubMonitor ordering(monitor, 0, Ordered);
  const MaxMinOrder order(problem.Points, ordering);
  SubMonitor preparing(monitor, Ordered, Prepared);
  const InverseCholesky inverse(order, PreconditionerOf(problem), preparing);
  ConjugateGradients solver(problem, order, inverse, h, tolerance, monitor);
  solver.Run();

  IterativeResult result;
  result.Misfit = solver.Misfit;
  result.Iterations = solver.Steps;
  result.Converged = solver.Misfit <= tolerance;
  result.Solution.Weights.resize(h.size());
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    result.Solution.Weights[order.Order()[i]] = solver.Best[i];
  }
  const Vector& r = solver.BestResidual;
  result.Solution.Polynomial = inverse.PolynomialThrough({ r[0], r[1], r[2], r[3] });
  return result;
}

double IterativeGigabytes(std::size_t constraints)
{
  // Measured: about 200 doubles a constraint for the preconditioner, the rest for the product and
  // the vectors; and the part that is solved exactly.
  return 2.6e-6 * static_cast<double>(constraints) + 0.02;
}
}
