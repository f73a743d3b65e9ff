// SPDX-License-Identifier: GPL-3.0-or-later
// The whole polyhedral method on shapes with known answers; row 6 of what the project must show.
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Checks the surface with every combination of options and returns that of the defaults.
PolyhedralSurface ExpectSound(const ContourSet& contours)
{
  for (const bool internalPoints : { false, true })
  {
    for (const bool lift : { false, true })
    {
      SCOPED_TRACE(std::string(internalPoints ? "with" : "without") + " internal points, " +
        (lift ? "lifted" : "not lifted"));
      PolyhedralOptions options;
      options.InternalPoints = internalPoints;
      options.LiftInternalPoints = lift;
      ExpectKeepsPromises(BuildSurface(contours, options), contours);
    }
  }
  return BuildSurface(contours);
}

/// The same levels `count` times over: a prism of the given volume, without a point that is not
/// given.
void ExpectPrism(const std::vector<Ring>& level, double area, int count)
{
  SCOPED_TRACE(std::to_string(count) + " levels");
  const ContourSet contours = BuildStack(RingStack(count, level), 0.5);
  const PolyhedralSurface surface = ExpectSound(contours);
  EXPECT_TRUE(surface.Report.empty());
  const double volume = 0.5 * (count - 1) * area;
  EXPECT_NEAR(VolumeOf(surface.Mesh), volume, 1e-12 * volume);
}

/// n / 2 r^2 sin(2 pi / n)
double AreaOfRegularPolygon(int count, double radius)
{
  return 0.5 * count * radius * radius * std::sin(FullTurn / count);
}

int CountFaces(const PolyhedralSurface& surface, PolyhedralSurface::FaceKindType kind)
{
  return static_cast<int>(std::count(surface.FaceKind.begin(), surface.FaceKind.end(), kind));
}
}

TEST(PolyhedralSurface, IdenticalSquaresMakeABox)
{
  for (const int count : { 2, 3, 50 })
  {
    ExpectPrism({ Rectangle(0, 0, 2, 3) }, 6, count);
  }
}

TEST(PolyhedralSurface, IdenticalPolygonsMakeAPrism)
{
  for (const int corners : { 3, 5, 24, 100 })
  {
    SCOPED_TRACE(std::to_string(corners) + " corners");
    for (const int count : { 2, 3, 50 })
    {
      ExpectPrism({ RegularPolygon(corners, 3) }, AreaOfRegularPolygon(corners, 3), count);
    }
  }
}

TEST(PolyhedralSurface, ARegularPolygonOnAllLevelsHasPlaneSides)
{
  const PolyhedralSurface surface =
    BuildSurface(BuildStack(RingStack(4, { RegularPolygon(12, 1) })));
  EXPECT_EQ(surface.Mesh.Points.size(), 48u);
  EXPECT_EQ(CountFaces(surface, PolyhedralSurface::Cap), 2 * 10);
  EXPECT_EQ(CountFaces(surface, PolyhedralSurface::Wall), 3 * 24);
}

