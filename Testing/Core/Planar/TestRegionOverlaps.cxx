// SPDX-License-Identifier: GPL-3.0-or-later
// Areas that regions of two levels share: against numbers known by hand and against sampling.
#include "Core/Contours/SoupMaker.h"
#include "Planar/RegionOverlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Area by (source of the lower contour, source of the upper one).
using Areas = std::map<std::pair<int, int>, double>;

Areas Measure(const ContourSet& set)
{
  Areas areas;
  for (const RegionOverlap& overlap :
    MeasureRegionOverlaps(set, set.Levels.at(0), set.Levels.at(1)))
  {
    const auto source = [&set](int c) { return set.Contours[static_cast<std::size_t>(c)].Source; };
    areas[{ source(overlap.LowerContour), source(overlap.UpperContour) }] = overlap.Area;
  }
  return areas;
}

TEST(RegionOverlaps, RectanglesThatCross)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 10, 4), 0).Loop(Rectangle(3, -2, 5, 9), 1).Build();
  EXPECT_EQ(Measure(set), (Areas{ { { 0, 1 }, 8.0 } }));
}

TEST(RegionOverlaps, HolesAreRegionsOfTheirOwn)
{
  // Below: 10 x 10 with a hole 2..8 x 2..8. Above: 0..6 x 0..6 with a hole 1..3 x 1..3.
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 10, 10), 0)
                           .Loop(Rectangle(2, 2, 8, 8), 0)
                           .Loop(Rectangle(0, 0, 6, 6), 1)
                           .Loop(Rectangle(1, 1, 3, 3), 1)
                           .Build();
  const Areas expected{ { { 0, 2 }, 36 - 16 - 3 }, { { 0, 3 }, 3 }, { { 1, 2 }, 16 - 1 },
    { { 1, 3 }, 1 } };
  EXPECT_EQ(Measure(set), expected);
}

TEST(RegionOverlaps, EqualContoursShareAll)
{
  const std::vector<Point2> circle = Circle(100.1, -7.3, 3, 61);
  const ContourSet set = SoupMaker().Loop(circle, 0).Loop(circle, 1).Build();
  const Areas areas = Measure(set);
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(areas.begin()->second, set.Contours[0].SignedArea, 1e-12);
}

TEST(RegionOverlaps, NeighboursThatTouchShareNothing)
{
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 2, 2), 0)
                           .Loop(Rectangle(2, 0, 4, 2), 1)
                           .Loop(Rectangle(0, 2, 2, 4), 1)
                           .Build();
  EXPECT_TRUE(Measure(set).empty());
}

TEST(RegionOverlaps, EdgesThatCoincideInPart)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 4, 4), 0).Loop(Rectangle(1, 0, 3, 2), 1).Build();
  EXPECT_EQ(Measure(set), (Areas{ { { 0, 1 }, 4.0 } }));
}

TEST(RegionOverlaps, LevelsApartShareNothing)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 1, 1), 0).Loop(Rectangle(5, 0, 6, 1), 1).Build();
  EXPECT_TRUE(Measure(set).empty());
}

TEST(RegionOverlaps, ContoursThatShareVerticesKeepTheirRegions)
{
  // Three diamonds in a row that touch in their tips, against a bar across all of them.
  SoupMaker maker;
  for (int i = 0; i < 3; ++i)
  {
    const double x = 2.0 * i;
    maker.Loop({ { x, 0 }, { x + 1, -1 }, { x + 2, 0 }, { x + 1, 1 } }, 0);
  }
  maker.Loop(Rectangle(-1, 0, 7, 3), 1);
  const Areas expected{ { { 0, 3 }, 1 }, { { 1, 3 }, 1 }, { { 2, 3 }, 1 } };
  EXPECT_EQ(Measure(maker.Build()), expected);
}

/// Star-shaped loops that cross at odd places, one within the other.
std::vector<Point2> Wobbly(double x, double y, double radius, int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> factor(0.8, 1.0);
  std::vector<Point2> points = Circle(0, 0, radius, count);
  for (Point2& p : points)
  {
    const double f = factor(random);
    p = { x + f * p[0], y + f * p[1] };
  }
  return points;
}

