// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourMeasures.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
/// A square of 4 x 4 and, in it, a strip of 2 x 0.01.
ContourSet SquareAndStrip()
{
  ContourSet set;
  set.Planar = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 1 }, { 1, 1.01 }, { 3, 1.01 },
    { 3, 1 } };
  for (const Point2& p : set.Planar)
  {
    set.Points.push_back({ p[0], p[1], 5 });
  }
  Contour square;
  square.Points = { 0, 1, 2, 3 };
  square.SignedArea = 16;
  Contour strip;
  strip.Points = { 4, 5, 6, 7 };
  strip.SignedArea = -0.02;
  set.Contours = { square, strip };
  return set;
}
}

TEST(ContourMeasures, TheBoxIsOfTheContoursAskedFor)
{
  const ContourSet set = SquareAndStrip();
  EXPECT_EQ(PlanarBounds(set, { 0, 1 }).High, (Point2{ 4, 4 }));
  EXPECT_EQ(PlanarBounds(set, { 1 }).Low, (Point2{ 1, 1 }));
  EXPECT_EQ(PlanarBounds(set, { 1 }).High, (Point2{ 3, 1.01 }));
  EXPECT_GT(PlanarBounds(set, {}).Low[0], PlanarBounds(set, {}).High[0]);
}

TEST(ContourMeasures, AStripIsAsWideAsItIs)
{
  const ContourSet set = SquareAndStrip();
  EXPECT_NEAR(MeanWidth(set, set.Contours[1]), 0.01, 1e-4);
  EXPECT_DOUBLE_EQ(MeanWidth(set, set.Contours[0]), 2);
}

TEST(ContourMeasures, HeightsAreAlongOneNormal)
{
  Level level;
  level.Offset = 3;
  level.Frame = PlanarFrame::About({ 0, 0, 1 });
  EXPECT_EQ(HeightOf(level, { 0, 0, 1 }), 3);
  EXPECT_EQ(HeightOf(level, { 0, 0, -1 }), -3);
  EXPECT_EQ(OffsetAlong({ 1, 0, 0 }, { -1, 0, 0 }, -2), 2);
}
