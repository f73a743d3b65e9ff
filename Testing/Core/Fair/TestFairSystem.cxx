// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSystem.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

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
}

TEST(FairSystem, FullTensionLeavesTheMeshWhereItIs)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  Monitor monitor;
  FairSystem system(torus, {}, 1, 0, monitor);
  const std::vector<Point3> places =
    system.Solve(torus.Points, PullEvery(torus, 7, { 0, 0, 0 }), 1);
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
    moved.Points = system.Solve(torus.Points, pulls, tension);
    for (const Pull& pull : pulls)
    {
      EXPECT_LT(Norm(pull.From.On(moved) - pull.To), 0.02) << tension;
    }
  }
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
  const double out = Norm(system.Solve(sphere.Points, pulls, 0)[150]);
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
  const std::vector<Point3> first = twice.Solve(torus.Points, pulls, 0.1);
  const std::vector<Point3> second = twice.Solve(shape, pulls, 0.1);
  FairSystem once(torus, {}, 1, 3, monitor);
  EXPECT_EQ(second, once.Solve(shape, pulls, 0.1));
  EXPECT_NE(second, first);
}
