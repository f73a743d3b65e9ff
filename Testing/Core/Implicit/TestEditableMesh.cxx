// SPDX-License-Identifier: GPL-3.0-or-later
// Edits in place: who is next to whom, what may merge, what is put back, who is told.
#include "Core/Mesh/MeshInvariants.h"
#include "EditedMeshes.h"

#include <set>

using namespace recon;
using namespace recon::testing;

TEST(EditableMesh, KnowsNeighboursAndBorder)
{
  edited::Shape sheet = edited::Sheet(2); // points 0 1 2 / 3 4 5 / 6 7 8
  const EditableMesh mesh(sheet.Mesh, sheet.Normals);
  EXPECT_EQ(mesh.Neighbours(4), (std::vector<int>{ 0, 1, 3, 5, 7, 8 }));
  EXPECT_EQ(mesh.TrianglesAt(0, 4).size(), 2u);
  EXPECT_EQ(mesh.TrianglesAt(0, 1).size(), 1u);
  EXPECT_TRUE(mesh.TrianglesAt(0, 8).empty());
  for (int v = 0; v < 9; ++v)
  {
    EXPECT_EQ(mesh.Border[v], v == 4 ? 0 : 1) << v;
  }
}

TEST(EditableMesh, ListsShortEdgesShortestFirst)
{
  edited::Shape sheet = edited::Sheet(1);
  sheet.Mesh.Points[1][0] = 0.5;
  const EditableMesh mesh(sheet.Mesh, sheet.Normals);
  const auto edges = mesh.EdgesShorterThan(1.1);
  ASSERT_EQ(edges.size(), 3u); // 0-1 of .5, 0-2 and 2-3 of 1; 1-3 is longer
  EXPECT_EQ(edges.front(), std::make_pair(0, 1));
}

TEST(EditableMesh, MeasuresTriangles)
{
  edited::Shape sheet = edited::Sheet(1);
  const EditableMesh mesh(sheet.Mesh, sheet.Normals);
  EXPECT_NEAR(mesh.AngleOf(mesh.T[0]), std::atan(1.0), 1e-15);
  EXPECT_DOUBLE_EQ(mesh.LongestEdge(mesh.T[0]), std::sqrt(2.0));
  EXPECT_EQ(mesh.AreaNormal(mesh.T[0]), (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(EditableMesh::Third({ 4, 7, 9 }, 9, 4), 7);
  EXPECT_TRUE(EditableMesh::Follows({ 4, 7, 9 }, 9, 4));
  EXPECT_FALSE(EditableMesh::Follows({ 4, 7, 9 }, 4, 9));
}

TEST(EditableMesh, MergesOnlyWhereTheLinkAllows)
{
  // A prism closed by two triangles: its waist edges may not go, as it would become flat.
  edited::Shape ball = edited::Ball(2, 3);
  EditableMesh mesh(ball.Mesh, ball.Normals);
  EXPECT_FALSE(mesh.LinkAllows(1, 2)); // round the waist, where the ring is a triangle
  ASSERT_TRUE(mesh.LinkAllows(0, 1));  // the pole goes into the ring
  mesh.Merge(0, 1);
  mesh.Compact();
  ExpectClosed(ball.Mesh);
  ExpectManifold(ball.Mesh);
  EXPECT_EQ(ball.Mesh.Points.size(), 7u);
  EXPECT_EQ(ball.Mesh.Triangles.size(), 10u);
  EXPECT_EQ(ball.Normals.size(), ball.Mesh.Points.size());
}

TEST(EditableMesh, KeepsTheBorderFromBeingPinched)
{
  edited::Shape strip = edited::Sheet(1);
  const EditableMesh mesh(strip.Mesh, strip.Normals);
  EXPECT_FALSE(mesh.LinkAllows(0, 3)); // the diagonal, between two border points
}

TEST(EditableMesh, PutsBackWhatItRemembers)
{
  edited::Shape ball = edited::Ball(4, 8);
  const TriangleMesh before = ball.Mesh;
  EditableMesh mesh(ball.Mesh, ball.Normals);
  const auto around = mesh.Around;
  const EditableMesh::Changes changes = mesh.Remember(mesh.Around[5]);
  mesh.Merge(5, mesh.Neighbours(5).front());
  EXPECT_FALSE(ball.Mesh.Triangles == before.Triangles);
  mesh.Restore(changes);
  EXPECT_TRUE(ball.Mesh.Triangles == before.Triangles);
  for (std::size_t v = 0; v < around.size(); ++v)
  {
    EXPECT_EQ(std::set<int>(around[v].begin(), around[v].end()),
      std::set<int>(mesh.Around[v].begin(), mesh.Around[v].end()));
  }
}

TEST(EditableMesh, TellsOfEveryChange)
{
  edited::Shape ball = edited::Ball(4, 8);
  EditableMesh mesh(ball.Mesh, ball.Normals);
  std::set<int> told;
  mesh.Changed = [&told](int t) { told.insert(t); };
  mesh.MoveTo(7, { 0, 0, 0 });
  EXPECT_EQ(told, std::set<int>(mesh.Around[7].begin(), mesh.Around[7].end()));
  told.clear();
  mesh.Replace(3, mesh.T[3]);
  EXPECT_EQ(told, std::set<int>{ 3 });
}
