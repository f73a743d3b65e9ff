// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/PiecesAndHandles.h"
#include "Mesh/SheetLinks.h"
#include "MeshInvariants.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
const PlanarFrame Upright = PlanarFrame::About({ 0, 0, 1 });

TriangleMesh Boxes(double gap)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 1 + gap, 0, 0 }, { 2 + gap, 1, 1 }));
  return mesh;
}

SheetLinks ExpectLinked(
  TriangleMesh mesh, const LinksWanted& wanted, const PiecesAndHandles& result)
{
  const TriangleMesh before = mesh;
  Monitor monitor;
  SheetLinks links = LinkSheets(mesh, Upright, { 0, 1 }, wanted, monitor);
  EXPECT_EQ(CountPiecesAndHandles(mesh).Pieces, result.Pieces);
  EXPECT_EQ(CountPiecesAndHandles(mesh).Handles, result.Handles);
  EXPECT_EQ(links.PartOf.size(), mesh.Triangles.size());
  EXPECT_TRUE(std::equal(before.Points.begin(), before.Points.end(), mesh.Points.begin()));
  ExpectSoundSurface(mesh);
  return links;
}
}

TEST(SheetLinks, TwoBoxesBecomeOne)
{
  const SheetLinks links = ExpectLinked(Boxes(0.5), { 1, 0 }, { 1, 0 });
  ASSERT_EQ(links.Links.size(), 1U);
  EXPECT_FALSE(links.Links[0].ThroughSolid);
  EXPECT_LT(Norm(links.Links[0].To - links.Links[0].From), 1);
}

TEST(SheetLinks, ACavityIsOpenedThroughTheSolid)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  TriangleMesh cavity = MakeBox({ 0.25, 0.25, 0.25 }, { 0.75, 0.75, 0.75 });
  TurnInsideOut(cavity);
  Append(mesh, cavity);
  const SheetLinks links = ExpectLinked(mesh, { 1, 0 }, { 1, 0 });
  ASSERT_EQ(links.Links.size(), 1U);
  EXPECT_TRUE(links.Links[0].ThroughSolid);
}

TEST(SheetLinks, OfThreeInARowEachIsJoinedToTheNext)
{
  TriangleMesh mesh = Boxes(0.5);
  Append(mesh, MakeBox({ 3, 0, 0 }, { 4, 1, 1 }));
  for (const SheetLink& link : ExpectLinked(mesh, { 2, 0 }, { 1, 0 }).Links)
  {
    EXPECT_LT(Norm(link.To - link.From), 1);
  }
}

TEST(SheetLinks, NothingIsMadeWhereNothingIsWanted)
{
  EXPECT_TRUE(ExpectLinked(Boxes(0.5), { 0, 0 }, { 2, 0 }).Links.empty());
}

TEST(SheetLinks, OfOnePieceThereIsNone)
{
  EXPECT_TRUE(ExpectLinked(MakeCube(), { 1, 1 }, { 1, 0 }).Links.empty());
}
