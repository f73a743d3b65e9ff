// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSystem.h"

#include "Base/Median.h"
#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Every n-th point is pulled to where it is, moved and turned by an affine map.
std::vector<Pull> PullEvery(const TriangleMesh& mesh, std::size_t step, const Point3& by)
{
  std::vector<Pull> pulls;
  for (std::size_t t = 0; t < mesh.Triangles.size(); t += step)
  {
    Pull pull;
    pull.From.Triangle = static_cast<int>(t);
    pull.From.Shares = { 0.2, 0.3, 0.5 };
    pull.To = pull.From.On(mesh) + by;
    pull.Weight = 1e6;
    pulls.push_back(pull);
  }
  return pulls;
}

/// The same at every point.
std::vector<double> All(const TriangleMesh& mesh, double tension)
{
  return std::vector<double>(mesh.Points.size(), tension);
}
}

TEST(FairSystem, FullTensionLeavesTheMeshWhereItIs)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  Monitor monitor;
  FairSystem system(torus, {}, 1, 0, monitor);
  const std::vector<Point3> places =
    system.Solve(torus.Points, PullEvery(torus, 7, { 0, 0, 0 }), All(torus, 1), 0);
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    EXPECT_LT(Norm(places[p] - torus.Points[p]), 1e-9);
  }
}

TEST(FairSystem, FollowsPullsThatAgree)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  Monitor monitor;
  FairSystem system(torus, {}, 1, 0, monitor);
  const Vector3 by{ 1, 2, 3 };
  for (const double tension : { 0.0, 0.4, 1.0 })
  {
    const std::vector<Pull> pulls = PullEvery(torus, 3, by);
    TriangleMesh moved = torus;
    moved.Points = system.Solve(torus.Points, pulls, All(torus, tension), 2);
    for (const Pull& pull : pulls)
    {
      EXPECT_LT(Norm(pull.From.On(moved) - pull.To), 0.02) << tension;
    }
  }
}

TEST(FairSystem, ABallStaysABallWhereBendIsEvenedOut)
{
  // Held at two circles of latitude, about half a unit apart from its poles: a plate is flat there, a ball is not.
  const TriangleMesh sphere = MakeSphere(48, 24);
  std::vector<Pull> pulls;
  for (std::size_t t = 0; t < sphere.Triangles.size(); ++t)
  {
    Pull pull;
    pull.From.Triangle = static_cast<int>(t);
    pull.From.Shares = { 1, 0, 0 };
    pull.To = pull.From.On(sphere);
    pull.Weight = 1e6;
    if (std::abs(std::abs(pull.To[2]) - 0.6) < 0.15)
    {
      pulls.push_back(pull);
    }
  }
  Monitor monitor;
  FairSystem system(sphere, {}, 1, 1, monitor);
  const auto farthest = [&](int evenings)
  {
    double most = 0;
    for (const Point3& p : system.Solve(sphere.Points, pulls, All(sphere, 0), evenings))
    {
      most = std::max(most, std::abs(Norm(p) - 1));
    }
    return most;
  };
  const double plate = farthest(0);
  EXPECT_GT(plate, 0.02);
  EXPECT_LT(farthest(1), 0.6 * plate);
  EXPECT_LT(farthest(6), 0.3 * plate);
}

TEST(FairSystem, EvensOutAStep)
{
  // A point that stands out, and no pull there: it goes back between its neighbours.
  TriangleMesh sphere = MakeSphere(24, 12);
  const std::vector<Pull> pulls = PullEvery(sphere, 2, { 0, 0, 0 });
  const Point3 kept = sphere.Points[150];
  sphere.Points[150] = 1.2 * kept;
  Monitor monitor;
  FairSystem system(sphere, {}, 0.5, 0, monitor);
  const double out = Norm(system.Solve(sphere.Points, pulls, All(sphere, 0), 0)[150]);
  EXPECT_LT(std::abs(out - 1), 0.05);
}

