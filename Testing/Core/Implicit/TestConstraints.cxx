// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 13: counts, sides, values, merging, resampling.
#include "HandMadeContours.h"
#include "Implicit/Constraints/ContourResampling.h"
#include "Implicit/Constraints/ContourTips.h"
#include "Implicit/Constraints/NearConstraints.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;

namespace
{
ConstraintSet Build(const ContourSet& contours, const ConstraintOptions& options = {})
{
  Monitor monitor;
  return BuildInPlaneConstraints(contours, options, monitor);
}

/// By winding of angles: another way than the one under test.
bool IsInside(const ContourSet& set, int level, const Point3& p)
{
  const Point2 at = set.Levels[static_cast<std::size_t>(level)].Frame.ToPlane(p);
  double turns = 0;
  for (const Contour& contour : set.Contours)
  {
    if (contour.Level != level)
    {
      continue;
    }
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Point2& a = set.Planar[contour.Points[i]];
      const Point2& b = set.Planar[contour.Points[(i + 1) % contour.Points.size()]];
      const double ax = a[0] - at[0];
      const double ay = a[1] - at[1];
      const double bx = b[0] - at[0];
      const double by = b[1] - at[1];
      turns += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
  }
  // Outer walls turn once, holes turn back.
  return turns > 3;
}

double DistanceToLevel(const ContourSet& set, int level, const Point3& p)
{
  const Point2 at = set.Levels[static_cast<std::size_t>(level)].Frame.ToPlane(p);
  double least = 1e300;
  for (const Contour& contour : set.Contours)
  {
    for (std::size_t i = 0; contour.Level == level && i < contour.Points.size(); ++i)
    {
      const Point2& a = set.Planar[contour.Points[i]];
      const Point2& b = set.Planar[contour.Points[(i + 1) % contour.Points.size()]];
      const double ux = b[0] - a[0];
      const double uy = b[1] - a[1];
      const double t = std::min(
        1.0, std::max(0.0, ((at[0] - a[0]) * ux + (at[1] - a[1]) * uy) / (ux * ux + uy * uy)));
      least = std::min(least, std::hypot(at[0] - a[0] - t * ux, at[1] - a[1] - t * uy));
    }
  }
  return least;
}

void ExpectProperMargins(const ContourSet& contours, const ConstraintSet& set)
{
  ASSERT_EQ(set.Points.size(), set.Values.size());
  ASSERT_EQ(set.Points.size(), set.Kind.size());
  for (std::size_t i = 0; i < set.Points.size(); ++i)
  {
    const int level = contours.Contours[static_cast<std::size_t>(set.Contour[i])].Level;
    const double distance = DistanceToLevel(contours, level, set.Points[i]);
    switch (set.Kind[i])
    {
      case ConstraintSet::Boundary:
        EXPECT_EQ(set.Values[i], 0);
        EXPECT_LT(distance, 1e-12);
        break;
      case ConstraintSet::Inner:
        EXPECT_TRUE(IsInside(contours, level, set.Points[i])) << i;
        EXPECT_GT(set.Values[i], 0);
        break;
      default:
        EXPECT_FALSE(IsInside(contours, level, set.Points[i])) << i;
        EXPECT_LT(set.Values[i], 0);
        break;
    }
  }
}

ContourSet TwoDiscsWithHole()
{
  handmade::Maker maker;
  const int low = maker.AddLevel({ 0, 0, 1 }, -2);
  maker.AddCircle(low, { 0, 0 }, 10, 40);
  maker.AddCircle(low, { 1, 0 }, 4, 20);
  const int high = maker.AddLevel({ 0, 0, 1 }, 3);
  maker.AddCircle(high, { 0, 0 }, 9, 32);
  return maker.Finish();
}
}

TEST(Constraints, ExactlyThreeAVertexEachOnItsSide)
{
  const ContourSet contours = TwoDiscsWithHole();
  const ConstraintSet set = Build(contours);
  EXPECT_EQ(set.Points.size(), 3u * (40 + 20 + 32));
  EXPECT_TRUE(set.Report.empty());
  ExpectProperMargins(contours, set);
}