TEST(PolyhedralSurface, IdenticalPixelContoursMakeAPrism)
{
  const Ring disc = PixelDisc(7, 1);
  double twice = 0;
  for (std::size_t i = 0; i < disc.size(); ++i)
  {
    const Point2 &p = disc[i], &q = disc[(i + 1) % disc.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  for (const int count : { 2, 3, 50 })
  {
    ExpectPrism({ disc }, twice / 2, count);
  }
}

TEST(PolyhedralSurface, IdenticalRingsWithIslandsMakePipes)
{
  const std::vector<Ring> level{ Rectangle(0, 0, 6, 6), Rectangle(1, 1, 5, 5),
    Rectangle(2, 2, 4, 4) };
  for (const int count : { 2, 3, 50 })
  {
    ExpectPrism(level, 36 - 16 + 4, count);
  }
}

TEST(PolyhedralSurface, PixelContourShiftedByOnePixel)
{
  for (const double step : { 1.0, 0.2 })
  {
    SCOPED_TRACE(step);
    ExpectSound(BuildStack({ { PixelDisc(8, step) }, { PixelDisc(8, step, { step, 0 }) },
      { PixelDisc(8, step, { step, step }) }, { PixelDisc(8, step) } }));
  }
}

TEST(PolyhedralSurface, SquaresRotatedByFortyFiveDegreesMakeAnAntiprism)
{
  // The same circumradius: the hull of both, whose section halfway is a regular octagon.
  const Ring square{ { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };
  const double r = std::sqrt(2.0);
  const Ring diamond{ { r, 0 }, { 0, r }, { -r, 0 }, { 0, -r } };
  const PolyhedralSurface surface = ExpectSound(BuildStack({ { square }, { diamond } }));
  // Prismatoid: (4 + 4 M + 4) / 6, with the octagon's M = (4 + 4 + 2 * mixed) / 4 and mixed area
  // = support of the square times edges of the diamond / 2 = 4 * 2 * sqrt(2) / 2.
  const double middle = (4 + 4 + 2 * 4 * std::sqrt(2.0)) / 4;
  EXPECT_NEAR(VolumeOf(surface.Mesh), (4 + 4 * middle + 4) / 6, 1e-12);
  EXPECT_EQ(surface.Mesh.Points.size(), 8u);
  // Many levels, turned each time.
  RingStack stack;
  for (int l = 0; l < 12; ++l)
  {
    stack.push_back({ l % 2 == 0 ? square : diamond });
  }
  EXPECT_NEAR(VolumeOf(ExpectSound(BuildStack(stack)).Mesh), 11 * (4 + 4 * middle + 4) / 6, 1e-11);
}

TEST(PolyhedralSurface, RotatedPolygonsMakeAntiprisms)
{
  // Turned by half a corner: the section halfway has the edges of both, half as long.
  for (const int corners : { 3, 5, 6, 12, 25 })
  {
    SCOPED_TRACE(std::to_string(corners) + " corners");
    const double half = FullTurn / corners / 2;
    const PolyhedralSurface surface = ExpectSound(
      BuildStack({ { RegularPolygon(corners, 1) }, { RegularPolygon(corners, 1, half) } }));
    const double area = AreaOfRegularPolygon(corners, 1);
    // Mixed area of P and its turned copy: perimeter * inradius-like support / 2 with support
    // h(u) = circumradius, as the normals of one are the corners of the other.
    const double perimeter = corners * 2 * std::sin(half);
    const double mixed = perimeter * 1 / 2;
    EXPECT_NEAR(VolumeOf(surface.Mesh), (2 * area + 2 * area + 2 * mixed) / 6, 1e-12);
  }
}

TEST(PolyhedralSurface, FrustaOfScaledPolygonsAreExact)
{
  const PolyhedralSurface surface = ExpectSound(BuildStack(
    { { RegularPolygon(20, 3) }, { RegularPolygon(20, 2) }, { RegularPolygon(20, 2.5) } }));
  const auto frustum = [](double r, double s)
  { return AreaOfRegularPolygon(20, 1) * (r * r + r * s + s * s) / 3; };
  EXPECT_NEAR(VolumeOf(surface.Mesh), frustum(3, 2) + frustum(2, 2.5), 1e-11);
}

namespace
{
ContourSet OneToTwo()
{
  return BuildStack({ { RegularPolygon(40, 4) },
    { RegularPolygon(30, 1.5, 0.1, { -2, 0 }), RegularPolygon(30, 1.5, 0.2, { 2, 0 }) } });
}
}

TEST(PolyhedralSurface, OneToTwoIsOnePiece)
{
  const PolyhedralSurface surface = ExpectSound(OneToTwo());
  EXPECT_EQ(CheckTopology(surface.Mesh).Total.Components, 1);
  PolyhedralOptions options;
  options.InternalPoints = false;
  EXPECT_EQ(CheckTopology(BuildSurface(OneToTwo(), options).Mesh).Total.Euler, 2);
}

// A point of the ridge between the branches that stays in its plane would be a hole through it.
TEST(PolyhedralSurface, OneToTwoHasNoHandle)
{
  EXPECT_EQ(CheckTopology(BuildSurface(OneToTwo()).Mesh).Total.Euler, 2);
}

TEST(PolyhedralSurface, ALobeThatEndsIsRoundedOff)
{
  // A square and a round lobe joined by a bar, twice; above them only the square goes on.
  Ring bars{ { -3, -1 }, { -1, -1 }, { -1, -0.3 } };
  for (int i = -5; i <= 5; ++i)
  {
    const double angle = FullTurn * i / 12;
    bars.push_back({ 5 + std::cos(angle), std::sin(angle) });
  }
  bars.insert(bars.end(), { { -1, 0.3 }, { -1, 1 }, { -3, 1 } });
  const ContourSet contours = BuildStack({ { bars }, { bars }, { Rectangle(-3, -1, -1, 1) } });
  PolyhedralOptions options;
  options.EndCaps = PolyhedralOptions::Tapered;
  const PolyhedralSurface surface = BuildSurface(contours, options);
  ExpectKeepsPromises(surface, contours);
  EXPECT_EQ(CheckTopology(surface.Mesh).Total.Euler, 2);
  double highest = 0;
  for (const Point3& p : surface.Mesh.Points)
  {
    highest = p[0] > 4 ? std::max(highest, p[2]) : highest;
  }
  // Half a slab, as the wall below is upright; a cone to the left square would be below a sixth.
  EXPECT_NEAR(highest, 1.5, 1e-9);
}

TEST(PolyhedralSurface, RingOverRingIsATorus)
{
  const std::vector<Ring> ring{ RegularPolygon(40, 3), RegularPolygon(30, 1.5, 0.1) };
  const PolyhedralSurface surface = ExpectSound(BuildStack({ ring, ring, ring }));
  EXPECT_EQ(CheckTopology(surface.Mesh).Total.Euler, 0);
}

TEST(PolyhedralSurface, HardShapesKeepTheirPromises)
{
  ExpectSound(
    BuildStack({ { Needles(20, 10, 0.5) }, { Needles(17, 9, 1) }, { Needles(20, 10, 3) } }));
  ExpectSound(BuildStack(
    { { SpikedSquare(3, 1e-4) }, { Rectangle(-1, -1, 3, 1) }, { SpikedSquare(5, 1e-2) } }));
  std::vector<Ring> nested;
  for (int i = 0; i < 6; ++i)
  {
    nested.push_back(RegularPolygon(40, 8 - i, 0.01 * i));
  }
  ExpectSound(BuildStack({ nested, { RegularPolygon(30, 8.5) }, nested }));
}

TEST(PolyhedralSurface, NamesAContourThatNothingFaces)
{
  const ContourSet contours = BuildStack({ { Rectangle(0, 0, 1, 1) }, { Rectangle(0, 0, 1, 1) },
    { Rectangle(0, 0, 1, 1), Rectangle(100, 100, 101, 101) }, { Rectangle(0, 0, 1, 1) } });
  const PolyhedralSurface surface = BuildSurface(contours);
  EXPECT_LE(ContoursLeftOut(surface).Wholly.size(), 1u);
  ExpectSound(contours);
}

TEST(PolyhedralSurface, DoesNotDependOnTheThreads)
{
  const ContourSet contours = BuildStack(RandomStack(4));
  PolyhedralOptions options;
  options.Threads = 1;
  const PolyhedralSurface one = BuildSurface(contours, options);
  for (const int threads : { 0, 2, 5 })
  {
    options.Threads = threads;
    ExpectEqualSurfaces(one, BuildSurface(contours, options));
  }
}

TEST(PolyhedralSurface, TiltedPlanes)
{
  // A frame that no coordinate axis fits.
  const Vector3 n{ 2.0 / 7, 3.0 / 7, 6.0 / 7 }, u{ 6.0 / 7, 2.0 / 7, -3.0 / 7 };
  const Vector3 v = Cross(n, u);
  SoupMaker maker;
  for (int l = 0; l < 4; ++l)
  {
    std::vector<Point3> loop;
    for (const Point2& p : RegularPolygon(30, 3 + 0.5 * (l % 2), 0.05 * l))
    {
      loop.push_back(p[0] * u + (p[1] * v + (0.7 * l) * n));
    }
    maker.Chain(loop, true);
  }
  ExpectSound(maker.Build());
}
