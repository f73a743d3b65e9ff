// SPDX-License-Identifier: GPL-3.0-or-later
// What contours say about the volume: exact where sections are parabolas, never without the truth
// where shapes end anywhere between two slices, and nothing where it cannot be known.
#include "Contours/VolumeInterval.h"
#include "SoupMaker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// A polygon of the area of a circle.
std::vector<Point2> Disk(double radius, Point2 middle = { 0, 0 }, double stretch = 1)
{
  constexpr int Corners = 72;
  const double r = radius * std::sqrt(2 * Pi / Corners / std::sin(2 * Pi / Corners));
  std::vector<Point2> points;
  for (int i = 0; i < Corners; ++i)
  {
    const double angle = 2 * Pi * i / Corners;
    points.push_back(
      { middle[0] + stretch * r * std::cos(angle), middle[1] + r * std::sin(angle) });
  }
  return points;
}

VolumeInterval Estimate(const SoupMaker& maker, const ContourMappingOptions& options = {})
{
  Monitor monitor;
  return EstimateVolume(maker.Build(), options, monitor).value();
}

/// Slices one apart, the first at that place, as long as there is a section.
SoupMaker Slices(double first, double last, const std::function<std::vector<Point2>(double)>& at)
{
  SoupMaker maker;
  for (double z = first; z < last; z += 1)
  {
    maker.Loop(at(z), z);
  }
  return maker;
}

SoupMaker Ball(double radius, double offset, double stretch = 1)
{
  return Slices(offset - std::floor(radius + offset), radius - 1e-3,
    [&](double z) {
      return Disk(std::sqrt(radius * radius - z * z), { 0, 0 }, stretch);
    });
}

void ExpectWithin(const VolumeInterval& interval, double truth, const std::string& what)
{
  constexpr double Rounding = 1e-12;
  EXPECT_LE(interval.Lowest, truth * (1 + Rounding)) << what;
  EXPECT_GE(interval.Highest, truth * (1 - Rounding)) << what;
  EXPECT_LE(interval.Lowest, interval.Estimate) << what;
  EXPECT_GE(interval.Highest, interval.Estimate) << what;
  double widths = 0;
  for (const VolumeDoubt& doubt : interval.Doubts)
  {
    widths += doubt.Width;
  }
  EXPECT_GE(widths, (interval.Highest - interval.Lowest) * (1 - 1e-9)) << what;
}
}

TEST(VolumeInterval, IsExactForBallsAndEllipsoidsWhereverTheirSlicesAre)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (const double diameter : { 3.0, 5.0, 7.0, 10.0, 15.0, 20.0 })
  {
    for (int i = 0; i < 20; ++i)
    {
      const double stretch = 0.5 + part(random);
      const double r = diameter / 2;
      const SoupMaker maker = Ball(r, part(random), stretch);
      const double truth = stretch * 4 * Pi / 3 * r * r * r;
      const VolumeInterval interval = Estimate(maker);
      ExpectWithin(interval, truth, std::to_string(diameter));
      if (maker.Soup.Chains.size() > 2)
      {
        EXPECT_NEAR(interval.Estimate, truth, 1e-6 * truth) << diameter;
      }
    }
  }
}

TEST(VolumeInterval, TwoSlicesOfABallTellItsVolume)
{
  SoupMaker maker;
  maker.Loop(Disk(std::sqrt(1 - 0.4 * 0.4)), -0.4).Loop(Disk(std::sqrt(1 - 0.5 * 0.5)), 0.5);
  const VolumeInterval interval = Estimate(maker);
  ExpectWithin(interval, 4 * Pi / 3, "ball");
  // Ends are exact, the one slab is taken for a cone's.
  EXPECT_NEAR(interval.Estimate, 4 * Pi / 3, 0.15 * 4 * Pi / 3);
}

TEST(VolumeInterval, HoldsCylindersThatLieAcrossTheSlices)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 60; ++i)
  {
    const double r = 2 + 10 * part(random);
    const double length = 3 + 30 * part(random);
    const double offset = part(random);
    const SoupMaker maker = Slices(offset - std::floor(r + offset), r - 1e-3,
      [&](double z)
      {
        const double w = std::sqrt(r * r - z * z);
        return std::vector<Point2>{ { -w, 0 }, { w, 0 }, { w, length }, { -w, length } };
      });
    ExpectWithin(Estimate(maker), Pi * r * r * length, std::to_string(r));
  }
}

TEST(VolumeInterval, HoldsCylindersWithASectionOnTheirVerySides)
{
  for (const double r : { 3.0, 5.0, 12.0, 20.0 })
  {
    SoupMaker maker;
    for (double z = -r; z <= r; z += 1)
    {
      const double w = std::max(1e-3, std::sqrt(r * r - z * z));
      maker.Loop(Rectangle(-w, 0, w, 24), z);
    }
    ExpectWithin(Estimate(maker), Pi * r * r * 24, std::to_string(r));
  }
}

