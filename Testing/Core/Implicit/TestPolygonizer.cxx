// SPDX-License-Identifier: GPL-3.0-or-later
// The zero set as triangles: closed, manifold, outward, without slivers, on the surface, seeded
// components only.
#include "Core/Mesh/MeshInvariants.h"
#include "Implicit/ImplicitSurface.h"
#include "ImplicitShapes.h"
#include "Mesh/TriangleTree.h"

#include <random>
#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
ContourFit Fit(const ContourSet& contours)
{
  Monitor monitor;
  return FitContours(contours, ConstraintOptions(), FunctionOptions(), monitor);
}

ImplicitMesh Mesh(const ContourFit& fit, const PolygonizerOptions& options = {})
{
  Monitor monitor;
  return Polygonize(fit.Function, SeedsOf(fit.Contours), options, monitor);
}

int EulerOf(const TriangleMesh& mesh)
{
  return CheckTopology(mesh).Total.Euler;
}

const ContourFit& Ball()
{
  static const ContourFit fit = Fit(handmade::SphereSlices({ 30, -20, 500 }, 10, 9, 36));
  return fit;
}
}

TEST(Polygonizer, SphereIsSoundAndRound)
{
  const ImplicitMesh ball = Mesh(Ball());
  ExpectSoundSurface(ball.Mesh);
  EXPECT_EQ(EulerOf(ball.Mesh), 2);
  EXPECT_GE(ball.SmallestAngle, 1);
  EXPECT_TRUE(ball.Report.empty()) << ball.Report.front();
  ASSERT_EQ(ball.Normals.size(), ball.Mesh.Points.size());
  for (std::size_t i = 0; i < ball.Mesh.Points.size(); ++i)
  {
    const Vector3 out = ball.Mesh.Points[i] - Point3{ 30, -20, 500 };
    EXPECT_NEAR(Norm(out), 10, 0.15);
    EXPECT_GT(Dot(out, ball.Normals[i]), 9.5);
    EXPECT_NEAR(Norm(ball.Normals[i]), 1, 1e-12);
  }
}

TEST(Polygonizer, EveryVertexIsOnTheZeroSet)
{
  for (const bool clean : { false, true })
  {
    PolygonizerOptions options;
    options.CleanUp = clean;
    options.CellSize = 1;
    const ImplicitMesh ball = Mesh(Ball(), options);
    ExpectClosed(ball.Mesh);
    ExpectManifold(ball.Mesh);
    const std::vector<double> f = Ball().Function.Evaluate(ball.Mesh.Points, 0);
    const std::vector<Vector3> g = Ball().Function.EvaluateGradients(ball.Mesh.Points, 0);
    for (std::size_t i = 0; i < f.size(); ++i)
    {
      EXPECT_LT(std::abs(f[i]) / Norm(g[i]), 2e-6);
    }
  }
}

TEST(Polygonizer, BoundsCloseOrCut)
{
  PolygonizerOptions options;
  options.Box = Bounds{ 25, 45, -40, 0, 480, 504 };
  options.CellSize = 0.5;
  const ImplicitMesh closed = Mesh(Ball(), options);
  ExpectSoundSurface(closed.Mesh);
  EXPECT_EQ(EulerOf(closed.Mesh), 2);
  EXPECT_GE(closed.SmallestAngle, 1);
  for (const Point3& p : closed.Mesh.Points)
  {
    EXPECT_GE(p[0], 25 - 1e-6);
    EXPECT_LE(p[2], 504 + 1e-6);
  }
  options.ClosedAtBounds = false;
  const ImplicitMesh open = Mesh(Ball(), options);
  ExpectManifold(open.Mesh);
  const TopologyFigures total = CheckTopology(open.Mesh).Total;
  EXPECT_GT(total.OpenEdges, 0);
  EXPECT_EQ(total.MisorientedEdges, 0);
  EXPECT_EQ(total.Euler, 1);
  EXPECT_GE(open.SmallestAngle, 1);
}