TEST(RegionOverlaps, AddUpToTheRegions)
{
  // Every level fills the same frame, so the overlaps of a region add up to its area.
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SoupMaker maker;
    for (double z : { 0.0, 1.0 })
    {
      maker.Loop(Rectangle(-9, -9, 9, 9), z);
      maker.Loop(Wobbly(0.1 * seed, 0.3 * z, 7, 120, 2 * seed + static_cast<unsigned>(z)), z);
      maker.Loop(Wobbly(0.1 * seed, 0.3 * z, 4.5, 90, 77 + seed + static_cast<unsigned>(z)), z);
      maker.Loop(Wobbly(0.1 * seed, 0.3 * z, 3, 33, 99 + seed), z);
    }
    const ContourSet set = maker.Build();
    ASSERT_EQ(set.Contours.size(), 8u) << "seed " << seed;
    std::vector<double> sums(8, 0.0);
    for (const RegionOverlap& overlap : MeasureRegionOverlaps(set, set.Levels[0], set.Levels[1]))
    {
      sums[static_cast<std::size_t>(overlap.LowerContour)] += overlap.Area;
      sums[static_cast<std::size_t>(overlap.UpperContour)] += overlap.Area;
    }
    for (std::size_t c = 0; c < sums.size(); ++c)
    {
      double area = std::abs(set.Contours[c].SignedArea);
      for (const Contour& other : set.Contours)
      {
        area -= other.Parent == static_cast<int>(c) ? std::abs(other.SignedArea) : 0;
      }
      EXPECT_NEAR(sums[c], area, 1e-10) << "seed " << seed << ", contour " << c;
    }
  }
}

TEST(RegionOverlaps, CrossingsThatRoundDoNotMislead)
{
  // Walls a few units in the last place apart, crossed by many slanted edges: rounded crossings
  // may fall on the wrong side, and must not change the areas of what is far away.
  const double step = 1e-15;
  SoupMaker maker;
  maker.Loop(Rectangle(0.1, 0.1, 10.1, 10.1), 0);
  maker.Loop(Rectangle(0.2, 0.2, 10, 10), 0);
  maker.Loop(Rectangle(3.1, 3.1, 5.1, 5.1), 0);
  std::vector<Point2> comb;
  for (int i = 0; i < 60; ++i)
  {
    comb.push_back({ 0.13 * i + 0.7, -1.0 - 0.01 * i });
    comb.push_back({ 0.13 * i + 0.77, 9.0 + 0.003 * i });
  }
  comb.push_back({ 30, 30 });
  comb.push_back({ 30, -30 });
  maker.Loop(comb, 1);
  ContourSet set = maker.Build();
  for (int p : set.Contours[1].Points)
  {
    // Afterwards, as contours so near to each other are taken to touch when a set is built.
    for (double& x : set.Planar[static_cast<std::size_t>(p)])
    {
      x = x < 1 ? 0.1 + step : 10.1 - 8 * step;
    }
  }
  double solid = 0;
  double facingHole = 0;
  for (const RegionOverlap& overlap : MeasureRegionOverlaps(set, set.Levels[0], set.Levels[1]))
  {
    const Contour& lower = set.Contours[static_cast<std::size_t>(overlap.LowerContour)];
    (lower.Depth == 2 ? solid : facingHole) += overlap.Area;
  }
  // The comb over the inner square alone, measured without the walls around it.
  const ContourSet alone = SoupMaker().Loop(Rectangle(3.1, 3.1, 5.1, 5.1), 0).Loop(comb, 1).Build();
  const ContourSet outer =
    SoupMaker().Loop(Rectangle(0.1, 0.1, 10.1, 10.1), 0).Loop(comb, 1).Build();
  const double inner = Measure(alone).at({ 0, 1 });
  EXPECT_GT(inner, 0.5);
  EXPECT_NEAR(solid, inner, 1e-10);
  EXPECT_NEAR(facingHole, Measure(outer).at({ 0, 1 }) - inner, 1e-10);
}

TEST(RegionOverlaps, ManyRegionsALevel)
{
  // 23 x 23 squares against the same, moved by a quarter: each meets four, in areas known.
  constexpr int count = 23;
  SoupMaker maker;
  for (double z : { 0.0, 1.0 })
  {
    for (int i = 0; i < count * count; ++i)
    {
      const double x = i % count + 0.25 * z;
      const double y = i / count + 0.25 * z;
      maker.Loop(Rectangle(x, y, x + 0.875, y + 0.875), z);
    }
  }
  const ContourSet set = maker.Build();
  ASSERT_EQ(set.Contours.size(), 2u * count * count);
  const Areas areas = Measure(set);
  EXPECT_EQ(areas.size(),
    static_cast<std::size_t>(count * count + 2 * count * (count - 1) + (count - 1) * (count - 1)));
  for (const auto& [pair, area] : areas)
  {
    const int dx = pair.second % count != pair.first % count;
    const int dy = (pair.second - count * count) / count != pair.first / count;
    // The moved square reaches 0.125 into the next one.
    const double expected = pair.second - count * count == pair.first ? 0.625 * 0.625
      : dx && dy                                                      ? 0.125 * 0.125
                                                                      : 0.625 * 0.125;
    EXPECT_DOUBLE_EQ(area, expected) << pair.first << ", " << pair.second;
  }
}
}
