// SPDX-License-Identifier: GPL-3.0-or-later
// The edge next below another, beside what a look at all edges says.
#include "Planar/EdgeSweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace recon;

namespace
{
/// Edges from cell to cell of a grid: steps right, up, and up to the right, that never cross.
std::vector<PlanarEdge> GridEdges(int side, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<PlanarEdge> edges;
  const auto add = [&](int a, int b)
  {
    if (random() % 3 > 0)
    {
      edges.push_back(random() % 2 == 0 ? PlanarEdge{ a, b, 0 } : PlanarEdge{ b, a, 0 });
    }
  };
  for (int i = 0; i + 1 < side; ++i)
  {
    for (int j = 0; j + 1 < side; ++j)
    {
      const int at = i * side + j;
      add(at, at + side);
      add(at, at + 1);
      add(at, at + side + 1);
    }
  }
  std::shuffle(edges.begin(), edges.end(), random);
  return edges;
}

std::vector<Point2> GridPoints(int side)
{
  std::vector<Point2> points;
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      points.push_back({ double(i), double(j) });
    }
  }
  return points;
}

struct Line
{
  Point2 Left;
  Point2 Right;
  double At(double x) const
  {
    const double t = (x - this->Left[0]) / (this->Right[0] - this->Left[0]);
    return this->Left[1] + t * (this->Right[1] - this->Left[1]);
  }
};

/// The height, just right of an edge's left end, of the highest edge below it; numbers are exact here.
double HeightBelow(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges, int e)
{
  const auto line = [&](const PlanarEdge& edge)
  {
    return Line{ std::min(points[edge.A], points[edge.B]),
      std::max(points[edge.A], points[edge.B]) };
  };
  const Line of = line(edges[e]);
  const double x = of.Left[0] + 0.25;
  const bool vertical = of.Left[0] == of.Right[0];
  const double height = vertical ? of.Left[1] + 0.5 : of.At(x);
  double best = -1;
  for (const PlanarEdge& edge : edges)
  {
    const Line other = line(edge);
    if (other.Left[0] < x && other.Right[0] > x && other.Left[0] == of.Left[0] &&
      other.At(x) < height)
    {
      best = std::max(best, other.At(x));
    }
  }
  return best;
}

TEST(EdgeSweep, TellsTheEdgeNextBelowAsAllEdgesDo)
{
  const int side = 7;
  const std::vector<Point2> points = GridPoints(side);
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const std::vector<PlanarEdge> edges = GridEdges(side, seed);
    const std::vector<SweptEdge> swept = SweepEdges(points, edges);
    ASSERT_EQ(swept.size(), edges.size());
    std::vector<bool> met(edges.size(), false);
    for (const SweptEdge& s : swept)
    {
      EXPECT_FALSE(met[s.Edge]);
      met[s.Edge] = true;
      EXPECT_TRUE(s.Below < 0 || met[s.Below]);
      const PlanarEdge& e = edges[s.Edge];
      if (points[e.A][0] == points[e.B][0])
      {
        continue; // what is below the foot of an upright edge lies left of it
      }
      const double expected = HeightBelow(points, edges, s.Edge);
      const double x = std::min(points[e.A], points[e.B])[0] + 0.25;
      if (s.Below < 0)
      {
        EXPECT_EQ(expected, -1) << "seed " << seed;
        continue;
      }
      const PlanarEdge& b = edges[s.Below];
      const Line below{ std::min(points[b.A], points[b.B]), std::max(points[b.A], points[b.B]) };
      EXPECT_EQ(below.At(x), expected) << "seed " << seed;
    }
  }
}

TEST(EdgeSweep, GoesUpwardAlongUprightEdges)
{
  // A square, and a shorter upright edge in it.
  const std::vector<Point2> points{ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 2, 1 }, { 2, 3 } };
  const std::vector<PlanarEdge> edges{ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 5, 4 } };
  const std::vector<SweptEdge> swept = SweepEdges(points, edges);
  ASSERT_EQ(swept.size(), 5u);
  EXPECT_EQ(swept[0].Edge, 0);
  EXPECT_EQ(swept[1].Edge, 3);
  EXPECT_EQ(swept[1].Below, 0);
  EXPECT_EQ(swept[2].Edge, 2);
  EXPECT_EQ(swept[2].Below, 0); // the upright edge ends there
  EXPECT_EQ(swept[3].Edge, 4);
  EXPECT_EQ(swept[3].Below, 0);
  EXPECT_EQ(swept[4].Edge, 1);
  EXPECT_FALSE(RunsRight(points, edges[4]));
  EXPECT_TRUE(RunsRight(points, edges[0]));
  EXPECT_TRUE(SweepEdges(points, {}).empty());
}
}
