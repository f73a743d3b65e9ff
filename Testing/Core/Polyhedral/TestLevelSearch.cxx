// SPDX-License-Identifier: GPL-3.0-or-later
// Nearest vertices and first contours beside those found by trying all.
#include "BoundaryOracle.h"

#include "Polyhedral/DelaunayEdges.h"
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

constexpr double Nowhere = 1e9;

/// @returns where on the line it meets the segment from p to q, or Nowhere
double PlaceOnLine(const PlanarLine& line, const Point2& p, const Point2& q)
{
  // origin + s direction = p + u (q - p)
  const double dx = line.Direction[0], dy = line.Direction[1];
  const double ex = q[0] - p[0], ey = q[1] - p[1];
  const double px = p[0] - line.Origin[0], py = p[1] - line.Origin[1];
  const double s = (px * ey - py * ex) / (dx * ey - dy * ex);
  const double u = (px * dy - py * dx) / (dx * ey - dy * ex);
  return u >= 0 && u <= 1 && s >= line.From && s <= line.To ? s : Nowhere;
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
    double first = Nowhere;
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
        first = std::min(first, PlaceOnLine(line, p, q));
      }
    }
    const auto found = search.FirstContour(line, 1e-10);
    ASSERT_EQ(found.has_value(), first < Nowhere);
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

TEST(LevelSearch, FindsTheFirstEdgeOfTheExternalSkeletonThatALineMeets)
{
  const LevelTriangulation level = RandomLevel();
  const LevelSearch search(level);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-2, 5);
  int met = 0;
  for (int i = 0; i < 500; ++i)
  {
    const PlanarLine line{ { place(random), place(random) }, { place(random), place(random) }, -0.5,
      1.5 };
    double first = Nowhere;
    for (int edge = 0; edge < static_cast<int>(3 * level.Triangles.size()); ++edge)
    {
      const int triangle = edge / 3;
      const int neighbour = level.Neighbours[triangle][edge % 3];
      if (KindOf(level, edge) != EdgeKind::External)
      {
        continue;
      }
      const Point2& a = level.Points[level.Triangles[triangle][(edge + 1) % 3]];
      const Point2& b = level.Points[level.Triangles[triangle][(edge + 2) % 3]];
      const Point2 p = level.VoronoiVertex(triangle);
      // Across the hull it goes to infinity, at right angles to the edge.
      const Point2 q = neighbour < 0
        ? Point2{ p[0] + 1e3 * (b[1] - a[1]), p[1] - 1e3 * (b[0] - a[0]) }
        : level.VoronoiVertex(neighbour);
      first = std::min(first, PlaceOnLine(line, p, q));
    }
    const auto found = search.FirstExternal(line, 1e-10);
    ASSERT_EQ(found.has_value(), first < Nowhere);
    if (found)
    {
      ++met;
      EXPECT_LE(found->From, first);
      EXPECT_NEAR(found->From, first, 1e-4);
    }
  }
  EXPECT_GT(met, 100);
}