TEST(Constraints, ThinShapesShrinkTheirMargins)
{
  handmade::Maker maker;
  for (const double z : { 0.0, 1.0 })
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, z);
    // A sliver a thousandth wide, and a comb whose teeth nearly touch.
    maker.AddContour(level, { { 0, 0, z }, { 10, 0, z }, { 10, 0.01, z }, { 0, 0.01, z } });
    maker.AddContour(level,
      { { 0, 1, z }, { 9, 1, z }, { 9, 4, z }, { 5.001, 4, z }, { 5, 1.5, z }, { 4.999, 4, z },
        { 0, 4, z } });
  }
  const ContourSet contours = maker.Finish();
  const ConstraintSet set = Build(contours);
  // But for the outer one in each slit's end, which has no room that a fit could see.
  EXPECT_EQ(set.LeftOut, 2u);
  EXPECT_EQ(set.Points.size(), 3u * contours.Points.size() - 2);
  ExpectProperMargins(contours, set);
}

TEST(Constraints, WhatAFitCannotTellApartBecomesOneOrIsLeftOut)
{
  // Upper and lower half of a disc, whose diameters nearly meet: by a hair and by a visible gap.
  for (const double gap : { 1e-6, 0.05 })
  {
    handmade::Maker maker;
    for (const double z : { 0.0, 5.0 })
    {
      const int level = maker.AddLevel({ 0, 0, 1 }, z);
      for (const int side : { 1, -1 })
      {
        std::vector<Point3> half;
        for (int k = 0; k <= 20; ++k)
        {
          const double t = 3.14159265358979323846 * k / 20;
          half.push_back({ side * 10 * std::cos(t), side * (10 * std::sin(t) + gap), z });
        }
        for (int k = 1; k < 12; ++k)
        {
          half.push_back({ side * (20.0 * k / 12 - 10), side * gap, z });
        }
        maker.AddContour(level, half);
      }
    }
    const ContourSet contours = maker.Finish();
    const std::size_t n = contours.Points.size();
    const ConstraintSet set = Build(contours);
    const double apart = LeastDistanceApart(set);
    EXPECT_GT(apart, 1e-6);
    EXPECT_LT(apart, 0.01 * set.MarginDistance);
    if (gap > 2 * apart)
    {
      EXPECT_EQ(set.Points.size(), 3 * n);
      EXPECT_TRUE(set.Report.empty());
      continue;
    }
    // The lower diameter's points stand where the upper one's do; between them is no room.
    EXPECT_EQ(set.Points.size() + set.LeftOut, 3 * n);
    EXPECT_EQ(set.LeftOut, 2u * 2 * 13);
    ASSERT_EQ(set.Report.size(), 2u);
    EXPECT_EQ(set.Report[0].rfind("26 contour points took the place of another one", 0), 0u);
    EXPECT_EQ(set.Report[1].rfind("52 margin points were left out", 0), 0u);
    std::vector<Point3> places = set.Points;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    EXPECT_EQ(places.size(), set.Points.size() - 26);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      for (std::size_t j = i + 1; j < places.size(); ++j)
      {
        EXPECT_GT(Norm(places[j] - places[i]), apart);
      }
    }
  }
}

TEST(Constraints, ContoursThatTouchKeepTheirSides)
{
  // Two squares that meet in a vertex they share by index: outside one is inside the other.
  handmade::Maker maker;
  for (const double z : { 0.0, 1.0 })
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, z);
    maker.AddContour(level, { { 0, 0, z }, { 2, 0, z }, { 2, 2, z }, { 0, 2, z } });
    maker.AddContour(level, { { 2, 2, z }, { 4, 2, z }, { 4, 4, z }, { 2, 4, z } });
  }
  ContourSet contours = maker.Finish();
  for (std::size_t c = 0; c < contours.Contours.size(); c += 2)
  {
    contours.Contours[c + 1].Points[0] = contours.Contours[c].Points[2];
  }
  const ConstraintSet set = Build(contours);
  EXPECT_EQ(set.Points.size(), 3u * 16);
  ExpectProperMargins(contours, set);
}

TEST(Constraints, ValuesAreUnitOrDistance)
{
  const ContourSet contours = TwoDiscsWithHole();
  ConstraintOptions options;
  options.Values = ConstraintOptions::Unit;
  ConstraintSet set = Build(contours, options);
  for (std::size_t i = 0; i < set.Values.size(); ++i)
  {
    EXPECT_EQ(set.Values[i], set.Kind[i]);
  }
  options.Values = ConstraintOptions::Distance;
  options.MarginDistance = 0.2;
  set = Build(contours, options);
  EXPECT_EQ(set.MarginDistance, 0.2);
  for (std::size_t i = 0; i < set.Values.size(); ++i)
  {
    const int level = contours.Contours[static_cast<std::size_t>(set.Contour[i])].Level;
    EXPECT_NEAR(std::abs(set.Values[i]), DistanceToLevel(contours, level, set.Points[i]), 1e-12);
  }
}

