// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/InwardDirection.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;

TEST(InwardDirection, LeadsAlongTheAxisOfACorner)
{
  double clearance = 0;
  const Vector3 inward = InwardOf({ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, clearance);
  for (const double x : inward)
  {
    EXPECT_NEAR(x, -1 / std::sqrt(3.0), 1e-12);
  }
  EXPECT_NEAR(clearance, 1 / std::sqrt(3.0), 1e-12);
}

TEST(InwardDirection, KeepsInsideOfAllWhereThatCanBe)
{
  // Ten planes that lean one way and one that leans the other: the sum alone would lie outside of it.
  std::vector<Vector3> normals(10, { -0.8, 0, 0.6 });
  normals.push_back({ 0.8, 0, 0.6 });
  double clearance = 0;
  const Vector3 inward = InwardOf(normals, clearance);
  EXPECT_NEAR(Norm(inward), 1, 1e-12);
  EXPECT_GT(clearance, 0.5);
  for (const Vector3& normal : normals)
  {
    EXPECT_LE(Dot(normal, inward), -clearance + 1e-12);
  }
}

TEST(InwardDirection, OfPlanesThatLeaveNoSideIsOutsideOfOne)
{
  double clearance = 0;
  InwardOf({ { 1, 0, 0 }, { -1, 0, 1e-3 }, { 0, 0, -1 } }, clearance);
  EXPECT_LE(clearance, 0);
}
