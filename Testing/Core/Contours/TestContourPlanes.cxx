// SPDX-License-Identifier: GPL-3.0-or-later
// Which rings lie in one plane, and which planes are levels.
#include "Base/Text.h"
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

/// Circles of radius 5 in planes through (0, 0, z) that are turned by an angle, each its own way.
SoupMaker TiltedStack(double degrees)
{
  SoupMaker maker;
  for (int l = 0; l < 12; ++l)
  {
    const double angle = degrees * 3.14159265358979323846 / 180;
    const double way = 2.4 * l;
    PlanarFrame frame = PlanarFrame::About(
      Vector3{ std::sin(angle) * std::cos(way), std::sin(angle) * std::sin(way), std::cos(angle) });
    std::vector<Point3> loop;
    for (const Point2& p : Circle(0, 0, 5, 40))
    {
      loop.push_back(frame.ToSpace(p, 0) + Vector3{ 0, 0, 2.0 * l });
    }
    maker.Chain(loop, true);
  }
  return maker;
}

/// A tube of walls and holes on 11 slices; the holes of some lie off their slice.
SoupMaker Tube(double off, int every)
{
  SoupMaker maker;
  for (int l = 0; l < 11; ++l)
  {
    maker.Loop(Circle(0, 0, 20, 64), 3 * l);
    maker.Loop(Circle(0, 0, 10, 64), 3 * l + (l % every == every - 1 ? off : 0));
  }
  return maker;
}

TEST(ContourPlanes, UnevenSpacingAndLevelsAHairApart)
{
  SoupMaker maker;
  for (double z : { 0.0, 0.004, 0.01, 0.016, 100.0 })
  {
    maker.Loop(Circle(0, 0, 10, 20), z);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Levels.size(), 5u);
}

TEST(ContourPlanes, SlicesMuchNearerThanTheirSizeAreLevels)
{
  // Squares 1e-4 apart, and a nested lake: the size of the contours has no say in it.
  SoupMaker squares;
  const std::vector<double> depths{ 0, -1e-4, -1.3e-4, -2.3e-4 };
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const double half = 1.5 - 0.1 * static_cast<double>(i);
    squares.Loop(Rectangle(-half, -half, half, half), depths[i]);
  }
  const ContourSet set = squares.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Levels.size(), 4u);
  EXPECT_TRUE(set.Report.empty());
}

TEST(ContourPlanes, AContourOffItsSliceIsOfTheSlice)
{
  for (bool millimetres : { true, false })
  {
    for (int every : { 11, 1, 2 })
    {
      SoupMaker maker = Tube(0.004, every);
      maker.Soup.Millimetres = millimetres;
      const ContourSet set = maker.Build();
      CheckContourSet(set, 0.002 + 1e-12);
      EXPECT_EQ(set.Levels.size(), 11u);
      EXPECT_EQ(set.Contours[1].Depth + set.Contours[0].Depth, 1);
      ASSERT_EQ(set.Report.size(), 1u);
      EXPECT_TRUE(Reports(set, "contours lie up to 0.004 apart along the normal"));
      EXPECT_NEAR(set.Levels[10].Thickness, every == 2 ? 0 : 0.002, 1e-12);
    }
  }
  EXPECT_EQ(Tube(0.004, 11).Build(true, 1e-3).Levels.size(), 12u) << "a tolerance of one's own";
  EXPECT_EQ(Tube(0.4, 11).Build(true, 0.5).Levels.size(), 11u);
  EXPECT_EQ(Tube(0.4, 11).Build().Levels.size(), 12u);
}