TEST(VolumeInterval, HoldsColumnsAndConesThatEndAnywhereBetweenTwoSlices)
{
  for (double end = 0.02; end < 1; end += 0.08)
  {
    const SoupMaker column = Slices(0, 8.5, [](double) { return Disk(5); });
    ExpectWithin(Estimate(column), Pi * 25 * (8 + end + (1 - end) / 2), "column");
    // Its base, which widens, is beyond the last slice.
    const SoupMaker cone = Slices(1 - end, 9.99 - end, [](double z) { return Disk(z); });
    ExpectWithin(Estimate(cone), Pi / 3 * std::pow(10 - end - 1 + 0.5, 3), "cone");
  }
}

TEST(VolumeInterval, IsNarrowWhereSlicesAreDense)
{
  const VolumeInterval interval = Estimate(Ball(20, 0.3));
  EXPECT_LT(interval.Highest - interval.Lowest, 0.01 * interval.Estimate);
}

TEST(VolumeInterval, NamesTheSlicesThatWouldTellMost)
{
  // A wide column that ends below a narrow one: nothing is as doubtful as where it does.
  SoupMaker maker;
  for (int z = 0; z < 9; ++z)
  {
    maker.Loop(Disk(1, { 20, 0 }), z);
    if (z < 5)
    {
      maker.Loop(Disk(10), z);
    }
  }
  const VolumeInterval interval = Estimate(maker);
  ASSERT_GE(interval.Doubts.size(), 3u);
  EXPECT_EQ(interval.Doubts[0].Offset, -0.5) << "both columns end there";
  EXPECT_EQ(interval.Doubts[1].Offset, 4.5);
  EXPECT_NEAR(interval.Doubts[1].Width, Pi * 100, 1e-6);
  EXPECT_EQ(interval.Doubts[2].Offset, 8.5);
  EXPECT_NEAR(interval.Doubts[2].Width, Pi, 1e-9);
  ExpectWithin(interval, Pi * (4 * 100 + 8), "both end on their slices");
  ExpectWithin(interval, Pi * (6 * 100 + 10), "both go on as far as can be");
}

TEST(VolumeInterval, AHoleThatClosesMayDoSoAnywhereAndOneThatOpensMayNot)
{
  const auto ring = [](bool closes)
  {
    SoupMaker maker;
    for (int z = 0; z < 6; ++z)
    {
      maker.Loop(Rectangle(0, 0, 20, 20), z);
      if (z < 3)
      {
        maker.Loop(Rectangle(5, 5, 15, 15), z);
      }
      else if (!closes)
      {
        maker.Soup.Chains.pop_back();
        maker.Loop({ { 0, 0 }, { 20, 0 }, { 20, 20 }, { 15, 20 }, { 15, 5 }, { 5, 5 }, { 5, 20 },
                     { 0, 20 } },
          z);
      }
    }
    return Estimate(maker);
  };
  const auto widthAt = [](const VolumeInterval& interval, double offset)
  {
    for (const VolumeDoubt& doubt : interval.Doubts)
    {
      if (doubt.Offset == offset)
      {
        return doubt.Width;
      }
    }
    return 0.0;
  };
  const VolumeInterval closing = ring(true);
  EXPECT_GE(widthAt(closing, 2.5), 100);
  ExpectWithin(closing, 400 * 5 - 100 * 2, "closes at once");
  ExpectWithin(closing, 400 * 5 - 100 * 3, "closes late");
  EXPECT_LT(widthAt(ring(false), 2.5), 50);
}

TEST(VolumeInterval, StacksThatLieFarApartEndEach)
{
  SoupMaker maker;
  for (const int start : { 0, 100 })
  {
    for (int z = 0; z < 5; ++z)
    {
      maker.Loop(Disk(5), start + z);
    }
  }
  const VolumeInterval interval = Estimate(maker);
  EXPECT_NEAR(interval.Lowest, 2 * 4 * Pi * 25, 1e-6);
  EXPECT_NEAR(interval.Highest, 2 * 6 * Pi * 25, 1e-6);
}

TEST(VolumeInterval, FollowsJoinsThatAreForbidden)
{
  const SoupMaker maker = Slices(0, 2.5, [](double) { return Disk(5); });
  ContourMappingOptions options;
  options.ForbiddenJoins = { { 0, 1 } };
  EXPECT_NEAR(Estimate(maker, options).Lowest, Pi * 25, 1e-6) << "of one slab instead of two";
}

TEST(VolumeInterval, IsNothingWhereItCannotBeKnown)
{
  Monitor monitor;
  SoupMaker one;
  one.Loop(Disk(5), 0);
  EXPECT_FALSE(EstimateVolume(one.Build(), {}, monitor));
  SoupMaker crossed;
  crossed.Loop(Disk(5), 0).Chain({ { 0, -2, 1 }, { 0, 2, 1 }, { 0, 2, 5 }, { 0, -2, 5 } }, true);
  EXPECT_FALSE(EstimateVolume(crossed.Build(false), {}, monitor));
}
