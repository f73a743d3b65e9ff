// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/MaterialWalker.h"

#include <gtest/gtest.h>

#include <algorithm>

using recon::BorderWalk;
using recon::MaterialWalker;

namespace
{
const recon::Vector3 Up{ 0, 0, 1 };

/// The walk from its smallest vertex on.
std::vector<int> FromSmallest(BorderWalk walk)
{
  std::rotate(walk.Points.begin(), std::min_element(walk.Points.begin(), walk.Points.end()),
    walk.Points.end());
  return walk.Points;
}

/// Two unit squares side by side, materials 1 and 2.
const std::vector<recon::Point3> Squares{ { 0, 0, 3 }, { 1, 0, 3 }, { 2, 0, 3 }, { 2, 1, 3 },
  { 1, 1, 3 }, { 0, 1, 3 } };

std::vector<recon::NetworkEdge> EdgesOfSquares()
{
  return { { 0, 1, 1, 0 }, { 1, 2, 2, 0 }, { 2, 3, 2, 0 }, { 3, 4, 2, 0 }, { 4, 5, 1, 0 },
    { 5, 0, 1, 0 }, { 1, 4, 1, 2 } };
}
}

TEST(MaterialWalker, WalksWithTheMaterialToTheLeft)
{
  MaterialWalker walker(Up, Squares, EdgesOfSquares());
  EXPECT_FALSE(walker.SwapSidesWhereZeroIsInside());
  EXPECT_EQ(walker.GetMaterials(), (std::vector<int>{ 1, 2 }));
  const std::vector<BorderWalk> first = walker.Walk(1);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_TRUE(first[0].Closed);
  EXPECT_EQ(FromSmallest(first[0]), (std::vector<int>{ 0, 1, 4, 5 }));
  ASSERT_EQ(walker.Walk(2).size(), 1u);
  EXPECT_EQ(FromSmallest(walker.Walk(2)[0]), (std::vector<int>{ 1, 2, 3, 4 }));
}

TEST(MaterialWalker, SeenFromTheOtherSideAllTurnsRound)
{
  // From below, left is right: material 0 is inside then, and the sides are swapped.
  MaterialWalker walker({ 0, 0, -1 }, Squares, EdgesOfSquares());
  EXPECT_TRUE(walker.SwapSidesWhereZeroIsInside());
  EXPECT_EQ(FromSmallest(walker.Walk(1)[0]), (std::vector<int>{ 0, 5, 4, 1 }));
}

TEST(MaterialWalker, WalksOfAMaterialThatMeetInAVertexStayApart)
{
  // Two triangles of one material with vertex 0 in common.
  const std::vector<recon::Point3> vertices{ { 0, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  MaterialWalker walker(Up, vertices,
    { { 0, 1, 1, 0 }, { 1, 2, 1, 0 }, { 2, 0, 1, 0 }, { 0, 3, 1, 0 }, { 3, 4, 1, 0 },
      { 4, 0, 1, 0 } });
  const std::vector<BorderWalk> walks = walker.Walk(1);
  ASSERT_EQ(walks.size(), 2u);
  for (const BorderWalk& walk : walks)
  {
    EXPECT_TRUE(walk.Closed);
    EXPECT_EQ(walk.Points.size(), 3u);
  }
}

TEST(MaterialWalker, WhatDoesNotCloseIsOpen)
{
  std::vector<recon::NetworkEdge> edges = EdgesOfSquares();
  edges.erase(edges.begin()); // from 0 to 1
  MaterialWalker walker(Up, Squares, edges);
  const std::vector<BorderWalk> walks = walker.Walk(1);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_FALSE(walks[0].Closed);
  EXPECT_EQ(walks[0].Points, (std::vector<int>{ 1, 4, 5, 0 }));
}
