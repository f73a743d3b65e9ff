// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/TurnedPieces.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
TriangleMesh Ball(double radius, double x)
{
  TriangleMesh ball = MakeSphere(12, 6);
  for (Point3& p : ball.Points)
  {
    p = radius * p;
  }
  Move(ball, { x, 0, 0 });
  return ball;
}

std::vector<char> Find(const TriangleMesh& mesh)
{
  return FindTurnedPieces(mesh, FindTriangleComponents(mesh));
}
}

TEST(TurnedPieces, OutwardOnesAndCavitiesAreWell)
{
  TriangleMesh mesh = Ball(1, 0);
  Append(mesh, Ball(1, 3));
  TriangleMesh cavity = Ball(0.5, 3);
  TurnInsideOut(cavity);
  Append(mesh, cavity);
  EXPECT_EQ(Find(mesh), (std::vector<char>{ 0, 0, 0 }));
}

TEST(TurnedPieces, InsideOutAndWithinAnotherAreNot)
{
  TriangleMesh mesh = Ball(1, 0);
  Append(mesh, Ball(0.5, 0));
  TriangleMesh alone = Ball(1, 3);
  TurnInsideOut(alone);
  Append(mesh, alone);
  EXPECT_EQ(Find(mesh), (std::vector<char>{ 0, 1, 1 }));
}

TEST(TurnedPieces, OfOpenOnesNothingIsSaid)
{
  TriangleMesh mesh = Ball(1, 0);
  TurnInsideOut(mesh);
  mesh.Triangles.pop_back();
  EXPECT_EQ(Find(mesh), (std::vector<char>{ 0 }));
}
