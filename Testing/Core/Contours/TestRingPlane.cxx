// SPDX-License-Identifier: GPL-3.0-or-later
// What single rings tell about planes, and what they have in common.
#include "Contours/RingDirections.h"
#include "Contours/RingPlane.h"
#include "SoupMaker.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<Ring> RingsOf(const SoupMaker& maker)
{
  std::vector<Ring> rings;
  for (const LoopSoup::Chain& chain : maker.Soup.Chains)
  {
    rings.push_back({ chain.Points, chain.Source, -1 });
  }
  return rings;
}

TEST(RingPlane, NormalRoughnessAndTrust)
{
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 4, 2), 3);
  maker.Chain({ { 0, 0, 0.1 }, { 4, 0, -0.1 }, { 4, 2, 0.1 }, { 0, 2, -0.1 } }, true);
  maker.Loop({ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 2 } }, 1); // a bow tie without net area
  maker.Loop({ { 0, 0 }, { 1, 0 }, { 2, 0 } }, 1);
  const std::vector<Ring> rings = RingsOf(maker);
  const RingPlane flat = FindRingPlane(maker.Soup, rings[0], 1e-3);
  EXPECT_EQ(flat.AreaVector, (Vector3{ 0, 0, 8 }));
  EXPECT_EQ(flat.Roughness, 0);
  EXPECT_TRUE(flat.Trusted);
  EXPECT_FALSE(FindRingPlane(maker.Soup, rings[0], 1).Trusted) << "narrow beside the tolerance";
  EXPECT_NEAR(FindRingPlane(maker.Soup, rings[1], 1e-3).Roughness, 0.1, 1e-3);
  EXPECT_TRUE(FindRingPlane(maker.Soup, rings[2], 1e-3).HasNormal);
  EXPECT_FALSE(FindRingPlane(maker.Soup, rings[3], 1e-3).HasNormal);
  EXPECT_EQ(CanonicalNormal({ 0, 0, -2 }), (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(NearestAxis({ 0.1, -0.9, 0.2 }), (Vector3{ 0, 1, 0 }));
  EXPECT_EQ(RangeAlong(maker.Soup, rings[0], { 1, 0, 0 }).Middle(), 2);
}

TEST(RingPlane, StepOfRoundedCoordinates)
{
  const auto stepOf = [](double x)
  {
    const SoupMaker maker = SoupMaker().Loop({ { x, 0 }, { 3.5, 0 }, { 2, 2 } });
    return CoordinateStep(maker.Soup, RingsOf(maker));
  };
  EXPECT_DOUBLE_EQ(stepOf(1), 0.1) << "whole numbers may be exact";
  EXPECT_DOUBLE_EQ(stepOf(1.25), 0.01);
  EXPECT_DOUBLE_EQ(stepOf(1.257), 0.001);
  EXPECT_DOUBLE_EQ(stepOf(5412345.1234567), 0) << "neither decimals nor single precision";
  const auto single = static_cast<double>(std::nextafter(5e6F, 6e6F));
  EXPECT_DOUBLE_EQ(stepOf(single + 1.0 / 3), 0);
  EXPECT_DOUBLE_EQ(stepOf(1.0 / 3), 0);
  EXPECT_DOUBLE_EQ(stepOf(1.0 / 1024 / 1024), std::ldexp(1, -22)) << "that of 3.5";
}

TEST(RingDirections, TheCommonNormalIsThatOfMostRings)
{
  SoupMaker maker;
  maker.Loop(Circle(0, 0, 5, 20), 0).Loop(Circle(0, 0, 5, 20), 1);
  std::vector<Point3> upright;
  for (const Point2& p : Circle(0, 0, 50, 20))
  {
    upright.push_back({ 1, p[0], p[1] });
  }
  maker.Chain(upright, true);
  const std::vector<Ring> rings = RingsOf(maker);
  Monitor monitor;
  RingDirections directions(maker.Soup, rings, 1e-3, monitor);
  EXPECT_EQ(directions.AllowForRoughness(), 0);
  const Vector3 normal = directions.CommonNormal();
  EXPECT_EQ(normal, (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(directions.FlatRings(normal), (std::vector<int>{ 0, 1 }));
  EXPECT_NEAR(directions.AngleTo(normal, 2), std::acos(0.0), 1e-12);
  EXPECT_EQ(directions.GetByArea()[0], 2);
  EXPECT_EQ(directions.FindNearlyParallel(normal, 0, false).Rings, (std::vector<int>{ 0, 1 }));
}

TEST(RingDirections, NearlyParallelRingsAreThoseWithinAFifthOfTheDistance)
{
  const auto nearly = [](double rise)
  {
    SoupMaker maker;
    for (int l = 0; l < 5; ++l)
    {
      std::vector<Point3> loop = SoupMaker::Lift(Circle(0, 0, 50, 40), 10 * l);
      for (Point3& p : loop)
      {
        p[2] += l == 2 ? rise * p[0] / 50 : 0;
      }
      maker.Chain(loop, true);
    }
    const std::vector<Ring> rings = RingsOf(maker);
    Monitor monitor;
    RingDirections directions(maker.Soup, rings, 1e-3, monitor);
    return directions.FindNearlyParallel(directions.CommonNormal(), 0, false);
  };
  const NearlyParallel kept = nearly(1.9);
  EXPECT_EQ(kept.Rings.size(), 5u);
  EXPECT_EQ(kept.Tilted, 1u);
  EXPECT_NEAR(kept.FarthestOff, 1.9, 1e-9);
  EXPECT_NEAR(kept.LargestAngle, std::atan(1.9 / 50), 1e-9);
  EXPECT_EQ(nearly(2.1).Rings.size(), 4u) << "farther than a fifth of 10";
  EXPECT_EQ(nearly(3).Rings.size(), 4u) << "and turned by more than three degrees";
}
}