TEST(ContourPlanes, PlanesThatAreNotQuiteParallelAreLevels)
{
  for (double degrees : { 0.001, 0.01, 0.1, 1.0, 2.0 })
  {
    for (bool parallel : { true, false })
    {
      SCOPED_TRACE(degrees);
      const ContourSet set = TiltedStack(degrees).Build(parallel);
      CheckContourSet(set, 5 * std::sin(degrees * 0.0175));
      EXPECT_TRUE(set.Parallel);
      EXPECT_EQ(set.Levels.size(), 12u);
      EXPECT_EQ(set.Levels[0].Frame.Normal, (Vector3{ 0, 0, 1 }));
      EXPECT_EQ(set.Report.size(), degrees > 0.01 ? 1u : set.Report.size());
      if (degrees > 0.01)
      {
        EXPECT_TRUE(Reports(set, "of 12 are not quite parallel"));
        EXPECT_TRUE(Reports(set, "the largest angle is " + Text(degrees).substr(0, 3)));
      }
    }
  }
}

TEST(ContourPlanes, PlanesThatAreTiltedTooMuchAreLeftOutInOneSentence)
{
  const ContourSet set = TiltedStack(10).Build(true);
  EXPECT_LT(set.Contours.size(), 12u);
  EXPECT_NE(set.Warning.find("of 12 contours lie in other planes"), std::string::npos)
    << set.Warning;
  EXPECT_NE(set.Warning.find("Implicit Surface"), std::string::npos);
  const ContourSet any = TiltedStack(10).Build(false);
  EXPECT_EQ(any.Contours.size(), 12u);
  EXPECT_TRUE(any.Warning.empty());
}

TEST(ContourPlanes, OneTiltedContourDoesNotTurnTheOthers)
{
  SoupMaker maker;
  for (int l = 0; l < 8; ++l)
  {
    maker.Chain(InFrame(TiltedFrame(), Circle(0, 0, 5, 40), 2 * l), true);
  }
  PlanarFrame turned =
    PlanarFrame::About((1 / std::sqrt(14.0 + 0.02 * 0.02)) * Vector3{ 1.02, 2, 3 });
  maker.Chain(InFrame(turned, Circle(0, 0, 5, 40), 16), true);
  const ContourSet set = maker.Build();
  EXPECT_EQ(set.Levels.size(), 9u);
  EXPECT_NEAR(Dot(set.Levels[0].Frame.Normal, TiltedFrame().Normal), 1, 1e-14);
  EXPECT_TRUE(Reports(set, "1 contour of 9 is not quite parallel"));
}

TEST(ContourPlanes, DecimalsDoNotCountMoreForASmallOrgan)
{
  for (double radius : { 3.0, 6.0, 10.0, 40.0 })
  {
    SoupMaker maker;
    for (double offset : { 0.0, 1.0, 2.0 })
    {
      std::vector<Point3> loop = InFrame(TiltedFrame(), Circle(0, 0, radius, 32), offset);
      for (Point3& p : loop)
      {
        p = { Rounded(p[0], 0.01), Rounded(p[1], 0.01), Rounded(p[2], 0.01) };
        for (double& x : p)
        {
          x = std::round(100 * x) / 100;
        }
      }
      maker.Chain(loop, true);
      for (bool parallel : { true, false })
      {
        const ContourSet set = maker.Build(parallel);
        CheckContourSet(set, 0.02);
        EXPECT_EQ(set.Levels.size(), static_cast<std::size_t>(offset) + 1) << radius;
      }
    }
  }
}

TEST(ContourPlanes, SinglePrecisionFarFromTheOrigin)
{
  SoupMaker maker;
  const PlanarFrame frame = PlanarFrame::About((1 / std::sqrt(2.0)) * Vector3{ 1, -1, 0 });
  for (int l = 0; l < 7; ++l)
  {
    std::vector<Point3> loop;
    for (const Point2& p : Circle(0, 0, 40, 40))
    {
      Point3 x = frame.ToSpace(p, 40.0 * l) + Vector3{ 5e5, 5412400, -200 };
      for (double& c : x)
      {
        // GCC 12 leaves out the rounding of a plain cast there and back.
        const volatile float stored = static_cast<float>(c);
        c = static_cast<double>(stored);
      }
      loop.push_back(x);
    }
    maker.Chain(loop, true);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 1);
  EXPECT_EQ(set.Levels.size(), 7u);
  ASSERT_EQ(set.Report.size(), 1u);
}

