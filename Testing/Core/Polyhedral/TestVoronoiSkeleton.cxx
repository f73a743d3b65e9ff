// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton of shapes whose points were rounded is that of the shapes.
#include "PolyhedralShapes.h"

#include "Polyhedral/VoronoiSkeleton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
Ring Rounded(Ring ring, double unit)
{
  for (Point2& p : ring)
  {
    p = { std::round(p[0] / unit) * unit, std::round(p[1] / unit) * unit };
  }
  return ring;
}

LevelTriangulation LevelOf(const ContourSet& contours)
{
  return LevelTriangulator(contours, 0).Finish();
}

ContourSet TwoLevels(const Ring& ring)
{
  return BuildStack({ { ring }, { ring } });
}

struct Disc
{
  Point2 Centre;
  double Radius;
};

std::vector<Disc> DiscsOf(const LevelTriangulation& level, const std::vector<unsigned char>& wanted)
{
  std::vector<Disc> discs;
  for (std::size_t t = 0; t < wanted.size(); ++t)
  {
    const Point2 centre = level.VoronoiVertex(static_cast<int>(t));
    if (wanted[t] && level.Inside[t] && std::isfinite(centre[0] + centre[1]))
    {
      discs.push_back({ centre, Distance(centre, level.Points[level.Triangles[t][0]]) });
    }
  }
  return discs;
}

/// A hand of five fingers of different lengths.
Ring Hand()
{
  Ring ring;
  for (int i = 0; i < 400; ++i)
  {
    const double angle = FullTurn * i / 400;
    const double radius = 10 + (4 + std::cos(2 * angle)) * std::cos(5 * angle);
    ring.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return ring;
}
}

TEST(VoronoiSkeleton, OfARoundedCircleIsItsCentre)
{
  for (const double unit : { 0.1, 0.01, 1e-3, 1e-4 })
  {
    for (const double radius : { 3.0, 12.0, 47.3 })
    {
      SCOPED_TRACE(std::to_string(unit) + ", radius " + std::to_string(radius));
      const ContourSet contours = TwoLevels(Rounded(RegularPolygon(120, radius), unit));
      EXPECT_DOUBLE_EQ(UnitOfLevel(contours, 0), unit);
      const LevelTriangulation level = LevelOf(contours);
      EXPECT_GT(InternalSkeletonVertices(level, 0).size(), 30u) << "nothing to leave out";
      const std::vector<Point2> left = InternalSkeletonVertices(level, unit);
      ASSERT_EQ(left.size(), 1u);
      EXPECT_LT(std::hypot(left[0][0], left[0][1]), 2 * unit);
    }
  }
}

TEST(VoronoiSkeleton, OutsideARoundedCircleIsNothingNear)
{
  for (const double unit : { 0.1, 0.01 })
  {
    const LevelTriangulation level = LevelOf(TwoLevels(Rounded(RegularPolygon(376, 12), unit)));
    const std::size_t all = ExternalSkeletonVertices(level, 0).size();
    EXPECT_GT(all, 20u) << unit;
    EXPECT_LE(ExternalSkeletonVertices(level, unit).size(), all / 10) << unit;
  }
}

TEST(VoronoiSkeleton, KeepsBaysThatAreNoRounding)
{
  // A C: the middle of its bay is a vertex, and its decimals do not explain it.
  const ContourSet contours = TwoLevels(
    { { 0, 0 }, { 20, 0 }, { 20, 4 }, { 4, 4 }, { 4, 8 }, { 20, 8 }, { 20, 12 }, { 0, 12 } });
  const std::vector<Point2> bay = ExternalSkeletonVertices(LevelOf(contours), 1);
  EXPECT_TRUE(std::any_of(bay.begin(), bay.end(),
    [](const Point2& p) { return p[0] > 4 && p[0] < 20 && std::abs(p[1] - 6) < 1e-9; }));
}

TEST(VoronoiSkeleton, CoversWhatItLeavesOut)
{
  for (const double unit : { 0.1, 0.01 })
  {
    const LevelTriangulation level = LevelOf(TwoLevels(Rounded(Hand(), unit)));
    const std::vector<Disc> all =
      DiscsOf(level, std::vector<unsigned char>(level.Triangles.size(), 1));
    const std::vector<Disc> left = DiscsOf(level, FindInternalSkeleton(level, unit));
    EXPECT_LT(left.size(), all.size());
    for (const Disc& disc : all)
    {
      double least = disc.Radius;
      for (const Disc& other : left)
      {
        least = std::min(least, Distance(disc.Centre, other.Centre) + disc.Radius - other.Radius);
      }
      EXPECT_LE(least, 2 * unit);
    }
  }
}

TEST(VoronoiSkeleton, KeepsWhatStandsOut)
{
  const LevelTriangulation level = LevelOf(TwoLevels(Rounded(Hand(), 0.01)));
  const std::vector<Point2> left = InternalSkeletonVertices(level, 0.01);
  for (int finger = 0; finger < 5; ++finger)
  {
    const double angle = FullTurn * finger / 5;
    const double tip = 14 + std::cos(2 * angle);
    const Point2 near{ (tip - 3) * std::cos(angle), (tip - 3) * std::sin(angle) };
    EXPECT_TRUE(
      std::any_of(left.begin(), left.end(), [&](const Point2& p) { return Distance(p, near) < 1; }))
      << "finger " << finger;
  }
}

TEST(VoronoiSkeleton, KeepsShapesOfWholeNumbers)
{
  // An L of width 2 and length 12: its last decimal is the ones.
  const ContourSet contours =
    TwoLevels({ { 0, 0 }, { 12, 0 }, { 12, 2 }, { 2, 2 }, { 2, 12 }, { 0, 12 } });
  EXPECT_EQ(UnitOfLevel(contours, 0), 1);
  const LevelTriangulation level = LevelOf(contours);
  const std::vector<Point2> all = InternalSkeletonVertices(level, 0);
  const std::vector<Point2> left = InternalSkeletonVertices(level, 1);
  for (const Point2& p : all)
  {
    EXPECT_TRUE(
      std::any_of(left.begin(), left.end(), [&](const Point2& q) { return Distance(p, q) < 1e-9; }))
      << p[0] << ' ' << p[1];
  }
}

TEST(VoronoiSkeleton, FindsTheUnitOfALevel)
{
  const Ring circle = RegularPolygon(60, 5, 0.1);
  EXPECT_EQ(UnitOfLevel(TwoLevels(circle), 0), 0) << "as many as fit";
  Ring ring = Rounded(circle, 0.01);
  EXPECT_DOUBLE_EQ(UnitOfLevel(TwoLevels(ring), 0), 0.01);
  ring[7] = circle[7];
  EXPECT_DOUBLE_EQ(UnitOfLevel(TwoLevels(ring), 0), 0.01) << "one point may be a crossing";
  // A plane has decimals of its own.
  SoupMaker maker;
  maker.Loop(Rounded(circle, 0.1), 1.0 / 3);
  maker.Loop(Rounded(circle, 0.1), 4.0 / 3);
  EXPECT_DOUBLE_EQ(UnitOfLevel(maker.Build(), 0), 0.1);
}
