// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/LoopOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace recon;

TEST(LoopOrder, IsTheSameForEveryStartAndDirection)
{
  std::vector<int> loop{ 7, 3, 9, 4, 11, 5 };
  const std::vector<int> wanted{ 3, 7, 5, 11, 4, 9 };
  for (std::size_t start = 0; start < loop.size(); ++start)
  {
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    EXPECT_EQ(CanonicalLoop(loop), wanted);
    std::vector<int> turned = loop;
    std::reverse(turned.begin(), turned.end());
    EXPECT_EQ(CanonicalLoop(turned), wanted);
  }
}

TEST(LoopOrder, OfFewPoints)
{
  EXPECT_TRUE(CanonicalLoop({}).empty());
  EXPECT_EQ(CanonicalLoop({ 4 }), (std::vector<int>{ 4 }));
  EXPECT_EQ(CanonicalLoop({ 4, 2 }), (std::vector<int>{ 2, 4 }));
}
