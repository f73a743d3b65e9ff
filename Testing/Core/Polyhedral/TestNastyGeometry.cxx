// SPDX-License-Identifier: GPL-3.0-or-later
// What nobody draws and programs write: every promise, with every combination of options, upright and
// tilted. Where the shape is a prism its volume is known.
#include "DegenerateStacks.h"
#include "NodeDefaults.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
/// The same contours on every level.
SoupMaker Prism(const std::vector<Ring>& rings, const std::vector<double>& heights)
{
  SoupMaker maker;
  for (const double height : heights)
  {
    for (const Ring& ring : rings)
    {
      maker.Loop(ring, height);
    }
  }
  return maker;
}

SoupMaker Stack(const RingStack& levels, double spacing = 1)
{
  SoupMaker maker;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    for (const Ring& ring : levels[l])
    {
      maker.Loop(ring, spacing * static_cast<double>(l));
    }
  }
  return maker;
}

/// The options that users meet leave nothing out.
void ExpectNothingLeftOut(const SoupMaker& maker)
{
  const ContourSet contours = maker.Build();
  ASSERT_GE(contours.Levels.size(), 2u);
  const LeftOut leftOut = ContoursLeftOut(BuildSurface(contours, NodeOptions()));
  EXPECT_EQ(leftOut.Wholly.size() + leftOut.InPart.size(), 0u);
}

/// All promises, upright and tilted in three directions.
void ExpectHolds(const SoupMaker& maker)
{
  EXPECT_EQ(BrokenPromisesOfStack(maker), "") << "upright";
  ExpectNothingLeftOut(maker);
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    SCOPED_TRACE("tilted by seed " + std::to_string(seed));
    const SoupMaker tilted = Tilted(maker, seed);
    EXPECT_EQ(BrokenPromisesOfStack(tilted), "");
    ExpectNothingLeftOut(tilted);
  }
}

/// With flat ends.
double FlatVolume(const SoupMaker& maker)
{
  return VolumeOf(BuildSurface(maker.Build()).Mesh);
}

void ExpectPrism(const SoupMaker& maker, double volume, double relativeTolerance)
{
  ExpectHolds(maker);
  EXPECT_NEAR(FlatVolume(maker) / volume, 1, relativeTolerance);
  EXPECT_NEAR(FlatVolume(Tilted(maker, 1)) / volume, 1, relativeTolerance) << "tilted";
}

/// Every second square of a board, those of one parity.
std::vector<Ring> Board(int count, int parity)
{
  std::vector<Ring> rings;
  for (int i = 0; i < count * count; ++i)
  {
    const int x = i % count, y = i / count;
    if ((x + y) % 2 == parity)
    {
      rings.push_back(Rectangle(x, y, x + 1, y + 1));
    }
  }
  return rings;
}

/// A band that winds inwards, so wide and with so wide a gap between its turns.
Ring Spiral(int turns, double width, double gap)
{
  constexpr int PerTurn = 24;
  const double pitch = width + gap;
  const auto at = [&](int i, double inwards)
  {
    const double angle = FullTurn * i / PerTurn;
    const double radius = 1 + pitch * turns - pitch * i / PerTurn - inwards;
    return Point2{ radius * std::cos(angle), radius * std::sin(angle) };
  };
  Ring ring;
  for (int i = 0; i <= turns * PerTurn; ++i)
  {
    ring.push_back(at(i, 0));
  }
  for (int i = turns * PerTurn; i >= 0; --i)
  {
    ring.push_back(at(i, width));
  }
  return ring;
}

/// A back of height 1 with teeth of length 2 upwards, `gap` between them.
Ring Comb(int teeth, double gap)
{
  Ring ring{ { 0, 0 }, { static_cast<double>(teeth), 0 } };
  for (int i = teeth - 1; i >= 0; --i)
  {
    const double left = i > 0 ? i + gap / 2 : 0;
    const double right = i < teeth - 1 ? i + 1 - gap / 2 : teeth;
    ring.insert(ring.end(), { { right, 1 }, { right, 3 }, { left, 3 }, { left, 1 } });
  }
  return ring;
}

Ring Moved(Ring ring, double x, double y)
{
  for (Point2& p : ring)
  {
    p = { p[0] + x, p[1] + y };
  }
  return ring;
}

