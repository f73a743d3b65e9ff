// SPDX-License-Identifier: GPL-3.0-or-later
// Which rings lie in one plane, and which planes are levels.
#include "ContourInvariants.h"
#include "SoupMaker.h"

#include <functional>

using namespace recon;
using namespace recon::testing;

namespace
{
PlanarFrame TiltedFrame()
{
  PlanarFrame f;
  f.Normal = (1 / std::sqrt(14.0)) * Vector3{ 1, 2, 3 };
  f.U = (1 / std::sqrt(5.0)) * Vector3{ 2, -1, 0 };
  f.V = Cross(f.Normal, f.U);
  return f;
}

std::vector<Point3> InFrame(
  const PlanarFrame& frame, const std::vector<Point2>& loop, double offset)
{
  std::vector<Point3> points;
  for (const Point2& p : loop)
  {
    points.push_back(frame.ToSpace(p, offset));
  }
  return points;
}

double Rounded(double x, double unit)
{
  return std::round(x / unit) * unit;
}

TEST(ContourPlanes, UnevenSpacingAndLevelsAHairApart)
{
  SoupMaker maker;
  for (double z : { 0.0, 0.004, 0.5, 100.0 })
  {
    maker.Loop(Circle(0, 0, 10, 20), z);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Levels.size(), 4u);
}

TEST(ContourPlanes, NoiseBelowTheToleranceIsOneLevel)
{
  SoupMaker maker;
  std::mt19937 random(1);
  for (double x : { 0.0, 30.0, 60.0 })
  {
    std::vector<Point3> loop = SoupMaker::Lift(Circle(x, 0, 10, 50), 5);
    for (Point3& p : loop)
    {
      p[2] += (static_cast<double>(random() % 1001) - 500) * 1e-6;
    }
    maker.Chain(loop, true);
  }
  maker.Loop(Circle(0, 0, 10, 50), 15);
  const ContourSet set = maker.Build();
  CheckContourSet(set, 1e-3);
  ASSERT_EQ(set.Levels.size(), 2u);
  EXPECT_EQ(set.Levels[0].Frame.Normal, (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(set.Levels[0].Contours.size(), 3u);
  EXPECT_TRUE(set.Report.empty());
}

TEST(ContourPlanes, ObliqueContoursOfFewDecimals)
{
  // Two decimals of a millimetre on 60 mm: much less flat than the tolerance of 1e-5.
  SoupMaker maker;
  for (double offset : { -20.0, -10.0, 0.0, 10.0, 20.0 })
  {
    for (double x : { -15.0, 15.0 })
    {
      std::vector<Point3> loop = InFrame(TiltedFrame(), Circle(x, 0, 12, 60), offset);
      for (Point3& p : loop)
      {
        p = { Rounded(p[0], 0.01), Rounded(p[1], 0.01), Rounded(p[2], 0.01) };
      }
      maker.Chain(loop, true);
    }
  }
  for (bool parallel : { true, false })
  {
    const ContourSet set = maker.Build(parallel);
    CheckContourSet(set, 0.02);
    EXPECT_TRUE(set.Parallel);
    EXPECT_EQ(set.Levels.size(), 5u);
    EXPECT_EQ(set.Contours.size(), 10u);
    EXPECT_EQ(set.Report.size(), 1u);
    EXPECT_TRUE(Reports(set, "planes were found with a tolerance of"));
  }
}

TEST(ContourPlanes, TipsOfAlmostNoAreaFindTheirLevel)
{
  // Like the phantoms: rings of a nanometre, whose own normals are noise of the coordinates.
  SoupMaker maker;
  for (double z : { -1.0, 0.0, 1.0 })
  {
    maker.Loop(Circle(50, 60, 12 * std::sqrt(2 - z * z), 40), 12 * z);
  }
  std::vector<Point3> tip = SoupMaker::Lift(Circle(50, 60, 1e-9, 40), 20);
  tip[3][2] += 1e-6;
  maker.Chain(tip, true);
  const ContourSet set = maker.Build();
  CheckContourSet(set, 1e-3);
  ASSERT_EQ(set.Levels.size(), 4u);
  EXPECT_NEAR(set.Levels[3].Offset, 20, 1e-5);
  EXPECT_GT(set.Contours[3].SignedArea, 0);
  EXPECT_LT(set.Contours[3].SignedArea, 1e-16);
}

TEST(ContourPlanes, OtherDirectionsAreLeftOutOrLevels)
{
  SoupMaker maker;
  maker.Loop(Circle(0, 0, 5, 30), 1).Loop(Circle(0, 0, 4, 30), 2);
  std::vector<Point3> upright;
  for (const Point2& p : Circle(0, 1, 20, 30))
  {
    upright.push_back({ 0.5, p[0], p[1] });
  }
  maker.Chain(upright, true);
  maker.Chain(InFrame(TiltedFrame(), Circle(0, 0, 30, 30), 1), true);
  const ContourSet parallel = maker.Build(true);
  CheckContourSet(parallel, 1e-12);
  EXPECT_TRUE(parallel.Parallel);
  EXPECT_EQ(parallel.Levels.size(), 2u);
  ASSERT_EQ(parallel.Report.size(), 2u);
  EXPECT_TRUE(Reports(parallel,
    "Contour of cell 2 (30 points, at offset 1): lies in a plane of normal "
    "(1, 0, 0), which is not parallel to the others; left out."));
  EXPECT_TRUE(Reports(parallel, "Contour of cell 3"));

  const ContourSet any = maker.Build(false);
  CheckContourSet(any, 1e-12);
  EXPECT_FALSE(any.Parallel);
  ASSERT_EQ(any.Levels.size(), 4u);
  EXPECT_EQ(any.Levels[2].Frame.Normal, (Vector3{ 1, 0, 0 }));
  EXPECT_EQ(any.Levels[2].Offset, 0.5);
  EXPECT_NEAR(any.Levels[3].Offset, 1, 1e-12);
  EXPECT_TRUE(any.Report.empty());
}

TEST(ContourPlanes, ManyContoursOfOneObliquePlaneNest)
{
  SoupMaker maker;
  for (double offset : { 1.0, 2.0 })
  {
    for (double radius : { 1.0, 2.0, 3.0 })
    {
      maker.Chain(InFrame(TiltedFrame(), Circle(5, 5, radius, 30), offset), true);
    }
  }
  std::vector<Point3> other = SoupMaker::Lift(Circle(0, 0, 30, 30), 4);
  maker.Chain(other, true);
  const ContourSet set = maker.Build(false);
  CheckContourSet(set, 1e-12);
  EXPECT_FALSE(set.Parallel);
  ASSERT_EQ(set.Levels.size(), 3u);
  EXPECT_EQ(set.Levels[0].Contours.size(), 3u);
  EXPECT_EQ(set.Contours[2].Depth, 0);
  EXPECT_EQ(set.Contours[1].Depth, 1);
  EXPECT_EQ(set.Contours[0].Depth, 2);
}

TEST(ContourPlanes, BowTieWithoutNetAreaHasAPlane)
{
  std::vector<Point3> tie = InFrame(TiltedFrame(), { { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 2 } }, 3);
  const ContourSet set = SoupMaker().Chain(tie, true).Build();
  CheckContourSet(set, 1e-12);
  EXPECT_EQ(set.Contours.size(), 2u);
  EXPECT_NEAR(SolidArea(set), 2, 1e-11); // of the grid of a tilted frame
}

TEST(ContourPlanes, EqualOutlinesInTiltedPlanesAreEqual)
{
  // In its own plane the same outline comes out the same, though its points in space round.
  SoupMaker maker;
  const std::vector<Point2> outline = Circle(0.3, -0.2, 1, 100);
  for (int l = 0; l < 4; ++l)
  {
    maker.Chain(InFrame(TiltedFrame(), outline, 0.7 * l), true);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 1e-12);
  ASSERT_EQ(set.Contours.size(), 4u);
  EXPECT_GT(set.Levels[0].Grid, 0);
  int equal = 0;
  for (const Contour& contour : set.Contours)
  {
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      equal += set.Planar[At(contour.Points[i])] == set.Planar[At(set.Contours[0].Points[i])];
    }
  }
  EXPECT_EQ(equal, 400);
}

TEST(ContourPlanes, FarFromTheOrigin)
{
  SoupMaker maker;
  for (double z : { 1e6, 1e6 + 3 })
  {
    maker.Loop(Circle(1e6, -1e6, 20, 100), z).Loop(Circle(1e6, -1e6, 10, 100), z);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Levels.size(), 2u);
  EXPECT_NEAR(SolidArea(set), 2 * 100 * std::sin(2 * 3.14159265358979323846 / 100) / 2 * 300, 1e-5);
}

TEST(ContourPlanes, ResultDoesNotDependOnTheOrderOfContours)
{
  std::vector<std::function<void(SoupMaker&)>> parts;
  for (int i = 0; i < 12; ++i)
  {
    parts.emplace_back([i](SoupMaker& m) { m.Loop(Circle(i % 3 * 20, 0, 5 + i, 30), i / 3); });
  }
  SoupMaker first;
  SoupMaker second;
  for (int i = 0; i < 12; ++i)
  {
    parts[At(i)](first);
    parts[At((i * 5 + 3) % 12)](second);
  }
  const ContourSet a = first.Build();
  const ContourSet b = second.Build();
  CheckContourSet(a, 0);
  CheckContourSet(b, 0);
  ASSERT_EQ(a.Levels.size(), b.Levels.size());
  ASSERT_EQ(a.Contours.size(), b.Contours.size());
  EXPECT_NEAR(SolidArea(a), SolidArea(b), 1e-9);
  const ContourSet again = first.Build();
  EXPECT_EQ(again.Points, a.Points) << "the same input gives the same bits";
}
}
