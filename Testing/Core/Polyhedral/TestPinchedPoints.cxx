// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"
#include "Polyhedral/PinchedPoints.h"

#include <gtest/gtest.h>

using namespace recon;

TEST(PinchedPoints, TwoTrianglesAtACornerGetOneEach)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
  mesh.Triangles = { { { 0, 1, 2 } }, { { 0, 3, 4 } } };
  ASSERT_FALSE(CheckTopology(mesh).Total.VertexManifold);
  EXPECT_EQ(CutPinchedPoints(mesh), std::vector<int>{ 0 });
  ASSERT_EQ(mesh.Points.size(), 6u);
  EXPECT_EQ(mesh.Points[5], mesh.Points[0]);
  EXPECT_TRUE(CheckTopology(mesh).Total.VertexManifold);
}

TEST(PinchedPoints, AFanStaysWhole)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 } };
  mesh.Triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  const auto before = mesh.Triangles;
  EXPECT_TRUE(CutPinchedPoints(mesh).empty());
  EXPECT_EQ(mesh.Triangles, before);
}
