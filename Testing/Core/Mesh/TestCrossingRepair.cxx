// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose points are off by their last digits, uncrossed.
#include "Mesh/CrossingRepair.h"
#include "MeshInvariants.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
CrossingRepairResult Repair(TriangleMesh& mesh, const std::vector<char>& mayMove, double reach)
{
  CrossingRepairOptions options;
  options.MayMove = mayMove;
  options.Reach = reach;
  options.Threads = 1;
  Monitor monitor;
  return UndoCrossings(mesh, options, monitor);
}

/// Closed, manifold and outward still, and without crossings.
void ExpectRepaired(const TriangleMesh& mesh, const CrossingRepairResult& result)
{
  EXPECT_GT(result.Found, 0u);
  EXPECT_EQ(result.Left, 0u);
  ExpectSoundSurface(mesh);
}

/// Points that did not have to stay where they were.
std::size_t ChangedAmong(
  const TriangleMesh& before, const TriangleMesh& after, const std::vector<char>& mayMove, bool may)
{
  std::size_t changed = 0;
  for (std::size_t p = 0; p < before.Points.size(); ++p)
  {
    changed += (mayMove[p] != 0) == may && before.Points[p] != after.Points[p] ? 1 : 0;
  }
  return changed;
}

/// A box that stands in another by so much, its corners beside those of the other.
TriangleMesh StackedBoxes(double depth)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 3, 3, 1 });
  Append(mesh, MakeBox({ 1, 1, 1 - depth }, { 2, 2, 2 }));
  return mesh;
}

