// SPDX-License-Identifier: GPL-3.0-or-later
// Conjugate gradients and what they stand on: order, neighbours, preconditioner; hard inputs, ends.
#include "ConstraintShapes.h"
#include "Implicit/Solver/AvailableMemory.h"
#include "Implicit/Solver/InverseCholesky.h"
#include "Implicit/Solver/IterativeSolver.h"
#include "Implicit/Solver/MaximinOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

using namespace recon;
using shapes::Sample;

namespace
{
/// Processor seconds of this process: others that run on the machine do not count.
double Seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

ImplicitFunction Fit(
  const Sample& sample, FunctionOptions::SolverType solver, double tolerance = 0, int threads = 0)
{
  FunctionOptions options;
  options.Solver = solver;
  options.Tolerance = tolerance;
  options.Threads = threads;
  Monitor monitor;
  return FitImplicitFunction(sample.Points, sample.Values, options, monitor);
}

ImplicitFunction Iterate(const Sample& sample, double tolerance = 0, int threads = 0)
{
  return Fit(sample, FunctionOptions::Iterative, tolerance, threads);
}

double LargestMisfit(const ImplicitFunction& function, const Sample& sample)
{
  const std::vector<double> f = function.Evaluate(sample.Points, 0);
  double largest = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
  {
    largest = std::max(largest, std::abs(f[i] - sample.Values[i]));
  }
  return largest;
}

bool Says(const ImplicitFunction& function, const std::string& words)
{
  return std::any_of(function.Report.begin(), function.Report.end(),
    [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// Asks to stop when it hears of that much progress, and knows when that was and the longest
/// silence.
class Impatient final : public Monitor
{
public:
  explicit Impatient(double fraction) : Fraction(fraction) {}

  bool AbortRequested() override
  {
    this->Silence = std::max(this->Silence, Seconds() - this->Last);
    this->Last = Seconds();
    return this->Reached;
  }

  double Silence = 0;
  bool Reached = false;
  double Last = Seconds();

protected:
  void OnProgress(double fraction, const char*) override
  {
    this->Reached = fraction >= this->Fraction;
  }

private:
  double Fraction;
};
}

TEST(MaximinOrder, IsFarthestFirst)
{
  const Sample sample = shapes::WavyBall(12, 20, 0.02);
  Monitor monitor;
  const MaximinOrder order(sample.Points, monitor);
  const std::size_t n = sample.Points.size();
  std::vector<int> sorted = order.Order();
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);

  // By the definition: the distance to those before is the largest of all that are left.
  std::vector<double> left(n, 1e30);
  for (std::size_t rank = 0; rank < n; ++rank)
  {
    const std::size_t at = static_cast<std::size_t>(order.Order()[rank]);
    EXPECT_EQ(order.Points()[rank], sample.Points[at]);
    if (rank >= MaximinOrder::Simplex)
    {
      EXPECT_EQ(order.Distances()[rank], left[at]);
      EXPECT_EQ(left[at], *std::max_element(left.begin(), left.end()));
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      left[i] = std::min(left[i], Norm(sample.Points[i] - sample.Points[at]));
    }
    left[at] = -1;
  }
}

TEST(MaximinOrder, StartsWithAFatTetrahedron)
{
  // One dense contour and a single point off its plane: greed by distance alone starts flat.
  std::vector<Point3> points;
  for (int k = 0; k < 500; ++k)
  {
    points.push_back({ std::cos(0.01 * k), std::sin(0.01 * k), 0 });
  }
  points.push_back({ 0, 0, 0.05 });
  Monitor monitor;
  const MaximinOrder order(points, monitor);
  const auto& p = order.Points();
  const double volume = std::abs(Dot(p[1] - p[0], Cross(p[2] - p[0], p[3] - p[0]))) / 6;
  EXPECT_GT(volume, 0.01);
}

TEST(MaximinOrder, NearestAreThoseOfBruteForce)
{
  const Sample sample = shapes::WavyBall(10, 30, 0.02);
  Monitor monitor;
  const MaximinOrder order(sample.Points, monitor);
  for (const int below : { 5, 40, 333, 900 })
  {
    const Point3& x = order.Points()[static_cast<std::size_t>(below) - 1];
    std::vector<int> ranks(below);
    std::iota(ranks.begin(), ranks.end(), 0);
    std::sort(ranks.begin(), ranks.end(),
      [&](int i, int j)
      {
        const Vector3 a = order.Points()[i] - x;
        const Vector3 b = order.Points()[j] - x;
        return std::make_pair(Dot(a, a), i) < std::make_pair(Dot(b, b), j);
      });
    ranks.resize(std::min(below, 25));
    std::sort(ranks.begin(), ranks.end());
    EXPECT_EQ(order.Nearest(x, below, 25), ranks) << below;
  }
}

TEST(InverseCholesky, IsTheInverseWhereAllIsExact)
{
  const Sample sample = shapes::WavyBall(10, 30, 0.02);
  RbfProblem problem;
  problem.Points = sample.Points;
  Monitor monitor;
  const IterativeResult result = SolveIteratively(problem, sample.Values, 1e-7, monitor);
  EXPECT_TRUE(result.Converged);
  EXPECT_EQ(result.Iterations, 1);
}

TEST(InverseCholesky, ItsWeightsAreOrthogonalToLinearPolynomials)
{
  const Sample sample = shapes::WavyBall(30, 40, 0.02);
  Monitor monitor;
  const MaximinOrder order(sample.Points, monitor);
  const InverseCholesky inverse(order, {}, monitor);
  std::vector<double> r(sample.Points.size());
  for (std::size_t i = 0; i < r.size(); ++i)
  {
    r[i] = std::sin(7.0 * static_cast<double>(i));
  }
  const std::vector<double> w = inverse.Apply(inverse.Project(r), monitor);
  double sum = 0;
  double size = 0;
  Vector3 moment{ 0, 0, 0 };
  for (std::size_t i = 0; i < w.size(); ++i)
  {
    sum += w[i];
    moment = moment + w[i] * order.Points()[i];
    size += std::abs(w[i]);
  }
  EXPECT_LT(std::abs(sum), 1e-12 * size);
  EXPECT_LT(Norm(moment), 1e-12 * size);
}

TEST(IterativeSolver, GivesTheDirectSolversFunction)
{
  const Sample sample = shapes::WavyBall(25, 40, 0.02);
  const ImplicitFunction direct = Fit(sample, FunctionOptions::Direct);
  const ImplicitFunction iterative = Iterate(sample, 1e-7);
  EXPECT_EQ(direct.Iterations, 0);
  EXPECT_GT(iterative.Iterations, 1);
  EXPECT_TRUE(iterative.Report.empty());
  EXPECT_LE(iterative.Residual, 1e-7);
  std::vector<Point3> between;
  for (int i = 0; i < 300; ++i)
  {
    between.push_back({ std::sin(1.0 * i), std::sin(2.0 * i + 1), std::sin(3.0 * i + 2) });
  }
  const std::vector<double> a = direct.Evaluate(between, 0);
  const std::vector<double> b = iterative.Evaluate(between, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a[i], b[i], 1e-6 * std::max(1.0, std::abs(a[i])));
  }
}

TEST(IterativeSolver, ResidualIsTheLargestMisfit)
{
  const Sample sample = shapes::WavyBall(30, 45, 0.01);
  const ImplicitFunction function = Iterate(sample, 1e-3);
  EXPECT_LE(function.Residual, 1e-3);
  EXPECT_GT(function.Residual, 1e-9);
  EXPECT_NEAR(function.Residual, LargestMisfit(function, sample), 1e-9);
}

TEST(IterativeSolver, ConvergesInTensOfStepsOnHardInputs)
{
  Sample far = shapes::WavyBall(30, 45, 0.01);
  for (Point3& p : far.Points)
  {
    p = 40 * p + Point3{ 1e5, -2e5, 3e4 };
  }
  const struct
  {
    const char* Name;
    Sample Shape;
    int Steps;
  } cases[] = {
    { "ball", shapes::WavyBall(30, 45, 0.01), 25 },
    { "narrow margins", shapes::WavyBall(30, 45, 0.003), 25 },
    { "uneven", shapes::WavyBall(30, 45, 0.003, true), 35 },
    { "crossing planes", shapes::CrossingPlanes(10, 40, 0.01), 25 },
    { "plane through itself", shapes::CrossingPlanes(9, 44, 0.01), 25 },
    { "thin", shapes::ThinPlate(26, 0.02, 0.004), 25 },
    { "far away", far, 25 },
  };
  for (const auto& one : cases)
  {
    const ImplicitFunction function = Iterate(one.Shape);
    EXPECT_LE(function.Iterations, one.Steps) << one.Name;
    EXPECT_LE(function.Residual, 1.05e-5) << one.Name;
    EXPECT_FALSE(Says(function, "stopped after")) << one.Name;
  }
}

TEST(IterativeSolver, PointsThatNearlyRepeatOthersDoNoHarm)
{
  for (const double apart : { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7 })
  {
    Sample sample = shapes::WavyBall(25, 40, 0.01);
    for (int k = 0; k < 25 * 40; k += 7)
    {
      Point3 x;
      Vector3 outward;
      const double t = 2 * shapes::Pi * (k % 40 + 0.5 * (k / 40 % 2)) / 40 + apart;
      shapes::WavyPoint(-0.97 + 1.94 * (k / 40 + 0.5) / 25, t, x, outward);
      sample.Add(x, outward, 0.01);
    }
    const ImplicitFunction function = Iterate(sample);
    EXPECT_LE(function.Iterations, 30) << apart;
    EXPECT_LE(function.Residual, 1.05e-5) << apart;
  }
}

TEST(IterativeSolver, SmoothingIsTheDirectSolvers)
{
  const Sample sample = shapes::WavyBall(20, 30, 0.02);
  Monitor monitor;
  FunctionOptions options;
  options.Smoothing = 1e-5;
  options.Solver = FunctionOptions::Direct;
  const ImplicitFunction direct =
    FitImplicitFunction(sample.Points, sample.Values, options, monitor);
  options.Solver = FunctionOptions::Iterative;
  options.Tolerance = 1e-8;
  const ImplicitFunction iterative =
    FitImplicitFunction(sample.Points, sample.Values, options, monitor);
  EXPECT_GT(direct.Residual, 0.01);
  EXPECT_NEAR(direct.Residual, iterative.Residual, 1e-5);
  for (std::size_t j = 0; j < direct.Weights.size(); ++j)
  {
    EXPECT_NEAR(direct.Weights[j], iterative.Weights[j], 1e-2);
  }
}

TEST(IterativeSolver, AnyNumberOfThreadsGivesTheSameBits)
{
  const Sample sample = shapes::WavyBall(30, 40, 0.01);
  const ImplicitFunction one = Iterate(sample, 0, 1);
  for (const int threads : { 2, 5 })
  {
    const ImplicitFunction other = Iterate(sample, 0, threads);
    EXPECT_EQ(one.Weights, other.Weights);
    EXPECT_EQ(one.Polynomial, other.Polynomial);
    EXPECT_EQ(one.Iterations, other.Iterations);
  }
}

TEST(IterativeSolver, FastSumsReachTheToleranceThatExactSumsSee)
{
  const Sample sample = shapes::WavyBall(70, 80, 0.01);
  const ImplicitFunction one = Iterate(sample, 0, 1);
  EXPECT_LE(one.Iterations, 30);
  EXPECT_LE(one.Residual, 1.05e-5);
  EXPECT_NEAR(one.Residual, LargestMisfit(one, sample), 1e-7);
  const ImplicitFunction two = Iterate(sample, 0, 2);
  EXPECT_EQ(one.Weights, two.Weights);
}

TEST(IterativeSolver, WeightsThatCancelBeyondTheFastSumsGetExactOnesInTime)
{
  // Margins of a thousandth of the radius, a thirtieth of the spacing: what fast sums leave out of
  // weights that cancel so well is more than the tolerance.
  const Sample sample = shapes::WavyBall(70, 80, 0.001);
  const ImplicitFunction function = Iterate(sample);
  EXPECT_FALSE(Says(function, "stopped after"));
  EXPECT_LE(function.Residual, 1.05e-5);
  EXPECT_LE(LargestMisfit(function, sample), 1.05e-5);
  // Where the residual drifts until the end, another descent makes it more. (44 to 78 by processor,
  // compiler and version of Eigen, as last bits differ.)
  EXPECT_LE(function.Iterations, 100);
}

TEST(IterativeSolver, AMisfitThatCannotBeReachedEndsWithASentence)
{
  const Sample sample = shapes::WavyBall(20, 30, 0.01);
  const ImplicitFunction rounding = Iterate(sample, 1e-15);
  EXPECT_TRUE(Says(rounding, "stopped after"));
  EXPECT_LT(rounding.Residual, 1e-6);

  // Two constraints a hair apart that ask for 0 and for 0.5.
  Sample contradiction = sample;
  contradiction.Points.push_back(sample.Points[300] + Vector3{ 0, 0, 1e-7 });
  contradiction.Values.push_back(0.5);
  const ImplicitFunction torn = Iterate(contradiction);
  EXPECT_TRUE(Says(torn, "stopped after"));
  EXPECT_NEAR(torn.Residual, 0.5, 0.3);
  // What contradicts nothing is met all the same.
  const std::vector<double> f = torn.Evaluate(sample.Points, 0);
  EXPECT_NEAR(f[0], 0, 1e-2);
  EXPECT_NEAR(f[901], 1, 1e-2);
}

TEST(IterativeSolver, AutomaticGoesDirectWhereTheIterativeSolverDoesNotGetThere)
{
  const Sample sample = shapes::WavyBall(26, 40, 0.02);
  FunctionOptions options;
  options.Tolerance = 1e-15;
  Monitor monitor;
  ASSERT_EQ(ChooseSolver(sample.Points.size(), options), FunctionOptions::Iterative);
  const ImplicitFunction function =
    FitImplicitFunction(sample.Points, sample.Values, options, monitor);
  EXPECT_TRUE(Says(function, "solved directly instead"));
  EXPECT_LT(function.Residual, 1e-7);
}

TEST(IterativeSolver, StopsWithinASecondWhereverItIs)
{
  // Whenever it is asked, it hears of it at the next word: so no silence may be long.
  const Sample sample = shapes::WavyBall(70, 80, 0.01);
  FunctionOptions options;
  options.Solver = FunctionOptions::Iterative;
  options.Tolerance = 0.1;
  options.Threads = 1;
  Impatient whole(2);
  FitImplicitFunction(sample.Points, sample.Values, options, whole);
  EXPECT_LT(whole.Silence, 1);
  for (const double fraction : { 0.01, 0.1, 0.3, 0.6 })
  {
    Impatient stopper(fraction);
    EXPECT_THROW(FitImplicitFunction(sample.Points, sample.Values, options, stopper), Aborted);
    EXPECT_LT(Seconds() - stopper.Last, 1) << fraction;
  }
}

TEST(DirectSolvers, StopWithinASecondWhereverTheyAre)
{
  const Sample sample = shapes::WavyBall(40, 50, 0.01);
  for (const auto solver : { FunctionOptions::Direct, FunctionOptions::LU })
  {
    FunctionOptions options;
    options.Solver = solver;
    options.Threads = 1;
    Impatient whole(2);
    const ImplicitFunction function =
      FitImplicitFunction(sample.Points, sample.Values, options, whole);
    EXPECT_LT(whole.Silence, 1) << solver;
    EXPECT_LT(function.Residual, 1e-8) << solver;
    Impatient stopper(0.5);
    EXPECT_THROW(FitImplicitFunction(sample.Points, sample.Values, options, stopper), Aborted);
    EXPECT_LT(Seconds() - stopper.Last, 1) << solver;
  }
}

TEST(CentreReduction, TakesFewerCentresAndMissesNoConstraintByMore)
{
  const Sample sample = shapes::WavyBall(40, 60, 0.05);
  std::size_t before = sample.Points.size();
  for (const double allowed : { 0.02, 0.2 })
  {
    FunctionOptions options;
    options.CentreReduction = allowed;
    Monitor monitor;
    const ImplicitFunction function =
      FitImplicitFunction(sample.Points, sample.Values, options, monitor);
    EXPECT_LE(function.Residual, allowed);
    EXPECT_NEAR(function.Residual, LargestMisfit(function, sample), 1e-4 * allowed);
    EXPECT_LT(function.Centres.size(), before * 3 / 4);
    EXPECT_TRUE(Says(function, std::to_string(function.Centres.size()) + " of 7200"));
    before = function.Centres.size();
  }
}

TEST(Solver, AutomaticChoosesByTimeAndMemory)
{
  FunctionOptions options;
  EXPECT_EQ(ChooseSolver(500, options), FunctionOptions::Direct);
  EXPECT_EQ(ChooseSolver(20000, options), FunctionOptions::Iterative);
  options.MaxGigabytes = 1e-3;
  EXPECT_EQ(ChooseSolver(500, options), FunctionOptions::Iterative);
  options.Solver = FunctionOptions::LU;
  EXPECT_EQ(ChooseSolver(500, options), FunctionOptions::LU);
}

TEST(Solver, WhatDoesNotFitIsRefusedBeforeItIsBuilt)
{
  EXPECT_GT(AvailableGigabytes(), 0);
  EXPECT_LT(AvailableGigabytes(), 1e5);
  EXPECT_LT(IterativeGigabytes(1000000), 24);
  const Sample sample = shapes::WavyBall(100, 300, 0.01);
  FunctionOptions options;
  options.Solver = FunctionOptions::Direct;
  options.MaxGigabytes = 1;
  Monitor monitor;
  try
  {
    FitImplicitFunction(sample.Points, sample.Values, options, monitor);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("choose the iterative solver"), std::string::npos);
  }
}

TEST(SolverInvalid, ToleranceMustBeANumberThatIsNotNegative)
{
  const Sample sample = shapes::WavyBall(4, 10, 0.02);
  EXPECT_THROW(Iterate(sample, -1), Error);
  EXPECT_THROW(Iterate(sample, std::nan("")), Error);
}
