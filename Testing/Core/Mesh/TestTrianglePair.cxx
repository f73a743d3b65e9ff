// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TrianglePair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace recon;

namespace
{
/// Relation of abc to def, which must not depend on the order of triangles and corners, nor on the
/// coordinates' axes.
PairRelation Relate(const std::array<Point3, 3>& first, const std::array<Point3, 3>& second)
{
  std::array<int, 3> turn{ 0, 1, 2 };
  TriangleMesh mesh;
  mesh.Points = { first[0], first[1], first[2], second[0], second[1], second[2] };
  mesh.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  const PairRelation relation = RelateTriangles(mesh, 0, 1);
  do
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      TriangleMesh other;
      for (const Point3& p : mesh.Points)
      {
        other.Points.push_back({ p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] });
      }
      other.Triangles = { { turn[0], turn[1], turn[2] },
        { 3 + turn[1], 3 + turn[0], 3 + turn[2] } };
      EXPECT_EQ(RelateTriangles(other, 0, 1), relation);
      EXPECT_EQ(RelateTriangles(other, 1, 0), relation);
    }
  } while (std::next_permutation(turn.begin(), turn.end()));
  return relation;
}

const std::array<Point3, 3> Flat{ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } } };
}

TEST(TrianglePair, ApartIsClean)
{
  EXPECT_EQ(Relate(Flat, { { { 0, 0, 1 }, { 4, 0, 1 }, { 0, 4, 1 } } }), PairRelation::Clean);
  EXPECT_EQ(Relate(Flat, { { { 5, 5, 0 }, { 9, 5, 0 }, { 5, 9, 0 } } }), PairRelation::Clean);
}

TEST(TrianglePair, ThroughTheInnerIsCrossing)
{
  EXPECT_EQ(Relate(Flat, { { { 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 0 } } }), PairRelation::Crossing);
  // By the least that a double can tell.
  EXPECT_EQ(
    Relate(Flat, { { { 1, 1, -5e-324 }, { 1, 1, 1 }, { 2, 1, 1 } } }), PairRelation::Crossing);
}

TEST(TrianglePair, InOnePlaneIsOverlapping)
{
  EXPECT_EQ(Relate(Flat, { { { 1, 1, 0 }, { 9, 1, 0 }, { 1, 9, 0 } } }), PairRelation::Overlapping);
  EXPECT_EQ(Relate(Flat, Flat), PairRelation::Overlapping);
}

TEST(TrianglePair, AtPointsThatAreNotSharedIsTouching)
{
  // A corner on the inside, a corner on an edge, edges that cross in a plane's border, equal
  // corners of other numbers.
  EXPECT_EQ(Relate(Flat, { { { 1, 1, 0 }, { 1, 1, 1 }, { 2, 1, 1 } } }), PairRelation::Touching);
  EXPECT_EQ(Relate(Flat, { { { 2, 2, 0 }, { 5, 5, 1 }, { 5, 5, -1 } } }), PairRelation::Touching);
  EXPECT_EQ(Relate(Flat, { { { 2, 0, 1 }, { 2, 0, -1 }, { 2, -3, 0 } } }), PairRelation::Touching);
  EXPECT_EQ(Relate(Flat, { { { 0, 0, 0 }, { -4, 0, 1 }, { 0, -4, 1 } } }), PairRelation::Touching);
}

TEST(TrianglePair, WhatIsSharedByIndexIsClean)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 4, 1 }, { -4, 0, 1 }, { 0, -4, 1 },
    { 1, 1, 0 } };
  mesh.Triangles = { { 0, 1, 2 }, { 2, 1, 3 }, { 0, 4, 5 }, { 0, 1, 6 } };
  EXPECT_EQ(RelateTriangles(mesh, 0, 1), PairRelation::Clean);
  EXPECT_EQ(RelateTriangles(mesh, 0, 2), PairRelation::Clean);
  EXPECT_EQ(RelateTriangles(mesh, 0, 3), PairRelation::Overlapping);
}

TEST(TrianglePair, WithoutAreaThereIsNoRelation)
{
  EXPECT_EQ(Relate(Flat, { { { 1, 1, 0 }, { 1, 1, 0 }, { 1, 1, 0 } } }), PairRelation::Clean);
  EXPECT_EQ(Relate(Flat, { { { 1, 1, -1 }, { 1, 1, 0 }, { 1, 1, 1 } } }), PairRelation::Clean);
}

TEST(TrianglePair, CornersThatAreSharedHideNoCrossing)
{
  // The same triangles with points of their own cross or overlap just then; corners of a grid, as it is
  // and sheared so that coordinates round.
  std::mt19937 random(1);
  std::uniform_int_distribution<int> whole(-2, 2);
  int crossing = 0, overlapping = 0, clean = 0;
  for (int i = 0; i < 200000; ++i)
  {
    TriangleMesh shared;
    for (int p = 0; p < 5; ++p)
    {
      const double x = whole(random), y = whole(random), z = i % 3 == 0 ? 0 : whole(random);
      shared.Points.push_back(i % 2 == 0
          ? Point3{ x, y, z }
          : Point3{ x + 0.1 * y + 0.7 * z, 0.3 * x + y, z / 3 - 0.9 * y });
    }
    shared.Triangles = { { 0, 1, 2 }, { 0, 3, i % 5 < 2 ? 1 : 4 } };
    TriangleMesh apart;
    for (const auto& corners : shared.Triangles)
    {
      const int first = static_cast<int>(apart.Points.size());
      for (int p : corners)
      {
        apart.Points.push_back(shared.Points[p]);
      }
      apart.Triangles.push_back({ first, first + 1, first + 2 });
    }
    const PairRelation by = RelateTriangles(shared, 0, 1);
    const PairRelation of = RelateTriangles(apart, 0, 1);
    const auto isBad = [](PairRelation relation)
    { return relation == PairRelation::Crossing || relation == PairRelation::Overlapping; };
    ASSERT_TRUE(isBad(by) == isBad(of) && (!isBad(of) || by == of)) << i;
    crossing += of == PairRelation::Crossing ? 1 : 0;
    overlapping += of == PairRelation::Overlapping ? 1 : 0;
    clean += by == PairRelation::Clean ? 1 : 0;
  }
  EXPECT_GT(crossing, 1000);
  EXPECT_GT(overlapping, 1000);
  EXPECT_GT(clean, 1000);
}
