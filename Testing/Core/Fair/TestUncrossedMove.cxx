// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/UncrossedMove.h"

#include "Core/Mesh/MeshShapes.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TriangleTree.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
/// The unit ball, and behind its points those of a small one beside it.
TriangleMesh BallWithOneBeside(double radius, double distance)
{
  TriangleMesh balls = MakeSphere(24, 12);
  TriangleMesh small = MakeSphere(8, 4);
  for (Point3& p : small.Points)
  {
    p = radius * p;
  }
  Move(small, { distance, 0, 0 });
  Append(balls, small);
  return balls;
}
}

TEST(UncrossedMove, GoesAllTheWayWhereNothingCrosses)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  std::vector<Point3> places = sphere.Points;
  for (Point3& p : places)
  {
    p = 1.5 * p;
  }
  Monitor monitor;
  const UncrossedMove moved = MoveUncrossed(sphere, places, 0, {}, 1, monitor);
  EXPECT_EQ(moved.Mesh.Points, places);
  EXPECT_EQ(moved.HeldBack, 0u);
}

TEST(UncrossedMove, HoldsBackWhatWouldCross)
{
  // Two balls that grow into each other; far sides go all the way.
  TriangleMesh balls = MakeSphere(24, 12);
  TriangleMesh other = MakeSphere(24, 12);
  Move(other, { 2.2, 0, 0 });
  Append(balls, other);
  std::vector<Point3> places = balls.Points;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const Point3 middle{ p < places.size() / 2 ? 0.0 : 2.2, 0, 0 };
    places[p] = middle + 1.3 * (places[p] - middle);
  }
  Monitor monitor;
  const UncrossedMove moved = MoveUncrossed(balls, places, 0, {}, 1, monitor);
  EXPECT_FALSE(FindSelfIntersections(moved.Mesh, monitor).Any());
  EXPECT_GT(moved.HeldBack, 0u);
  EXPECT_LT(moved.HeldBack, places.size());
}

TEST(UncrossedMove, LetsNoAngleBecomeSmall)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  std::vector<Point3> places = sphere.Points;
  places[100] = places[101]; // a collapsed edge
  Monitor monitor;
  const UncrossedMove moved = MoveUncrossed(sphere, places, 0.05, {}, 1, monitor);
  EXPECT_GT(Norm(moved.Mesh.Points[100] - moved.Mesh.Points[101]), 0.01);
}

TEST(UncrossedMove, TurnsNoComponentInsideOut)
{
  // A small ball through its own middle, beside a large one that moves a little.
  TriangleMesh balls = MakeSphere(24, 12);
  TriangleMesh small = MakeSphere(8, 4);
  const std::size_t first = balls.Points.size();
  Move(small, { 3, 0, 0 });
  Append(balls, small);
  std::vector<Point3> places = balls.Points;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    places[p] = p < first ? 1.1 * places[p] : Point3{ 3, 0, 0 } - (places[p] - Point3{ 3, 0, 0 });
  }
  Monitor monitor;
  const UncrossedMove moved = MoveUncrossed(balls, places, 0, {}, 1, monitor);
  EXPECT_TRUE(CheckTopology(moved.Mesh).Total.Outward);
  EXPECT_EQ(moved.Mesh.Points.front(), places.front());
  EXPECT_EQ(moved.HeldBack, places.size() - first);
}

TEST(UncrossedMove, PutsNoComponentIntoAnother)
{
  const std::size_t first = MakeSphere(24, 12).Points.size();
  const TriangleMesh balls = BallWithOneBeside(0.1, 1.3);
  std::vector<Point3> places = balls.Points;
  for (std::size_t p = first; p < places.size(); ++p)
  {
    places[p][0] -= 1.3;
  }
  Monitor monitor;
  const UncrossedMove moved = MoveUncrossed(balls, places, 0, {}, 1, monitor);
  EXPECT_TRUE(CheckTopology(moved.Mesh).Total.Outward);
  EXPECT_FALSE(FindSelfIntersections(moved.Mesh, monitor).Any());
}

TEST(UncrossedMove, PassesOverNoComponent)
{
  // A large ball grows past a small one that stays where it is.
  const std::size_t first = MakeSphere(24, 12).Points.size();
  const TriangleMesh balls = BallWithOneBeside(0.05, 1.2);
  std::vector<Point3> places = balls.Points;
  for (std::size_t p = 0; p < first; ++p)
  {
    places[p] = 1.5 * places[p];
  }
  Monitor monitor;
  const UncrossedMove moved = MoveUncrossed(balls, places, 0, {}, 1, monitor);
  EXPECT_TRUE(CheckTopology(moved.Mesh).Total.Outward);
  EXPECT_FALSE(FindSelfIntersections(moved.Mesh, monitor).Any());
  EXPECT_GT(moved.HeldBack, 0u);
  EXPECT_LT(moved.HeldBack, first / 2);
}

TEST(UncrossedMove, GoesOnToPassPlaces)
{
  // A ball that shrinks away from places beside it, of which one is a point of it; elsewhere it goes all the way.
  const TriangleMesh sphere = MakeSphere(24, 12);
  std::vector<Point3> places = sphere.Points;
  for (Point3& p : places)
  {
    p = 0.8 * p;
  }
  const Point3 own = sphere.Points[100];
  const Point3 beside = 1.02 * sphere.Points[200];
  Monitor monitor;
  const UncrossedMove moved =
    MoveUncrossed(sphere, places, 0, { { own, beside }, 0.05 }, 1, monitor);
  EXPECT_EQ(moved.Mesh.Points[100], own);
  const TriangleTree tree(moved.Mesh);
  EXPECT_LE(tree.DistanceTo(beside, 1), 0.05);
  EXPECT_GT(moved.HeldBack, 1u);
  EXPECT_LT(moved.HeldBack, places.size() / 4);
  EXPECT_FALSE(FindSelfIntersections(moved.Mesh, monitor).Any());
}
