// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/SurfacePlaces.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace recon;
using namespace recon::testing;

TEST(SurfacePlaces, AgreeWithTheTreesDistances)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  const SurfacePlaces places(torus);
  const TriangleTree tree(torus);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (int i = 0; i < 300; ++i)
  {
    const Point3 p{ uniform(random), uniform(random), 0.3 * uniform(random) };
    const double distance = tree.DistanceTo(p, std::numeric_limits<double>::max());
    // Of every direction one that no nearest triangle faces away from.
    double least = std::numeric_limits<double>::max();
    for (const Vector3& n : { Vector3{ 1, 0, 0 }, Vector3{ -1, 0, 0 }, Vector3{ 0, 1, 0 },
           Vector3{ 0, -1, 0 }, Vector3{ 0, 0, 1 }, Vector3{ 0, 0, -1 } })
    {
      const SurfacePlace place = places.Nearest(p, n, 20);
      ASSERT_GE(place.Triangle, 0);
      EXPECT_NEAR(Norm(place.On(torus) - p), place.Distance, 1e-9);
      least = std::min(least, place.Distance);
    }
    EXPECT_NEAR(least, distance, 1e-9);
  }
}

TEST(SurfacePlaces, TellSheetsApartByTheirSide)
{
  const TriangleMesh cube = MakeBox({ 0, 0, 0 }, { 4, 4, 0.1 });
  const SurfacePlaces places(cube);
  const Point3 nearTop{ 2, 2, 0.09 };
  EXPECT_NEAR(places.Nearest(nearTop, { 0, 0, 1 }, 1).On(cube)[2], 0.1, 1e-12);
  EXPECT_NEAR(places.Nearest(nearTop, { 0, 0, -1 }, 1).On(cube)[2], 0, 1e-12);
}

TEST(SurfacePlaces, NoneBeyondTheRadius)
{
  const TriangleMesh cube = MakeCube();
  EXPECT_EQ(SurfacePlaces(cube).Nearest({ 5, 0, 0 }, { 1, 0, 0 }, 1).Triangle, -1);
}

TEST(SurfacePlaces, NormalsOfASpherePointOut)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  const std::vector<Vector3> normals = PointNormals(sphere);
  for (std::size_t p = 0; p < normals.size(); ++p)
  {
    EXPECT_GT(Dot(normals[p], sphere.Points[p]), 0.98);
  }
}

TEST(SurfacePlaces, AGuessChangesNothing)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  const SurfacePlaces places(torus);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-4, 4);
  std::uniform_int_distribution<int> triangle(0, static_cast<int>(torus.Triangles.size()) - 1);
  for (int i = 0; i < 2000; ++i)
  {
    const Point3 p{ coordinate(random), coordinate(random), 0.3 * coordinate(random) };
    const Vector3 normal{ 0, 0, i % 2 == 0 ? 1.0 : -1.0 };
    const SurfacePlace one = places.Nearest(p, normal, 1);
    const SurfacePlace other = places.Nearest(p, normal, 1, triangle(random));
    EXPECT_EQ(one.Triangle, other.Triangle);
    EXPECT_EQ(one.Shares, other.Shares);
    EXPECT_EQ(one.Distance, other.Distance);
  }
}