/// Two tetrahedra, edge across edge, the upper one too low by so much.
TriangleMesh EdgeAcrossEdge(double depth)
{
  TriangleMesh mesh{ { { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, -1 }, { 0, 1, -1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
  const TriangleMesh other{ { { 0, -1, -depth }, { 0, 1, -depth }, { -1, 0, 1 }, { 1, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
  Append(mesh, other);
  return mesh;
}
}

TEST(CrossingRepair, LeavesWhatDoesNotCross)
{
  for (const TriangleMesh& whole : { MakeLinkedTori(), StackedBoxes(-1e-15), EdgeAcrossEdge(0) })
  {
    TriangleMesh mesh = whole;
    const CrossingRepairResult result = Repair(mesh, std::vector<char>(mesh.Points.size(), 1), 0.1);
    EXPECT_EQ(result.Found, 0u);
    EXPECT_EQ(result.Moved, 0u);
    EXPECT_EQ(mesh.Points, whole.Points);
    EXPECT_EQ(mesh.Triangles, whole.Triangles);
  }
}

// What is exact crosses nothing else that is, so only the box that is off is looked at, with the same result.
TEST(CrossingRepair, LooksOnlyAtTrianglesWithAPointThatMayBeOff)
{
  const TriangleMesh whole = StackedBoxes(1e-9);
  const std::vector<char> mayMove(whole.Points.size(), 1);
  CrossingRepairOptions options;
  options.MayMove = mayMove;
  options.Reach = 1e-3;
  options.Threads = 1;
  Monitor monitor;
  TriangleMesh all = whole, half = whole, none = whole;
  const CrossingRepairResult ofAll = UndoCrossings(all, options, monitor);
  options.IsExact.assign(8, 1); // the lower box; what is not named may be off
  const CrossingRepairResult ofHalf = UndoCrossings(half, options, monitor);
  options.IsExact.assign(whole.Points.size(), 1);
  const CrossingRepairResult ofNone = UndoCrossings(none, options, monitor);
  ExpectRepaired(half, ofHalf);
  EXPECT_EQ(ofHalf.Found, ofAll.Found);
  EXPECT_EQ(half.Points, all.Points);
  EXPECT_EQ(half.Triangles, all.Triangles);
  EXPECT_EQ(ofNone.Found, 0u);
  EXPECT_EQ(none.Points, whole.Points);
}

TEST(CrossingRepair, MovesAboutAsFarAsPointsAreOff)
{
  for (const double depth : { 1e-14, 1e-12, 1e-9, 1e-6 })
  {
    SCOPED_TRACE(depth);
    const TriangleMesh before = StackedBoxes(depth);
    TriangleMesh mesh = before;
    std::vector<char> mayMove(mesh.Points.size(), 0);
    std::fill(mayMove.begin() + 8, mayMove.end(), 1);
    const CrossingRepairResult result = Repair(mesh, mayMove, 1e-3);
    ExpectRepaired(mesh, result);
    EXPECT_EQ(ChangedAmong(before, mesh, mayMove, false), 0u);
    EXPECT_LE(ChangedAmong(before, mesh, mayMove, true), result.Moved);
    EXPECT_LE(result.Moved, ChangedAmong(before, mesh, mayMove, true) + result.AddedPoints);
    EXPECT_LE(result.Farthest, 20 * depth);
  }
}

TEST(CrossingRepair, WhereAllPointsMustStayEdgesGetSomeThatMayMove)
{
  for (const double depth : { 1e-14, 1e-12, 1e-6 })
  {
    SCOPED_TRACE(depth);
    const TriangleMesh before = EdgeAcrossEdge(depth);
    TriangleMesh mesh = before;
    const std::vector<char> mayMove(mesh.Points.size(), 0);
    const CrossingRepairResult result = Repair(mesh, mayMove, 1e-3);
    ExpectRepaired(mesh, result);
    EXPECT_EQ(ChangedAmong(before, mesh, mayMove, false), 0u);
    EXPECT_EQ(mesh.Points.size(), before.Points.size() + result.AddedPoints);
    ASSERT_EQ(mesh.Triangles.size(), before.Triangles.size() + result.PartOf.size());
    EXPECT_LE(result.Farthest, 20 * depth);
    ExpectVolume(mesh, 4.0 / 3, 1e-4);
    for (std::size_t i = 0; i < result.PartOf.size(); ++i)
    {
      EXPECT_LT(result.PartOf[i], static_cast<int>(before.Triangles.size() + i));
    }
  }
}

TEST(CrossingRepair, SolidsThatTouchTurnedAndRounded)
{
  // Edge across edge, face on face, corner at corner, in frames in which nothing is exact.
  TriangleMesh touching = EdgeAcrossEdge(0);
  TriangleMesh beside = StackedBoxes(0);
  Move(beside, { 5, 0, 0 });
  Append(touching, beside);
  Append(touching, MakeBox({ 0, 5, 0 }, { 1, 6, 1 }));
  Append(touching, MakeBox({ 1, 6, 1 }, { 2, 7, 2 }));
  int found = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> part;
    const Vector3 drawn{ part(random), part(random), part(random) };
    const PlanarFrame frame = PlanarFrame::About((1 / Norm(drawn)) * drawn);
    TriangleMesh mesh = touching;
    std::vector<char> mayMove;
    for (Point3& p : mesh.Points)
    {
      p = frame.ToSpace({ p[0], p[1] }, p[2]);
      mayMove.push_back(random() % 2 == 0 ? 1 : 0);
    }
    const TriangleMesh before = mesh;
    const CrossingRepairResult result = Repair(mesh, mayMove, 1e-3);
    found += result.Found > 0 ? 1 : 0;
    EXPECT_EQ(result.Left, 0u);
    ExpectSoundSurface(mesh);
    EXPECT_LE(result.Farthest, 1e-12);
    const std::set<Point3> places(mesh.Points.begin(), mesh.Points.end());
    for (std::size_t p = 0; p < before.Points.size(); ++p)
    {
      EXPECT_TRUE(mayMove[p] || places.count(before.Points[p]) > 0) << "point " << p;
    }
  }
  EXPECT_GT(found, 20);
}

TEST(CrossingRepair, CountsWhatItCannotUndoWithinReach)
{
  const TriangleMesh before = StackedBoxes(0.5);
  TriangleMesh mesh = before;
  const CrossingRepairResult result = Repair(mesh, std::vector<char>(mesh.Points.size(), 1), 1e-3);
  EXPECT_GT(result.Left, 0u);
  EXPECT_LE(result.Farthest, 1e-3);
  EXPECT_LE(mesh.Points.size(), before.Points.size() + 64 + before.Triangles.size() / 2);
  ExpectClosed(mesh);
  ExpectManifold(mesh);
}

TEST(CrossingRepair, DoesNotDependOnTheThreads)
{
  TriangleMesh one = StackedBoxes(1e-9);
  TriangleMesh two = one;
  CrossingRepairOptions options;
  options.MayMove.assign(one.Points.size(), 1);
  options.Reach = 1e-3;
  Monitor monitor;
  options.Threads = 1;
  UndoCrossings(one, options, monitor);
  options.Threads = 2;
  UndoCrossings(two, options, monitor);
  EXPECT_EQ(one.Points, two.Points);
}
