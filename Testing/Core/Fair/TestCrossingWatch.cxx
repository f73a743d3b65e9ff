// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/CrossingWatch.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Two balls beside each other, a tenth apart.
TriangleMesh Balls()
{
  TriangleMesh balls = MakeSphere(24, 12);
  TriangleMesh other = MakeSphere(24, 12);
  Move(other, { 2.1, 0, 0 });
  Append(balls, other);
  return balls;
}

/// A point of the first ball nearest to the second.
int Rightmost(const TriangleMesh& mesh)
{
  int found = 0;
  for (std::size_t p = 0; p < mesh.Points.size() / 2; ++p)
  {
    found = mesh.Points[p][0] > mesh.Points[found][0] ? static_cast<int>(p) : found;
  }
  return found;
}
}

TEST(CrossingWatch, SeesWhatAChangeMakesCross)
{
  LinkedMesh mesh(Balls());
  CrossingWatch watch(mesh, 0.2);
  const int v = Rightmost(mesh.Mesh);
  const Point3 before = mesh.Points[v];
  const auto crossesAt = [&](double x)
  {
    mesh.Points[v][0] = x;
    const std::vector<int> around = mesh.Around(v);
    watch.Register(around);
    return watch.AnyCrosses(around);
  };
  EXPECT_FALSE(watch.WasAsked());
  EXPECT_FALSE(crossesAt(before[0]));
  EXPECT_TRUE(watch.WasAsked());
  EXPECT_TRUE(crossesAt(before[0] + 0.3));
  EXPECT_FALSE(crossesAt(before[0] - 0.1));
}

TEST(CrossingWatch, SeesWhatIsGoneThrough)
{
  TriangleMesh mesh = MakeSphere(24, 12);
  TriangleMesh speck = MakeSphere(8, 4);
  for (Point3& p : speck.Points)
  {
    p = Point3{ 1.1, 0, 0 } + 0.001 * p;
  }
  Append(mesh, speck);
  LinkedMesh linked(mesh);
  CrossingWatch watch(linked, 0.2);
  int v = 0;
  for (std::size_t p = 0; p < 24 * 12 && p < mesh.Points.size(); ++p)
  {
    v = Norm(mesh.Points[p] - Point3{ 1, 0, 0 }) < Norm(mesh.Points[v] - Point3{ 1, 0, 0 })
      ? static_cast<int>(p)
      : v;
  }
  const std::vector<int> around = linked.Around(v);
  ASSERT_FALSE(watch.AnyCrosses(around));
  EXPECT_TRUE(watch.AnyPointWithin(watch.WayOf(around, v, { 1.5, 0, 0 })));
  EXPECT_FALSE(watch.AnyPointWithin(watch.WayOf(around, v, { 1.05, 0, 0 })));
}

TEST(CrossingWatch, SeesWhatTurnsASmallPiece)
{
  // The tip of a tetrahedron, and of one whose base is two triangles, through the base; nothing crosses then.
  TriangleMesh pieces;
  pieces.Points = { { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } };
  pieces.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 3, 2, 1 } };
  TriangleMesh other;
  other.Points = { { 0, 0, 1 }, { 1, 1, 0 }, { -1, 1, 0 }, { -1, -1, 0 }, { 1, -1, 0 } };
  other.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 }, { 3, 2, 1 },
    { 4, 3, 1 } };
  Move(other, { 5, 0, 0 });
  Append(pieces, other);
  TriangleMesh ball = MakeSphere(8, 4);
  Move(ball, { 10, 0, 0 });
  Append(pieces, ball);
  const LinkedMesh mesh(pieces);
  const CrossingWatch watch(mesh, 1);
  for (const int tip : { 0, 4 })
  {
    const std::vector<int> around = mesh.Around(tip);
    const Point3 place = mesh.Points[tip];
    EXPECT_TRUE(watch.TurnsPiece(around, tip, { place[0], 0, -0.1 }));
    EXPECT_TRUE(watch.TurnsPiece(around, tip, { place[0], 0, 0 }));
    EXPECT_FALSE(watch.TurnsPiece(around, tip, { place[0], 0.2, 0.1 }));
  }
  const std::vector<int> around = mesh.Around(9);
  EXPECT_FALSE(watch.TurnsPiece(around, 9, { 10, 0, -5 }));
}
