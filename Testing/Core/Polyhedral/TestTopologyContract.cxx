// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces and handles that are asked for, on stacks whose own are plain to see.
#include "Mesh/PiecesAndHandles.h"
#include "NodeDefaults.h"
#include "Polyhedral/ContractMapping.h"
#include "Polyhedral/TopologyContract.h"
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
/// A rectangle with a point every fourth of a unit: branches of four points can be lost.
Ring Slat(double x0, double x1, double y0 = 0, double y1 = 1)
{
  const Ring corners{ { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
  Ring ring;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Point2& a = corners[k];
    const Point2& b = corners[(k + 1) % 4];
    const int count = static_cast<int>(std::lround(4 * std::hypot(b[0] - a[0], b[1] - a[1])));
    for (int i = 0; i < count; ++i)
    {
      const double share = static_cast<double>(i) / count;
      ring.push_back({ a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]) });
    }
  }
  return ring;
}

PolyhedralOptions Asking(int pieces, int handles)
{
  PolyhedralOptions options = NodeOptions();
  options.ExpectedPieces = pieces;
  options.ExpectedHandles = handles;
  return options;
}

void ExpectCount(const PolyhedralSurface& surface, int pieces, int handles)
{
  const PiecesAndHandles count = CountPiecesAndHandles(surface.Mesh);
  EXPECT_EQ(count.Pieces, pieces);
  EXPECT_EQ(count.Handles, handles);
}

/// Untold, then told.
PolyhedralSurface ExpectMet(
  const ContourSet& contours, const PiecesAndHandles& untold, const PiecesAndHandles& told)
{
  ExpectCount(BuildSurface(contours, Asking(-1, -1)), untold.Pieces, untold.Handles);
  PolyhedralSurface surface = BuildSurface(contours, Asking(told.Pieces, told.Handles));
  ExpectCount(surface, told.Pieces, told.Handles);
  ExpectKeepsPromises(surface, contours);
  EXPECT_FALSE(surface.Contract.empty());
  EXPECT_EQ(surface.Report.back().find("not what was asked for"), std::string::npos)
    << surface.Report.back();
  return surface;
}

/// A bar, two or three pillars on it, and a bar on these: handles between the pillars.
ContourSet Table(int pillars)
{
  const Ring bar = Slat(0, 10);
  std::vector<Ring> feet{ Slat(0, 2), Slat(8, 10) };
  if (pillars > 2)
  {
    feet.push_back(Slat(4.5, 5.5));
  }
  return BuildStack({ { bar }, feet, feet, { bar } });
}

Ring Round(double x, double y = 0)
{
  return RegularPolygon(20, 1, 0.1, { x, y });
}

/// Two towers, the upper one beside the lower one.
ContourSet StepAside(double gap)
{
  return BuildStack(
    { { Round(0) }, { Round(0) }, { Round(2 + gap, 0.3) }, { Round(2 + gap, 0.3) } });
}
}

TEST(TopologyContract, WhatIsBesideIsJoinedToOnePiece)
{
  const PolyhedralSurface surface = ExpectMet(StepAside(0.5), { 2, 0 }, { 1, 0 });
  ASSERT_EQ(surface.Contract.size(), 1U);
  EXPECT_EQ(surface.Contract[0].Kind, ContractDecision::Join);
  EXPECT_EQ(surface.Contract[0].Slab, 1);
  EXPECT_NEAR(surface.Contract[0].Cost, std::hypot(2.5, 0.3) - 2, 0.1);
}

TEST(TopologyContract, TheNearestAreJoined)
{
  const std::vector<Ring> below{ Round(0), Round(6) };
  const std::vector<Ring> above{ Round(2.6, 0.2) }; // .6 from the left, 1.4 from the right
  const ContourSet contours = BuildStack({ below, below, above, above });
  const PolyhedralSurface two = ExpectMet(contours, { 3, 0 }, { 2, 0 });
  ASSERT_EQ(two.Contract.size(), 1U);
  EXPECT_NEAR(two.Contract[0].Cost, 0.6, 0.1);
  const PolyhedralSurface one = ExpectMet(contours, { 3, 0 }, { 1, 0 });
  EXPECT_EQ(one.Contract.size(), 2U);
}

TEST(TopologyContract, TrousersArePartedWhereTheyOverlapLeast)
{
  const std::vector<Ring> legs{ Slat(0, 3), Slat(4, 6) };
  const Ring waist = Slat(0, 5); // all of the one leg, half of the other
  const PolyhedralSurface surface =
    ExpectMet(BuildStack({ legs, legs, { waist }, { waist } }), { 1, 0 }, { 2, 0 });
  ASSERT_EQ(surface.Contract.size(), 1U);
  EXPECT_EQ(surface.Contract[0].Kind, ContractDecision::Part);
  EXPECT_NEAR(surface.Contract[0].Cost, 0.5, 1e-9);
}

