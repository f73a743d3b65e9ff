// SPDX-License-Identifier: GPL-3.0-or-later
// Slivers and needles go, by flips, collapses and shifts, and nothing else changes.
#include "Core/Mesh/MeshInvariants.h"
#include "EditedMeshes.h"
#include "Implicit/ZeroSet/MeshCleanUp.h"
#include "Implicit/ZeroSet/SliverRemoval.h"

using namespace recon;
using namespace recon::testing;

namespace
{
edited::Shape Ball(double poleShift)
{
  edited::Shape ball = edited::Ball(12, 24);
  // A ring's point almost upon its neighbour: needles on both sides.
  std::vector<Point3> p{ ball.Mesh.Points[60] +
    poleShift * (ball.Mesh.Points[61] - ball.Mesh.Points[60]) };
  std::vector<Vector3> n;
  std::vector<char> done;
  edited::OntoBall(p, n, done);
  ball.Mesh.Points[60] = p.front();
  ball.Normals[60] = n.front();
  return ball;
}
}

TEST(SliverRemoval, TakesNeedlesOutOfAnEvenMesh)
{
  edited::Shape ball = Ball(0.97);
  ASSERT_LT(ComputeSmallestAngle(ball.Mesh), NeedleAngle);
  const std::vector<char> thin(ball.Mesh.Points.size(), 0);
  Remesher remesher(ball.Mesh, ball.Normals, 0.25, thin);
  RemoveSlivers(remesher, edited::OntoBall);
  remesher.Edited.Compact();
  EXPECT_GE(ComputeSmallestAngle(ball.Mesh), SliverAngle);
  ExpectSoundSurface(ball.Mesh);
  for (const Point3& p : ball.Mesh.Points)
  {
    EXPECT_NEAR(Norm(p), 1, 1e-12);
  }
}

TEST(SliverRemoval, LeavesAGoodMeshWithItsPoints)
{
  edited::Shape sheet = edited::Sheet(5);
  const std::vector<Point3> points = sheet.Mesh.Points;
  const std::vector<char> thin(points.size(), 0);
  Remesher remesher(sheet.Mesh, sheet.Normals, 1, thin);
  RemoveSlivers(remesher, edited::OntoBall);
  remesher.Edited.Compact();
  EXPECT_TRUE(sheet.Mesh.Points == points);
}

TEST(SliverRemoval, CleanUpKeepsACloseCrossingFreeManifold)
{
  edited::Shape ball = edited::Ball(20, 60, 0.35);
  CleanUpOptions options;
  options.EdgeLength = 0.2;
  Monitor monitor;
  const CleanUpResult cleaned =
    CleanUp(ball.Mesh, ball.Normals, edited::OntoBall, options, monitor);
  EXPECT_EQ(cleaned.Crossing, 0);
  EXPECT_GE(ComputeSmallestAngle(ball.Mesh), SliverAngle);
  ExpectSoundSurface(ball.Mesh);
  EXPECT_EQ(CheckTopology(ball.Mesh).Total.Euler, 2);
}