Ring Scaled(Ring ring, double x, double y)
{
  for (Point2& p : ring)
  {
    p = { x * p[0], y * p[1] };
  }
  return ring;
}
}

TEST(NastyGeometry, SquaresThatShareAllTheirCorners)
{
  ExpectPrism(Prism(Board(4, 0), { 0, 1, 2 }), 16, 1e-9);
}

TEST(NastyGeometry, BoardsThatShareAllTheirEdgesFromLevelToLevel)
{
  ExpectHolds(Stack({ Board(3, 0), Board(3, 1), Board(3, 0) }));
}

TEST(NastyGeometry, SquaresThatShareEdges)
{
  // A row of four is one rectangle.
  std::vector<Ring> row;
  for (int i = 0; i < 4; ++i)
  {
    row.push_back(Rectangle(0.1 * i, 0, 0.1 * (i + 1), 0.1));
  }
  const SoupMaker maker = Prism(row, { 0, 0.1, 0.2 });
  EXPECT_EQ(maker.Build().Contours.size(), 3u);
  ExpectPrism(maker, 0.4 * 0.1 * 0.2, 1e-9);
}

TEST(NastyGeometry, RunsOfPointsInLine)
{
  // Tenths are in line up to rounding only; levels have them at other places.
  const auto square = [](int pieces)
  {
    const Ring corners = Rectangle(0.1, 0.1, 1.3, 1.3);
    Ring ring;
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Point2 &a = corners[c], &b = corners[(c + 1) % 4];
      for (int i = 0; i < pieces; ++i)
      {
        const double t = static_cast<double>(i) / pieces;
        ring.push_back({ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) });
      }
    }
    return ring;
  };
  ExpectPrism(Stack({ { square(10) }, { square(7) }, { square(1) }, { square(10) } }, 0.1),
    1.2 * 1.2 * 0.3, 1e-9);
}

TEST(NastyGeometry, SliversBesideASquare)
{
  for (const double height : { 1e-12, 1e-9, 1e-6 })
  {
    SCOPED_TRACE(height);
    const std::vector<Ring> rings{ Rectangle(0, 0, 1, 1), { { 2, 0 }, { 3, 0 }, { 2.5, height } } };
    ExpectPrism(Prism(rings, { 0, 1, 2 }), 2, 2 * height + 1e-9);
  }
}

TEST(NastyGeometry, ASliverWithinASquare)
{
  for (const double height : { 1e-12, 1e-9, 1e-6 })
  {
    SCOPED_TRACE(height);
    const std::vector<Ring> rings{ Rectangle(0, 0, 1, 1),
      { { 0.2, 0.5 }, { 0.8, 0.5 }, { 0.5, 0.5 + height } } };
    ExpectPrism(Prism(rings, { 0, 1, 2 }), 2, 2 * height + 1e-9);
  }
}

TEST(NastyGeometry, Spirals)
{
  for (const double gap : { 0.1, 1e-3, 1e-5 })
  {
    SCOPED_TRACE(gap);
    ExpectHolds(Stack({ { Spiral(2, 0.2, gap) }, { Spiral(2, 0.2, gap) } }));
  }
  // The turns of one lie across the gaps of the other.
  ExpectHolds(Stack({ { Spiral(2, 0.1, 0.1) }, { Spiral(2, 0.15, 0.05) } }));
}

TEST(NastyGeometry, Combs)
{
  for (const double gap : { 0.1, 1e-3, 1e-6 })
  {
    SCOPED_TRACE(gap);
    const Ring comb = Comb(4, gap);
    ExpectPrism(Prism({ comb }, { 0, 1 }), 4 + 2 * (4 - 3 * gap), 1e-9);
    // The other's teeth lie across these gaps, from the same side and from the other.
    ExpectHolds(Stack({ { comb }, { Moved(comb, 0.5, 0) } }));
    ExpectHolds(Stack({ { comb }, { Scaled(comb, 1, -1) }, { comb } }));
  }
}