TEST(Constraints, AutomaticMarginIsAThirdOfTheSpacing)
{
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 60);
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 1), { 0, 0 }, 10, 60);
  const double spacing = 2 * 10 * std::sin(3.14159265358979323846 / 60);
  EXPECT_NEAR(Build(maker.Finish()).MarginDistance, spacing / 3, 1e-12);
}

TEST(Constraints, MarginsReachAcrossAStep)
{
  // A wide disc, and 2 above it a narrow one: a step 6 wide inside the lower circle, outside the
  // upper one.
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 60);
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 2), { 0, 0 }, 4, 60);
  const ContourSet contours = maker.Finish();
  ConstraintOptions options;
  options.ReachAcrossSteps = true;
  const ConstraintSet set = Build(contours, options);
  ASSERT_EQ(set.Points.size(), 3u * 120);
  ExpectProperMargins(contours, set);
  for (std::size_t i = 0; i < set.Points.size(); ++i)
  {
    const int level = contours.Contours[static_cast<std::size_t>(set.Contour[i])].Level;
    const double distance = DistanceToLevel(contours, level, set.Points[i]);
    if (set.Kind[i] == (level == 0 ? ConstraintSet::Inner : ConstraintSet::Outer))
    {
      // As far as the levels are apart; there the surface is 2 of 6 parts of the way to the other.
      EXPECT_NEAR(distance, 2, 0.02);
      EXPECT_NEAR(std::abs(set.Values[i]), 2 * (2.0 / 3) / std::hypot(2, 2.0 / 3), 0.02);
    }
    else if (set.Kind[i] != ConstraintSet::Boundary)
    {
      EXPECT_LE(distance, set.MarginDistance * (1 + 1e-9));
      EXPECT_NEAR(std::abs(set.Values[i]), distance, 1e-12);
    }
  }
}

TEST(Constraints, CornersOfTheBoundingBox)
{
  const ContourSet contours = TwoDiscsWithHole();
  ConstraintOptions options;
  options.Mode = ConstraintOptions::BoundingBoxCorners;
  const ConstraintSet set = Build(contours, options);
  EXPECT_EQ(set.Points.size(), 40u + 20 + 32 + 8);
  EXPECT_EQ(std::count(set.Kind.begin(), set.Kind.end(), ConstraintSet::Outer), 8);
  double least = 1e300;
  for (const Point3& p : contours.Points)
  {
    least = std::min(least, Norm(p - set.Points.back()));
  }
  EXPECT_EQ(set.Values.back(), -least);
}

TEST(Constraints, CrossingPlanesMergeAtTheirCrossing)
{
  // Three great circles of a sphere, drawn with a wobble: at each of the six crossings two points,
  // not equal.
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 36, 0);
  maker.AddCircle(maker.AddLevel({ 1, 0, 0 }, 0), { 0, 0 }, 10.05, 36, 0);
  maker.AddCircle(maker.AddLevel({ 0, 1, 0 }, 0), { 0, 0 }, 9.95, 36, 0);
  const ContourSet contours = maker.Finish();
  EXPECT_EQ(Build(contours).Points.size(), 3u * 108);
  ConstraintOptions options;
  options.MergeBox = 0.05;
  const ConstraintSet set = Build(contours, options);
  EXPECT_EQ(set.Points.size(), 3u * 102);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_NE(set.Report[0].find("12 points"), std::string::npos) << set.Report[0];

  // Points of parallel planes are never merged, however near.
  handmade::Maker parallel;
  parallel.AddCircle(parallel.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 36);
  parallel.AddCircle(parallel.AddLevel({ 0, 0, 1 }, 0.01), { 0, 0 }, 10, 36);
  EXPECT_EQ(Build(parallel.Finish(), options).Points.size(), 3u * 72);
}

TEST(ContourResampling, SpacingAndTolerance)
{
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 400);
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 2), { 0, 0 }, 0.1, 100);
  const ContourSet contours = maker.Finish();
  const ContourSet even = ResampleToSpacing(contours, 1);
  EXPECT_EQ(even.Contours[0].Points.size(), 63u);
  EXPECT_EQ(even.Contours[1].Points.size(), static_cast<std::size_t>(MinimumPoints));
  EXPECT_NEAR(even.Contours[0].SignedArea, contours.Contours[0].SignedArea, 1);
  const ContourSet few = ResampleToTolerance(contours, 0.05);
  EXPECT_LT(few.Contours[0].Points.size(), 60u);
  for (const Point3& p : contours.Points)
  {
    const int level = p[2] > 1 ? 1 : 0;
    EXPECT_LT(DistanceToLevel(few, level, p), 0.0501);
  }
}

