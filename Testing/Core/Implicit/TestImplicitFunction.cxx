// SPDX-License-Identifier: GPL-3.0-or-later
// The fit against scipy's and against its own conditions; evaluation, gradients, threads.
#include "Implicit/Solver/FitImplicitFunction.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

using namespace recon;

namespace
{
/// The generator of Reference/make_scipy_weights.py.
class Random
{
public:
  explicit Random(std::uint64_t seed) : State(seed) {}
  double Next()
  {
    this->State = this->State * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(this->State >> 11) / 9007199254740992.0;
  }

private:
  std::uint64_t State;
};

struct Sample
{
  std::vector<Point3> Points;
  std::vector<double> Values;
};

Sample RandomSample(int count)
{
  Random random(static_cast<std::uint64_t>(count));
  Sample sample;
  for (int i = 0; i < count; ++i)
  {
    const double x = random.Next();
    const double y = random.Next();
    const double z = random.Next();
    sample.Points.push_back({ 100 * x - 250, 60 * y + 40, 30 * z + 900 });
    sample.Values.push_back(2 * random.Next() - 1);
  }
  return sample;
}

ImplicitFunction Fit(const Sample& sample, const FunctionOptions& options = {})
{
  Monitor monitor;
  return FitImplicitFunction(sample.Points, sample.Values, options, monitor);
}

/// The polynomial about the origin of the coordinates, as other software prints it.
std::array<double, 4> AboutTheOrigin(const ImplicitFunction& function)
{
  const Vector3 slope{ function.Polynomial[1], function.Polynomial[2], function.Polynomial[3] };
  return { function.Polynomial[0] - Dot(slope, function.Origin), slope[0], slope[1], slope[2] };
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

double Largest(const std::vector<double>& a)
{
  return LargestDifference(a, std::vector<double>(a.size(), 0.0));
}

/// Half the diagonal of the bounding box: the unit ball's radius that Smoothing is relative to.
double BallRadius(const std::vector<Point3>& points)
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
  return 0.5 * Norm(high - low);
}
}

TEST(ImplicitFunction, WeightsAreThoseOfScipy)
{
  std::ifstream file(recon::testing::OwnPath("Testing/Core/Implicit/Reference/scipy_weights.txt"));
  int count = 0;
  int listed = 0;
  int sets = 0;
  double smoothing = 0;
  while (file >> count >> smoothing >> listed)
  {
    const Sample sample = RandomSample(count);
    FunctionOptions options;
    options.Smoothing = smoothing / std::pow(BallRadius(sample.Points), 3);
    const ImplicitFunction function = Fit(sample, options);
    const double scale = Largest(function.Weights);
    for (int i = 0; i < listed; ++i)
    {
      int index = 0;
      double weight = 0;
      ASSERT_TRUE(file >> index >> weight);
      EXPECT_NEAR(function.Weights[static_cast<std::size_t>(index)], weight, 1e-8 * scale)
        << count << " " << index;
    }
    // Less sharp: these are extrapolated to the origin, far from all points, from scipy's own
    // rounding.
    for (const double ours : AboutTheOrigin(function))
    {
      double theirs = 0;
      ASSERT_TRUE(file >> theirs);
      EXPECT_NEAR(ours, theirs, 1e-6 * std::max(1.0, std::abs(theirs)));
    }
    ++sets;
  }
  EXPECT_EQ(sets, 4);
}

TEST(ImplicitFunction, ProjectedCholeskySolvesTheThesisLU)
{
  const Sample sample = RandomSample(700);
  FunctionOptions lu;
  lu.Solver = FunctionOptions::LU;
  const ImplicitFunction a = Fit(sample);
  const ImplicitFunction b = Fit(sample, lu);
  EXPECT_LT(LargestDifference(a.Weights, b.Weights), 1e-8 * Largest(b.Weights));
  for (int k = 0; k < 4; ++k)
  {
    // Less well conditioned than the weights; how much less depends on the machine's BLAS.
    EXPECT_NEAR(a.Polynomial[k], b.Polynomial[k], 1e-7);
  }
}

TEST(ImplicitFunction, InterpolatesAndWeightsAreOrthogonalToPolynomials)
{
  const Sample sample = RandomSample(400);
  const ImplicitFunction function = Fit(sample);
  EXPECT_LT(function.Residual, 1e-8);
  EXPECT_EQ(
    LargestDifference(function.Evaluate(sample.Points, 1), sample.Values), function.Residual);
  double sum = 0;
  Vector3 moment{ 0, 0, 0 };
  for (std::size_t j = 0; j < function.Weights.size(); ++j)
  {
    sum += function.Weights[j];
    moment = moment + function.Weights[j] * (function.Centres[j] - function.Origin);
  }
  const double scale = Largest(function.Weights);
  EXPECT_NEAR(sum, 0, 1e-8 * scale);
  EXPECT_NEAR(Norm(moment), 0, 1e-6 * scale);
}

TEST(ImplicitFunction, ReproducesALinearFunction)
{
  Sample sample = RandomSample(60);
  for (std::size_t i = 0; i < sample.Points.size(); ++i)
  {
    sample.Values[i] = 3 - 0.5 * sample.Points[i][0] + 2 * sample.Points[i][2];
  }
  const ImplicitFunction function = Fit(sample);
  EXPECT_NEAR(function.Value({ 1000, -20, 3 }), 3 - 500 + 6, 1e-6);
  EXPECT_NEAR(AboutTheOrigin(function)[1], -0.5, 1e-9);
  EXPECT_NEAR(AboutTheOrigin(function)[2], 0, 1e-9);
}

