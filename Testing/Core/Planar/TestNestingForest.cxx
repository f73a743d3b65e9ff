// SPDX-License-Identifier: GPL-3.0-or-later
// Which contour lies in which, above all where they touch.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"
#include "Planar/NestingForest.h"

using namespace recon;
using namespace recon::testing;

namespace
{
TEST(NestingForest, TriangleInTheSameLeftmostCorner)
{
  // All three start at the origin; each lies in the one before.
  const std::vector<Point2> points{ { 0, 0 }, { 8, -8 }, { 8, 8 }, { 4, -3 }, { 4, 3 }, { 2, -1 },
    { 2, 1 } };
  const std::vector<std::vector<int>> loops{ { 0, 5, 6 }, { 0, 1, 2 }, { 0, 3, 4 } };
  const NestingForest forest = BuildNestingForest(points, loops);
  EXPECT_EQ(forest.Parent, (std::vector<int>{ 2, -1, 1 }));
  EXPECT_EQ(forest.Depth, (std::vector<int>{ 2, 0, 1 }));
}

TEST(NestingForest, SiblingsInTheSameLeftmostCorner)
{
  const std::vector<Point2> points{ { 0, 0 }, { 8, -8 }, { 8, -4 }, { 8, 4 }, { 8, 8 }, { -1, -20 },
    { 20, 0 }, { -1, 20 } };
  const std::vector<std::vector<int>> loops{ { 0, 3, 4 }, { 0, 1, 2 }, { 5, 6, 7 } };
  const NestingForest forest = BuildNestingForest(points, loops);
  EXPECT_EQ(forest.Parent, (std::vector<int>{ 2, 2, -1 }));
  EXPECT_EQ(forest.Depth, (std::vector<int>{ 1, 1, 0 }));
}

TEST(NestingForest, VerticalEdgesAndCommonCorners)
{
  // A frame of squares whose corners lie on one another's sides and corners.
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 10, 10))
                           .Loop({ { 0, 0 }, { 5, 2 }, { 2, 5 } })
                           .Loop({ { 10, 10 }, { 5, 8 }, { 8, 5 } })
                           .Loop(Rectangle(-2, -2, 0, 0))
                           .Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 4u);
  EXPECT_EQ(set.Contours[1].Parent, 0);
  EXPECT_EQ(set.Contours[2].Parent, 0);
  EXPECT_EQ(set.Contours[3].Parent, -1);
}

TEST(NestingForest, RandomCirclesLikeRussianDolls)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 random(seed);
    SoupMaker maker;
    // Two circles in every cell of a grid, squares around many of them, in a random order.
    // larger one.
    std::vector<std::vector<Point2>> loops;
    for (int i = 0; i < 8; ++i)
    {
      for (int j = 0; j < 8; ++j)
      {
        loops.push_back(Circle(i, j, 0.3, 5 + static_cast<int>(random() % 20)));
        loops.push_back(Circle(i, j, 0.15, 3 + static_cast<int>(random() % 20)));
      }
    }
    for (int r = 1; r < 4; ++r)
    {
      loops.push_back(Rectangle(r - 0.5, r - 0.5, 7.5 - r, 7.5 - r));
    }
    std::shuffle(loops.begin(), loops.end(), random);
    for (const std::vector<Point2>& loop : loops)
    {
      maker.Loop(loop);
    }
    const ContourSet set = maker.Build();
    CheckContourSet(set, 0);
    EXPECT_EQ(set.Contours.size(), loops.size());
    EXPECT_TRUE(set.Report.empty());
  }
}

TEST(NestingForest, AreasOfSliversAreExact)
{
  const double tiny = std::ldexp(1.0, -52);
  const std::vector<Point2> points{ { 1, 1 }, { 2, 2 }, { 3, 3 + 2 * tiny } };
  EXPECT_EQ(SignedAreaOf(points, { 0, 1, 2 }), tiny);
  EXPECT_EQ(SignedAreaOf(points, { 2, 1, 0 }), -tiny);
  EXPECT_EQ(SignedAreaOf(points, { 1, 2, 0 }), tiny);
}
}
