// SPDX-License-Identifier: GPL-3.0-or-later
// No edit may let triangles cross: thin places are found, crossings are seen and taken back.
#include "EditedMeshes.h"

#include <gtest/gtest.h>

using namespace recon;

TEST(CrossingGuard, FindsThinPlaces)
{
  // A plate of thickness .5: every point has another sheet near, but for none at .4.
  const edited::Shape plate = edited::Both(edited::Sheet(3, 0.5, true), edited::Sheet(3, 0, false));
  const auto near = ThinPlaces(plate.Mesh.Points, plate.Normals, 0.6);
  EXPECT_EQ(std::count(near.begin(), near.end(), 1), static_cast<long>(near.size()));
  const auto far = ThinPlaces(plate.Mesh.Points, plate.Normals, 0.4);
  EXPECT_EQ(std::count(far.begin(), far.end(), 1), 0);
  // One sheet is none, however dense.
  const edited::Shape one = edited::Sheet(3);
  const auto alone = ThinPlaces(one.Mesh.Points, one.Normals, 5);
  EXPECT_EQ(std::count(alone.begin(), alone.end(), 1), 0);
}

TEST(CrossingGuard, SeesAVertexGoThroughAnotherSheet)
{
  edited::Shape plate = edited::Both(edited::Sheet(3, 0.5, true), edited::Sheet(3, 0, false));
  EditableMesh mesh(plate.Mesh, plate.Normals);
  const std::vector<char> thin(plate.Mesh.Points.size(), 1);
  CrossingGuard guard(plate.Mesh, mesh, thin, 2);
  const int inner = 5; // not on the border of the upper sheet
  ASSERT_FALSE(mesh.Border[inner]);
  for (const int t : mesh.Around[inner])
  {
    EXPECT_FALSE(guard.Crosses(t));
  }
  mesh.MoveTo(inner, { 1.2, 1.3, -0.4 });
  bool crosses = false;
  for (const int t : mesh.Around[inner])
  {
    crosses = crosses || guard.Crosses(t);
  }
  EXPECT_TRUE(crosses);
}

TEST(CrossingGuard, TakesACrossingChangeBack)
{
  edited::Shape plate = edited::Both(edited::Sheet(3, 0.5, true), edited::Sheet(3, 0, false));
  plate.Add({ 1.4, 1.6, -3 }, { 0, 0, 1 }); // of no triangle
  const int below = static_cast<int>(plate.Mesh.Points.size()) - 1;
  const std::vector<std::array<int, 3>> before = plate.Mesh.Triangles;
  EditableMesh mesh(plate.Mesh, plate.Normals);
  const std::vector<char> thin(plate.Mesh.Points.size(), 0);
  CrossingGuard guard(plate.Mesh, mesh, thin, 2);
  const EditableMesh::Changes harmless = mesh.Remember({ 8 });
  EXPECT_FALSE(guard.AnyThin(harmless));
  mesh.Replace(8, before[8]);
  EXPECT_TRUE(guard.KeepUncrossed(harmless));
  // A triangle from the upper sheet through the lower one.
  const EditableMesh::Changes changes = mesh.Remember({ 8 });
  mesh.Replace(8, { 5, 6, below });
  EXPECT_FALSE(guard.KeepUncrossed(changes));
  EXPECT_TRUE(plate.Mesh.Triangles == before);
}

TEST(CrossingGuard, MarksTheSurroundingsOfCrossings)
{
  // Two squares that cross along a line; a third one far away.
  edited::Shape crossed = edited::Both(edited::Sheet(1), edited::Sheet(1, 50));
  crossed.Add({ 0.3, 0.3, -1 }, { 0, 0, 1 });
  crossed.Add({ 0.3, 0.3, 1 }, { 0, 0, 1 });
  crossed.Add({ 0.9, 0.8, 1 }, { 0, 0, 1 });
  crossed.Mesh.Triangles.push_back({ 8, 9, 10 });
  std::vector<char> thin(crossed.Mesh.Points.size(), 0);
  Monitor monitor;
  EXPECT_GT(MarkCrossings(crossed.Mesh, crossed.Mesh.Points, 3, 1, monitor, thin), 0);
  EXPECT_TRUE(thin[0] && thin[1] && thin[8]);
  EXPECT_FALSE(thin[4] || thin[7]);
  std::vector<char> none(8, 0);
  const edited::Shape apart = edited::Both(edited::Sheet(1), edited::Sheet(1, 50));
  EXPECT_EQ(MarkCrossings(apart.Mesh, apart.Mesh.Points, 3, 1, monitor, none), 0);
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
}
