// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/IterativeSolver.h"

#include "Base/SubMonitor.h"
#include "Implicit/FastMultipole/DirectSums.h"
#include "Implicit/FastMultipole/FastKernelSum.h"
#include "Implicit/Solver/InverseCholesky.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

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
/// And in place of the finest fast ones, whose operators must be computed first.
constexpr std::size_t ExactSumsOrFinest = 60000;
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
/**
 * Steps that want more digits than quick sums have leave their error in the residual. Where those
 * errors may add up to so many times the aim, the residual is summed anew, once steps are so short
 * that what they still add is a hundredth of that or less. Measured: errors that may be 86, 182 and
 * 374 aims (two balls, a lung) were 1.1, 1.7 and 47 of them.
 */
constexpr double MostErrors = 30;
constexpr double ShortSteps = 0.01;
/// Where a descent did not help, products are so much more accurate in the next, for so many times.
constexpr double Tighten = 0.1;
constexpr int MaximumFailures = 2;
constexpr double LoosestAccuracy = 1e-6;
/// What the sums that a misfit is judged by may be off, as a part of the tolerance, and by how many
/// exact ones that is told.
constexpr double ErrorOfTruth = 0.1;
constexpr int ErrorSamples = 256;

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
      this->Fast =
        std::make_unique<FastKernelSum>(centres, FastKernelSum::FinestQuickAccuracy, threads);
    }
  }

  bool IsExact() const { return !this->Fast; }

  Vector operator()(const Vector& w, double accuracy, Monitor& monitor)
  {
    const double asked = std::clamp(accuracy, FastKernelSum::FinestQuickAccuracy, LoosestAccuracy);
    return this->Fast ? this->Summed(w, asked, monitor) : this->Exact(w, monitor);
  }

  /// Off by no more than is allowed, as far as a sample tells. @returns nothing where the sums of
  /// the steps are not so accurate.
  std::optional<Vector> QuicklyWithin(const Vector& w, double allowed, Monitor& monitor)
  {
    return this->Fast ? this->SummedWithin(w, FastKernelSum::FinestQuickAccuracy, allowed, monitor)
                      : this->Exact(w, monitor);
  }

  /// The same by the finest fast sums, or exact ones.
  Vector Within(const Vector& w, double allowed, Monitor& monitor)
  {
    if (this->Fast && this->Centres.size() > ExactSumsOrFinest)
    {
      std::optional<Vector> y =
        this->SummedWithin(w, FastKernelSum::FinestAccuracy, allowed, monitor);
      if (y)
      {
        return *std::move(y);
      }
    }
    return this->Exact(w, monitor);
  }

private:
  std::optional<Vector> SummedWithin(
    const Vector& w, double accuracy, double allowed, Monitor& monitor)
  {
    Vector y = this->Summed(w, accuracy, monitor);
    return this->Fast->SampledError(y, ErrorSamples) <= allowed ? std::optional(std::move(y))
                                                                : std::nullopt;
  }

  Vector Summed(const Vector& w, double accuracy, Monitor& monitor)
  {
    this->Fast->SetAccuracy(accuracy);
    this->Fast->SetWeights(w, monitor);
    return this->Fast->ValuesAtCentres(monitor);
  }

  Vector Exact(const Vector& w, Monitor& monitor) const
  {
    return SumAllKernels(Kernel{}, this->Centres, w, this->Centres, this->Threads, monitor);
  }

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
  char Stage[96] = "fitting";
};

/// All vectors here are by rank.
class ConjugateGradients
{
public:
  ConjugateGradients(const RbfProblem& problem, const MaximinOrder& order,
    const InverseCholesky& inverse, const Vector& h, double tolerance, Monitor& monitor)
    : ErrorShare(ErrorShareOf(h.size())),
      Lambda(problem.Lambda),
      Inverse(inverse),
      Multiply(order.Points(), problem.Threads),
      Tolerance(tolerance),
      Watch(monitor, tolerance)
  {
    for (const int i : order.Order())
    {
      this->Residual.push_back(h[i]);
    }
    this->Weights.assign(h.size(), 0);
    this->R = this->Inverse.Project(this->Residual);
    this->Misfit = LargestOf(this->R);
  }

