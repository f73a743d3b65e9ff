// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairFit.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Places a little outside a sphere, at every third point.
std::vector<ContourSample> Around(const TriangleMesh& sphere, double radius)
{
  std::vector<ContourSample> samples;
  for (std::size_t p = 1; p < sphere.Points.size(); p += 3)
  {
    samples.push_back({ radius * sphere.Points[p], sphere.Points[p], 0.1, 0, true, radius });
  }
  return samples;
}

FairFitOptions Options(double tolerance)
{
  FairFitOptions options;
  options.Tolerance = tolerance;
  options.EdgeLength = 0.2;
  options.Weight = 100;
  options.Threads = 1;
  return options;
}
}

TEST(FairFit, MeasuresHowFarVerticesAre)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  Monitor monitor;
  const SampleMisfit misfit = MeasureMisfit(sphere, Around(sphere, 1.1), 0.05, 1, monitor);
  EXPECT_NEAR(misfit.Farthest, 0.1, 1e-9);
  EXPECT_EQ(misfit.Beyond, Around(sphere, 1.1).size());
  EXPECT_EQ(MeasureMisfit(sphere, Around(sphere, 1), 0.05, 1, monitor).Beyond, 0u);
}

TEST(FairFit, MoreWeightBringsTheSurfaceWithinTheTolerance)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  const std::vector<ContourSample> samples = Around(sphere, 1.1);
  const FairFitOptions options = Options(0.02);
  Monitor monitor;
  std::vector<Pull> pulls = PullsOf(SurfacePlaces(sphere), samples, options, monitor);
  ASSERT_EQ(pulls.size(), samples.size());
  TriangleMesh moved = sphere;
  moved.Points = SolveWithin(sphere, pulls, 0.1, options, monitor).Points;
  EXPECT_EQ(MeasureMisfit(moved, samples, options.Tolerance, 1, monitor).Beyond, 0u);
}

TEST(FairFit, PullsWithinTheTolerance)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  const std::vector<ContourSample> samples = Around(sphere, 1.02);
  Monitor monitor;
  const PulledMesh made = PullWithin(sphere, samples, Options(0.005), monitor);
  EXPECT_TRUE(made.IsWithin);
  const TriangleMesh& pulled = made.Mesh;
  EXPECT_EQ(MeasureMisfit(pulled, samples, 0.005, 1, monitor).Beyond, 0u);
}

TEST(FairFit, SmallContoursPullMore)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  FairFitOptions options = Options(0.02);
  Monitor monitor;
  const auto weightAt = [&](double scale, double most)
  {
    options.Scale = scale;
    options.MostWeight = most;
    return PullsOf(SurfacePlaces(sphere), Around(sphere, 1), options, monitor).front().Weight;
  };
  const double usual = weightAt(1, 1e9);
  EXPECT_NEAR(usual, 100 * 0.1, 1e-9);
  EXPECT_NEAR(weightAt(2, 1e9), 8 * usual, 1e-9);
  EXPECT_NEAR(weightAt(2, 300), 3 * usual, 1e-9);
  EXPECT_NEAR(weightAt(0.5, 1), usual, 1e-9);
}
