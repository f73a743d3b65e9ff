// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MassProperties.h"
#include "Mesh/MeshTopology.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<MassFigures> Measure(const TriangleMesh& mesh)
{
  const MeshTopology topology = CheckTopology(mesh);
  std::vector<bool> encloses;
  for (const auto& component : topology.Components)
  {
    encloses.push_back(component.EnclosesVolume());
  }
  return ComputeMassProperties(mesh, topology.ComponentOfTriangle, encloses);
}
}

TEST(MassProperties, Box)
{
  const MassFigures box = Measure(MakeBox({ 1, 2, 3 }, { 2, 4, 7 })).back();
  EXPECT_DOUBLE_EQ(box.Volume.value(), 8);
  EXPECT_DOUBLE_EQ(box.Area, 2 * (2 + 4 + 8));
  EXPECT_EQ(box.Low, (Point3{ 1, 2, 3 }));
  EXPECT_EQ(box.High, (Point3{ 2, 4, 7 }));
  EXPECT_DOUBLE_EQ(box.Centroid.value()[0], 1.5);
  EXPECT_DOUBLE_EQ(box.Centroid.value()[1], 3);
  EXPECT_DOUBLE_EQ(box.Centroid.value()[2], 5);
  EXPECT_NEAR(box.SmallestAngle, std::atan2(1, 4) * 180 / Pi, 1e-12);
}

TEST(MassProperties, Tetrahedron)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 } };
  mesh.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  const MassFigures figures = Measure(mesh).back();
  EXPECT_NEAR(figures.Volume.value(), 64.0 / 6, 1e-13);
  for (const double x : figures.Centroid.value())
  {
    EXPECT_NEAR(x, 1, 1e-13);
  }
  EXPECT_NEAR(figures.SmallestAngle, 45, 1e-12);
}

TEST(MassProperties, SameFarFromTheOrigin)
{
  TriangleMesh mesh = MakeLinkedTori();
  for (auto& p : mesh.Points)
  {
    p = 100.0 * p; // the size of a head in millimetres
  }
  const auto near = Measure(mesh);
  Move(mesh, { 1e6, -1e6, 1e6 });
  const auto far = Measure(mesh);
  ASSERT_EQ(near.size(), 3u);
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    EXPECT_NEAR(far[i].Volume.value() / near[i].Volume.value(), 1, 1e-9);
    EXPECT_NEAR(far[i].Area / near[i].Area, 1, 1e-9);
    EXPECT_NEAR(far[i].SmallestAngle / near[i].SmallestAngle, 1, 1e-9);
    EXPECT_NEAR(far[i].Centroid.value()[0], near[i].Centroid.value()[0] + 1e6, 1e-6);
  }
}

TEST(MassProperties, NoVolumeWhereNoneIsEnclosed)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.pop_back();
  Append(mesh, MakeBox({ 3, 3, 3 }, { 4, 4, 4 }));
  const auto figures = Measure(mesh);
  EXPECT_FALSE(figures[0].Volume.has_value());
  EXPECT_FALSE(figures[0].Centroid.has_value());
  EXPECT_DOUBLE_EQ(figures[0].Area, 5.5);
  EXPECT_DOUBLE_EQ(figures[1].Volume.value(), 1);
  EXPECT_FALSE(figures[2].Volume.has_value());
  EXPECT_DOUBLE_EQ(figures[2].Area, 11.5);
}

TEST(MassProperties, CavityIsSubtracted)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 4, 4, 4 });
  TriangleMesh cavity = MakeBox({ 1, 1, 1 }, { 2, 2, 2 });
  TurnInsideOut(cavity);
  Append(mesh, cavity);
  const auto figures = Measure(mesh);
  EXPECT_DOUBLE_EQ(figures[1].Volume.value(), -1);
  EXPECT_DOUBLE_EQ(figures[2].Volume.value(), 63);
  EXPECT_NEAR(figures[2].Centroid.value()[0], (64 * 2 - 1.5) / 63, 1e-14);
}

TEST(MassProperties, EmptyMesh)
{
  const auto figures = Measure(TriangleMesh());
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_FALSE(figures[0].Volume.has_value());
  EXPECT_EQ(figures[0].Area, 0);
}

TEST(MassProperties, FlatTriangleHasNoAngle)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  mesh.Triangles = { { 0, 1, 2 } };
  EXPECT_EQ(Measure(mesh).back().SmallestAngle, 0);
}