TEST(FairSystem, AnotherShapeIsAsIfItWereTheFirst)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  std::vector<Point3> shape = torus.Points;
  for (Point3& p : shape)
  {
    p = { p[0], 1.5 * p[1], p[2] + 0.1 * p[0] * p[1] };
  }
  Monitor monitor;
  const std::vector<Pull> pulls = PullEvery(torus, 5, { 0.1, 0, 0 });
  FairSystem twice(torus, {}, 1, 1, monitor);
  const std::vector<Point3> first = twice.Solve(torus.Points, pulls, All(torus, 0.1), 1);
  const std::vector<Point3> second = twice.Solve(shape, pulls, All(torus, 0.1), 1);
  FairSystem once(torus, {}, 1, 3, monitor);
  EXPECT_EQ(second, once.Solve(shape, pulls, All(torus, 0.1), 1));
  EXPECT_NE(second, first);
}

TEST(FairSystem, ASliverOrAStrongPullHoldsNothingElse)
{
  // Pulled out at a few places, the rest of a ball follows; whatever a single triangle or pull weighs.
  TriangleMesh sphere = MakeSphere(24, 12);
  const auto meanRadius = [&](double weight)
  {
    std::vector<Pull> pulls = PullEvery(sphere, 40, { 0, 0, 0 });
    for (Pull& pull : pulls)
    {
      pull.To = 1.5 * pull.To;
    }
    pulls.front().Weight = weight;
    Monitor monitor;
    FairSystem system(sphere, {}, 1, 1, monitor);
    double sum = 0;
    for (const Point3& p : system.Solve(sphere.Points, pulls, All(sphere, 0), 0))
    {
      sum += Norm(p);
    }
    return sum / static_cast<double>(sphere.Points.size());
  };
  const double usual = meanRadius(1e6);
  EXPECT_GT(usual, 1.4);
  EXPECT_NEAR(meanRadius(1e11), usual, 1e-3);
  const auto& corners = sphere.Triangles[100];
  sphere.Points[corners[0]] =
    sphere.Points[corners[1]] + 1e-9 * (sphere.Points[corners[0]] - sphere.Points[corners[1]]);
  EXPECT_NEAR(meanRadius(1e6), usual, 0.02);
}

TEST(FairSystem, TensionMayDifferFromPlaceToPlace)
{
  // Pulls move all of a ball; where there is all the tension, its shape stays as it was at rest.
  TriangleMesh sphere = MakeSphere(24, 12);
  for (Point3& p : sphere.Points)
  {
    p[2] *= p[2] > 0.3 ? 1 + 0.2 * std::sin(20 * p[0]) : 1;
  }
  std::vector<double> tension = All(sphere, 0);
  for (std::size_t p = 0; p < tension.size(); ++p)
  {
    tension[p] = sphere.Points[p][0] > 0 ? 1 : 0;
  }
  Monitor monitor;
  FairSystem system(sphere, {}, 1, 1, monitor);
  std::vector<Pull> pulls = PullEvery(sphere, 40, { 0, 0, 0 });
  const std::vector<Point3> places = system.Solve(sphere.Points, pulls, tension, 0);
  double tense = 0;
  double loose = 0;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    double& most = sphere.Points[p][0] > 0.5 ? tense : loose;
    most =
      std::max(most, std::abs(sphere.Points[p][0]) > 0.5 ? Norm(places[p] - sphere.Points[p]) : 0);
  }
  EXPECT_LT(tense, 0.5 * loose);
}

TEST(FairSystem, TheBendOfABallIsThatOfItsRadius)
{
  // Both curvatures are 1, in units of one by the scale.
  TriangleMesh sphere = MakeSphere(60, 30);
  Monitor monitor;
  FairSystem system(sphere, {}, 0.5, 1, monitor);
  // Most points; beside the poles triangles are thin.
  EXPECT_NEAR(Median(system.BendOf(sphere.Points)), 0.5 * 2, 0.05);
}
