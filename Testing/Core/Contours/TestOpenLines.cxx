// SPDX-License-Identifier: GPL-3.0-or-later
// Isolines that leave their window are closed along its border, on the right side.
#include "ContourInvariants.h"
#include "SoupMaker.h"

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// The parts of a circle that lie in a rectangle, as open lines, or the circle itself.
void AddClipped(const Point2& centre, double radius, const Box2& window, double z, SoupMaker& maker)
{
  const int count = 720;
  const auto at = [&](int i)
  {
    const double angle = 2 * Pi * i / count;
    return Point2{ centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle) };
  };
  int outside = -1;
  for (int i = 0; i < count; ++i)
  {
    outside = window.Contains(at(i)) ? outside : i;
  }
  if (outside < 0)
  {
    maker.Loop(Circle(centre[0], centre[1], radius, count), z);
    return;
  }
  std::vector<Point2> line;
  for (int i = outside; i <= outside + count; ++i)
  {
    const Point2 p = at(i % count);
    const Point2 clamped{ std::clamp(p[0], window.Low[0], window.High[0]),
      std::clamp(p[1], window.Low[1], window.High[1]) };
    if (window.Contains(p))
    {
      line.push_back(p);
    }
    else if (!line.empty())
    {
      line.push_back(clamped);
      maker.Chain(SoupMaker::Lift(line, z), false);
      line.clear();
    }
    if (line.empty() && i <= outside + count - 1 && window.Contains(at((i + 1) % count)))
    {
      line.push_back(clamped);
    }
  }
}

/// Area of a disc within a rectangle, by counting.
double ClippedArea(const Point2& centre, double radius, const Box2& window)
{
  const int count = 1000;
  int inside = 0;
  for (int i = 0; i < count * count; ++i)
  {
    const double x = window.Low[0] + window.Extent(0) * (i % count + 0.5) / count;
    const double y = window.Low[1] + window.Extent(1) * (i / count + 0.5) / count;
    inside += std::hypot(x - centre[0], y - centre[1]) < radius ? 1 : 0;
  }
  return window.Extent(0) * window.Extent(1) * inside / (count * count);
}

double AreaOf(const ContourSet& set, const Level& level)
{
  double area = 0;
  for (int c : level.Contours)
  {
    area += set.Contours[At(c)].SignedArea;
  }
  return area;
}

/// A cone with its tip above `centre`; the window's corners are not on any line.
void CheckCone(const Point2& centre, const std::vector<double>& radii)
{
  const Box2 window({ 0, 0 }, { 12, 10 });
  SoupMaker maker;
  for (std::size_t l = 0; l < radii.size(); ++l)
  {
    AddClipped(centre, radii[l], window, static_cast<double>(l), maker);
  }
  const ContourSet set = maker.Build(true, 0, OpenLineRule::Border);
  CheckContourSet(set, 1e-12);
  EXPECT_TRUE(set.Warning.empty());
  ASSERT_EQ(set.Levels.size(), radii.size());
  for (std::size_t l = 0; l < radii.size(); ++l)
  {
    const double right = ClippedArea(centre, radii[l], window);
    EXPECT_NEAR(AreaOf(set, set.Levels[l]), right, 0.01 * right + 0.05) << "radius " << radii[l];
  }
}

TEST(OpenLines, AHillThatLeavesItsWindow)
{
  CheckCone({ 5, 5 }, { 7, 6, 5.5, 4, 3, 2 }); // four lines, two, and closed contours
  CheckCone({ 5, 5 }, { 2, 3, 4, 5.5, 6, 7 }); // a lake
}

TEST(OpenLines, AHillWithItsTopAtTheBorder)
{
  CheckCone({ 0.5, 5 }, { 11, 9, 7, 4, 2, 1 });
  CheckCone({ 0.5, 0.2 }, { 11, 9, 7, 4, 2, 1 });
}

TEST(OpenLines, TheOtherWayRoundWhereTheNextLevelSaysSo)
{
  // The closed contour at the top lies in the larger part of what the line of the lower level cuts.
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 10, 10), -1);
  maker.Chain(SoupMaker::Lift({ { 0, 1 }, { 1, 1.5 }, { 2, 1 }, { 2, 0 } }, 0), false);
  maker.Loop(Rectangle(3, 3, 9, 9), 1);
  const ContourSet set = maker.Build(true, 0, OpenLineRule::Border);
  CheckContourSet(set, 1e-12);
  ASSERT_EQ(set.Levels.size(), 3u);
  EXPECT_NEAR(AreaOf(set, set.Levels[1]), 100 - 2.5, 1e-9);
  EXPECT_TRUE(Reports(set, "closed along the border of the data, as OpenLines asks"));
}

TEST(OpenLines, WhatEndsInsideTheBorderStaysOpen)
{
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 10, 10), 0).Loop(Rectangle(0, 0, 10, 10), 1);
  maker.Chain(SoupMaker::Lift({ { 4, 4 }, { 5, 4 }, { 6, 5 }, { 4, 6 } }, 2), false);
  const ContourSet set = maker.Build(true, 0, OpenLineRule::Border);
  EXPECT_EQ(set.Levels.size(), 2u);
  EXPECT_TRUE(Reports(set, "is open, its ends are 2 apart; left out"));
}

TEST(OpenLines, ClosedContoursStayAsTheyAre)
{
  SoupMaker maker;
  maker.Loop(Circle(0, 0, 5, 30), 0).Loop(Circle(0, 0, 4, 30), 1);
  maker.Segments(SoupMaker::Lift(Circle(1, 0, 3, 30), 2), 7);
  const ContourSet plain = maker.Build();
  const ContourSet border = maker.Build(true, 0, OpenLineRule::Border);
  EXPECT_EQ(border.Contours.size(), plain.Contours.size());
  EXPECT_EQ(border.Points, plain.Points);
  EXPECT_EQ(border.Report, plain.Report);
}
}
