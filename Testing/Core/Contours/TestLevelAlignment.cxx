// SPDX-License-Identifier: GPL-3.0-or-later
// Oblique shapes, whose sections lie beside one another: levels shifted onto each other and back.
#include "Contours/LevelAlignment.h"
#include "Core/Polyhedral/PolyhedralShapes.h"
#include "Core/Polyhedral/SurfaceInvariants.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
/// `count` discs of radius 1, each shifted by `lean` against the one below it, a unit apart.
ContourSet ObliqueTube(int count, double lean, int corners = 48)
{
  RingStack levels;
  for (int i = 0; i < count; ++i)
  {
    levels.push_back({ RegularPolygon(corners, 1, 0, { lean * i, 0.3 * lean * i }) });
  }
  return BuildStack(levels);
}

double AreaOfDisc(int corners = 48)
{
  return 0.5 * corners * std::sin(FullTurn / corners);
}

PolyhedralSurface Build(const ContourSet& contours, LevelAlignmentMode mode)
{
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.AlignLevels = mode;
  return BuildSurface(contours, options);
}
}

TEST(LevelAlignment, ThinTubeIsAnObliqueCylinder)
{
  // By Cavalieri the volume is that of the upright one, to rounding, whatever the lean.
  for (double lean : { 0.8, 0.95 })
  {
    const ContourSet contours = ObliqueTube(9, lean);
    const PolyhedralSurface surface = Build(contours, LevelAlignmentMode::Automatic);
    ExpectKeepsPromises(surface, contours);
    EXPECT_NEAR(VolumeOf(surface.Mesh), 8 * AreaOfDisc(), 1e-9);
    ASSERT_EQ(surface.Report.size(), 1u);
    EXPECT_NE(surface.Report[0].find("shifted onto one another"), std::string::npos);
  }
}

TEST(LevelAlignment, SteepSectionsAreLeftAloneUnasked)
{
  const ContourSet contours = ObliqueTube(5, 3);
  const LevelAlignment none = FindLevelAlignment(contours, LevelAlignmentMode::Automatic, {});
  EXPECT_TRUE(none.IsEmpty());
  ASSERT_EQ(none.Report.size(), 1u);
  EXPECT_NE(none.Report[0].find("Align Levels to On"), std::string::npos);
  const PolyhedralSurface surface = Build(contours, LevelAlignmentMode::On);
  ExpectKeepsPromises(surface, contours);
  EXPECT_NEAR(VolumeOf(surface.Mesh), 4 * AreaOfDisc(), 1e-9);
}

TEST(LevelAlignment, UprightShapesStayAsTheyAre)
{
  const ContourSet contours = ObliqueTube(6, 0.05);
  const LevelAlignment none = FindLevelAlignment(contours, LevelAlignmentMode::Automatic, {});
  EXPECT_TRUE(none.IsEmpty());
  EXPECT_TRUE(none.Report.empty());
  ExpectEqualSurfaces(
    Build(contours, LevelAlignmentMode::Automatic), Build(contours, LevelAlignmentMode::Off));
}

TEST(LevelAlignment, LevelsOfSeveralContoursStayAsTheyAre)
{
  RingStack levels;
  for (int i = 0; i < 4; ++i)
  {
    levels.push_back(
      { RegularPolygon(24, 1, 0, { 0.9 * i, 0 }), RegularPolygon(24, 1, 0, { 0.9 * i, 5 }) });
  }
  const ContourSet contours = BuildStack(levels);
  EXPECT_TRUE(FindLevelAlignment(contours, LevelAlignmentMode::On, {}).IsEmpty());
}

TEST(LevelAlignment, ForcedJoinWithoutOverlapIsMade)
{
  const ContourSet contours = ObliqueTube(2, 5);
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.ForcedJoins = { { 1, 0 } };
  const PolyhedralSurface surface = BuildSurface(contours, options);
  ExpectKeepsPromises(surface, contours);
  EXPECT_NEAR(VolumeOf(surface.Mesh), AreaOfDisc(), 1e-9);
}

TEST(LevelAlignment, HolesAndEndsShiftAlong)
{
  RingStack levels;
  for (int i = 0; i < 6; ++i)
  {
    Ring hole = RegularPolygon(16, 0.5, 0, { 0.9 * i, 0 });
    levels.push_back({ RegularPolygon(48, 1, 0, { 0.9 * i, 0 }), hole });
  }
  const ContourSet contours = BuildStack(levels);
  for (auto caps :
    { PolyhedralOptions::Flat, PolyhedralOptions::HalfSlice, PolyhedralOptions::Tapered })
  {
    PolyhedralOptions options;
    options.Mapping = PolyhedralOptions::Overlap;
    options.AlignLevels = LevelAlignmentMode::Automatic;
    options.EndCaps = caps;
    const PolyhedralSurface surface = BuildSurface(contours, options);
    ExpectKeepsPromises(surface, contours);
    const double area = AreaOfDisc() - 0.25 * AreaOfDisc(16);
    const double length = caps == PolyhedralOptions::HalfSlice ? 6 : 5;
    if (caps != PolyhedralOptions::Tapered)
    {
      EXPECT_NEAR(VolumeOf(surface.Mesh), length * area, 1e-9);
    }
  }
}

TEST(LevelAlignment, UndoneIsWhereItWas)
{
  const ContourSet contours = ObliqueTube(4, 0.9);
  const LevelAlignment alignment = FindLevelAlignment(contours, LevelAlignmentMode::Automatic, {});
  ASSERT_FALSE(alignment.IsEmpty());
  const ContourSet shifted = Aligned(contours, alignment);
  for (const Contour& contour : contours.Contours)
  {
    for (int p : contour.Points)
    {
      const Point2 back = alignment.Undo(shifted.Planar[p], contours.Levels[contour.Level].Offset);
      EXPECT_NEAR(back[0], contours.Planar[p][0], 1e-12);
      EXPECT_NEAR(back[1], contours.Planar[p][1], 1e-12);
    }
  }
  // Half way up a slab, half of the shear.
  const Point2 low = alignment.Undo({ 0, 0 }, 1);
  const Point2 high = alignment.Undo({ 0, 0 }, 2);
  EXPECT_NEAR(alignment.Undo({ 0, 0 }, 1.5)[0], 0.5 * (low[0] + high[0]), 1e-12);
}

TEST(LevelAlignment, ForcedJoinBesideOthersDoesNotPartThem)
{
  RingStack levels;
  for (int i = 0; i < 2; ++i)
  {
    levels.push_back({ RegularPolygon(24, 1, 0, { 0, 0 }), RegularPolygon(24, 1, 0, { 5, 0 }) });
  }
  const ContourSet contours = BuildStack(levels);
  EXPECT_TRUE(FindLevelAlignment(contours, LevelAlignmentMode::Off, { { 0, 3 } }).IsEmpty());
}