TEST(NastyGeometry, AMillionfoldDifferenceOfSize)
{
  // Beside, within, and above.
  const Ring large = Scaled(RegularPolygon(16, 1), 1e6, 1e6);
  const Ring small = RegularPolygon(12, 1, 0.1);
  ExpectHolds(Prism({ large, Moved(small, 2e6, 0) }, { 0, 1, 2 }));
  ExpectHolds(Prism({ large, small }, { 0, 1, 2 }));
  ExpectHolds(Stack({ { large }, { small }, { large } }, 1e3));
  // In one direction only: of contours, and of the spacing.
  ExpectHolds(Prism({ Scaled(small, 1e6, 1) }, { 0, 1, 2 }));
  ExpectHolds(Prism({ small }, { 0, 1e6, 2e6 }));
  ExpectHolds(Stack({ { small }, { Scaled(small, 0.5, 1.5) } }, 1e6));
}

TEST(NastyGeometry, CoordinatesAtABillion)
{
  const Ring outline = Moved(RegularPolygon(12, 8), 1e9, -1e9);
  const Ring hole = Moved(RegularPolygon(5, 3), 1e9, -1e9);
  ExpectHolds(Prism({ outline, hole }, { 1e9, 1e9 + 3, 1e9 + 6 }));
  ExpectHolds(Stack({ { outline }, { outline, hole }, { hole } }, 3));
}

TEST(NastyGeometry, LevelsGivenTwice)
{
  // To the last bit, and hardly beside themselves.
  for (const double apart : { 0.0, 1e-15, 1e-12 })
  {
    SCOPED_TRACE(apart);
    const SoupMaker maker =
      Prism({ Rectangle(0, 0, 1, 1) }, { 0, 0 + apart, 1, 1 + apart, 2, 2 + apart, 3, 3 + apart });
    EXPECT_EQ(maker.Build().Levels.size(), 4u);
    ExpectPrism(maker, 3, 1e-9);
  }
}

TEST(NastyGeometry, SlicesABillionthApart)
{
  const SoupMaker maker = Prism({ Rectangle(0, 0, 1, 1) }, { 0, 1e-9, 2e-9, 3e-9 });
  EXPECT_EQ(maker.Build().Levels.size(), 4u);
  ExpectPrism(maker, 3e-9, 1e-6);
  ExpectHolds(Stack(
    { { RegularPolygon(12, 1) }, { RegularPolygon(9, 0.7) }, { RegularPolygon(12, 1) } }, 1e-9));
}

TEST(NastyGeometry, ThousandsOfContoursALevel)
{
  constexpr int Side = 50;
  std::vector<Ring> rings;
  for (int i = 0; i < Side * Side; ++i)
  {
    const double x = i % Side, y = i / Side;
    rings.push_back(Rectangle(x, y, x + 0.5, y + 0.5));
  }
  const SoupMaker maker = Prism(rings, { 0, 1, 2 });
  for (const bool tilted : { false, true })
  {
    const ContourSet contours = (tilted ? Tilted(maker, 1) : maker).Build();
    ASSERT_EQ(contours.Contours.size(), 3u * Side * Side);
    PolyhedralOptions options;
    options.Mapping = PolyhedralOptions::Overlap;
    const PolyhedralSurface surface = BuildSurface(contours, options);
    EXPECT_EQ(BrokenPromises(surface, contours, options) + IntersectionsOf(surface.Mesh), "");
    EXPECT_EQ(CheckTopology(surface.Mesh).Total.Components, Side * Side);
    EXPECT_NEAR(VolumeOf(surface.Mesh) / (0.25 * 2 * Side * Side), 1, 1e-9);
  }
}

TEST(NastyGeometry, EdgesThatAreNearlyParallel)
{
  for (const double turn : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    SCOPED_TRACE(turn);
    // From level to level, and of two walls beside each other.
    const Ring straight = Rectangle(0, 0, 2, 1);
    const Ring turned{ { 0, 0 }, { 2, turn }, { 2, 1 - turn }, { 0, 1 } };
    ExpectPrism(Stack({ { straight }, { turned }, { straight } }), 4, 2 * turn + 1e-9);
    const Ring wedge{ { 0, 1 + 1e-3 }, { 2, 1 + 1e-3 + turn }, { 2, 2 }, { 0, 2 } };
    ExpectHolds(Stack({ { straight, wedge }, { turned, wedge } }));
  }
}