TEST(ImplicitFunction, GradientIsTheSlope)
{
  for (const Kernel::KindType kind : { Kernel::Triharmonic, Kernel::Wendland })
  {
    FunctionOptions options;
    options.Kind = kind;
    const ImplicitFunction function = Fit(RandomSample(200), options);
    Random random(5);
    for (int i = 0; i < 20; ++i)
    {
      const Point3 x{ 100 * random.Next() - 250, 60 * random.Next() + 40,
        30 * random.Next() + 900 };
      const Vector3 g = function.Gradient(x);
      for (int a = 0; a < 3; ++a)
      {
        const double h = 1e-4;
        Point3 before = x;
        Point3 after = x;
        before[a] -= h;
        after[a] += h;
        const double slope = (function.Value(after) - function.Value(before)) / (2 * h);
        EXPECT_NEAR(g[a], slope, 1e-5 * (1 + Norm(g)));
      }
    }
  }
}

TEST(ImplicitFunction, AnyNumberOfThreadsGivesTheSameBits)
{
  const ImplicitFunction function = Fit(RandomSample(150));
  const std::vector<Point3> points = RandomSample(3001).Points;
  const std::vector<double> one = function.Evaluate(points, 1);
  EXPECT_EQ(one, function.Evaluate(points, 2));
  EXPECT_EQ(one, function.Evaluate(points, 7));
  EXPECT_EQ(function.EvaluateGradients(points, 1), function.EvaluateGradients(points, 5));
  // Nor does a value depend on which points stand beside it.
  for (std::size_t i = 0; i < points.size(); i += 97)
  {
    EXPECT_EQ(function.Value(points[i]), one[i]);
  }
}

TEST(ImplicitFunction, DuplicatesAreMergedAndContradictionsNamed)
{
  Sample sample = RandomSample(50);
  sample.Points.push_back(sample.Points[7]);
  sample.Values.push_back(sample.Values[7]);
  ImplicitFunction function = Fit(sample);
  EXPECT_EQ(function.Centres.size(), 50u);
  ASSERT_EQ(function.Report.size(), 1u);
  EXPECT_NE(function.Report[0].find("1 constraints"), std::string::npos);

  sample.Points.push_back(sample.Points[9]);
  sample.Values.push_back(sample.Values[9] + 1);
  function = Fit(sample);
  EXPECT_EQ(function.Centres.size(), 50u);
  EXPECT_EQ(function.Report.size(), 2u);
  EXPECT_NEAR(function.Value(sample.Points[9]), sample.Values[9] + 0.5, 1e-8);
}

TEST(ImplicitFunction, SmoothingMissesByWeightsAndWendlandInterpolates)
{
  const Sample sample = RandomSample(200);
  FunctionOptions smooth;
  smooth.Smoothing = 1e-3;
  const ImplicitFunction function = Fit(sample, smooth);
  EXPECT_GT(function.Residual, 1e-4);
  const double factor = smooth.Smoothing * std::pow(BallRadius(sample.Points), 3);
  EXPECT_NEAR(
    function.Value(sample.Points[3]) + factor * function.Weights[3], sample.Values[3], 1e-8);

  FunctionOptions sparse;
  sparse.Kind = Kernel::Wendland;
  sparse.SupportRadius = 25;
  const ImplicitFunction compact = Fit(sample, sparse);
  EXPECT_LT(compact.Residual, 1e-9);
  // Far from all constraints it is outside: the least of the values.
  EXPECT_EQ(
    compact.Value({ 5000, 0, 0 }), *std::min_element(sample.Values.begin(), sample.Values.end()));
}

TEST(ImplicitFunctionInvalid, EachBadInputHasItsSentence)
{
  const Sample good = RandomSample(20);
  Sample bad = good;
  bad.Points[4][1] = std::nan("");
  EXPECT_THROW(Fit(bad), Error);
  bad = good;
  bad.Values[4] = INFINITY;
  EXPECT_THROW(Fit(bad), Error);
  bad = good;
  bad.Values.assign(20, 0.0);
  EXPECT_THROW(Fit(bad), Error);
  bad = good;
  for (Point3& p : bad.Points)
  {
    p[2] = 0.25 * p[0] - p[1];
  }
  EXPECT_THROW(Fit(bad), Error);
  bad = good;
  bad.Points.assign(20, Point3{ 1, 2, 3 });
  EXPECT_THROW(Fit(bad), Error);
  bad = good;
  bad.Points.resize(3);
  bad.Values.resize(3);
  EXPECT_THROW(Fit(bad), Error);
  bad = good;
  bad.Values.pop_back();
  EXPECT_THROW(Fit(bad), Error);

  FunctionOptions options;
  options.MaxGigabytes = 1e-6;
  EXPECT_THROW(Fit(good, options), Error);
  options = FunctionOptions();
  options.Smoothing = -1;
  EXPECT_THROW(Fit(good, options), Error);

  ImplicitFunction torn = Fit(good);
  torn.Weights.pop_back();
  EXPECT_THROW(torn.Validate(), Error);
  torn = Fit(good);
  torn.Weights[0] = std::nan("");
  EXPECT_THROW(torn.Validate(), Error);
}

TEST(ImplicitFunction, CanBeStopped)
{
  struct Stopper : Monitor
  {
    bool AbortRequested() override { return true; }
  } stopper;
  const Sample sample = RandomSample(100);
  EXPECT_THROW(
    FitImplicitFunction(sample.Points, sample.Values, FunctionOptions(), stopper), Aborted);
}
