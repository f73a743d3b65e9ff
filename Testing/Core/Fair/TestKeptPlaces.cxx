// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/KeptPlaces.h"

#include "Core/Mesh/MeshShapes.h"
#include "Mesh/TriangleTree.h"

#include <gtest/gtest.h>

#include <limits>

using namespace recon;
using namespace recon::testing;

namespace
{
double Farthest(const TriangleMesh& mesh, const std::vector<Point3>& places)
{
  const TriangleTree tree(mesh);
  double farthest = 0;
  for (const Point3& p : places)
  {
    farthest = std::max(farthest, tree.DistanceTo(p, std::numeric_limits<double>::max()));
  }
  return farthest;
}

/// Collapses every edge of a sphere that may be, in the order of the points. @returns how many
int CollapseAll(LinkedMesh& mesh, KeptPlaces& kept)
{
  int collapsed = 0;
  const int count = static_cast<int>(mesh.Points.size());
  for (int from = 0; from < count; ++from)
  {
    const std::vector<int> neighbours =
      mesh.IsAlivePoint(from) ? mesh.Neighbours(from) : std::vector<int>();
    for (const int into : neighbours)
    {
      if (!mesh.IsAlivePoint(from) || !mesh.MayCollapse(from, into))
      {
        continue;
      }
      const std::vector<int> around = mesh.Around(from);
      std::vector<KeptPlaces::Change> after;
      for (const int t : around)
      {
        LinkedMesh::Triangle corners = mesh.Triangles[t];
        if (mesh.CornerOf(t, into) < 0)
        {
          std::replace(corners.begin(), corners.end(), from, into);
          after.emplace_back(t, corners);
        }
      }
      if (kept.MayChange(around, after))
      {
        mesh.Collapse(from, into);
        kept.Commit();
        ++collapsed;
      }
    }
  }
  return collapsed;
}
}

TEST(KeptPlaces, WitnessesAreTheNearestTriangles)
{
  const TriangleMesh cube = MakeCube();
  Box3 box;
  for (const Point3& p : cube.Points)
  {
    box.Add(p);
  }
  const Point3 above{ 0.5 * (box.Low[0] + box.High[0]), 0.4 * box.Low[1] + 0.6 * box.High[1],
    box.High[2] + 0.1 };
  Monitor monitor;
  const std::vector<int> found =
    FindWitnesses(cube, { { above, cube.Points[2] }, 0.2 }, 1, monitor);
  ASSERT_GE(found[0], 0);
  for (const int v : cube.Triangles[found[0]])
  {
    EXPECT_EQ(cube.Points[v][2], box.High[2]);
  }
  EXPECT_GE(found[1], 0);
  EXPECT_EQ(FindWitnesses(cube, { { above }, 0.05 }, 1, monitor).front(), -1);
}

TEST(KeptPlaces, StayWithinWhateverIsCollapsed)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  const std::vector<Point3>& places = sphere.Points;
  int before = -1;
  for (const double within : { 0.0, 0.02, 0.1, 10.0 })
  {
    LinkedMesh mesh(sphere);
    Monitor monitor;
    KeptPlaces kept(mesh, { places, within }, 1, monitor);
    const int collapsed = CollapseAll(mesh, kept);
    EXPECT_LE(Farthest(mesh.Compact(), places), within);
    EXPECT_GT(collapsed, before);
    before = collapsed;
  }
}

TEST(KeptPlaces, FollowTrianglesThatAreCut)
{
  // Places on a side that is cut again and again: without witnesses among the new triangles nothing would
  // hold them in the end.
  const TriangleMesh cube = MakeCube();
  LinkedMesh mesh(cube);
  const Point3 onSide =
    0.3 * cube.Points[cube.Triangles[0][1]] + 0.7 * cube.Points[cube.Triangles[0][2]];
  Monitor monitor;
  KeptPlaces kept(mesh, { { onSide }, 1e-9 }, 1, monitor);
  for (int cut = 0; cut < 20; ++cut)
  {
    const int t = cut % static_cast<int>(mesh.Triangles.size());
    mesh.Split(t, mesh.LongestSide(t));
    kept.TakeCut(mesh.Around(static_cast<int>(mesh.Points.size()) - 1));
  }
  CollapseAll(mesh, kept);
  EXPECT_LE(Farthest(mesh.Compact(), { onSide }), 1e-9);
}

TEST(KeptPlaces, ThoseFarFromTheBeginningHinderNothing)
{
  LinkedMesh mesh(MakeSphere(24, 12));
  Monitor monitor;
  KeptPlaces kept(mesh, { { { 5, 0, 0 } }, 0.1 }, 1, monitor);
  EXPECT_GT(CollapseAll(mesh, kept), 100);
}
