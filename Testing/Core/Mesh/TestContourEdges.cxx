// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ContourEdges.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<int> FindOn(const TriangleMesh& mesh, const SpaceLoop& loop)
{
  const HalfEdges edges(mesh);
  const std::vector<int> components = edges.Components();
  const std::vector<int> found = ContourEdges(mesh, edges, components).Find(loop);
  // Each from where the one before ends, round to the first.
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(
      mesh.Points[edges.To(found[i])], mesh.Points[edges.From(found[(i + 1) % found.size()])]);
  }
  return found;
}

/// The rim of the cube's top.
const SpaceLoop Rim{ { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
}

TEST(ContourEdges, FindsALoopOfTheSurfacesPoints)
{
  EXPECT_EQ(FindOn(MakeCube(), Rim).size(), 4u);
}

TEST(ContourEdges, FindsItInEitherDirectionAndFromAnyPoint)
{
  SpaceLoop loop = Rim;
  std::reverse(loop.begin(), loop.end());
  EXPECT_EQ(FindOn(MakeCube(), loop).size(), 4u);
  std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  EXPECT_EQ(FindOn(MakeCube(), loop).size(), 4u);
}

TEST(ContourEdges, PointsThatWereAddedOnAnEdgeArePassed)
{
  // Two boxes' cells in a row: the long edges have a point in their middle.
  const TriangleMesh mesh = MakeFromCells({ 2, 1, 1 }, [](int, int, int) { return true; });
  const SpaceLoop loop{ { 0, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 0, 1, 1 } };
  EXPECT_EQ(FindOn(mesh, loop).size(), 6u);
}

TEST(ContourEdges, IsEmptyWhereTheSurfaceHasNoSuchEdges)
{
  EXPECT_TRUE(FindOn(MakeCube(), { { 0, 0, 1 }, { 1, 0, 1 }, { 5, 5, 1 } }).empty());
  EXPECT_TRUE(FindOn(MakeCube(), { { 0, 0, 0.5 }, { 1, 0, 0.5 }, { 1, 1, 0.5 } }).empty());
}

TEST(ContourEdges, StaysOnOneComponent)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 0, 0, 1 }, { 1, 1, 2 }));
  const HalfEdges edges(mesh);
  const std::vector<int> components = edges.Components();
  const std::vector<int> found = ContourEdges(mesh, edges, components).Find(Rim);
  ASSERT_EQ(found.size(), 4u);
  for (const int h : found)
  {
    EXPECT_EQ(components[h / 3], components[found.front() / 3]);
  }
}
