// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation by fast sums against exact ones, and the surface and contours that are made of it.
#include "ConstraintShapes.h"
#include "Core/Mesh/MeshInvariants.h"
#include "Implicit/FastMultipole/DirectSums.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "Implicit/ZeroSet/Polygonizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace recon;

namespace
{
ImplicitFunction FitBall(int slices, int points)
{
  const shapes::Sample sample = shapes::WavyBall(slices, points, 0.02);
  Monitor monitor;
  return FitImplicitFunction(sample.Points, sample.Values, {}, monitor);
}

/// Just enough centres for the fast sum.
const ImplicitFunction& Large()
{
  static const ImplicitFunction function = FitBall(41, 50);
  return function;
}

/// Points at, around and far from the surface.
std::vector<Point3> Places(const ImplicitFunction& function)
{
  std::vector<Point3> places;
  for (std::size_t i = 0; i < function.Centres.size(); i += 4)
  {
    const double factor = i % 3 == 0 ? 1 : i % 100 == 1 ? 5 : 0.9 + 0.0001 * (i % 1999);
    places.push_back(factor * function.Centres[i]);
  }
  return places;
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
}

TEST(FunctionEvaluator, IsExactForFewCentres)
{
  const ImplicitFunction function = FitBall(10, 20);
  ASSERT_LT(function.Centres.size(), FunctionEvaluator::FastFrom);
  Monitor monitor;
  const FunctionEvaluator evaluator(function, 1);
  const std::vector<Point3> places = Places(function);
  EXPECT_EQ(evaluator.Values(places, monitor), function.Evaluate(places, 1));
  EXPECT_EQ(evaluator.LargestError(monitor), 0);
}

TEST(FunctionEvaluator, IsAsAccurateAsItSaysForManyCentres)
{
  const ImplicitFunction& function = Large();
  ASSERT_GE(function.Centres.size(), FunctionEvaluator::FastFrom);
  Monitor monitor;
  const FunctionEvaluator evaluator(function, 1);
  const double measured = evaluator.LargestError(monitor);
  EXPECT_GT(measured, 0); // else the sums would be exact
  EXPECT_LE(measured, FunctionEvaluator::AskedError);

  const std::vector<Point3> places = Places(function);
  std::vector<double> values;
  std::vector<Vector3> gradients;
  evaluator.ValuesAndGradients(places, values, gradients, monitor);
  // The worst of more points than were measured.
  EXPECT_LE(
    LargestDifference(values, function.Evaluate(places, 1)), 5 * FunctionEvaluator::AskedError);
  EXPECT_LE(LargestDifference(values, evaluator.Values(places, monitor)), 1e-9);
  const std::vector<Vector3> exact = function.EvaluateGradients(places, 1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_LE(Norm(gradients[i] - exact[i]), 1e-4 * (1 + Norm(exact[i])));
  }
}

TEST(FunctionEvaluator, GivesAPointOneValueInAnyCompany)
{
  const ImplicitFunction& function = Large();
  Monitor monitor;
  const FunctionEvaluator one(function, 1);
  const FunctionEvaluator two(function, 2);
  const std::vector<Point3> places = Places(function);
  const std::vector<double> together = one.Values(places, monitor);
  EXPECT_EQ(together, two.Values(places, monitor));
  for (std::size_t i = 0; i < places.size(); i += 41)
  {
    EXPECT_EQ(one.Values({ places[i] }, monitor).front(), together[i]);
  }
}

TEST(FunctionEvaluator, SurfacesOfManyCentresAreSoundAndTheSameWithAnyNumberOfThreads)
{
  const ImplicitFunction& function = Large();
  std::vector<ImplicitMesh> meshes;
  for (const int threads : { 1, 2 })
  {
    PolygonizerOptions options;
    options.CellSize = 0.04;
    options.Threads = threads;
    Monitor monitor;
    meshes.push_back(Polygonize(function, SeedsOf(function), options, monitor));
  }
  recon::testing::ExpectSoundSurface(meshes[0].Mesh);
  EXPECT_EQ(meshes[0].Mesh.Points, meshes[1].Mesh.Points);
  EXPECT_EQ(meshes[0].Mesh.Triangles, meshes[1].Mesh.Triangles);
  EXPECT_EQ(meshes[0].Normals, meshes[1].Normals);
  const std::vector<double> f = function.Evaluate(meshes[0].Mesh.Points, 1);
  const std::vector<Vector3> slope = function.EvaluateGradients(meshes[0].Mesh.Points, 1);
  for (std::size_t i = 0; i < f.size(); ++i)
  {
    // The ball is cut nowhere: its box is larger.
    EXPECT_LE(std::abs(f[i]) / Norm(slope[i]), 1e-5 * 0.04);
  }
}

TEST(FunctionEvaluator, ContoursOfManyCentresLieOnTheSurface)
{
  const ImplicitFunction& function = Large();
  TracerOptions options;
  options.CellSize = 0.04;
  Monitor monitor;
  const ContourSet contours = TraceContours(
    function, SeedsOf(function), ParallelPlanes({ 0, 1, 0 }, -0.4, 0.4, 0.2), options, monitor);
  EXPECT_EQ(contours.Levels.size(), 5u);
  EXPECT_EQ(contours.Contours.size(), 5u);
  EXPECT_LE(LargestDifference(function.Evaluate(contours.Points, 1),
              std::vector<double>(contours.Points.size(), 0.0)),
    1e-4);
}

namespace
{
class StopLater : public Monitor
{
public:
  explicit StopLater(int asked) : Left(asked) {}
  bool AbortRequested() override { return --this->Left < 0; }

private:
  int Left;
};
}

TEST(FunctionEvaluator, CanBeAbortedWhileItIsMade)
{
  const FunctionEvaluator evaluator(Large(), 1);
  StopLater stop(2);
  EXPECT_THROW(evaluator.Values({ { 0, 0, 0 } }, stop), Aborted);
  Monitor monitor;
  EXPECT_EQ(evaluator.Values({ { 0, 0, 0 } }, monitor).size(), 1u);
}
