// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/EvenMesh.h"

#include "Base/Median.h"
#include "Core/Mesh/MeshInvariants.h"
#include "Core/Mesh/MeshShapes.h"
#include "Fair/EvenPasses.h"
#include "Mesh/MassProperties.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Of a given length, closed, of one genus, with angles that are not small.
void ExpectEven(const TriangleMesh& given, double edgeLength)
{
  Monitor monitor;
  const EvenMesh even = MakeEvenMesh(given, {}, {}, edgeLength, 1, monitor);
  EXPECT_EQ(even.Crossing, 0);
  const TopologyFigures figures = CheckTopology(even.Mesh).Total;
  EXPECT_TRUE(figures.Closed && figures.Manifold() && figures.Outward);
  EXPECT_EQ(figures.Euler, CheckTopology(given).Total.Euler);
  EXPECT_GT(ComputeSmallestAngle(even.Mesh), FairLeastAngle);
  std::vector<double> lengths;
  for (const auto& t : even.Mesh.Triangles)
  {
    lengths.push_back(Norm(even.Mesh.Points[t[1]] - even.Mesh.Points[t[0]]));
  }
  EXPECT_NEAR(Median(lengths), edgeLength, 0.3 * edgeLength);
}
}

TEST(EvenMesh, OfLongAndOfShortTriangles)
{
  const TriangleMesh torus = MakeTorus(3, 1, 300, 8); // six times as long as wide
  ExpectEven(torus, 0.3);
  ExpectEven(torus, 0.15);
}

TEST(EvenMesh, OfACube)
{
  ExpectEven(MakeCube(), 0.2);
}

TEST(EvenMesh, DoesNotDependOnTheThreads)
{
  Monitor monitor;
  const TriangleMesh torus = MakeTorus(3, 1, 100, 8);
  const EvenMesh one = MakeEvenMesh(torus, {}, {}, 0.2, 1, monitor);
  const EvenMesh four = MakeEvenMesh(torus, {}, {}, 0.2, 4, monitor);
  EXPECT_EQ(one.Mesh.Points, four.Mesh.Points);
  EXPECT_EQ(one.Mesh.Triangles, four.Mesh.Triangles);
}

TEST(EvenMesh, SheetsThatAreNearDoNotCross)
{
  // Two cubes a hundredth of an edge apart.
  TriangleMesh both = MakeCube();
  TriangleMesh other = MakeCube();
  Move(other, { 1.002, 0, 0 });
  Append(both, other);
  Monitor monitor;
  const EvenMesh even = MakeEvenMesh(both, {}, {}, 0.2, 1, monitor);
  EXPECT_EQ(even.Crossing, 0);
  EXPECT_EQ(CheckTopology(even.Mesh).Total.Euler, 4);
}

TEST(EvenMesh, KeepsPlaces)
{
  // Much finer than the edges that are asked for.
  const TriangleMesh torus = MakeTorus(3, 1, 200, 60);
  Monitor monitor;
  const auto farthest = [&](const PlacesToKeep& keep)
  {
    const EvenMesh even = MakeEvenMesh(torus, {}, keep, 0.8, 1, monitor);
    EXPECT_EQ(even.Crossing, 0);
    EXPECT_EQ(CheckTopology(even.Mesh).Total.Euler, 0);
    const TriangleTree tree(even.Mesh);
    double most = 0;
    for (std::size_t p = 0; p < torus.Points.size(); p += 10)
    {
      most = std::max(most, tree.DistanceTo(torus.Points[p], 10));
    }
    return most;
  };
  PlacesToKeep keep;
  EXPECT_GT(farthest(keep), 0.02);
  for (std::size_t p = 0; p < torus.Points.size(); p += 10)
  {
    keep.Places.push_back(torus.Points[p]);
  }
  for (const double within : { 0.02, 0.005, 0.0 })
  {
    keep.Within = within;
    EXPECT_LE(farthest(keep), within);
  }
}

