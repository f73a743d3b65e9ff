// SPDX-License-Identifier: GPL-3.0-or-later
// Walks around a region: every edge once, none crosses another, open ones first.
#include "Planar/BorderWalks.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
void AddLoop(BorderWalks& walks, const std::vector<int>& loop)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    walks.Add(loop[i], loop[(i + 1) % loop.size()]);
  }
}

TEST(BorderWalks, RegionsThatTouchStayApart)
{
  // Two triangles with the origin in common, each with its inside on the left.
  const std::vector<Point2> points{ { 0, 0 }, { 2, -1 }, { 2, 1 }, { -2, 1 }, { -2, -1 } };
  for (const std::vector<int>& second : { std::vector<int>{ 0, 3, 4 }, { 3, 4, 0 }, { 4, 0, 3 } })
  {
    BorderWalks walks(points);
    AddLoop(walks, { 0, 1, 2 });
    AddLoop(walks, second);
    const std::vector<BorderWalk> found = walks.Walk();
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].Points, (std::vector<int>{ 0, 1, 2 }));
    EXPECT_EQ(found[1].Points, second);
    EXPECT_TRUE(found[0].Closed && found[1].Closed);
  }
}

TEST(BorderWalks, AHoleThatTouchesItsWallIsOneWalk)
{
  // A square with a clockwise hole that touches it in the corner 0, from wherever the walk begins.
  const std::vector<Point2> points{ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 4, 2 }, { 2, 4 } };
  const std::vector<std::vector<int>> starts{ { 0, 1, 2, 3, 0, 5, 4 }, { 0, 5, 4, 0, 1, 2, 3 },
    { 2, 3, 0, 5, 4, 0, 1 } };
  const std::vector<std::vector<std::vector<int>>> given{ { { 0, 1, 2, 3 }, { 0, 5, 4 } },
    { { 0, 5, 4 }, { 0, 1, 2, 3 } }, { { 2, 3, 0, 1 }, { 4, 0, 5 } } };
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    BorderWalks walks(points);
    AddLoop(walks, given[i][0]);
    AddLoop(walks, given[i][1]);
    const std::vector<BorderWalk> found = walks.Walk();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].Points, starts[i]);
    EXPECT_TRUE(found[0].Closed);
  }
}

TEST(BorderWalks, BridgesAreWalkedThereAndBack)
{
  const std::vector<Point2> points{ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 3, 3 }, { 3, 6 },
    { 6, 6 }, { 6, 3 } };
  BorderWalks walks(points);
  AddLoop(walks, { 0, 1, 2, 3 });
  AddLoop(walks, { 4, 5, 6, 7 });
  AddLoop(walks, { 0, 4 });
  const std::vector<BorderWalk> found = walks.Walk();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].Points, (std::vector<int>{ 0, 1, 2, 3, 0, 4, 5, 6, 7, 4 }));
}

TEST(BorderWalks, WhatDoesNotCloseBeginsWhereNothingReaches)
{
  const std::vector<Point2> points{ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 5, 0 }, { 6, 0 }, { 6, 1 } };
  BorderWalks walks(points);
  AddLoop(walks, { 3, 4, 5 });
  walks.Add(1, 2);
  walks.Add(0, 1);
  const std::vector<BorderWalk> found = walks.Walk();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_FALSE(found[0].Closed);
  EXPECT_EQ(found[0].Points, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_TRUE(found[1].Closed);
  EXPECT_EQ(found[1].Points, (std::vector<int>{ 3, 4, 5 }));
}
}
