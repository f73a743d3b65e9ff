// SPDX-License-Identifier: GPL-3.0-or-later
// Simple loops around the inside, wherever several pass one point.
#include "Base/Monitor.h"
#include "Planar/LoopTracing.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;

namespace
{
std::vector<std::size_t> SizesOf(const std::vector<TracedLoop>& loops)
{
  std::vector<std::size_t> sizes;
  for (const TracedLoop& loop : loops)
  {
    EXPECT_EQ(loop.Points.size(), loop.Edges.size());
    sizes.push_back(loop.Points.size());
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

TEST(LoopTracing, BowTieIsTwoTriangles)
{
  const std::vector<Point2> points{ { 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
  const std::vector<TracedLoop> loops = TraceLoops(
    points, { { 0, 1, 0 }, { 1, 2, 0 }, { 2, 3, 0 }, { 3, 1, 0 }, { 1, 4, 0 }, { 4, 0, 0 } });
  EXPECT_EQ(SizesOf(loops), (std::vector<std::size_t>{ 3, 3 }));
  for (const TracedLoop& loop : loops)
  {
    EXPECT_EQ(std::count(loop.Points.begin(), loop.Points.end(), 1), 1);
  }
}

TEST(LoopTracing, AHoleThatTouchesItsWallIsALoopOfItsOwn)
{
  const std::vector<Point2> points{ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 2, 1 }, { 1, 2 } };
  EXPECT_EQ(SizesOf(TraceLoops(points,
              { { 0, 1, 0 }, { 1, 2, 0 }, { 2, 3, 0 }, { 3, 0, 0 }, { 0, 4, 0 }, { 4, 5, 0 },
                { 5, 0, 0 } })),
    (std::vector<std::size_t>{ 3, 4 }));
}

TEST(LoopTracing, OpenEdgesAreAnError)
{
  EXPECT_THROW(TraceLoops({ { 0, 0 }, { 1, 0 } }, { { 0, 1, 0 } }), Error);
}
}
