// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Monitor.h"
#include "MeshInvariants.h"
#include "MeshShapes.h"

#include <limits>

using namespace recon;
using namespace recon::testing;

namespace
{
struct Expected
{
  int Components;
  int Euler;
  int Genus;
  int Nesting = 0;
};

void ExpectSound(const TriangleMesh& mesh, const Expected& expected)
{
  ExpectSoundSurface(mesh);
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_EQ(topology.Total.Components, expected.Components);
  EXPECT_EQ(topology.Total.Euler, expected.Euler);
  ASSERT_TRUE(topology.Total.Genus.has_value());
  EXPECT_EQ(*topology.Total.Genus, expected.Genus);
  EXPECT_EQ(topology.Total.DegenerateTriangles, 0);
  for (const int defect : topology.DefectOfTriangle)
  {
    EXPECT_EQ(defect, 0);
  }
}

int CountMarked(const std::vector<int>& defects, int bit)
{
  int count = 0;
  for (const int defect : defects)
  {
    count += (defect & bit) != 0 ? 1 : 0;
  }
  return count;
}
}

TEST(MeshTopology, CubeIsSound)
{
  ExpectSound(MakeCube(), { 1, 2, 0 });
  ExpectVolume(MakeCube(), 1, 1e-15);
  const auto figures = CheckTopology(MakeCube()).Total;
  EXPECT_EQ(figures.Points, 8);
  EXPECT_EQ(figures.Edges, 18);
  EXPECT_EQ(figures.Triangles, 12);
}

TEST(MeshTopology, CubeInsideOutIsNotOutward)
{
  TriangleMesh mesh = MakeCube();
  TurnInsideOut(mesh);
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_TRUE(topology.Total.Closed);
  EXPECT_TRUE(topology.Total.Oriented);
  EXPECT_FALSE(topology.Total.Outward);
  EXPECT_EQ(CountMarked(topology.DefectOfTriangle, DefectInward), 12);
  ExpectVolume(mesh, -1, 1e-15);
}

TEST(MeshTopology, CavityRunsInward)
{
  TriangleMesh mesh = MakeBox({ -4, -4, -4 }, { 4, 4, 4 });
  TriangleMesh cavity = MakeBox({ -3, -3, -3 }, { 3, 3, 3 });
  TurnInsideOut(cavity);
  Append(mesh, cavity);
  Append(mesh, MakeBox({ -1, -1, -1 }, { 1, 1, 1 })); // a solid in the cavity
  ExpectSound(mesh, { 3, 6, 0 });
  EXPECT_EQ(CheckTopology(mesh).Nesting, (std::vector<int>{ 0, 1, 2 }));
  ExpectVolume(mesh, 512 - 216 + 8, 1e-15);
}

TEST(MeshTopology, SolidInsideASolidIsNotOutward)
{
  TriangleMesh mesh = MakeBox({ -4, -4, -4 }, { 4, 4, 4 });
  Append(mesh, MakeCube());
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_TRUE(topology.Components[0].Outward);
  EXPECT_FALSE(topology.Components[1].Outward);
}

TEST(MeshTopology, NestingSurvivesRaysThroughEdgesAndCorners)
{
  // The small box's first corner lies straight below corners, edges and diagonals of both large
  // ones.
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  for (const double x : { 0.0, 1.0, 2.0, 3.0 })
  {
    for (const double y : { 0.0, 1.0, 2.0, 3.0 })
    {
      Append(mesh, MakeBox({ x, y, -5 }, { x + 0.5, y + 0.5, -4 }));
    }
  }
  Append(mesh, MakeBox({ 0.5, 0.5, 0.5 }, { 0.75, 0.75, 0.75 }));
  const auto nesting = CheckTopology(mesh).Nesting;
  ASSERT_EQ(nesting.size(), 18u);
  for (std::size_t c = 0; c + 1 < nesting.size(); ++c)
  {
    EXPECT_EQ(nesting[c], 0) << c;
  }
  EXPECT_EQ(nesting.back(), 1);
}

TEST(MeshTopology, NestingLooksPastPointsThatLieOnTheOther)
{
  // Stands on the floor of the larger box, so four of its corners lie on it.
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 4, 4, 4 });
  Append(mesh, MakeBox({ 1, 1, 0 }, { 2, 2, 1 }));
  EXPECT_EQ(CheckTopology(mesh).Nesting, (std::vector<int>{ 0, 1 }));
}

TEST(MeshTopology, CavityThatTouchesWithAllItsCorners)
{
  // A block without its eight corner cells, and its middle cell hollow: that has its corners in the
  // notches.
  TriangleMesh mesh =
    MakeFromCells({ 3, 3, 3 }, [](int x, int y, int z) { return x == 1 || y == 1 || z == 1; });
  TriangleMesh cavity = MakeBox({ 1, 1, 1 }, { 2, 2, 2 });
  TurnInsideOut(cavity);
  Append(mesh, cavity);
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_EQ(topology.Nesting, (std::vector<int>{ 0, 1 }));
  EXPECT_TRUE(topology.Total.Outward);
  ExpectVolume(mesh, 18, 1e-14);
  // A box in one of the notches touches with its corners as well, but from outside.
  TriangleMesh beside =
    MakeFromCells({ 3, 3, 3 }, [](int x, int y, int z) { return x == 1 || y == 1 || z == 1; });
  Append(beside, MakeBox({ 0, 0, 0 }, { 1, 1, 1 }));
  EXPECT_EQ(CheckTopology(beside).Nesting, (std::vector<int>{ 0, 0 }));
}

