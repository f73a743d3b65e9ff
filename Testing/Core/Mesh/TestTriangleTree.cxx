// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleTree.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

TriangleMesh MakeRandomTriangles(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, 10), near(-1, 1);
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t)
  {
    const Point3 p{ anywhere(random), anywhere(random), anywhere(random) };
    for (int k = 0; k < 3; ++k)
    {
      mesh.Points.push_back(p + Vector3{ near(random), near(random), near(random) });
    }
    mesh.Triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  return mesh;
}

Box3 BoxOf(const TriangleMesh& mesh, int t)
{
  Box3 box;
  for (const int p : mesh.Triangles[t])
  {
    box.Add(mesh.Points[p]);
  }
  return box;
}

/// The least distance of a fine grid of the triangle's points, which is a little too far.
double SampledDistance(const TriangleMesh& mesh, int t, const Point3& p, int steps)
{
  const auto& c = mesh.Triangles[t];
  double least = Infinity;
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      const Point3 q =
        (1 - u - v) * mesh.Points[c[0]] + (u * mesh.Points[c[1]] + v * mesh.Points[c[2]]);
      least = std::min(least, Norm(q - p));
    }
  }
  return least;
}
}

TEST(TriangleTree, VisitsEachPairWhoseBoxesMeetOnce)
{
  for (const int count : { 0, 1, 2, 4, 5, 300 })
  {
    const TriangleMesh mesh = MakeRandomTriangles(count);
    const TriangleTree tree(mesh);
    std::set<std::pair<int, int>> found;
    for (int leaf = 0; leaf < tree.GetNumberOfLeaves(); ++leaf)
    {
      tree.VisitPairsOfLeaf(leaf,
        [&](int i, int j)
        { EXPECT_TRUE(found.emplace(std::min(i, j), std::max(i, j)).second) << i << " " << j; });
    }
    std::set<std::pair<int, int>> expected;
    for (int i = 0; i < count; ++i)
    {
      for (int j = i + 1; j < count; ++j)
      {
        if (BoxOf(mesh, i).Meets(BoxOf(mesh, j)))
        {
          expected.emplace(i, j);
        }
      }
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(TriangleTree, OfSomeMeetsTheseAsTheTreeOfAllDoes)
{
  const TriangleMesh mesh = MakeRandomTriangles(300);
  std::vector<Box3> boxes;
  for (int t = 0; t < 300; ++t)
  {
    boxes.push_back(BoxOf(mesh, t).Grown(t % 3 == 0 ? 0.1 : 0.0));
  }
  for (const std::vector<int>& some :
    { std::vector<int>(), std::vector<int>{ 17 }, std::vector<int>{ 250, 3, 3, 40, 41 } })
  {
    const TriangleTree all(mesh, boxes);
    const TriangleTree few(mesh, boxes, some);
    EXPECT_LT(few.GetNumberOfLeaves(), all.GetNumberOfLeaves());
    for (const int t : some)
    {
      std::multiset<int> ofAll, ofFew;
      all.VisitMeeting(boxes[t], [&](int other) { ofAll.insert(other); });
      few.VisitMeeting(boxes[t], [&](int other) { ofFew.insert(other); });
      EXPECT_EQ(ofFew, ofAll);
      EXPECT_EQ(ofFew.count(t), 1u);
    }
  }
}

TEST(TriangleTree, DistanceIsThatToTheNearestTriangle)
{
  const TriangleMesh mesh = MakeRandomTriangles(40);
  const TriangleTree tree(mesh);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-3, 13);
  for (int n = 0; n < 50; ++n)
  {
    const Point3 p{ anywhere(random), anywhere(random), anywhere(random) };
    double sampled = Infinity;
    for (int t = 0; t < 40; ++t)
    {
      sampled = std::min(sampled, SampledDistance(mesh, t, p, 60));
    }
    const double distance = tree.DistanceTo(p, Infinity);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.06); // the grid's step
    EXPECT_EQ(tree.DistanceTo(p, distance / 2), distance / 2);
  }
}

TEST(TriangleTree, CornersAreAtNoDistance)
{
  TriangleMesh mesh = MakeSphere(30, 15);
  Move(mesh, { 1e6, -1e6, 0.1 });
  const TriangleTree tree(mesh);
  for (const Point3& p : mesh.Points)
  {
    EXPECT_EQ(tree.DistanceTo(p, Infinity), 0);
  }
}

TEST(TriangleTree, TrianglesWithoutAreaAreSegmentsAndPoints)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 9, 9, 9 } };
  mesh.Triangles = { { 0, 1, 2 }, { 3, 3, 3 } };
  const TriangleTree tree(mesh);
  EXPECT_EQ(tree.DistanceTo({ 1, 3, 0 }, Infinity), 3);
  EXPECT_EQ(tree.DistanceTo({ 9, 9, 7 }, Infinity), 2);
}

TEST(TriangleTree, NothingIsInfinitelyFar)
{
  EXPECT_EQ(TriangleTree(TriangleMesh()).DistanceTo({ 0, 0, 0 }, Infinity), Infinity);
}

TEST(TriangleTree, ATriangleAtHandDoesNotChangeTheDistance)
{
  const TriangleMesh mesh = MakeRandomTriangles(200);
  const TriangleTree tree(mesh);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-1, 11);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Point3 p{ anywhere(random), anywhere(random), anywhere(random) };
    const int hint = static_cast<int>(random() % mesh.Triangles.size());
    const double squared = tree.SquaredDistanceToTriangle(p, hint);
    const double distance = tree.DistanceTo(p, Infinity);
    EXPECT_GE(squared, distance * distance * (1 - 1e-12));
    EXPECT_EQ(std::sqrt(tree.SquaredDistanceTo(p, squared)), distance);
  }
}
