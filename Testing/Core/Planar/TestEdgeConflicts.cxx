// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings, touches and twins: each kind by itself, at and beside the tolerance.
#include "Base/Monitor.h"
#include "Planar/EdgeConflicts.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;

namespace
{
EdgeConflicts Between(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges,
  double tolerance = 0.01, std::size_t most = 100)
{
  return FindEdgeConflicts(points, edges, { tolerance }, most);
}

TEST(EdgeConflicts, Crossing)
{
  const std::vector<Point2> points{ { 0, 0 }, { 2, 2 }, { 0, 2 }, { 2, 0 } };
  const std::vector<PlanarEdge> edges{ { 0, 1, 0 }, { 2, 3, 0 } };
  const EdgeConflicts found = Between(points, edges);
  ASSERT_EQ(found.Crossings.size(), 1u);
  EXPECT_TRUE(found.Touches.empty());
  EXPECT_TRUE(found.SamePlace.empty());
  EXPECT_EQ(CrossingPoint(points[0], points[1], points[2], points[3]), (Point2{ 1, 1 }));
  EXPECT_THROW(Between(points, edges, 0.01, 0), Error);
}

TEST(EdgeConflicts, ATouchIsWithinTheTolerance)
{
  for (double height : { 0.0, 0.009, 0.011 })
  {
    const EdgeConflicts found =
      Between({ { 0, 0 }, { 2, 0 }, { 1, height }, { 1, 2 } }, { { 0, 1, 0 }, { 2, 3, 0 } });
    ASSERT_EQ(found.Touches.size(), height < 0.01 ? 1u : 0u);
    EXPECT_EQ(found.Empty(), height > 0.01);
    if (!found.Empty())
    {
      EXPECT_EQ(found.Touches[0].Edge, 0);
      EXPECT_EQ(found.Touches[0].Other, 1);
      EXPECT_EQ(found.Touches[0].Vertex, 2);
    }
  }
}

TEST(EdgeConflicts, TheSmallerToleranceOfTwoCounts)
{
  const std::vector<Point2> points{ { 0, 0 }, { 2, 0 }, { 1, 0.009 }, { 1, 2 } };
  const std::vector<PlanarEdge> edges{ { 0, 1, 0 }, { 2, 3, 1 } };
  EXPECT_FALSE(FindEdgeConflicts(points, edges, { 0.01, 0.01 }, 9).Empty());
  EXPECT_TRUE(FindEdgeConflicts(points, edges, { 0.01, 0.001 }, 9).Empty());
}

TEST(EdgeConflicts, PairsOfVeryManyNearPointsAreNotAllTold)
{
  // A walk back and forth between two places, each point a little beside the others of its place.
  std::vector<Point2> points;
  std::vector<PlanarEdge> edges;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back({ i % 2 + 1e-5 * i, 1e-5 * (i % 7) });
    edges.push_back({ i, (i + 1) % 200, 0 });
  }
  EXPECT_GT(Between(points, edges, 0.01, 1000000).SamePlace.size(), 19000u);
  EXPECT_EQ(Between(points, edges, 0.01, 500).SamePlace.size(), 501u);
  // Nor are short edges, which are looked at first.
  EXPECT_EQ(Between(points, edges, 9, 5).SamePlace.size(), 6u);
}

TEST(EdgeConflicts, TwinsAndShortEdges)
{
  const EdgeConflicts ends =
    Between({ { 0, 0 }, { 2, 0 }, { 2.006, 0.006 }, { 3, 3 } }, { { 0, 1, 0 }, { 2, 3, 0 } });
  ASSERT_EQ(ends.SamePlace.size(), 1u);
  EXPECT_EQ(ends.SamePlace[0].First, 1);
  EXPECT_EQ(ends.SamePlace[0].Second, 2);
  const EdgeConflicts shortEdge = Between({ { 0, 0 }, { 0.009, 0 } }, { { 0, 1, 0 } });
  ASSERT_EQ(shortEdge.SamePlace.size(), 1u);
  EXPECT_EQ(shortEdge.SamePlace[0].FirstEdge, shortEdge.SamePlace[0].OtherEdge);
}

TEST(EdgeConflicts, SpikesFoldBack)
{
  // Out to 1 and back to 3, hardly beside; and straight on.
  const EdgeConflicts spike =
    Between({ { 0, 0 }, { 2, 0 }, { 1, 0.004 } }, { { 0, 1, 0 }, { 1, 2, 0 } });
  ASSERT_EQ(spike.Touches.size(), 1u);
  EXPECT_EQ(spike.Touches[0].Vertex, 2);
  EXPECT_TRUE(Between({ { 0, 0 }, { 2, 0 }, { 4, 0.004 } }, { { 0, 1, 0 }, { 1, 2, 0 } }).Empty());
}

TEST(EdgeConflicts, WithoutToleranceEverythingIsExact)
{
  const double ulp = std::nextafter(1.0, 2.0) - 1;
  EXPECT_TRUE(
    Between({ { 0, 0 }, { 2, 0 }, { 1, ulp }, { 1, 2 } }, { { 0, 1, 0 }, { 2, 3, 0 } }, 0).Empty());
  EXPECT_FALSE(
    Between({ { 0, 0 }, { 2, 0 }, { 1, -ulp }, { 1, 2 } }, { { 0, 1, 0 }, { 2, 3, 0 } }, 0)
      .Empty());
}
}

TEST(EdgeConflicts, CrossingsAreCountedAsFarAsAsked)
{
  // A star of five rays: each edge crosses two others; walked twice, each crossing is there four times.
  std::vector<Point2> points;
  for (int i = 0; i < 5; ++i)
  {
    points.push_back({ std::cos(i * 4 * 3.14159265 / 5), std::sin(i * 4 * 3.14159265 / 5) });
  }
  std::vector<PlanarEdge> edges;
  AddLoopEdges({ 0, 1, 2, 3, 4 }, 0, edges);
  EXPECT_TRUE(CrossMoreOftenThan(points, edges, 4));
  EXPECT_FALSE(CrossMoreOftenThan(points, edges, 5));
  AddLoopEdges({ 0, 1, 2, 3, 4 }, 1, edges);
  EXPECT_TRUE(CrossMoreOftenThan(points, edges, 19));
  EXPECT_FALSE(CrossMoreOftenThan(points, edges, 20));
}
