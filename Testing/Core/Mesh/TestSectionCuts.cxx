// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/PiecesAndHandles.h"
#include "Mesh/SectionCuts.h"
#include "MeshInvariants.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Cuts and checks: `left` handles remain, in as many pieces as before, and the surface is sound.
SectionCuts ExpectCut(TriangleMesh mesh, const Vector3& normal, const std::vector<double>& offsets,
  int handles, int left)
{
  const TriangleMesh before = mesh;
  const PiecesAndHandles count = CountPiecesAndHandles(mesh);
  Monitor monitor;
  SectionCuts cuts = CutHandles(mesh, PlanarFrame::About(normal), offsets, handles, monitor);
  EXPECT_EQ(CountPiecesAndHandles(mesh).Pieces, count.Pieces);
  EXPECT_EQ(CountPiecesAndHandles(mesh).Handles, left);
  EXPECT_EQ(cuts.PartOf.size(), mesh.Triangles.size());
  EXPECT_TRUE(std::equal(before.Points.begin(), before.Points.end(), mesh.Points.begin()));
  ExpectSoundSurface(mesh);
  return cuts;
}
}

TEST(SectionCuts, AnUprightRingIsParted)
{
  const SectionCuts cuts = ExpectCut(MakeTorus(2, 0.5), { 1, 0, 0 }, { -2.5, 2.5 }, 1, 0);
  ASSERT_EQ(cuts.Cuts.size(), 1U);
  EXPECT_TRUE(cuts.Cuts[0].Solid);
  EXPECT_EQ(cuts.Cuts[0].Slab, 0);
}

TEST(SectionCuts, TheHoleOfALyingRingIsFilled)
{
  const SectionCuts cuts = ExpectCut(MakeTorus(2, 0.5), { 0, 0, 1 }, { -0.5, 0, 0.5 }, 1, 0);
  ASSERT_EQ(cuts.Cuts.size(), 1U);
  EXPECT_FALSE(cuts.Cuts[0].Solid);
}

TEST(SectionCuts, TheSmallestDiscsComeFirst)
{
  // Two bars of 1 x 1 and one of 3 x 1 between two plates: two handles.
  const TriangleMesh bench = MakeFromCells(
    { 9, 1, 3 }, [](int x, int, int z) { return z != 1 || x == 0 || x == 2 || (x > 3 && x < 7); });
  ExpectCut(bench, { 0, 0, 1 }, { 1, 2 }, 0, 2);
  const SectionCuts one = ExpectCut(bench, { 0, 0, 1 }, { 1, 2 }, 1, 1);
  ASSERT_EQ(one.Cuts.size(), 1U);
  EXPECT_NEAR(one.Cuts[0].Area, 1, 1e-12);
  const SectionCuts all = ExpectCut(bench, { 0, 0, 1 }, { 1, 2 }, 9, 0);
  EXPECT_EQ(all.Cuts.size(), 2U); // the third holds it together
}

TEST(SectionCuts, AChainOfRingsLosesAsManyHandlesAsAskedFor)
{
  for (const int handles : { 1, 2, 5 })
  {
    ExpectCut(MakeRingChain(5), { 0, 0, 1 }, { 0, 1 }, handles, 5 - handles);
    ExpectCut(MakeRingChain(5), { 0, 1, 0 }, { 1, 2 }, handles, 5 - handles);
  }
}

TEST(SectionCuts, AScaffoldLosesAllItsHandles)
{
  const TriangleMesh sponge = MakeSponge(2);
  const int handles = CountPiecesAndHandles(sponge).Handles;
  ExpectCut(sponge, { 0, 0, 1 }, { 0, 1, 2, 3, 4, 5 }, handles, 0);
}

TEST(SectionCuts, AThinHandleBetweenTwoHeightsIsFound)
{
  // The tube's hole is lower than an eighth of the slab, and between the middles of two of those.
  ExpectCut(MakeTorus(2, 0.05), { 0, 0, 1 }, { -0.85, 1.05 }, 1, 0);
}

namespace
{
/// Two bars between two plates; each has a hole through its middle, closed at the one plate.
TriangleMesh MakeHollowBars(bool opensAbove)
{
  return MakeFromCells({ 8, 3, 3 },
    [=](int x, int y, int z)
    {
      const bool isBar = x < 3 || x > 4;
      const bool isMiddle = (x == 1 || x == 6) && y == 1;
      return isMiddle ? z == (opensAbove ? 0 : 2) : z != 1 || isBar;
    });
}
}

TEST(SectionCuts, ARingIsPartedWithWhatHangsInIt)
{
  for (const bool opensAbove : { true, false })
  {
    const SectionCuts cuts = ExpectCut(MakeHollowBars(opensAbove), { 0, 0, 1 }, { 1, 2 }, 1, 0);
    ASSERT_EQ(cuts.Cuts.size(), 1U);
    EXPECT_TRUE(cuts.Cuts[0].Solid);
  }
}

TEST(SectionCuts, AHoleIsFilledAroundWhatStandsInIt)
{
  // A frame on a plate with a hole, in which a pillar hangs from a bar across the frame.
  for (const int foot : { 0, 1 })
  {
    const TriangleMesh mesh = MakeFromCells({ 5, 5, 3 },
      [=](int x, int y, int z)
      {
        const bool isFrame = x == 0 || y == 0 || x == 4 || y == 4;
        const bool isPillar = x == 2 && y == 2;
        return isFrame || (isPillar && z >= foot) || (y == 2 && z == 2);
      });
    const int handles = CountPiecesAndHandles(mesh).Handles;
    ASSERT_EQ(handles, 2);
    ExpectCut(mesh, { 0, 0, 1 }, { 1, 2 }, 1, 1);
  }
}

TEST(SectionCuts, AHandleAllAtOneHeightIsCutByATiltedPlane)
{
  // Two bars across two others: each section along the levels is of two bars, and parts their ends.
  const TriangleMesh pile = MakeFromCells(
    { 5, 5, 2 }, [](int x, int y, int z) { return z == 0 ? x == 1 || x == 3 : y == 1 || y == 3; });
  ASSERT_EQ(CountPiecesAndHandles(pile).Handles, 1);
  ExpectCut(pile, { 0, 0, 1 }, { -0.5, 2.5 }, 1, 0);
  ExpectCut(pile, { 0, 0, 1 }, { 0, 1, 2 }, 1, 1); // drawn on three levels, it is left as it is
}

TEST(SectionCuts, WhatHasNoHandleStays)
{
  ExpectCut(MakeCube(), { 0, 0, 1 }, { 0, 1 }, 3, 0);
}
