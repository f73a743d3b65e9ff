// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest vertices and first contours beside those found by trying all.
#include "BoundaryOracle.h"

#include "Polyhedral/LevelSearch.h"

#include <gtest/gtest.h>

#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
LevelTriangulation RandomLevel()
{
  std::mt19937 random(3);
  return TriangulateLevels(BuildStack({ { RandomStar(80, { 0, 0 }, 0.5, 1, random),
                                          RandomStar(40, { 3, 0 }, 0.2, 1, random) },
                             { RegularPolygon(5, 1) } }),
    false)[0];
}

double DistanceBetween(const Point2& p, const Point2& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}
}

TEST(LevelSearch, FindsTheNearestVertex)
{
  const LevelTriangulation level = RandomLevel();
  const LevelSearch search(level);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-2, 5);
  for (int i = 0; i < 500; ++i)
  {
    const Point2 p{ place(random), place(random) };
    double least = 1e9;
    for (const Point2& q : level.Points)
    {
      least = std::min(least, DistanceBetween(p, q));
    }
    EXPECT_EQ(DistanceBetween(p, level.Points[search.NearestVertex(p)]), least);
  }
}

TEST(LevelSearch, FindsTheFirstContourThatALineMeets)
{
  const LevelTriangulation level = RandomLevel();
  const LevelSearch search(level);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-2, 5);
  int met = 0;
  for (int i = 0; i < 500; ++i)
  {
    const PlanarLine line{ { place(random), place(random) }, { place(random), place(random) }, -0.5,
      1.5 };
    double first = 1e9;
    for (std::size_t t = 0; t < level.Triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (level.EdgeContour[t][k] < 0)
        {
          continue;
        }
        const Point2& p = level.Points[level.Triangles[t][(k + 1) % 3]];
        const Point2& q = level.Points[level.Triangles[t][(k + 2) % 3]];
        // origin + s direction = p + u (q - p)
        const double dx = line.Direction[0], dy = line.Direction[1];
        const double ex = q[0] - p[0], ey = q[1] - p[1];
        const double px = p[0] - line.Origin[0], py = p[1] - line.Origin[1];
        const double s = (px * ey - py * ex) / (dx * ey - dy * ex);
        const double u = (px * dy - py * dx) / (dx * ey - dy * ex);
        first = u >= 0 && u <= 1 && s >= line.From && s <= line.To ? std::min(first, s) : first;
      }
    }
    const auto found = search.FirstContour(line, 1e-10);
    ASSERT_EQ(found.has_value(), first < 1e9);
    if (found)
    {
      ++met;
      EXPECT_LE(found->From, first);
      EXPECT_GE(found->To, first);
      EXPECT_NEAR(found->From, first, 1e-6);
    }
  }
  EXPECT_GT(met, 100);
}
