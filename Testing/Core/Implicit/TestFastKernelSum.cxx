// SPDX-License-Identifier: GPL-3.0-or-later
// The fast sum against sums over all pairs: every accuracy, awkward clouds, gradients, threads.
#include "Implicit/FastMultipole/DirectSums.h"
#include "Implicit/FastMultipole/FastKernelSum.h"
#include "Implicit/Solver/FitImplicitFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace recon;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// The same numbers with every standard library: its distributions are not.
class Random
{
public:
  explicit Random(unsigned seed) : Engine(seed) {}
  /// In [-1, 1).
  double Next() { return static_cast<double>(this->Engine()) / 2147483648.0 - 1; }
  Point3 NextPoint() { return { this->Next(), this->Next(), this->Next() }; }

private:
  std::mt19937 Engine;
};

using Cloud = std::vector<Point3>;

Cloud Filled(int count, const std::function<Point3(Random&, int)>& make)
{
  Random random(7);
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    cloud.push_back(make(random, i));
  }
  return cloud;
}

/// Three constraints a point on parallel slices of a wavy ball, as contours give them.
Cloud WavyBall(int slices, int perSlice, double margin)
{
  Cloud cloud;
  for (int s = 0; s < slices; ++s)
  {
    const double theta = Pi * (s + 0.5) / slices;
    for (int k = 0; k < perSlice; ++k)
    {
      const double phi = 2 * Pi * (k + 0.37 * s) / perSlice;
      const double r = (1 + 0.1 * std::sin(5 * phi) * std::sin(3 * theta)) * std::sin(theta);
      for (int side = 1; side >= -1; --side)
      {
        const double at = r - side * margin;
        cloud.push_back({ at * std::cos(phi), at * std::sin(phi), std::cos(theta) });
      }
    }
  }
  return cloud;
}

std::vector<double> RandomWeights(std::size_t count)
{
  Random random(11);
  std::vector<double> weights(count);
  for (double& w : weights)
  {
    w = random.Next();
  }
  return weights;
}

std::vector<double> Exact(const Cloud& centres, const std::vector<double>& weights, const Cloud& at)
{
  std::vector<double> sums(at.size());
  SumKernels({}, centres, weights, at.data(), at.size(), sums.data());
  return sums;
}