TEST(TopologyContract, TheThinnestPillarGoes)
{
  const PolyhedralSurface surface = ExpectMet(Table(3), { 1, 2 }, { 1, 1 });
  ASSERT_EQ(surface.Contract.size(), 1U);
  EXPECT_EQ(surface.Contract[0].Kind, ContractDecision::Cut);
  EXPECT_LT(surface.Contract[0].Cost, 1.5); // of the pillar of area 1, not of those of 2
  ExpectMet(Table(3), { 1, 2 }, { 1, 0 });
}

TEST(TopologyContract, AHoleThroughASolidIsFilled)
{
  const std::vector<Ring> ring{ Slat(0, 6, 0, 6), Slat(2, 4, 2, 4) };
  const PolyhedralSurface surface = ExpectMet(BuildStack({ ring, ring, ring }), { 1, 1 }, { 1, 0 });
  ASSERT_EQ(surface.Contract.size(), 1U);
  EXPECT_EQ(surface.Contract[0].Kind, ContractDecision::Fill);
}

TEST(TopologyContract, AHandleIsMadeWhereContoursAreNextToOverlap)
{
  // The right pillar ends just beside the upper bar.
  const std::vector<Ring> feet{ Round(0), Round(6) };
  const std::vector<Ring> above{ Slat(-1, 4.8, -1, 1) };
  const PolyhedralSurface surface =
    ExpectMet(BuildStack({ { Slat(-1, 7, -1, 1) }, feet, above, above }), { 1, 0 }, { 1, 1 });
  ASSERT_EQ(surface.Contract.size(), 1U);
  EXPECT_EQ(surface.Contract[0].Kind, ContractDecision::Join);
}

TEST(TopologyContract, WhatIsThereAlreadyChangesNothing)
{
  const ContourSet contours = Table(2);
  const PolyhedralSurface free = BuildSurface(contours, Asking(-1, -1));
  PolyhedralSurface told = BuildSurface(contours, Asking(1, 1));
  EXPECT_TRUE(told.Contract.empty());
  ASSERT_EQ(told.Report.size(), free.Report.size() + 1);
  told.Report.pop_back();
  ExpectEqualSurfaces(free, told);
}

TEST(TopologyContract, WhatCannotBeMetIsSaid)
{
  const PolyhedralSurface surface =
    BuildSurface(BuildStack({ { Slat(0, 1) }, { Slat(0, 1) } }), Asking(5, -1));
  EXPECT_NE(surface.Report.back().find("ExpectedPieces is 5"), std::string::npos);
  EXPECT_NE(surface.Report.back().find("not what was asked for"), std::string::npos);
  EXPECT_LT(CountPiecesAndHandles(surface.Mesh).Pieces, 5);
}

TEST(TopologyContract, AnOpenSurfaceHasNone)
{
  PolyhedralOptions options = Asking(2, 0);
  options.EndCaps = PolyhedralOptions::NoCaps;
  const PolyhedralSurface surface = BuildSurface(Table(2), options);
  EXPECT_NE(surface.Report.back().find("EndCaps is None"), std::string::npos);
}

TEST(TopologyContract, AnyNumberOfThreadsMakesTheSame)
{
  const ContourSet contours = Table(3);
  PolyhedralOptions one = Asking(1, 0);
  PolyhedralOptions four = one;
  one.Threads = 1;
  four.Threads = 4;
  ExpectEqualSurfaces(BuildSurface(contours, one), BuildSurface(contours, four));
}

TEST(TopologyContract, NumbersThatCannotBeAreRefused)
{
  EXPECT_THROW(BuildSurface(Table(2), Asking(0, -1)), Error);
  EXPECT_THROW(BuildSurface(Table(2), Asking(-2, -1)), Error);
  EXPECT_THROW(BuildSurface(Table(2), Asking(-1, -2)), Error);
}

TEST(ContractMapping, HasRowsOfThatRule)
{
  Monitor monitor;
  const ContractMapping joined =
    MapByContract(StepAside(0.5), {}, LevelAlignmentMode::Off, { 1, -1 }, monitor);
  const auto isByContract = [](const ContourJoin& join)
  { return join.Rule == ContourJoin::ByContract; };
  const auto& joins = joined.Mapping.Joins;
  const auto join = std::find_if(joins.begin(), joins.end(), isByContract);
  ASSERT_NE(join, joins.end());
  EXPECT_TRUE(join->Joined);
  EXPECT_NE(join->Words.find("expected pieces and handles"), std::string::npos);

  const ContractMapping cut =
    MapByContract(Table(3), {}, LevelAlignmentMode::Off, { 1, 1 }, monitor);
  EXPECT_EQ(cut.WithCuts.Joins.size(), cut.Mapping.Joins.size() + 1);
  EXPECT_TRUE(isByContract(cut.WithCuts.Joins.back()));

  const ContractMapping free = MapByContract(Table(3), {}, LevelAlignmentMode::Off, {}, monitor);
  EXPECT_EQ(free.WithCuts.Joins.size(), free.Mapping.Joins.size());
}
