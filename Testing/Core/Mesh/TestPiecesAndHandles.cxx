// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/PiecesAndHandles.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
void ExpectCount(const TriangleMesh& mesh, int pieces, int handles)
{
  const PiecesAndHandles count = CountPiecesAndHandles(mesh);
  EXPECT_EQ(count.Pieces, pieces);
  EXPECT_EQ(count.Handles, handles);
}
}

TEST(PiecesAndHandles, OfShapesWhoseGenusIsKnown)
{
  ExpectCount(MakeCube(), 1, 0);
  ExpectCount(MakeTorus(2, 0.5), 1, 1);
  ExpectCount(MakeRingChain(3), 1, 3);
  ExpectCount(MakeSponge(2), 1, 3 * 2 * 9 - 27 + 1);
  ExpectCount(MakeLinkedTori(), 2, 2);
}

TEST(PiecesAndHandles, TheWallOfACavityIsAPiece)
{
  TriangleMesh box = MakeBox({ 0, 0, 0 }, { 3, 3, 3 });
  TriangleMesh cavity = MakeBox({ 1, 1, 1 }, { 2, 2, 2 });
  TurnInsideOut(cavity);
  Append(box, cavity);
  ExpectCount(box, 2, 0);
}

TEST(PiecesAndHandles, PointsThatNoTriangleUsesDoNotCount)
{
  TriangleMesh cube = MakeCube();
  cube.Points.push_back({ 9, 9, 9 });
  ExpectCount(cube, 1, 0);
  ExpectCount({}, 0, 0);
}
