// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/JointVoronoiPredicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace recon;

namespace
{
double SquaredDistance(const Point2& a, const Point2& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Where the bisectors of a-b and u-v cross, rounded.
Point2 NodeOf(const Point2& a, const Point2& b, const Point2& u, const Point2& v)
{
  const double a0 = b[0] - a[0], a1 = b[1] - a[1], u0 = v[0] - u[0], u1 = v[1] - u[1];
  const double c = (b[0] * b[0] + b[1] * b[1] - a[0] * a[0] - a[1] * a[1]) / 2;
  const double d = (v[0] * v[0] + v[1] * v[1] - u[0] * u[0] - u[1] * u[1]) / 2;
  const double det = a0 * u1 - a1 * u0;
  return { (c * u1 - a1 * d) / det, (a0 * d - c * u0) / det };
}

class Places
{
public:
  Point2 operator()() { return { this->Anywhere(this->Random), this->Anywhere(this->Random) }; }

private:
  std::mt19937 Random{ 17 };
  std::uniform_real_distribution<double> Anywhere{ -1, 1 };
};

LevelTriangulation OneTriangle(const Point2& a, const Point2& b, const Point2& c)
{
  LevelTriangulation level;
  level.Points = { a, b, c };
  level.Triangles = { { 0, 1, 2 } };
  return level;
}
}

TEST(JointVoronoiPredicates, NearerIsWhatDistancesSay)
{
  Places place;
  int decided = 0;
  for (int n = 0; n < 2000; ++n)
  {
    Point2 a = place(), b = place(), c = place();
    if ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0)
    {
      std::swap(b, c);
    }
    const LevelTriangulation level = OneTriangle(a, b, c);
    const Point2 centre = level.VoronoiVertex(0), p = place(), q = place();
    const double difference = SquaredDistance(centre, q) - SquaredDistance(centre, p);
    for (const bool fromLevel1 : { false, true })
    {
      const CircumcentreDistance distance(level, fromLevel1);
      EXPECT_NE(distance.IsNearer(0, p, q), distance.IsNearer(0, q, p));
      if (std::fabs(difference) > 1e-9 * (1 + SquaredDistance(centre, p)))
      {
        ++decided;
        EXPECT_EQ(distance.IsNearer(0, p, q), difference > 0);
      }
    }
  }
  EXPECT_GT(decided, 3000);
}

TEST(JointVoronoiPredicates, OfEquallyNearVerticesTheLevelsAgreeOnNone)
{
  // The circumcentre is (1, 1); p and q are as far from it. The larger one is nearer from level 1.
  const LevelTriangulation level = OneTriangle({ 0, 0 }, { 2, 0 }, { 0, 2 });
  const Point2 small{ -1, 1 }, large{ 3, 1 };
  EXPECT_TRUE(CircumcentreDistance(level, true).IsNearer(0, large, small));
  EXPECT_FALSE(CircumcentreDistance(level, true).IsNearer(0, small, large));
  EXPECT_TRUE(CircumcentreDistance(level, false).IsNearer(0, small, large));
  EXPECT_FALSE(CircumcentreDistance(level, false).IsNearer(0, large, small));
}

TEST(JointVoronoiPredicates, SideOfNodeIsThatOfTheCrossing)
{
  Places place;
  int decided = 0;
  for (int n = 0; n < 2000; ++n)
  {
    const Point2 a = place(), b = place(), u = place(), v = place();
    const Point2 node = NodeOf(a, b, u, v);
    const double turn = (b[0] - a[0]) * (node[1] - a[1]) - (b[1] - a[1]) * (node[0] - a[0]);
    if (std::isfinite(turn) &&
      std::fabs(turn) > 1e-9 * (1 + std::fabs(node[0]) + std::fabs(node[1])))
    {
      ++decided;
      EXPECT_EQ(SideOfNode(a, b, u, v), turn > 0 ? 1 : -1);
    }
  }
  EXPECT_GT(decided, 1500);
  // On the edge itself, exactly.
  EXPECT_EQ(SideOfNode({ 0, 0 }, { 2, 0 }, { 1, -1 }, { 1, 1 }), 0);
  EXPECT_EQ(SideOfNode({ 0, 0 }, { 2, 0 }, { 1, -1 }, { 1, std::nextafter(1, 2) }), 1);
}

TEST(JointVoronoiPredicates, SignAlongTheRightNormal)
{
  // u to v is up, so right is along +x.
  EXPECT_EQ(SignAlongRightNormal({ 0, 0 }, { 0, 1 }, { 5, 5 }, { 6, -9 }), 1);
  EXPECT_EQ(SignAlongRightNormal({ 0, 0 }, { 0, 1 }, { 5, 5 }, { 4, 9 }), -1);
  EXPECT_EQ(SignAlongRightNormal({ 0, 0 }, { 0, 1 }, { 5, 5 }, { 5, 7 }), 0);
  EXPECT_EQ(SignAlongRightNormal({ 0, 0 }, { 0.1, 0.3 }, { 0, 0 }, { 0.1, 0.3 }), 0);
}