TEST(MeshTopology, CavityThatTouchesAVerticalEdge)
{
  // In an upright cross, hollows with a tip at half the height of each inner edge: beside the tip a
  // ray finds nothing but upright walls.
  TriangleMesh mesh =
    MakeFromCells({ 3, 3, 1 }, [](int x, int y, int) { return x == 1 || y == 1; });
  std::vector<int> expected{ 0 };
  for (const double x : { 1.0, 2.0 })
  {
    for (const double y : { 1.0, 2.0 })
    {
      const double u = x < 1.5 ? 0.25 : -0.25;
      const double v = y < 1.5 ? 0.25 : -0.25;
      TriangleMesh hollow;
      hollow.Points = { { x, y, 0.5 }, { x + u, y + v, 0.5 }, { x + u, y, 0.75 },
        { x, y + v, 0.75 } };
      hollow.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
      if (u * v > 0)
      {
        TurnInsideOut(hollow);
      }
      Append(mesh, hollow);
      expected.push_back(1);
    }
  }
  EXPECT_EQ(CheckTopology(mesh).Nesting, expected);
  EXPECT_TRUE(CheckTopology(mesh).Total.Outward);
}

TEST(MeshTopology, ComponentsThatCrossAreAroundNeither)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  Append(mesh, MakeBox({ 1, 0.5, 0.25 }, { 3, 1.5, 1.125 }));
  Append(mesh, MakeBox({ 0.5, 0.5, 1.5 }, { 0.75, 0.75, 2.5 }));
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_EQ(topology.Nesting, (std::vector<int>{ 0, 0, 0 }));
  EXPECT_TRUE(topology.Total.Outward);
}

TEST(MeshTopology, GenusOfRingChainAndSponge)
{
  ExpectSound(MakeRingChain(5), { 1, 2 - 2 * 5, 5 });
  ExpectVolume(MakeRingChain(5), 28, 1e-14);
  const int genus = 3 * 4 * 25 - 125 + 1;
  ASSERT_GT(genus, 100);
  ExpectSound(MakeSponge(4), { 1, 2 - 2 * genus, genus });
  ExpectVolume(MakeSponge(4), 125 + 3 * 4 * 25, 1e-14);
}

TEST(MeshTopology, LinkedTori)
{
  ExpectSound(MakeLinkedTori(), { 2, 0, 2 });
}

TEST(MeshTopology, MoebiusStrip)
{
  const MeshTopology topology = CheckTopology(MakeMoebiusStrip(30));
  EXPECT_FALSE(topology.Total.Closed);
  EXPECT_TRUE(topology.Total.Manifold());
  EXPECT_FALSE(topology.Total.Oriented);
  EXPECT_EQ(topology.Total.MisorientedEdges, 1);
  EXPECT_EQ(topology.Total.OpenEdges, 60);
  EXPECT_EQ(topology.Total.Euler, 0);
  EXPECT_FALSE(topology.Total.Genus.has_value());
  EXPECT_FALSE(topology.Total.EnclosesVolume());
}

TEST(MeshTopology, PinchedSphere)
{
  const TriangleMesh mesh = MakeTorus(1, 1);
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_TRUE(topology.Total.Closed);
  EXPECT_TRUE(topology.Total.EdgeManifold);
  EXPECT_FALSE(topology.Total.VertexManifold);
  EXPECT_EQ(topology.Total.PinchedVertices, 1);
  EXPECT_EQ(topology.Total.Components, 1);
  EXPECT_EQ(topology.Total.Euler, 1);
  EXPECT_TRUE(topology.Total.Outward);
  EXPECT_FALSE(topology.Total.Genus.has_value());
  EXPECT_EQ(CountMarked(topology.DefectOfTriangle, DefectPinchedVertex), 80);
}

TEST(MeshTopology, CubeWithoutOneTriangle)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.pop_back();
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_FALSE(topology.Total.Closed);
  EXPECT_TRUE(topology.Total.Oriented);
  EXPECT_FALSE(topology.Total.Outward);
  EXPECT_EQ(topology.Total.OpenEdges, 3);
  EXPECT_EQ(topology.Total.Euler, 1);
  EXPECT_EQ(CountMarked(topology.DefectOfTriangle, DefectOpenEdge), 3);
}

TEST(MeshTopology, CubeWithOneTriangleDoubled)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.push_back({ mesh.Triangles[3][1], mesh.Triangles[3][2], mesh.Triangles[3][0] });
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_EQ(topology.Total.DuplicateTriangles, 1);
  EXPECT_EQ(topology.Total.OverusedEdges, 3);
  EXPECT_EQ(topology.Total.OpenEdges, 0);
  EXPECT_FALSE(topology.Total.Closed);
  EXPECT_FALSE(topology.Total.EnclosesVolume());
  EXPECT_EQ(CountMarked(topology.DefectOfTriangle, DefectDuplicate), 2);
}

