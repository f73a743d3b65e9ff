// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that touch in points and edges, drawn apart.
#include "Core/Polyhedral/PolyhedralShapes.h"
#include "Core/Polyhedral/SurfaceInvariants.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/PinchGap.h"

#include <gtest/gtest.h>

#include <ctime>
#include <map>
#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
/// The mesh as a file without indices gives it back: points of one place are one.
TriangleMesh Welded(const TriangleMesh& mesh)
{
  TriangleMesh welded;
  std::map<Point3, int> numbers;
  for (const auto& corners : mesh.Triangles)
  {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point3& p = mesh.Points[corners[k]];
      const auto found = numbers.emplace(p, static_cast<int>(welded.Points.size()));
      if (found.second)
      {
        welded.Points.push_back(p);
      }
      triangle[k] = found.first->second;
    }
    welded.Triangles.push_back(triangle);
  }
  return welded;
}

void ExpectManifoldWhenWelded(const TriangleMesh& mesh)
{
  const TriangleMesh welded = Welded(mesh);
  EXPECT_EQ(welded.Points.size(), mesh.Points.size());
  ExpectClosed(welded);
  ExpectManifold(welded);
  ExpectOriented(welded);
  ExpectNoSelfIntersections(welded);
}

/// Appends a tetrahedron that is outward oriented.
void AddTetrahedron(TriangleMesh& mesh, std::array<Point3, 4> p)
{
  if (Dot(p[1] - p[0], Cross(p[2] - p[0], p[3] - p[0])) < 0)
  {
    std::swap(p[2], p[3]);
  }
  const int first = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), p.begin(), p.end());
  for (const std::array<int, 3>& face :
    { std::array<int, 3>{ 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } })
  {
    mesh.Triangles.push_back({ first + face[0], first + face[1], first + face[2] });
  }
}

ContourSet PixelSquaresThatTouch()
{
  RingStack levels;
  for (int i = 0; i < 3; ++i)
  {
    levels.push_back({ Rectangle(0, 0, 1, 1), Rectangle(1, 1, 2, 2) });
  }
  return BuildStack(levels);
}
}

TEST(PinchGap, WedgesThatTouchInAPoint)
{
  TriangleMesh mesh;
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } });
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } } });
  Monitor monitor;
  const PinchGapResult result = OpenPinches(mesh, 1e-3, { 0, 0, 0 }, monitor);
  EXPECT_EQ(result.Places, 1u);
  EXPECT_EQ(result.Left, 0u);
  ExpectManifoldWhenWelded(mesh);
  EXPECT_EQ(std::count(mesh.Points.begin(), mesh.Points.end(), Point3{ 0, 0, 0 }), 1);
}

TEST(PinchGap, WedgesThatTouchInAnEdge)
{
  TriangleMesh mesh;
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 } } });
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { -1, -1, 0 } } });
  Monitor monitor;
  const PinchGapResult result = OpenPinches(mesh, 1e-3, { 0, 0, 0 }, monitor);
  EXPECT_EQ(result.Places, 2u);
  EXPECT_EQ(result.Left, 0u);
  ExpectManifoldWhenWelded(mesh);
}

TEST(PinchGap, MovesNoFurtherThanTheGap)
{
  TriangleMesh mesh;
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } });
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } } });
  const TriangleMesh before = mesh;
  Monitor monitor;
  OpenPinches(mesh, 0.01, { 0, 0, 0 }, monitor);
  int moved = 0;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const double way = Norm(mesh.Points[i] - before.Points[i]);
    EXPECT_LE(way, 0.01 * (1 + 1e-12));
    moved += way > 0 ? 1 : 0;
  }
  EXPECT_EQ(moved, 1);
  EXPECT_EQ(mesh.Triangles, before.Triangles);
}

namespace
{
constexpr std::array<Point3, 4> Flat{ Point3{ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
  { 0.3, 0.3, 1e-4 } };

/// A flat piece each of whose corners is the tip of a needle, too; needles have less room, and stay.
TriangleMesh FlatPieceWithNeedles()
{
  const std::array<Vector3, 4> away{ Vector3{ -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 },
    { 0, 0, 1 } };
  TriangleMesh mesh;
  AddTetrahedron(mesh, Flat);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Point3 end = Flat[i] + away[i];
    AddTetrahedron(
      mesh, { Flat[i], end, end + Vector3{ 1e-6, 0, 0 }, end + Vector3{ 0, 1e-6, 0 } });
  }
  return mesh;
}
}

TEST(PinchGap, DoesNotTurnAThinPieceInsideOut)
{
  TriangleMesh mesh = FlatPieceWithNeedles();
  ASSERT_TRUE(CheckTopology(mesh).Total.Outward);
  Monitor monitor;
  EXPECT_EQ(OpenPinches(mesh, 0.01, { 0, 0, 0 }, monitor).Places, 4u);
  EXPECT_TRUE(CheckTopology(mesh).Total.Outward);
  ExpectNoSelfIntersections(mesh);
}

TEST(PinchGap, APointOfNoTriangleIsOfNoPiece)
{
  TriangleMesh mesh = FlatPieceWithNeedles();
  mesh.Points.push_back(Flat[0]);
  Monitor monitor;
  OpenPinches(mesh, 0.01, { 0, 0, 0 }, monitor);
  EXPECT_TRUE(CheckTopology(mesh).Total.Outward);
  ExpectNoSelfIntersections(mesh);
}

