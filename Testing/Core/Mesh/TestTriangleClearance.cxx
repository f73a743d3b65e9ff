// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleClearance.h"
#include "Mesh/TrianglePair.h"

#include <gtest/gtest.h>

#include <random>

using namespace recon;

namespace
{
using Corners = std::array<Point3, 3>;

Point3 Anywhere(std::mt19937& random, double reach)
{
  std::uniform_real_distribution<double> uniform(-reach, reach);
  const double x = uniform(random), y = uniform(random);
  return { x, y, uniform(random) };
}

Corners RandomTriangle(std::mt19937& random, const Point3& middle)
{
  return { middle + Anywhere(random, 1), middle + Anywhere(random, 1),
    middle + Anywhere(random, 1) };
}

bool DoMeet(const Corners& s, const Corners& t)
{
  TriangleMesh mesh;
  mesh.Points.insert(mesh.Points.end(), s.begin(), s.end());
  mesh.Points.insert(mesh.Points.end(), t.begin(), t.end());
  mesh.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  return RelateTriangles(mesh, 0, 1) != PairRelation::Clean;
}
}

TEST(TriangleClearance, WhatIsFartherApartDoesNotMeetHoweverItIsMoved)
{
  std::mt19937 random(3);
  int apart = 0;
  for (int n = 0; n < 4000; ++n)
  {
    const Corners s = RandomTriangle(random, { 1e6, 0, 0 });
    const Corners t = RandomTriangle(random, Point3{ 1e6, 0, 0 } + Anywhere(random, 1));
    constexpr double Reach = 0.1;
    if (!AreFartherApartThan(s, t, 2 * Reach * std::sqrt(3.0)))
    {
      continue;
    }
    ++apart;
    for (int move = 0; move < 8; ++move)
    {
      Corners a = s, b = t;
      for (std::size_t k = 0; k < 3; ++k)
      {
        a[k] = a[k] + Anywhere(random, Reach);
        b[k] = b[k] + Anywhere(random, Reach);
      }
      EXPECT_FALSE(DoMeet(a, b));
    }
  }
  EXPECT_GT(apart, 400);
}

TEST(TriangleClearance, DistanceIsTakenAtItsWord)
{
  const Corners low{ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } } };
  const Corners high{ { { 1, 1, 2 }, { 5, 1, 2 }, { 1, 5, 2 } } };
  EXPECT_TRUE(AreFartherApartThan(low, high, 1.999));
  EXPECT_FALSE(AreFartherApartThan(low, high, 2));
  // Needles that pass each other, which no face and no side tells apart.
  const Corners along{ { { -5, 0, 0 }, { 5, 0, 0 }, { 5, 0, -1e-3 } } };
  const Corners across{ { { 0, -5, 1 }, { 0, 5, 1 }, { 0, 5, 1.001 } } };
  EXPECT_TRUE(AreFartherApartThan(along, across, 0.999));
  EXPECT_FALSE(AreFartherApartThan(along, across, 1));
}

TEST(TriangleClearance, WhatMeetsOrHasNoAreaIsNotApart)
{
  const Corners one{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } };
  const Corners point{ { { 9, 9, 9 }, { 9, 9, 9 }, { 9, 9, 9 } } };
  EXPECT_FALSE(AreFartherApartThan(one, one, 0));
  EXPECT_FALSE(AreFartherApartThan(point, point, 0));
  EXPECT_TRUE(AreFartherApartThan(one, point, 1));
  const Corners touching{ { { 0, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 } } };
  EXPECT_FALSE(AreFartherApartThan(one, touching, 0));
}
