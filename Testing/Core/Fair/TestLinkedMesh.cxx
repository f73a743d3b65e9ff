// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/LinkedMesh.h"

#include "Core/Mesh/MeshShapes.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Neighbours know each other, and points a triangle of theirs.
void ExpectLinked(const LinkedMesh& mesh)
{
  for (int t = 0; t < static_cast<int>(mesh.Triangles.size()); ++t)
  {
    for (int k = 0; k < 3 && mesh.IsAlive(t); ++k)
    {
      const int across = mesh.Neighbour[t][k];
      ASSERT_GE(across, 0);
      const auto& back = mesh.Neighbour[across];
      ASSERT_NE(std::find(back.begin(), back.end(), t), back.end());
      ASSERT_GE(mesh.CornerOf(across, mesh.Triangles[t][(k + 1) % 3]), 0);
      ASSERT_GE(mesh.CornerOf(mesh.TriangleAt[mesh.Triangles[t][k]], mesh.Triangles[t][k]), 0);
    }
  }
}

void ExpectTorus(const LinkedMesh& mesh)
{
  ExpectLinked(mesh);
  const TopologyFigures figures = CheckTopology(mesh.Compact()).Total;
  EXPECT_TRUE(figures.Closed && figures.Manifold() && figures.Oriented);
  EXPECT_EQ(figures.Euler, 0);
}
}

TEST(LinkedMesh, KeepsItsTopologyThroughManyChanges)
{
  LinkedMesh mesh(MakeTorus(3, 1, 20, 10));
  std::mt19937 random(1);
  for (int change = 0; change < 3000; ++change)
  {
    const int t = static_cast<int>(random() % mesh.Triangles.size());
    const int k = static_cast<int>(random() % 3);
    if (!mesh.IsAlive(t))
    {
      continue;
    }
    const int u = mesh.Triangles[t][(k + 1) % 3];
    const int v = mesh.Triangles[t][(k + 2) % 3];
    if (change % 3 == 0)
    {
      mesh.Split(t, k);
    }
    else if (change % 3 == 1 && mesh.MayFlip(t, k))
    {
      mesh.Flip(t, k);
    }
    else if (change % 3 == 2 && mesh.MayCollapse(u, v))
    {
      mesh.Collapse(u, v);
    }
  }
  ExpectTorus(mesh);
}

TEST(LinkedMesh, PutsBackWhatItRemembers)
{
  LinkedMesh mesh(MakeTorus(3, 1, 20, 10));
  const TriangleMesh before = mesh.Compact();
  const std::vector<int> around = mesh.Around(5);
  const int into = mesh.Neighbours(5).front();
  const LinkedMesh::Memory memory = mesh.Remember(around);
  ASSERT_TRUE(mesh.MayCollapse(5, into));
  mesh.Collapse(5, into);
  EXPECT_FALSE(mesh.IsAlivePoint(5));
  mesh.PutBack(memory);
  EXPECT_EQ(mesh.Compact().Triangles, before.Triangles);
  ExpectTorus(mesh);
}

TEST(LinkedMesh, DoesNotCloseAHandle)
{
  // Three points around the tube: an edge of that ring may not go.
  LinkedMesh mesh(MakeTorus(3, 1, 20, 3));
  int refused = 0;
  for (int t = 0; t < static_cast<int>(mesh.Triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      refused += mesh.MayCollapse(mesh.Triangles[t][k], mesh.Triangles[t][(k + 1) % 3]) ? 0 : 1;
    }
  }
  EXPECT_GE(refused, 2 * 3 * 20);
}

/// It has one side only, and is cut where two triangles do not agree.
TEST(LinkedMesh, GoesAroundAPointOfABorder)
{
  const LinkedMesh strip(MakeMoebiusStrip(30));
  for (std::size_t v = 0; v < strip.Points.size(); ++v)
  {
    EXPECT_TRUE(strip.OnBorder[v]);
    EXPECT_GE(strip.Around(static_cast<int>(v)).size(), 1u);
    EXPECT_LE(strip.Around(static_cast<int>(v)).size(), 3u);
  }
}

TEST(LinkedMesh, SmallestAngleOfTriangles)
{
  EXPECT_NEAR(SmallestAngle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), 0.785398, 1e-6);
  EXPECT_NEAR(SmallestAngle({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.866025, 0 }), 1.047198, 1e-5);
  EXPECT_EQ(SmallestAngle({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }), 0);
}