double LargestOf(const std::vector<double>& a)
{
  double largest = 0;
  for (const double x : a)
  {
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

/// What an accuracy is relative to.
double ScaleOf(const Cloud& centres, const std::vector<double>& weights)
{
  std::vector<double> sizes = weights;
  for (double& w : sizes)
  {
    w = std::abs(w);
  }
  return LargestOf(Exact(centres, sizes, centres));
}

std::vector<double> AtCentres(
  const Cloud& centres, const std::vector<double>& weights, double accuracy, int threads)
{
  Monitor monitor;
  FastKernelSum sum(centres, accuracy, threads);
  sum.SetWeights(weights, monitor);
  return sum.ValuesAtCentres(monitor);
}

/// Accuracy is kept, at centres and elsewhere, on one cloud.
void ExpectAccurate(const Cloud& centres, double accuracy)
{
  const std::vector<double> weights = RandomWeights(centres.size());
  const double scale = ScaleOf(centres, weights);
  Monitor monitor;
  FastKernelSum sum(centres, accuracy, 1);
  sum.SetWeights(weights, monitor);
  EXPECT_LE(LargestDifference(sum.ValuesAtCentres(monitor), Exact(centres, weights, centres)),
    accuracy * scale)
    << "at the centres, accuracy " << accuracy;
  Cloud between;
  for (std::size_t i = 0; i + 1 < centres.size(); i += 3)
  {
    between.push_back(0.5 * (centres[i] + centres[i + 1]));
  }
  EXPECT_LE(LargestDifference(sum.Values(between, monitor), Exact(centres, weights, between)),
    accuracy * scale)
    << "between, accuracy " << accuracy;
}
}

TEST(FastKernelSum, KeepsEveryAccuracyOnSurfacesAndInVolumes)
{
  const Cloud ball = WavyBall(30, 50, 0.01);
  const Cloud cube = Filled(4000, [](Random& random, int) { return random.NextPoint(); });
  for (const double accuracy :
    { 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13, 1e-14, FastKernelSum::FinestAccuracy })
  {
    ExpectAccurate(ball, accuracy);
    ExpectAccurate(cube, accuracy);
  }
}

TEST(FastKernelSum, GetsWorseWhereLessIsAskedFor)
{
  // Else the far field would not be in use, and the test above would say nothing.
  const Cloud ball = WavyBall(40, 70, 0.01);
  const std::vector<double> weights = RandomWeights(ball.size());
  const std::vector<double> exact = Exact(ball, weights, ball);
  const double coarse = LargestDifference(AtCentres(ball, weights, 1e-4, 1), exact);
  const double fine = LargestDifference(AtCentres(ball, weights, 1e-10, 1), exact);
  EXPECT_GT(coarse, 1e3 * fine);
  EXPECT_GT(fine, 0);
}

TEST(FastKernelSum, TakesAwkwardClouds)
{
  // In a plane, on a line, in two far clusters of very different density, at few places many times.
  const Cloud plane = Filled(4000,
    [](Random& random, int) {
      return Point3{ random.Next(), 0.25, random.Next() };
    });
  const Cloud line = Filled(4000,
    [](Random& random, int) {
      return random.Next() * Point3{ 1, 2, -3 };
    });
  const Cloud clusters = Filled(4000,
    [](Random& random, int i)
    {
      return i % 4 == 0 ? Point3{ 900, 0, 0 } + 5.0 * random.NextPoint()
                        : Point3{ 0, 0, 0 } + 1e-3 * random.NextPoint();
    });
  const Cloud graded =
    Filled(4000, [](Random& random, int i) { return std::exp2(-0.005 * i) * random.NextPoint(); });
  const Cloud repeated = Filled(4000,
    [](Random&, int i) {
      return Point3{ double(i % 3), double(i % 5), double(i % 7) };
    });
  for (const Cloud& cloud : { plane, line, clusters, graded, repeated })
  {
    ExpectAccurate(cloud, 1e-5);
    ExpectAccurate(cloud, 1e-9);
  }
}

TEST(FastKernelSum, TakesCoordinatesFarFromTheOrigin)
{
  Cloud ball = WavyBall(30, 60, 0.01);
  const std::vector<double> weights = RandomWeights(ball.size());
  const std::vector<double> here = AtCentres(ball, weights, 1e-10, 1);
  for (Point3& p : ball)
  {
    p = Point3{ -1250, 4096, 987654 } + 100.0 * p;
  }
  const std::vector<double> there = AtCentres(ball, weights, 1e-10, 1);
  const std::vector<double> exact = Exact(ball, weights, ball);
  // Coordinates of a million carry 1e-10 of a length; the kernels grew by 100^3.
  EXPECT_LE(LargestDifference(there, exact), 1e-9 * ScaleOf(ball, weights));
  std::vector<double> scaled = here;
  for (double& s : scaled)
  {
    s *= 1e6;
  }
  EXPECT_LE(LargestDifference(there, scaled), 1e-8 * ScaleOf(ball, weights));
}

TEST(FastKernelSum, TakesNothingAndOnePoint)
{
  Monitor monitor;
  FastKernelSum none({}, 1e-6, 1);
  none.SetWeights({}, monitor);
  EXPECT_TRUE(none.ValuesAtCentres(monitor).empty());
  EXPECT_EQ(none.Values({ { 1, 2, 3 } }, monitor), std::vector<double>{ 0 });

  FastKernelSum one({ { 1, 2, 3 } }, 1e-6, 1);
  one.SetWeights({ 2 }, monitor);
  EXPECT_EQ(one.ValuesAtCentres(monitor), std::vector<double>{ 0 });
  EXPECT_TRUE(one.Values({}, monitor).empty());
  EXPECT_NEAR(one.Values({ { 1, 2, 5 } }, monitor).front(), 16, 1e-12);
  // Far beyond the cube, where sums are direct.
  EXPECT_NEAR(one.Values({ { 1, 2, 1003 } }, monitor).front() / 2e9, 1, 1e-12);
}

TEST(FastKernelSum, GivesGradientsOfItsValues)
{
  const Cloud ball = WavyBall(40, 70, 0.01);
  const std::vector<double> weights = RandomWeights(ball.size());
  // In the ball, around it, and beyond three times its size.
  const Cloud at = Filled(
    3000, [](Random& random, int i) { return (i % 100 == 0 ? 20.0 : 1.5) * random.NextPoint(); });
  Monitor monitor;
  FastKernelSum sum(ball, 1e-9, 2);
  sum.SetWeights(weights, monitor);
  std::vector<double> values;
  std::vector<Vector3> gradients;
  sum.ValuesAndGradients(at, values, gradients, monitor);
  std::vector<Vector3> exact(at.size());
  SumKernelGradients({}, ball, weights, at.data(), at.size(), exact.data());
  const std::vector<double> exactValues = Exact(ball, weights, at);
  std::vector<double> sizes = weights;
  for (double& w : sizes)
  {
    w = std::abs(w);
  }
  const std::vector<double> size = Exact(ball, sizes, at);
  const double scale = ScaleOf(ball, weights);
  ASSERT_EQ(gradients.size(), at.size());
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    EXPECT_LE(std::abs(values[i] - exactValues[i]), 1e-9 * std::max(scale, size[i]));
    // The ball is 2 wide.
    EXPECT_LE(Norm(gradients[i] - exact[i]), 100 * 1e-9 * std::max(scale, size[i]) / 2);
  }
}

