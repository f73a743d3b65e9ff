// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/VertexStars.h"

#include "Mesh/TrianglePair.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<char> Find(const TriangleMesh& mesh, int threads = 1)
{
  Monitor monitor;
  return FindFlatStars(mesh, threads, monitor);
}

/// Triangles around point 0, through the others in turn.
TriangleMesh Fan(const std::vector<Point3>& ring)
{
  TriangleMesh fan;
  fan.Points.push_back({ 0, 0, 0 });
  fan.Points.insert(fan.Points.end(), ring.begin(), ring.end());
  const int count = static_cast<int>(ring.size());
  for (int k = 0; k < count; ++k)
  {
    fan.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % count });
  }
  return fan;
}

std::vector<Point3> Turned(int points, int rounds, double height)
{
  std::vector<Point3> ring;
  for (int k = 0; k < points; ++k)
  {
    const double angle = 2 * Pi * rounds * k / points;
    ring.push_back({ std::cos(angle), std::sin(angle), k % 2 == 0 ? height : -height });
  }
  return ring;
}
}

TEST(VertexStars, OfASmoothMeshAllAre)
{
  const std::vector<char> flat = Find(MakeTorus(3, 1, 60, 30));
  EXPECT_EQ(std::count(flat.begin(), flat.end(), 1), static_cast<int>(flat.size()));
}

TEST(VertexStars, ADiscIsOnceAround)
{
  for (const double height : { 0.0, 0.3, 5.0 })
  {
    EXPECT_TRUE(Find(Fan(Turned(6, 1, height)))[0]) << height;
    EXPECT_FALSE(Find(Fan(Turned(7, 2, height)))[0]) << height;
  }
  // Where it ends, and where it turns back, nothing is said.
  TriangleMesh open = Fan(Turned(6, 1, 0));
  EXPECT_FALSE(Find(open)[1]);
  open.Triangles.pop_back();
  EXPECT_FALSE(Find(open)[0]);
  EXPECT_FALSE(Find(Fan({ { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 1, 1, 0 }, { 0, -1, 0 } }))[0]);
}

TEST(VertexStars, WhatIsCalledFlatIsCleanPairByPair)
{
  // Rings on a coarse grid: in line with each other, twice in one place, folded.
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-2, 2);
  int flat = 0;
  for (int fan = 0; fan < 20000; ++fan)
  {
    std::vector<Point3> ring(3 + fan % 4);
    for (Point3& p : ring)
    {
      p = { 0.1 * coordinate(random), 0.1 * coordinate(random), 0.1 * coordinate(random) };
    }
    const TriangleMesh mesh = Fan(ring);
    if (!Find(mesh)[0])
    {
      continue;
    }
    ++flat;
    for (int s = 0; s < static_cast<int>(ring.size()); ++s)
    {
      for (int t = s + 1; t < static_cast<int>(ring.size()); ++t)
      {
        ASSERT_EQ(RelateTriangles(mesh, s, t), PairRelation::Clean) << fan << " " << s << " " << t;
      }
    }
  }
  EXPECT_GT(flat, 100);
}

TEST(VertexStars, DoNotDependOnTheThreads)
{
  const TriangleMesh torus = MakeTorus(3, 1, 100, 50);
  EXPECT_EQ(Find(torus, 1), Find(torus, 3));
}
