// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges have solid on one side only, by the winding number.
#include "Planar/WindingBorder.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
const std::vector<Point2> TwoSquares{ { 0, 0 }, { 6, 0 }, { 6, 6 }, { 0, 6 }, { 2, 2 }, { 4, 2 },
  { 4, 4 }, { 2, 4 } };

std::vector<PlanarEdge> EdgesOf(int weightOfInner)
{
  std::vector<PlanarEdge> edges;
  for (int i = 0; i < 4; ++i)
  {
    edges.push_back({ i, (i + 1) % 4, 0, 1 });
  }
  for (int i = 0; i < 4; ++i)
  {
    edges.push_back({ 4 + i, 4 + (i + 1) % 4, 1, weightOfInner });
  }
  return edges;
}

TEST(WindingBorder, OfNestedSquares)
{
  const std::vector<bool> outerOnly{ true, true, true, true, false, false, false, false };
  EXPECT_EQ(FindWindingBorder(TwoSquares, EdgesOf(1)), outerOnly);
  EXPECT_EQ(FindWindingBorder(TwoSquares, EdgesOf(-1)), std::vector<bool>(8, true));
  EXPECT_EQ(FindWindingBorder(TwoSquares, EdgesOf(-2)), outerOnly);
  EXPECT_TRUE(FindWindingBorder(TwoSquares, {}).empty());
}
}
