// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleComponents.h"

#include "Mesh/MeshTopology.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

TEST(TriangleComponents, AreThoseOfTheTopology)
{
  TriangleMesh mesh = MakeTorus(3, 1);
  Append(mesh, MakeSphere(8, 4));
  Append(mesh, MakeCube());
  const TriangleComponents found = FindTriangleComponents(mesh);
  EXPECT_EQ(found.Count, 3);
  EXPECT_EQ(found.Of, CheckTopology(mesh).ComponentOfTriangle);
}

TEST(TriangleComponents, APointJoinsThem)
{
  TriangleMesh mesh;
  mesh.Points.resize(7);
  mesh.Triangles = { { 3, 4, 5 }, { 0, 1, 2 }, { 2, 6, 3 } };
  EXPECT_EQ(FindTriangleComponents(mesh).Of, (std::vector<int>{ 0, 0, 0 }));
  mesh.Triangles.pop_back();
  EXPECT_EQ(FindTriangleComponents(mesh).Of, (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(FindTriangleComponents({}).Count, 0);
}
