// SPDX-License-Identifier: GPL-3.0-or-later
// What is given up is narrow, near the place, and has no other contour left within it.
#include "DegenerateStacks.h"

#include "Contours/ContourMeasures.h"
#include "Polyhedral/LevelTriangulation.h"
#include "Polyhedral/NeedleContours.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
const Ring Square{ { -3, -3 }, { -1, -3 }, { -1, -1 }, { -3, -1 } };

Ring NeedleAt(double y, double width)
{
  return { { 0, y }, { 2, y }, { 2, y + width } };
}

/// A square, needles of several widths, all but the first narrower than 1e-5 of the diagonal.
ContourSet NeedlesAndASquare()
{
  SoupMaker maker;
  for (const double z : { 0.0, 1.0 })
  {
    maker.Loop(Square, z);
    maker.Loop(NeedleAt(0, 1e-3), z);
    maker.Loop(NeedleAt(1, 1e-5), z);
    maker.Loop(NeedleAt(2, 2e-5), z);
  }
  return maker.Build();
}
}

TEST(NeedleContours, WidthOfALongTriangleIsThatOfItsMiddle)
{
  const ContourSet contours = NeedlesAndASquare();
  ASSERT_EQ(contours.Contours.size(), 8u);
  for (int c : contours.Levels[0].Contours)
  {
    if (contours.Contours[c].Points.size() == 3)
    {
      const double area = std::abs(contours.Contours[c].SignedArea);
      EXPECT_NEAR(MeanWidth(contours, contours.Contours[c]), area / 2, 1e-3 * area);
    }
  }
}

TEST(NeedleContours, TakesTheNearestThatIsNarrow)
{
  const ContourSet contours = NeedlesAndASquare();
  for (const double y : { -3.0, 0.1, 0.9, 1.4, 1.6, 5.0 })
  {
    const std::vector<int> found = FindNeedle(contours, contours.Levels[0].Contours, { 1, y });
    ASSERT_EQ(found.size(), 1u);
    const Point2& corner = contours.Planar[contours.Contours[found[0]].Points[0]];
    EXPECT_NEAR(corner[1], y < 1.5 ? 1 : 2, 1e-3) << y;
  }
}

TEST(NeedleContours, LeavesWhatIsNotNarrow)
{
  const ContourSet contours = BuildStack({ { Square }, { Square } });
  EXPECT_TRUE(FindNeedle(contours, contours.Levels[0].Contours, Square[0]).empty());
}

TEST(NeedleContours, TakesWhatLiesWithin)
{
  ContourSet contours = NeedlesAndASquare();
  const std::vector<int>& level = contours.Levels[0].Contours;
  const int needle = FindNeedle(contours, level, { 1, 1 }).at(0);
  // A hole in the needle and an island in the hole.
  const int hole = level.front() == needle ? level.back() : level.front();
  contours.Contours[hole].Parent = needle;
  const std::vector<int> found = FindNeedle(contours, level, { 1, 1 });
  EXPECT_EQ(std::set<int>(found.begin(), found.end()), (std::set<int>{ hole, needle }));
}

TEST(NeedleContours, AreNamedWhereALevelCannotBeHadWithThem)
{
  // Needles a little wider than what is snapped together, from lines that cross beside each other.
  const ContourSet contours = DegenerateStack(1433).Maker.Build();
  std::set<int> given;
  for (int level = 0; level < static_cast<int>(contours.Levels.size()); ++level)
  {
    const LevelTriangulator triangulator(contours, level);
    given.insert(triangulator.Needles().begin(), triangulator.Needles().end());
  }
  EXPECT_FALSE(given.empty());
  const PolyhedralSurface surface = BuildSurface(contours, EveryCombination().back());
  const std::set<int> named = ContoursLeftOut(surface).Wholly;
  for (int c : given)
  {
    EXPECT_EQ(named.count(c), 1u) << "contour " << c;
    EXPECT_LT(MeanWidth(contours, contours.Contours[c]), 1e-4);
  }
}