TEST(Polygonizer, OnlyWhatSeedsTouch)
{
  // Two balls; seeds of one only.
  const ContourSet two = handmade::SphereSlices({ 0, 0, 0 }, 5, 7, 24);
  const ContourSet other = handmade::SphereSlices({ 14, 0, 0 }, 5, 7, 24);
  handmade::Maker maker;
  for (std::size_t l = 0; l < two.Levels.size(); ++l)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, two.Levels[l].Offset);
    for (const ContourSet* set : { &two, &other })
    {
      std::vector<Point3> loop;
      for (const int p : set->Contours[l].Points)
      {
        loop.push_back(set->Points[static_cast<std::size_t>(p)]);
      }
      maker.AddContour(level, loop);
    }
  }
  const ContourFit fit = Fit(maker.Finish());
  ImplicitMesh both = Mesh(fit);
  ExpectSoundSurface(both.Mesh);
  EXPECT_EQ(CheckTopology(both.Mesh).Total.Components, 2);
  Monitor monitor;
  PolygonizerOptions options;
  options.Box = Bounds{ -8, 22, -8, 8, -8, 8 };
  const ImplicitMesh one = Polygonize(fit.Function, SeedsOf(two), options, monitor);
  ExpectSoundSurface(one.Mesh);
  EXPECT_EQ(CheckTopology(one.Mesh).Total.Components, 1);
}

TEST(Polygonizer, NoNeedlesWhereWallsAreThinnerThanCells)
{
  // Two rods whose gap is a third of a cell, cut off by the bounds: normals there say nothing.
  handmade::Maker maker;
  for (int i = 0; i < 6; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 2.0 * i);
    maker.AddCircle(level, { -3.15 - 0.03 * i, 0 }, 3, 30, 0.05 * i);
    maker.AddCircle(level, { 3.15, 0.1 * i }, 3, 30);
  }
  const ContourFit rods = Fit(maker.Finish());
  for (const double size : { 0.5, 0.63, 0.81, 0.97, 1.1 })
  {
    PolygonizerOptions options;
    options.CellSize = size;
    options.Box = Bounds{ -6.05, 6.1, -4, 4, -0.03, 10.04 };
    const ImplicitMesh mesh = Mesh(rods, options);
    ExpectSoundSurface(mesh.Mesh);
    EXPECT_GE(mesh.SmallestAngle, 1) << size;
  }
}

TEST(Polygonizer, MazesStaySound)
{
  // A function through random values: necks, walls and gaps of any width below a cell.
  std::size_t triangles = 0;
  int needles = 0;
  for (int seed = 0; seed < 12; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 1);
    std::vector<Point3> points;
    std::vector<double> values;
    for (int k = 0; k < 400; ++k)
    {
      points.push_back({ place(random), place(random), place(random) });
      values.push_back(k % 3 - 1);
    }
    Monitor monitor;
    const ImplicitFunction maze = FitImplicitFunction(points, values, FunctionOptions(), monitor);
    PolygonizerOptions options;
    options.Box = Bounds{ -1, 1, -1, 1, -1, 1 };
    options.CellSize = 0.1 + 0.005 * seed;
    const ImplicitMesh mesh = Polygonize(maze, SeedsOf(maze), options, monitor);
    ExpectSoundSurface(mesh.Mesh);
    // A neck that the bounds cut may keep a needle: the rim does not move off the bounds.
    EXPECT_GE(mesh.SmallestAngle, 0.9) << "seed " << seed;
    needles += mesh.SmallestAngle < 1 ? 1 : 0;
    EXPECT_TRUE(mesh.SmallestAngle >= 1 || !mesh.Report.empty()) << "which is told";
    triangles += mesh.Mesh.Triangles.size();
  }
  EXPECT_GT(triangles, 30000u);
  EXPECT_LE(needles, 1);
}

