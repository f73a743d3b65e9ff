// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/VertexRegions.h"

#include <gtest/gtest.h>

#include <set>

using namespace recon;

namespace
{
std::set<int> RegionsOf(const VertexRegions& regions, int vertex)
{
  std::set<int> all;
  regions.AnyOf(vertex,
    [&](int region)
    {
      EXPECT_TRUE(all.insert(region).second);
      return false;
    });
  return all;
}
}

TEST(VertexRegions, AreThoseOfTheTrianglesAround)
{
  // Vertex 2 is where regions 5, 8 and 9 touch; -1 is outside.
  LevelTriangulation level;
  level.Points.resize(8);
  level.Triangles = { { 0, 1, 2 }, { 2, 3, 4 }, { 2, 4, 5 }, { 2, 5, 6 }, { 2, 6, 0 } };
  level.Region = { 5, 8, -1, 9, 5 };
  const VertexRegions regions(level);
  EXPECT_EQ(RegionsOf(regions, 2), (std::set<int>{ 5, 8, 9 }));
  EXPECT_EQ(RegionsOf(regions, 0), (std::set<int>{ 5 }));
  EXPECT_EQ(RegionsOf(regions, 5), (std::set<int>{ 9 }));
  EXPECT_TRUE(RegionsOf(regions, 7).empty());
  EXPECT_TRUE(regions.IsTouching(2));
  EXPECT_FALSE(regions.IsTouching(6 - 1));
  EXPECT_TRUE(regions.AnyOf(2, [](int region) { return region == 9; }));
  EXPECT_FALSE(regions.AnyOf(2, [](int region) { return region == 7; }));
}
