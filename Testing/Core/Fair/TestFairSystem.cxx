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
  FairSystem system(torus, {}, torus.Points, 1, 0, monitor);
  const std::vector<Point3> places = system.Solve(PullEvery(torus, 7, { 0, 0, 0 }), 1);
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    EXPECT_LT(Norm(places[p] - torus.Points[p]), 1e-9);
  }
}

TEST(FairSystem, FollowsPullsThatAgree)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  Monitor monitor;
  FairSystem system(torus, {}, torus.Points, 1, 0, monitor);
  const Vector3 by{ 1, 2, 3 };
  for (const double tension : { 0.0, 0.4, 1.0 })
  {
    const std::vector<Pull> pulls = PullEvery(torus, 3, by);
    TriangleMesh moved = torus;
    moved.Points = system.Solve(pulls, tension);
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
  FairSystem system(sphere, {}, sphere.Points, 0.5, 0, monitor);
  const double out = Norm(system.Solve(pulls, 0)[150]);
  EXPECT_LT(std::abs(out - 1), 0.05);
}
