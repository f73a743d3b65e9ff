// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleMeasures.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;
using namespace recon::testing;

TEST(TriangleMeasures, NormalsOfABoxLookOutwardAlongAxes)
{
  const TriangleMesh box = MakeBox({ 1, 2, 3 }, { 2, 4, 6 });
  const Point3 middle{ 1.5, 3, 4.5 };
  for (int t = 0; t < static_cast<int>(box.Triangles.size()); ++t)
  {
    const Vector3 normal = UnitNormalOf(box, t);
    EXPECT_EQ(std::count(normal.begin(), normal.end(), 0.0), 2);
    EXPECT_EQ(Norm(normal), 1);
    EXPECT_GT(Dot(normal, box.Points[box.Triangles[t][0]] - middle), 0);
  }
}

TEST(TriangleMeasures, ATriangleWithoutAreaHasNoNormal)
{
  const TriangleMesh line{ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } } };
  EXPECT_EQ(UnitNormalOf(line, 0), (Vector3{ 0, 0, 0 }));
}

TEST(TriangleMeasures, TheBoxIsThatOfTheCorners)
{
  const TriangleMesh one{ { { 9, 9, 9 }, { 0, 5, 2 }, { 1, 4, 2 }, { -1, 6, 3 } },
    { { 1, 2, 3 } } };
  EXPECT_EQ(BoxOf(one, 0).Low, (Point3{ -1, 4, 2 }));
  EXPECT_EQ(BoxOf(one, 0).High, (Point3{ 1, 6, 3 }));
}