TEST(EvenMesh, MendsWholeClustersOfSlivers)
{
  // A band of a torus pressed to a thirtieth of its width: each triangle there has slivers on all sides.
  Monitor monitor;
  TriangleMesh torus = MakeEvenMesh(MakeTorus(3, 1, 100, 30), {}, {}, 0.2, 1, monitor).Mesh;
  for (Point3& p : torus.Points)
  {
    const double around = std::hypot(p[0], p[1]);
    const double angle = std::atan2(p[1], p[0]);
    const double pressed = angle < 0 || angle > 0.6 ? angle
      : angle < 0.3                                 ? angle / 30
                                                    : 0.01 + (angle - 0.3) * 0.59 / 0.3;
    p = { around * std::cos(pressed), around * std::sin(pressed), p[2] };
  }
  const double degrees = FairLeastAngle;
  ASSERT_LT(ComputeSmallestAngle(torus), 0.5 * degrees);
  const TriangleMesh mended = MendMesh(torus, {}, {}, 0.2, 1, monitor);
  EXPECT_GT(ComputeSmallestAngle(mended), degrees);
  ExpectSoundSurface(mended);
  EXPECT_EQ(CheckTopology(mended).Total.Euler, 0);
  const auto volumeOf = [](const TriangleMesh& mesh)
  { return ComputeSignedVolumes(mesh, std::vector<int>(mesh.Triangles.size(), 0), 1).front(); };
  EXPECT_NEAR(volumeOf(mended), volumeOf(torus), 0.01 * volumeOf(torus));
}

TEST(EvenPasses, SplittingKeepsTheShape)
{
  const TriangleMesh cube = MakeCube();
  const SurfacePlaces surface(cube);
  Monitor monitor;
  EvenPasses passes(cube, {}, &surface, {}, 0.25, 1, monitor);
  passes.SplitLong();
  const TriangleMesh made = passes.Mesh.Compact();
  EXPECT_GT(made.Triangles.size(), 200u);
  ExpectVolume(made, 1, 1e-12);
}

TEST(EvenMesh, KeepsTheCreaseBetweenTwoParts)
{
  // The top of the cube is a part of its own: all points of its rim stay on it.
  const TriangleMesh cube = MakeCube();
  std::vector<char> parts;
  double high = 0;
  for (const Point3& p : cube.Points)
  {
    high = std::max(high, p[2]);
  }
  const auto isOnTop = [&](const TriangleMesh& mesh, const std::array<int, 3>& t)
  {
    return std::all_of(
      t.begin(), t.end(), [&](int v) { return std::abs(mesh.Points[v][2] - high) < 1e-9; });
  };
  for (const auto& t : cube.Triangles)
  {
    parts.push_back(isOnTop(cube, t) ? 1 : 0);
  }
  Monitor monitor;
  const EvenMesh even = MakeEvenMesh(cube, parts, {}, 0.2, 1, monitor);
  ASSERT_EQ(even.Parts.size(), even.Mesh.Triangles.size());
  double area = 0;
  for (std::size_t t = 0; t < even.Parts.size(); ++t)
  {
    const auto& corners = even.Mesh.Triangles[t];
    EXPECT_EQ(even.Parts[t] != 0, isOnTop(even.Mesh, corners));
    const Point3& a = even.Mesh.Points[corners[0]];
    area += even.Parts[t]
      ? 0.5 * Norm(Cross(even.Mesh.Points[corners[1]] - a, even.Mesh.Points[corners[2]] - a))
      : 0;
  }
  EXPECT_NEAR(area, 1, 1e-9);
}

TEST(EvenPasses, GoThroughNoSmallPiece)
{
  // A twisted sheet whose diagonals all run the wrong way, and between those of one square a piece that
  // is much smaller: a flip there crosses nothing.
  const auto diagonalStays = [](bool withPiece)
  {
    constexpr int Side = 6;
    TriangleMesh sheet;
    for (int j = 0; j < Side; ++j)
    {
      for (int i = 0; i < Side; ++i)
      {
        sheet.Points.push_back({ i + 0.6 * j, 1.0 * j, 0.2 * i * j });
      }
    }
    for (int j = 0; j + 1 < Side; ++j)
    {
      for (int i = 0; i + 1 < Side; ++i)
      {
        const int p = Side * j + i;
        sheet.Triangles.push_back({ p, p + 1, p + Side + 1 });
        sheet.Triangles.push_back({ p, p + Side + 1, p + Side });
      }
    }
    const int from = 2 * Side + 2;
    const int to = from + Side + 1;
    if (withPiece)
    {
      TriangleMesh piece = MakeSphere(8, 4);
      const Point3 middle = 0.25 *
        ((sheet.Points[from] + sheet.Points[to]) +
          (sheet.Points[from + 1] + sheet.Points[from + Side]));
      for (Point3& p : piece.Points)
      {
        p = middle + 0.01 * p;
      }
      Append(sheet, piece);
    }
    Monitor monitor;
    const SurfacePlaces surface(sheet);
    EvenPasses passes(sheet, {}, &surface, {}, 1, 1, monitor);
    std::fill(passes.Thin.begin(), passes.Thin.end(), 1);
    passes.Flip();
    return passes.Mesh.Find(from, to).first >= 0;
  };
  EXPECT_FALSE(diagonalStays(false));
  EXPECT_TRUE(diagonalStays(true));
}
