// SPDX-License-Identifier: GPL-3.0-or-later
// Sides, distances and neighbours of the tree against a plain look at every segment.
#include "Core/Contours/SoupMaker.h"
#include "Planar/EdgeTree.h"

#include <gtest/gtest.h>

#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<PlanarSegment> SegmentsOf(const std::vector<Point2>& loop)
{
  std::vector<PlanarSegment> segments;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    segments.push_back({ loop[i], loop[(i + 1) % loop.size()] });
  }
  return segments;
}

TEST(EdgeTree, DistancesAndWindowsAreThoseOfAPlainLook)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 2);
  std::vector<PlanarSegment> segments;
  for (int i = 0; i < 300; ++i)
  {
    const Point2 a{ uniform(random), uniform(random) };
    segments.push_back({ a, { a[0] + 0.1 * uniform(random), a[1] + 0.1 * uniform(random) } });
  }
  const EdgeTree tree(segments);
  for (int i = 0; i < 500; ++i)
  {
    const Point2 p{ uniform(random), uniform(random) };
    double nearest = HUGE_VAL;
    std::set<int> expected;
    for (std::size_t e = 0; e < segments.size(); ++e)
    {
      const PlanarSegment& s = segments[e];
      nearest = std::min(nearest, DistanceToSegment(p, s));
      if (std::max(s.A[0], s.B[0]) >= p[0] && std::min(s.A[0], s.B[0]) <= p[0] + 0.2 &&
        std::max(s.A[1], s.B[1]) >= p[1] && std::min(s.A[1], s.B[1]) <= p[1] + 0.1)
      {
        expected.insert(static_cast<int>(e));
      }
    }
    EXPECT_EQ(tree.DistanceWithin(p, HUGE_VAL), nearest);
    EXPECT_EQ(tree.DistanceWithin(p, 0.5 * nearest), 0.5 * nearest);
    std::set<int> found;
    tree.ForNear(p, { p[0] + 0.2, p[1] + 0.1 }, [&found](int e) { found.insert(e); });
    EXPECT_EQ(found, expected);
  }
}

TEST(EdgeTree, SidesAreExact)
{
  const EdgeTree tree(SegmentsOf({ { 0, 0 }, { 1, 0.1 }, { 0.3, 0.2 }, { 0.3, 0.7 } }));
  EXPECT_EQ(tree.SideOf({ 0.29, 0.3 }), EdgeTree::Inside);
  EXPECT_EQ(tree.SideOf({ 0.31, 0.3 }), EdgeTree::Outside);
  EXPECT_EQ(tree.SideOf({ 0.3, 0.3 }), EdgeTree::On);
  EXPECT_EQ(tree.SideOf({ 0.3, 0.7 }), EdgeTree::On);
  EXPECT_EQ(tree.SideOf({ std::nextafter(0.3, 0.0), 0.3 }), EdgeTree::Inside);
  EXPECT_EQ(tree.SideOf({ std::nextafter(0.3, 1.0), 0.3 }), EdgeTree::Outside);
  EXPECT_EQ(tree.SideOf({ -1, 0 }), EdgeTree::Outside);
  // At the height of a corner.
  EXPECT_EQ(tree.SideOf({ 0.2, 0.2 }), EdgeTree::Inside);
  EXPECT_EQ(tree.SideOf({ 0.05, 0.1 }), EdgeTree::Inside);
}

TEST(EdgeTree, OfNothing)
{
  const EdgeTree tree({});
  EXPECT_EQ(tree.SideOf({ 0, 0 }), EdgeTree::Outside);
  EXPECT_EQ(tree.DistanceWithin(Point2{ 0, 0 }, 3), 3);
}
}