TEST(Constraints, ThinningOutMovesNothingAndKeepsCorners)
{
  handmade::Maker maker;
  const int low = maker.AddLevel({ 0, 0, 1 }, 0);
  // A square of 50 points a side, and a coarse hexagon that must stay as it is.
  std::vector<Point3> square;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < 50; ++i)
    {
      const double t = 0.2 * i;
      const Point3 places[4] = { { t, 0, 0 }, { 10, t, 0 }, { 10 - t, 10, 0 }, { 0, 10 - t, 0 } };
      square.push_back(places[side]);
    }
  }
  maker.AddContour(low, square);
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 4), { 5, 5 }, 4, 6);
  const ContourSet contours = maker.Finish();
  const ContourSet thin = ThinOut(contours, 1);
  EXPECT_EQ(thin.Contours[0].Points.size(), 40u);
  EXPECT_EQ(thin.Contours[1].Points.size(), 6u);
  EXPECT_DOUBLE_EQ(thin.Contours[0].SignedArea, 100);
  for (const Point3& p : thin.Points)
  {
    EXPECT_NE(std::find(contours.Points.begin(), contours.Points.end(), p), contours.Points.end());
  }
}

TEST(Constraints, ThinningOutLeavesNoNearlyCoincidentPoints)
{
  handmade::Maker maker;
  std::vector<Point3> loop;
  for (int i = 0; i < 60; ++i)
  {
    for (const double step : { 0.0, 1e-6 })
    {
      const double a = 2 * 3.14159265358979323846 * i / 60 + step;
      loop.push_back({ 10 * std::cos(a), 10 * std::sin(a), 0 });
    }
  }
  maker.AddContour(maker.AddLevel({ 0, 0, 1 }, 0), loop);
  const ContourSet thin = ThinOut(maker.Finish(), 0.5);
  const std::vector<int>& points = thin.Contours[0].Points;
  EXPECT_EQ(points.size(), 60u);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_GT(
      Norm(thin.Points[points[(i + 1) % points.size()]] - thin.Points[points[i]]), 0.05 * 0.5);
  }
}

TEST(Constraints, TipsAreContoursThatOnlyTouchTheEnd)
{
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 0.05, 8); // the pole of a ball
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 3), { 0, 0 }, 8, 40);
  const int middle = maker.AddLevel({ 0, 0, 1 }, 6);
  maker.AddCircle(middle, { 0, 0 }, 8, 40);
  maker.AddCircle(middle, { 20, 0 }, 0.05, 8); // a thread that nothing continues
  maker.AddCircle(middle, { 2, 0 }, 0.05, 8);  // a needle hole
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 9), { 0, 0 }, 4, 40); // ends broadly
  const ContourSet contours = maker.Finish();
  const std::vector<ContourTip> tips = FindTips(contours);
  ASSERT_EQ(tips.size(), contours.Contours.size());
  EXPECT_EQ(std::abs(tips[0].Side), 1);
  EXPECT_TRUE(tips[0].Flat);
  const double side = tips[0].Side * contours.Levels[0].Frame.Normal[2];
  EXPECT_GT(side, 0); // the solid lies above
  for (std::size_t c = 1; c < tips.size(); ++c)
  {
    EXPECT_EQ(tips[c].Side, 0) << c;
  }
  EXPECT_NEAR(TypicalGap(contours), 3, 1);
}

TEST(ConstraintsInvalid, EachBadInputHasItsSentence)
{
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 36);
  EXPECT_THROW(Build(maker.Finish()), Error);
  EXPECT_THROW(Build(ContourSet()), Error);
  const ContourSet good = TwoDiscsWithHole();
  ConstraintOptions options;
  options.MarginDistance = -1;
  EXPECT_THROW(Build(good, options), Error);
  options.MarginDistance = std::nan("");
  EXPECT_THROW(Build(good, options), Error);
  options.MarginDistance = 1000;
  EXPECT_THROW(Build(good, options), Error);
  options = ConstraintOptions();
  options.MergeBox = 1.5;
  EXPECT_THROW(Build(good, options), Error);
  options = ConstraintOptions();
  options.ResampleSpacing = -2;
  EXPECT_THROW(Build(good, options), Error);
}