TEST(Polygonizer, SmallerCellsWhereAGapWouldBeMissed)
{
  // Two blocks with a slit between them that is narrower than a cell, so that there need be no
  // corner in it.
  handmade::Maker maker;
  for (int i = 0; i < 3; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, i);
    for (const double side : { -1.0, 1.0 })
    {
      const double low = side < 0 ? -2 : 0.025;
      const double high = side < 0 ? -0.025 : 2;
      std::vector<Point3> loop;
      for (int k = 0; k < 10; ++k)
      {
        loop.push_back({ low, 1 - k / 5.0, static_cast<double>(i) });
      }
      for (int k = 0; k < 10; ++k)
      {
        loop.push_back({ high, -1 + k / 5.0, static_cast<double>(i) });
      }
      maker.AddContour(level, loop);
    }
  }
  const ContourFit blocks = Fit(maker.Finish());
  const std::vector<Point3> seeds = SeedsOf(blocks.Contours);
  int missed = 0;
  for (int shift = 0; shift < 2; ++shift)
  {
    PolygonizerOptions options;
    // One cell more puts the slit between two planes of corners, or into one.
    const double side = 2.5 + 0.5 * shift * ChooseCellSize(seeds, 0);
    options.Box = Bounds{ -side, side, -1.5, 1.5, -0.5, 2.5 };
    const ImplicitMesh mesh = Mesh(blocks, options);
    ExpectSoundSurface(mesh.Mesh);
    EXPECT_GE(mesh.SmallestAngle, 1);
    EXPECT_TRUE(mesh.Report.empty()) << mesh.Report.front();
    const TriangleTree tree(mesh.Mesh);
    for (const Point3& seed : seeds)
    {
      EXPECT_LE(tree.DistanceTo(seed, 10), mesh.CellSize);
    }
    // A size that was asked for is kept, and what it misses is told.
    options.CellSize = ChooseCellSize(seeds, 0);
    const ImplicitMesh asked = Mesh(blocks, options);
    EXPECT_EQ(asked.CellSize, options.CellSize);
    EXPECT_LE(mesh.CellSize, asked.CellSize);
    EXPECT_EQ(asked.Report.empty(), mesh.CellSize == asked.CellSize);
    missed += asked.Report.empty() ? 0 : 1;
  }
  EXPECT_GT(missed, 0);
}

TEST(Polygonizer, FlatEndsAreCutExactlyAtTheBounds)
{
  // A column that goes on beyond the bounds: its ends are discs of the same circle.
  handmade::Maker maker;
  for (int i = 0; i < 5; ++i)
  {
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 2.0 * i), { 0, 0 }, 4, 48);
  }
  const ContourFit column = Fit(maker.Finish());
  for (const bool cleanUp : { false, true })
  {
    PolygonizerOptions options;
    options.CellSize = 0.7;
    options.CleanUp = cleanUp;
    options.Box = Bounds{ -5, 5, -5, 5, 0.53, 7.31 };
    const ImplicitMesh mesh = Mesh(column, options);
    ExpectSoundSurface(mesh.Mesh);
    double area = 0;
    for (const auto& t : mesh.Mesh.Triangles)
    {
      const std::array<Point3, 3> p{ mesh.Mesh.Points[t[0]], mesh.Mesh.Points[t[1]],
        mesh.Mesh.Points[t[2]] };
      const bool isEnd = p[0][2] == 7.31 && p[1][2] == 7.31 && p[2][2] == 7.31;
      area += isEnd ? 0.5 * Norm(Cross(p[1] - p[0], p[2] - p[0])) : 0;
      // No step beside the rim: what is not of an end stands upright.
      const Vector3 normal = Cross(p[1] - p[0], p[2] - p[0]);
      const bool isFlat = isEnd || (p[0][2] == 0.53 && p[1][2] == 0.53 && p[2][2] == 0.53);
      EXPECT_TRUE(isFlat || std::abs(normal[2]) < 0.25 * Norm(normal));
    }
    EXPECT_NEAR(area, 3.14159265 * 16, 0.01 * 3.14159265 * 16);
    if (cleanUp)
    {
      EXPECT_GE(mesh.SmallestAngle, 1);
    }
  }
}