TEST(MeshTopology, CubeWithOneTriangleFlipped)
{
  TriangleMesh mesh = MakeCube();
  std::swap(mesh.Triangles[3][1], mesh.Triangles[3][2]);
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_TRUE(topology.Total.Closed);
  EXPECT_TRUE(topology.Total.Manifold());
  EXPECT_FALSE(topology.Total.Oriented);
  EXPECT_EQ(topology.Total.MisorientedEdges, 3);
  EXPECT_FALSE(topology.Total.Outward);
  EXPECT_EQ(CountMarked(topology.DefectOfTriangle, DefectMisorientedEdge), 4);
}

TEST(MeshTopology, CubeWithOneTriangleCollapsedByIndex)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles[3][1] = mesh.Triangles[3][0];
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_EQ(topology.Total.DegenerateTriangles, 1);
  EXPECT_EQ(topology.Total.Triangles, 12);
  EXPECT_EQ(topology.Total.OpenEdges, 3);
  EXPECT_EQ(topology.Total.Components, 1);
  EXPECT_EQ(topology.ComponentOfTriangle[3], 0);
}

TEST(MeshTopology, CubeWithOneTriangleFlattened)
{
  // A corner of a cap's triangle that lies on its own edge: closed, but of no area.
  TriangleMesh mesh = MakeCube();
  const auto cut = mesh.Triangles[0];
  const int middle = static_cast<int>(mesh.Points.size());
  mesh.Points.push_back(0.5 * mesh.Points[cut[0]] + 0.5 * mesh.Points[cut[1]]);
  mesh.Triangles[0] = { cut[0], middle, cut[2] };
  mesh.Triangles.push_back({ middle, cut[1], cut[2] });
  mesh.Triangles.push_back({ cut[0], cut[1], middle });
  const MeshTopology topology = CheckTopology(mesh);
  EXPECT_TRUE(topology.Total.Closed);
  EXPECT_TRUE(topology.Total.Outward);
  EXPECT_EQ(topology.Total.DegenerateTriangles, 1);
  EXPECT_EQ(topology.DefectOfTriangle.back(), DefectDegenerate);
}

TEST(MeshTopology, NearlyFlatIsNotDegenerate)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1e-300, 0 }, { 0.5, 0, 0 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 1, 3 } };
  EXPECT_EQ(CheckTopology(mesh).Total.DegenerateTriangles, 1);
}

TEST(MeshTopology, BoxesThatShareAnEdgeByIndex)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 1, 1, 0 }, { 2, 2, 1 }));
  EXPECT_EQ(CheckTopology(mesh).Total.Components, 2);
  ExpectManifold(mesh);
  const MeshTopology welded = CheckTopology(WeldPoints(mesh));
  EXPECT_EQ(welded.Total.Components, 1);
  EXPECT_EQ(welded.Total.OverusedEdges, 1);
  EXPECT_TRUE(welded.Total.Closed) << "four triangles an edge bound nothing";
  EXPECT_TRUE(welded.Total.Oriented);
  EXPECT_EQ(welded.Total.PinchedVertices, 0);
  EXPECT_FALSE(welded.Total.Genus.has_value());
}

TEST(MeshTopology, WeldingGivesASoupItsConnectivity)
{
  const TriangleMesh cube = MakeCube();
  TriangleMesh soup;
  for (const auto& t : cube.Triangles)
  {
    for (const int p : t)
    {
      soup.Points.push_back(cube.Points[p]);
      if (soup.Points.back()[0] == 0 && soup.Points.size() % 2 != 0)
      {
        soup.Points.back()[0] = -0.0; // equals 0
      }
    }
    const int n = static_cast<int>(soup.Points.size());
    soup.Triangles.push_back({ n - 3, n - 2, n - 1 });
  }
  EXPECT_EQ(CheckTopology(soup).Total.Components, 12);
  EXPECT_EQ(CheckTopology(soup).Total.OpenEdges, 36);
  ExpectSound(WeldPoints(soup), { 1, 2, 0 });
}

TEST(MeshTopology, NothingIsNotClosed)
{
  const MeshTopology topology = CheckTopology(TriangleMesh());
  EXPECT_FALSE(topology.Total.Closed);
  EXPECT_FALSE(topology.Total.Outward);
  EXPECT_EQ(topology.Total.Components, 0);
}

TEST(MeshTopologyInvalid, RefusesWhatIsNoMesh)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles[5][1] = 8;
  EXPECT_THROW(CheckTopology(mesh), Error);
  mesh.Triangles[5][1] = -1;
  EXPECT_THROW(CheckTopology(mesh), Error);
  EXPECT_THROW(WeldPoints(mesh), Error);
  mesh = MakeCube();
  mesh.Points[3][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CheckTopology(mesh), Error);
  Monitor monitor;
  EXPECT_THROW(FindSelfIntersections(mesh, monitor), Error);
}