TEST(PinchGap, LeavesWhatTouchesNowhere)
{
  TriangleMesh mesh;
  AddTetrahedron(mesh, { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } });
  const TriangleMesh before = mesh;
  Monitor monitor;
  const PinchGapResult result = OpenPinches(mesh, 0.1, { 0, 0, 0 }, monitor);
  EXPECT_EQ(result.Places, 0u);
  EXPECT_EQ(mesh.Points, before.Points);
}

TEST(PinchGap, PixelSquaresThatTouchInACornerAreManifoldInAFileWithoutIndices)
{
  PolyhedralOptions options;
  const ContourSet contours = PixelSquaresThatTouch();
  EXPECT_NE(Welded(BuildSurface(contours, options).Mesh).Points.size(),
    BuildSurface(contours, options).Mesh.Points.size());
  options.PinchGap = 1e-3;
  const PolyhedralSurface surface = BuildSurface(contours, options);
  ExpectManifoldWhenWelded(surface.Mesh);
  ExpectContourVertices(surface, contours);
  ASSERT_FALSE(surface.Report.empty());
  EXPECT_NE(surface.Report.back().find("drawn apart"), std::string::npos);
}

TEST(PinchGap, EmptyWedgesThatTouchAreDrawnApartAsWell)
{
  // Two holes that share a corner within one square: the solid is around both.
  RingStack levels;
  for (int i = 0; i < 3; ++i)
  {
    levels.push_back({ Rectangle(0, 0, 6, 6), Rectangle(2, 2, 3, 3), Rectangle(3, 3, 4, 4) });
  }
  PolyhedralOptions options;
  options.PinchGap = 1e-3;
  const ContourSet contours = BuildStack(levels);
  const PolyhedralSurface surface = BuildSurface(contours, options);
  ExpectManifoldWhenWelded(surface.Mesh);
  ExpectContourVertices(surface, contours);
}

TEST(PinchGap, RandomStacksAreManifoldInAFileWithoutIndices)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const ContourSet contours = BuildStack(RandomStack(seed));
    PolyhedralOptions options;
    options.Mapping = PolyhedralOptions::Overlap;
    options.IsolatedContours = PolyhedralOptions::Extrude;
    options.PinchGap = 1e-3;
    const PolyhedralSurface surface = BuildSurface(contours, options);
    ExpectContourVertices(surface, contours);
    ExpectManifoldWhenWelded(surface.Mesh);
    options.PinchGap = 0;
    // Sections differ by strips as wide as the gap.
    EXPECT_NEAR(VolumeOf(surface.Mesh), VolumeOf(BuildSurface(contours, options).Mesh),
      1e-2 * VolumeOf(surface.Mesh));
  }
}

TEST(PinchGap, PiecesMuchSmallerThanTheGapTakeNoLongerThanOthers)
{
  // All of them are within one gap of one another, which says nothing about which of them may meet.
  constexpr int Pairs = 2000;
  constexpr double Small = 1e-7;
  TriangleMesh mesh;
  AddTetrahedron(mesh, { { { -9, 0, 0 }, { -8, 0, 0 }, { -9, 1, 0 }, { -9, 0, 1 } } });
  for (int i = 0; i < Pairs; ++i)
  {
    const Point3 o{ 4 * Small * (i % 50), 4 * Small * (i / 50), 0 };
    for (const double s : { Small, -Small })
    {
      AddTetrahedron(
        mesh, { { o, o + Vector3{ s, 0, 0 }, o + Vector3{ 0, s, 0 }, o + Vector3{ 0, 0, s } } });
    }
  }
  Monitor monitor;
  // Of the processor, as other tests may run beside this one.
  const std::clock_t start = std::clock();
  const PinchGapResult result = OpenPinches(mesh, 1e-3, { 0, 0, 0 }, monitor);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 5);
  EXPECT_EQ(result.Places, static_cast<std::size_t>(Pairs));
  EXPECT_EQ(result.Left, 0u);
  ExpectManifoldWhenWelded(mesh);
}

TEST(PinchGap, NoSheetIsMovedPastAPieceThinnerThanTheGap)
{
  // A prism with a lid on its top, whose corners they share, and a cavity so near below the top that its corners cannot
  // go down. Up, they would go past the lid.
  TriangleMesh mesh;
  const auto addPrism = [&mesh](double size, double low, double high, bool isCavity)
  {
    const int first = static_cast<int>(mesh.Points.size());
    for (const double z : { low, high })
    {
      mesh.Points.insert(
        mesh.Points.end(), { { -2 * size, -size, z }, { 2 * size, -size, z }, { 0, 2 * size, z } });
    }
    for (std::array<int, 3> t : std::vector<std::array<int, 3>>{ { 0, 2, 1 }, { 3, 4, 5 },
           { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 }, { 2, 0, 3 }, { 2, 3, 5 } })
    {
      if (isCavity)
      {
        std::swap(t[1], t[2]);
      }
      mesh.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
  };
  addPrism(1, -1, 0, false);
  addPrism(0.8, -0.5, -0.001, true);
  mesh.Points.insert(mesh.Points.end(),
    { mesh.Points[3], mesh.Points[4], mesh.Points[5], { 0, 0, 1e-4 }, { 0, 0, 1e-3 } });
  for (int k = 0; k < 3; ++k)
  {
    mesh.Triangles.push_back({ 12 + (k + 1) % 3, 12 + k, 15 });
    mesh.Triangles.push_back({ 12 + k, 12 + (k + 1) % 3, 16 });
  }
  ASSERT_TRUE(CheckTopology(mesh).Total.Outward);
  Monitor monitor;
  const PinchGapResult result = OpenPinches(mesh, 0.05, { 0, 0, 0 }, monitor);
  EXPECT_EQ(result.Places, 3u);
  EXPECT_TRUE(CheckTopology(mesh).Total.Outward);
}