TEST(FastKernelSum, IsTheSameWithAnyNumberOfThreads)
{
  const Cloud ball = WavyBall(60, 90, 0.01);
  const std::vector<double> weights = RandomWeights(ball.size());
  EXPECT_EQ(AtCentres(ball, weights, 1e-7, 1), AtCentres(ball, weights, 1e-7, 2));
  EXPECT_EQ(AtCentres(ball, weights, 1e-7, 1), AtCentres(ball, weights, 1e-7, 3));
  Monitor monitor;
  const Cloud at = Filled(5000, [](Random& random, int) { return 1.2 * random.NextPoint(); });
  std::vector<std::vector<double>> values(2);
  std::vector<std::vector<Vector3>> gradients(2);
  for (int threads = 1; threads <= 2; ++threads)
  {
    FastKernelSum sum(ball, 1e-7, threads);
    sum.SetWeights(weights, monitor);
    sum.ValuesAndGradients(at, values[threads - 1], gradients[threads - 1], monitor);
  }
  EXPECT_EQ(values[0], values[1]);
  EXPECT_EQ(gradients[0], gradients[1]);
}

TEST(FastKernelSum, ChangesItsAccuracyAndWeights)
{
  const Cloud ball = WavyBall(30, 60, 0.01);
  const std::vector<double> weights = RandomWeights(ball.size());
  Monitor monitor;
  FastKernelSum sum(ball, 1e-4, 1);
  sum.SetWeights(std::vector<double>(ball.size(), 1), monitor);
  sum.SetAccuracy(1e-8);
  sum.SetWeights(weights, monitor);
  EXPECT_EQ(sum.ValuesAtCentres(monitor), AtCentres(ball, weights, 1e-8, 1));
  EXPECT_THROW(sum.SetAccuracy(0), Error);
  EXPECT_THROW(sum.SetAccuracy(std::numeric_limits<double>::quiet_NaN()), Error);
  EXPECT_THROW(sum.SetWeights({ 1, 2 }, monitor), Error);
}

TEST(FastKernelSum, MeasuresItsOwnError)
{
  const Cloud ball = WavyBall(30, 60, 0.01);
  const std::vector<double> weights = RandomWeights(ball.size());
  Monitor monitor;
  FastKernelSum sum(ball, 1e-5, 1);
  sum.SetWeights(weights, monitor);
  const std::vector<double> values = sum.ValuesAtCentres(monitor);
  const double error = LargestDifference(values, Exact(ball, weights, ball));
  // All centres, then some.
  EXPECT_NEAR(sum.SampledError(values, static_cast<int>(ball.size())), error, 1e-12 * error);
  const double sampled = sum.SampledError(values, 200);
  EXPECT_LE(sampled, error);
  EXPECT_GE(sampled, 0.05 * error);
}

TEST(FastKernelSum, IsAccurateForFittedWeights)
{
  // Weights of triples nearly cancel: what counts is the error beside the constraints' values, +-1.
  const Cloud ball = WavyBall(20, 40, 0.01);
  std::vector<double> values;
  for (std::size_t i = 0; i < ball.size(); ++i)
  {
    values.push_back(1.0 - static_cast<double>(i % 3));
  }
  Monitor monitor;
  const ImplicitFunction function = FitImplicitFunction(ball, values, {}, monitor);
  const std::vector<double> exact = Exact(function.Centres, function.Weights, function.Centres);
  EXPECT_GT(ScaleOf(function.Centres, function.Weights), 1e4 * LargestOf(exact));
  EXPECT_LE(LargestDifference(AtCentres(function.Centres, function.Weights, 1e-9, 1), exact), 1e-2);
  EXPECT_LE(
    LargestDifference(AtCentres(function.Centres, function.Weights, 1e-13, 1), exact), 1e-5);
}

namespace
{
class Stopping : public Monitor
{
public:
  bool AbortRequested() override { return true; }
};
}

TEST(FastKernelSum, CanBeAborted)
{
  const Cloud ball = WavyBall(60, 90, 0.01);
  Stopping stopping;
  FastKernelSum sum(ball, 1e-6, 1);
  EXPECT_THROW(sum.SetWeights(RandomWeights(ball.size()), stopping), Aborted);
}