TEST(Polygonizer, DetailSetsTheCells)
{
  const double diagonal = DiagonalOf(BoundsOf(SeedsOf(Ball().Contours)));
  PolygonizerOptions options;
  options.Detail = PolygonizerOptions::Coarse;
  const ImplicitMesh coarse = Mesh(Ball(), options);
  ExpectSoundSurface(coarse.Mesh);
  EXPECT_DOUBLE_EQ(coarse.CellSize, diagonal / 50);
  ASSERT_EQ(coarse.Report.size(), 1u);
  EXPECT_NE(coarse.Report.front().find("preview"), std::string::npos);
  options.Detail = PolygonizerOptions::Medium;
  const ImplicitMesh medium = Mesh(Ball(), options);
  ExpectSoundSurface(medium.Mesh);
  EXPECT_DOUBLE_EQ(medium.CellSize, std::max(diagonal / 100, Mesh(Ball()).CellSize));
  EXPECT_GE(medium.SmallestAngle, 1);
}

TEST(Polygonizer, SnapsContourPoints)
{
  PolygonizerOptions options;
  options.SnapToSeeds = true;
  options.CellSize = 0.8;
  const ImplicitMesh ball = Mesh(Ball(), options);
  ExpectSoundSurface(ball.Mesh);
  EXPECT_GE(ball.SmallestAngle, 1);
  const std::set<Point3> points(ball.Mesh.Points.begin(), ball.Mesh.Points.end());
  std::size_t snapped = 0;
  for (const Point3& seed : SeedsOf(Ball().Contours))
  {
    snapped += points.count(seed);
  }
  EXPECT_GT(snapped, Ball().Contours.Points.size() * 2 / 3);
}

TEST(Polygonizer, ThreadsDoNotChangeTheMesh)
{
  PolygonizerOptions options;
  options.CellSize = 1;
  options.Threads = 1;
  const ImplicitMesh one = Mesh(Ball(), options);
  options.Threads = 5;
  const ImplicitMesh five = Mesh(Ball(), options);
  EXPECT_EQ(one.Mesh.Points, five.Mesh.Points);
  EXPECT_EQ(one.Mesh.Triangles, five.Mesh.Triangles);
}

TEST(PolygonizerInvalid, EachBadOptionHasItsSentence)
{
  PolygonizerOptions options;
  for (const double size : { -1.0, std::nan(""), HUGE_VAL })
  {
    options.CellSize = size;
    EXPECT_THROW(Mesh(Ball(), options), Error);
  }
  options.CellSize = 1e-5;
  try
  {
    Mesh(Ball(), options);
    ADD_FAILURE() << "an absurd cell size was taken";
  }
  catch (const Error& error)
  {
    // It says how many cells it would take: 1.5 * 6 * 20 * 20 / 1e-10, about.
    EXPECT_NE(std::string(error.what()).find("e+13 cells"), std::string::npos) << error.what();
  }
  options = PolygonizerOptions();
  options.Box = Bounds{ 0, 0, 0, 1, 0, 1 };
  EXPECT_THROW(Mesh(Ball(), options), Error);
  options.Box = Bounds{ 1000, 1001, 0, 1, 0, 1 };
  EXPECT_THROW(Mesh(Ball(), options), Error);
  ImplicitFunction empty;
  Monitor monitor;
  EXPECT_THROW(Polygonize(empty, SeedsOf(Ball().Contours), PolygonizerOptions(), monitor), Error);
  EXPECT_THROW(Polygonize(Ball().Function, {}, PolygonizerOptions(), monitor), Error);
}
