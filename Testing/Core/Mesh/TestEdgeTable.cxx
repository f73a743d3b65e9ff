// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/EdgeTable.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
using Edge = std::tuple<int, int, int>; // low, high, triangles

std::vector<Edge> EdgesOf(const TriangleMesh& mesh)
{
  std::vector<Edge> edges;
  ForEachEdge(SortEdges(mesh),
    [&](const EdgeGroup& edge) { edges.emplace_back(edge.Low, edge.High, edge.Count()); });
  return edges;
}

int MisorientedEdges(const TriangleMesh& mesh)
{
  int count = 0;
  ForEachEdge(
    SortEdges(mesh), [&](const EdgeGroup& edge) { count += IsOriented(mesh, edge) ? 0 : 1; });
  return count;
}
}

TEST(EdgeTable, HasEveryEdgeOnceInOrder)
{
  TriangleMesh mesh;
  mesh.Points.resize(5);
  mesh.Triangles = { { 2, 1, 0 }, { 0, 1, 4 }, { 1, 0, 3 } };
  EXPECT_EQ(EdgesOf(mesh),
    (std::vector<Edge>{
      { 0, 1, 3 }, { 0, 2, 1 }, { 0, 3, 1 }, { 0, 4, 1 }, { 1, 2, 1 }, { 1, 3, 1 }, { 1, 4, 1 } }));
}

TEST(EdgeTable, LeavesOutCollapsedTriangles)
{
  TriangleMesh mesh;
  mesh.Points.resize(3);
  mesh.Triangles = { { 0, 1, 1 }, { 2, 2, 2 } };
  EXPECT_TRUE(EdgesOf(mesh).empty());
  EXPECT_TRUE(EdgesOf(TriangleMesh()).empty());
}

TEST(EdgeTable, TellsSidesThatDisagree)
{
  TriangleMesh mesh = MakeCube();
  EXPECT_EQ(EdgesOf(mesh).size(), 18u);
  EXPECT_EQ(MisorientedEdges(mesh), 0);
  std::swap(mesh.Triangles[0][0], mesh.Triangles[0][1]);
  EXPECT_EQ(MisorientedEdges(mesh), 3);
}