TEST(ContourPlanes, LevelsThatWereFoundStay)
{
  // What one filter made one level by its tolerance, or kept apart, the next must not undo.
  const auto again = [](const ContourSet& set)
  {
    SoupMaker maker;
    maker.Soup.Points = set.Points;
    for (const Level& level : set.Levels)
    {
      maker.Soup.Levels.push_back({ level.Frame.Normal, level.Offset, level.Thickness });
    }
    for (std::size_t c = 0; c < set.Contours.size(); ++c)
    {
      maker.Soup.Chains.push_back(
        { set.Contours[c].Points, true, static_cast<int>(c), set.Contours[c].Level, false });
    }
    return maker;
  };
  SoupMaker tube = Tube(0.4, 11);
  const ContourSet one = tube.Build(false, 0.5);
  ASSERT_EQ(one.Levels.size(), 11u);
  const ContourSet two = Tube(0.004, 11).Build(false, 1e-4);
  ASSERT_EQ(two.Levels.size(), 12u);
  for (bool parallel : { true, false })
  {
    const ContourSet kept = again(one).Build(parallel);
    EXPECT_EQ(kept.Levels.size(), 11u);
    EXPECT_EQ(kept.Points, one.Points);
    EXPECT_TRUE(kept.Report.empty());
    EXPECT_EQ(again(two).Build(parallel).Levels.size(), 12u);
  }
  // Contours that were moved since are grouped anew; they lie on their planes by now.
  SoupMaker moved = again(one);
  for (Point3& p : moved.Soup.Points)
  {
    p[2] *= 2;
  }
  EXPECT_EQ(moved.Build().Levels.size(), 11u);
  // Two sets in one: the levels of the second have the numbers of the first.
  SoupMaker both = again(one);
  both.Loop(Circle(100, 0, 5, 20), 4.5);
  both.Soup.Chains.back().Level = 0;
  EXPECT_EQ(both.Build().Levels.size(), 12u);
}

TEST(ContourPlanes, LevelsOfSeveralDirectionsStay)
{
  SoupMaker maker;
  maker.Loop(Circle(0, 0, 5, 30), 0).Loop(Circle(0, 0, 5, 30), 3);
  maker.Chain(InFrame(TiltedFrame(), Circle(0, 0, 30, 30), 1), true);
  maker.Chain(InFrame(TiltedFrame(), Circle(50, 0, 10, 30), 1.3), true);
  const ContourSet set = maker.Build(false, 0.5);
  ASSERT_EQ(set.Levels.size(), 3u);
  SoupMaker again;
  again.Soup.Points = set.Points;
  for (const Level& level : set.Levels)
  {
    again.Soup.Levels.push_back({ level.Frame.Normal, level.Offset, level.Thickness });
  }
  for (std::size_t c = 0; c < set.Contours.size(); ++c)
  {
    again.Soup.Chains.push_back(
      { set.Contours[c].Points, true, static_cast<int>(c), set.Contours[c].Level, false });
  }
  const ContourSet kept = again.Build(false);
  EXPECT_EQ(kept.Levels.size(), 3u);
  EXPECT_EQ(kept.Levels[2].Contours.size(), 2u);
  EXPECT_EQ(again.Build(true).Levels.size(), 1u) << "of one direction two contours, of one level";
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
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_TRUE(Reports(set, "were put on it"));
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
  EXPECT_EQ(parallel.Report[0], "2 contours were left out, 2 are kept.");
  EXPECT_EQ(parallel.Report[1].find(
              "2 contours, the first of cell 2 (30 points, at offset 1): lies in a plane of "
              "normal (1, 0, 0), which is not parallel to the others; left "
              "out. Likewise cell 3 (30 points, at offset "),
    0u)
    << parallel.Report[1];

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