  /// Descents, each from the true residual of the one before (iterative refinement).
  void Run()
  {
    double aim = AimBelow * this->Tolerance;
    int failures = 0;
    while (this->Misfit > this->Tolerance && this->Steps < MaximumSteps)
    {
      const double before = this->Misfit;
      this->Descend(aim);
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

  Vector Weights;  ///< the best so far
  Vector Residual; ///< h less all but the polynomial, with those
  double Misfit = 0;
  int Steps = 0;

private:
  /// Judges a descent by the change's own product: the smaller the change is, the less its sums can
  /// be off.
  void Judge()
  {
    const double allowed = ErrorOfTruth * this->Tolerance;
    std::optional<Vector> product =
      this->Multiply.QuicklyWithin(this->Change, allowed, this->Watch);
    if (!product)
    {
      product = this->Multiply.Within(this->Change, allowed, this->Watch);
      this->ErrorShare *= Tighten;
    }
    if (!this->Take(*std::move(product)))
    {
      this->R = this->Inverse.Project(this->Residual);
    }
  }

  /// Takes the change of the weights where it brings the true misfit down, and the true residual for
  /// the drifted one. @param product of the kernels with the change
  bool Take(Vector product)
  {
    for (std::size_t i = 0; i < product.size(); ++i)
    {
      product[i] = this->Residual[i] - (product[i] + this->Lambda * this->Change[i]);
    }
    Vector r = this->Inverse.Project(product);
    const double misfit = LargestOf(r);
    // A NaN is none.
    if (!(misfit < this->Misfit))
    {
      return false;
    }
    this->Misfit = misfit;
    this->Residual = std::move(product);
    this->R = std::move(r);
    for (std::size_t i = 0; i < this->Change.size(); ++i)
    {
      this->Weights[i] += this->Change[i];
      this->Change[i] = 0;
    }
    return true;
  }

  /// Within a descent, which goes on from there (Van der Vorst and Ye 2000: residual replacement).
  void ReplaceResidual()
  {
    this->Take(this->Multiply.Within(this->Change, ErrorOfTruth * this->Tolerance, this->Watch));
    this->Errors = 0;
    // Weights that cancel so much want more digits of the next products too.
    this->ErrorShare *= Tighten;
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

  /// Steps until the residual is below the aim or stalls.
  void Descend(double aim)
  {
    this->Change.assign(this->R.size(), 0);
    this->Direction.assign(this->R.size(), 0);
    this->Previous.assign(this->R.size(), 0);
    this->PreviousProduct = 1;
    this->Alpha = 1; // as the preconditioner is meant
    this->Errors = 0;
    double misfit = LargestOf(this->R);
    double least = misfit;
    int leastAt = this->Steps;
    while (misfit > aim && this->Steps < MaximumSteps)
    {
      this->Watch.Tell(misfit, this->Steps);
      if (!this->Step(aim))
      {
        return;
      }
      misfit = LargestOf(this->R);
      if (this->Errors > MostErrors && this->LastError < ShortSteps * MostErrors &&
        misfit < LeastGain * this->Misfit)
      {
        this->ReplaceResidual();
        misfit = LargestOf(this->R);
      }
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

  /// The preconditioner and the products are not exact to the last digit: beta is Polak's and
  /// Ribiere's, which forgives that. @returns false where what is left of the residual is rounding.
  bool Step(double aim)
  {
    const Vector z = this->Inverse.Apply(this->R, this->Watch);
    const double product = recon::Product(this->R, z);
    const double beta = (product - recon::Product(this->Previous, z)) / this->PreviousProduct;
    for (std::size_t i = 0; i < z.size(); ++i)
    {
      this->Direction[i] = z[i] + beta * this->Direction[i];
    }
    this->Previous = this->R;
    this->PreviousProduct = product;

    const double size = SumOfSizes(this->Direction);
    const double accuracy = this->ErrorShare * aim / (this->Alpha * size);
    const Vector y = this->Inverse.Project(this->Product(this->Direction, accuracy));
    const double alpha =
      recon::Product(this->Direction, this->R) / recon::Product(this->Direction, y);
    if (!(alpha > 0) || !std::isfinite(alpha))
    {
      return false;
    }
    for (std::size_t i = 0; i < y.size(); ++i)
    {
      this->Change[i] += alpha * this->Direction[i];
      this->R[i] -= alpha * y[i];
    }
    this->Alpha = alpha;
    this->LastError =
      this->Multiply.IsExact() ? 0 : FastKernelSum::FinestQuickAccuracy * alpha * size / aim;
    this->Errors += this->LastError;
    ++this->Steps;
    return true;
  }

  double ErrorShare;
  double Lambda;
  const InverseCholesky& Inverse;
  KernelProduct Multiply;
  double Tolerance;
  DescentMonitor Watch;
  Vector R;      ///< the residual, projected, that the steps carry along
  Vector Change; ///< of the weights since it was the true one
  Vector Direction;
  Vector Previous; ///< residual
  double PreviousProduct = 1;
  double Alpha = 1;  ///< of the last step
  double Errors = 0; ///< bound of what products since the true residual may be off, in aims
  double LastError = 0;
};
}

IterativeResult SolveIteratively(
  const RbfProblem& problem, const std::vector<double>& h, double tolerance, Monitor& monitor)
{
  SubMonitor ordering(monitor, 0, Ordered);
  const MaximinOrder order(problem.Points, ordering);
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
    result.Solution.Weights[order.Order()[i]] = solver.Weights[i];
  }
  const Vector& r = solver.Residual;
  result.Solution.Polynomial = inverse.PolynomialThrough({ r[0], r[1], r[2], r[3] });
  return result;
}

double IterativeGigabytes(std::size_t constraints)
{
  // Measured: about 200 doubles a constraint for the preconditioner, the rest for the product and
  // the vectors; the part that is solved exactly; and the operators of the fast sums.
  double gigabytes = 2.6e-6 * static_cast<double>(constraints) + 0.02;
  gigabytes += constraints > ExactSums ? 0.07 : 0;
  gigabytes += constraints > ExactSumsOrFinest ? 0.14 : 0;
  return gigabytes;
}
}
