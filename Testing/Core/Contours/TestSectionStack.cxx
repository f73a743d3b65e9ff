// SPDX-License-Identifier: GPL-3.0-or-later
// How sections follow one another, where they end, and how they would go on.
#include "Contours/SectionStack.h"
#include "SoupMaker.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
/// The stack, and what it refers to.
struct Stacked
{
  explicit Stacked(const SoupMaker& maker)
    : Contours(maker.Build()),
      Mapping(Map(this->Contours)),
      Gaps(FindLevelGaps(this->Contours, DefaultMaximumGap)),
      Stack(this->Contours, this->Mapping, this->Gaps)
  {
  }

  static ContourMapping Map(const ContourSet& contours)
  {
    Monitor monitor;
    return BuildContourMapping(contours, {}, monitor);
  }

  const ContourSet Contours;
  const ContourMapping Mapping;
  const LevelGaps Gaps;
  const SectionStack Stack;
};

/// A square of that area.
std::vector<Point2> Square(double area, double x = 0)
{
  const double half = std::sqrt(area) / 2;
  return Rectangle(x - half, -half, x + half, half);
}
}

TEST(SectionParabola, KnowsItsVolumeAndWhereAnAreaIs)
{
  const SectionParabola ball{ 7, -6, -1 }; // 16 - (3 + t)^2
  EXPECT_DOUBLE_EQ(ball.PlaceOf(0), 1);
  EXPECT_DOUBLE_EQ(ball.PlaceOf(16 - 3.5 * 3.5), 0.5);
  EXPECT_DOUBLE_EQ(ball.PlaceOf(7), 0);
  EXPECT_NEAR(ball.Integral(1), 7 - 3 - 1.0 / 3, 1e-12);
  const SectionParabola cone{ 4, -4, 1 }; // (2 - t)^2, which touches zero
  EXPECT_DOUBLE_EQ(cone.PlaceOf(1), 1);
  EXPECT_DOUBLE_EQ(cone.PlaceOf(0), 2);
  const SectionParabola straight{ 6, -2, 0 };
  EXPECT_DOUBLE_EQ(straight.PlaceOf(0), 3);
  for (const SectionParabola& none :
    { SectionParabola{ 4, 0, 0 }, SectionParabola{ 4, 1, 0 }, SectionParabola{ 4, -1, 1 } })
  {
    EXPECT_TRUE(std::isinf(none.PlaceOf(0)));
  }
}

TEST(SectionStack, GoesOnAsTheSectionsBefore)
{
  // Of a ball of radius 5, every 2 from -4 on, in areas of pi (25 - z^2).
  SoupMaker maker;
  for (const double z : { -4.0, -2.0, 0.0, 2.0, 3.0 })
  {
    maker.Loop(Square(3.14159265358979323846 * (25 - z * z)), z);
  }
  const Stacked ball(maker);
  EXPECT_TRUE(ball.Stack.Ends(0, -1));
  EXPECT_FALSE(ball.Stack.Ends(0, 1));
  EXPECT_TRUE(ball.Stack.Ends(4, 1));
  EXPECT_NEAR(ball.Stack.ParabolaAtEnd(0, -1)->PlaceOf(0), 1, 1e-9);
  EXPECT_NEAR(ball.Stack.ParabolaAtEnd(4, 1)->PlaceOf(0), 2, 1e-9) << "levels of two distances";
  EXPECT_EQ(ball.Stack.ReachOf(0, -1), 2);
  EXPECT_EQ(ball.Stack.ReachOf(4, 1), 1);
  EXPECT_EQ(ball.Stack.ReachOf(2, 1), 2);
}

TEST(SectionStack, TakesTwoSectionsForABall)
{
  SoupMaker maker;
  for (const double z : { 0.0, 2.0 })
  {
    maker.Loop(Square(3.14159265358979323846 * (25 - z * z)), z);
  }
  EXPECT_NEAR(Stacked(maker).Stack.ParabolaAtEnd(1, 1)->PlaceOf(0), 3, 1e-9);
}

TEST(SectionStack, KnowsNothingOfWhatWasPartOfAnother)
{
  SoupMaker maker;
  maker.Loop(Rectangle(-6, -1, 6, 1), 0).Loop(Square(4, -4), 1).Loop(Square(4, 4), 1);
  const Stacked fork(maker);
  ASSERT_EQ(fork.Stack.PartsOf(0).size(), 1u);
  EXPECT_EQ(fork.Stack.PartsOf(0)[0].Regions[1].size(), 2u);
  EXPECT_EQ(fork.Stack.PartsOf(0)[0].Area[1], 8);
  EXPECT_FALSE(fork.Stack.ParabolaAtEnd(1, 1)) << "a tine";
  EXPECT_FALSE(fork.Stack.WholePartAt({ 1 }, -1));
  EXPECT_TRUE(fork.Stack.WholePartAt({ 1, 2 }, -1));
  EXPECT_TRUE(fork.Stack.ParabolaAtEnd(0, -1)) << "the handle becomes both tines and nothing else";
}

TEST(SectionStack, DoesNotReachIntoGaps)
{
  SoupMaker maker;
  for (const double z : { 0.0, 1.0, 2.0, 50.0, 51.0, 52.0 })
  {
    maker.Loop(Square(4), z);
  }
  const Stacked parts(maker);
  EXPECT_TRUE(parts.Stack.Ends(2, 1));
  EXPECT_FALSE(parts.Stack.IsBridged(2));
  EXPECT_EQ(parts.Stack.ReachOf(2, 1), 1);
  EXPECT_EQ(parts.Stack.ReachOf(3, -1), 1);
}
