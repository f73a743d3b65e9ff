// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionComparison.h"
#include "Mesh/TriangleTree.h"
#include "MeshShapes.h"
#include "Planar/PlanarDifference.h"

#include <gtest/gtest.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <limits>
#include <random>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

using namespace recon;
using namespace recon::testing;

namespace
{
using Ring = std::vector<Point2>;

Ring Square(double x, double y, double size)
{
  return { { x, y }, { x + size, y }, { x + size, y + size }, { x, y + size } };
}

void AddRing(const Ring& ring, PlanarRegions::LayerType layer, PlanarRegions& regions)
{
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    regions.Segments.push_back({ ring[i], ring[(i + 1) % ring.size()], layer });
  }
}

/// Contours are put on the level as they are; the depth is of no concern here.
void AddLevel(
  const PlanarFrame& frame, double offset, const std::vector<Ring>& rings, ContourSet& set)
{
  const int level = static_cast<int>(set.Levels.size());
  set.Levels.emplace_back();
  set.Levels.back().Frame = frame;
  set.Levels.back().Offset = offset;
  for (const auto& ring : rings)
  {
    Contour contour;
    contour.Level = level;
    for (const auto& p : ring)
    {
      contour.Points.push_back(static_cast<int>(set.Points.size()));
      set.Points.push_back(frame.ToSpace(p, offset));
      set.Planar.push_back(frame.ToPlane(set.Points.back()));
    }
    set.Levels.back().Contours.push_back(static_cast<int>(set.Contours.size()));
    set.Contours.push_back(contour);
  }
}

std::vector<SectionDifference> Compare(
  const TriangleMesh& mesh, const ContourSet& set, double rounding = 0)
{
  Monitor monitor;
  SectionOptions options;
  options.CoordinateRounding = rounding;
  return CompareSections(mesh, set, options, monitor);
}

std::optional<ContourDistance> Distance(const TriangleMesh& mesh, const ContourSet& set)
{
  Monitor monitor;
  return MeasureContourDistance(mesh, TriangleTree(mesh), set, 0, monitor);
}

/// A star-shaped polygon about a point, which is simple.
Ring MakeStar(int count, const Point2& middle, std::mt19937& random)
{
  std::uniform_real_distribution<double> radius(0.5, 1.5);
  Ring ring;
  for (int i = 0; i < count; ++i)
  {
    const double r = radius(random);
    const double a = 2 * Pi * i / count;
    ring.push_back({ middle[0] + r * std::cos(a), middle[1] + r * std::sin(a) });
  }
  return ring;
}

double ExactSymmetricDifference(const Ring& a, const Ring& b)
{
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler notOurs; // CGAL's Boolean operations leave some memory behind
#endif
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Polygon_2<Kernel> p, q;
  for (const auto& x : a)
  {
    p.push_back({ x[0], x[1] });
  }
  for (const auto& x : b)
  {
    q.push_back({ x[0], x[1] });
  }
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  CGAL::symmetric_difference(p, q, std::back_inserter(parts));
  Kernel::FT area = 0;
  for (const auto& part : parts)
  {
    area += part.outer_boundary().area();
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole)
    {
      area += hole->area(); // negative
    }
  }
  return CGAL::to_double(area);
}
}

TEST(PlanarDifference, AgreesWithExactBooleans)
{
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i)
  {
    const Ring a = MakeStar(40, { 0, 0 }, random);
    const Ring b = MakeStar(57, { 0.1 * i, 0.03 * i }, random);
    PlanarRegions regions;
    AddRing(a, PlanarRegions::Below, regions);
    AddRing(b, PlanarRegions::Contour, regions);
    const PlanarDifference measured = MeasurePlanarDifference(regions);
    EXPECT_TRUE(measured.SurfaceIsClosed);
    EXPECT_NEAR(measured.SymmetricDifference, ExactSymmetricDifference(a, b), 1e-12);
  }
}

TEST(PlanarDifference, LayersOfTheSurfaceAreUnited)
{
  PlanarRegions regions;
  AddRing(Square(0, 0, 2), PlanarRegions::Below, regions);
  AddRing(Square(1, 0, 2), PlanarRegions::Above, regions);
  AddRing(Square(1.5, 0.5, 3), PlanarRegions::InPlane, regions);
  AddRing(Square(2, 1, 1), PlanarRegions::InPlane, regions); // covered twice
  const PlanarDifference measured = MeasurePlanarDifference(regions);
  EXPECT_NEAR(measured.SurfaceArea, 6 + 9 - 1.5 * 1.5, 1e-14);
  EXPECT_EQ(measured.ContourArea, 0);
  EXPECT_NEAR(measured.SymmetricDifference, measured.SurfaceArea, 1e-14);
}

TEST(PlanarDifference, HolesByEvenOdd)
{
  PlanarRegions regions;
  AddRing(Square(0, 0, 3), PlanarRegions::Contour, regions);
  AddRing(Square(1, 1, 1), PlanarRegions::Contour, regions);
  AddRing(Square(0, 0, 3), PlanarRegions::Below, regions);
  const PlanarDifference measured = MeasurePlanarDifference(regions);
  EXPECT_NEAR(measured.ContourArea, 8, 1e-14);
  EXPECT_NEAR(measured.SymmetricDifference, 1, 1e-14);
}

TEST(PlanarDifference, NearlyEqualBordersFarFromTheOrigin)
{
  std::mt19937 random(8);
  const Ring a = MakeStar(500, { 1e6, -1e6 }, random);
  Ring b = a;
  for (auto& p : b)
  {
    p[0] = std::nextafter(p[0], random() % 2 != 0 ? 0.0 : 1e7);
  }
  PlanarRegions regions;
  AddRing(a, PlanarRegions::Below, regions);
  AddRing(b, PlanarRegions::Contour, regions);
  EXPECT_LT(MeasurePlanarDifference(regions).SymmetricDifference, 1e-8);
}

TEST(PlanarDifference, OpenBorderIsNoticed)
{
  PlanarRegions regions;
  AddRing(Square(0, 0, 1), PlanarRegions::Below, regions);
  regions.Segments.erase(regions.Segments.begin() + 1);
  EXPECT_FALSE(MeasurePlanarDifference(regions).SurfaceIsClosed);
}

TEST(SectionComparison, BoxGivesItsSquaresBack)
{
  ContourSet set;
  for (const double z : { 0.0, 0.25, 1.0 }) // the bottom, in between, the top
  {
    AddLevel({}, z, { Square(0, 0, 1) }, set);
  }
  const TriangleMesh mesh = MakeCube();
  for (const auto& level : Compare(mesh, set))
  {
    EXPECT_DOUBLE_EQ(level.ContourArea, 1);
    EXPECT_DOUBLE_EQ(level.SurfaceArea.value(), 1);
    EXPECT_EQ(level.SymmetricDifference.value(), 0);
    EXPECT_EQ(level.Percent.value(), 0);
  }
  EXPECT_EQ(Distance(mesh, set)->FarthestVertex, 0);
  EXPECT_EQ(Distance(mesh, set)->FarthestEdge, 0);
}

TEST(SectionComparison, ShiftedContourIsMeasured)
{
  ContourSet set;
  AddLevel({}, 0.5, { Square(0.25, 0, 1) }, set);
  AddLevel({}, 2, { Square(0, 0, 1) }, set); // above the box
  const auto levels = Compare(MakeCube(), set);
  EXPECT_DOUBLE_EQ(levels[0].SymmetricDifference.value(), 0.5);
  EXPECT_DOUBLE_EQ(levels[0].Percent.value(), 50);
  EXPECT_EQ(levels[1].SurfaceArea.value(), 0);
  EXPECT_DOUBLE_EQ(levels[1].Percent.value(), 100);
  const auto distance = Distance(MakeCube(), set);
  EXPECT_EQ(distance->Vertices, 8);
  EXPECT_DOUBLE_EQ(distance->FarthestVertex, 1);
  EXPECT_DOUBLE_EQ(distance->MeanVertex, (2 * 0.25 + 4 * 1) / 8);
  EXPECT_DOUBLE_EQ(distance->FarthestEdge, 1);
  EXPECT_EQ(distance->FarthestAt[2], 2);
}

TEST(SectionComparison, StepIsSeenFromBothSides)
{
  // 3 x 3 cells below, one on them: the plane between shows 3 x 3.
  const TriangleMesh mesh =
    MakeFromCells({ 3, 3, 2 }, [](int x, int y, int z) { return z == 0 || (x == 1 && y == 1); });
  ContourSet set;
  AddLevel({}, 0, { Square(0, 0, 3) }, set);
  AddLevel({}, 1, { Square(0, 0, 3) }, set);
  AddLevel({}, 1.5, { Square(1, 1, 1) }, set);
  AddLevel({}, 2, { Square(1, 1, 1) }, set);
  for (const auto& level : Compare(mesh, set))
  {
    EXPECT_EQ(level.SymmetricDifference.value(), 0) << level.Level;
  }
}

TEST(SectionComparison, TiltedPlanes)
{
  PlanarFrame frame;
  frame.Normal = (1 / std::sqrt(14.0)) * Vector3{ 1, 2, 3 };
  frame.U = (1 / std::sqrt(5.0)) * Vector3{ 2, -1, 0 };
  frame.V = Cross(frame.Normal, frame.U);
  TriangleMesh mesh =
    MakeFromCells({ 3, 3, 2 }, [](int x, int y, int z) { return z == 0 || (x == 1 && y == 1); });
  for (auto& p : mesh.Points)
  {
    p = frame.ToSpace({ p[0] + 100, p[1] }, p[2] + 50);
  }
  ContourSet set;
  AddLevel(frame, 50, { Square(100, 0, 3) }, set);
  AddLevel(frame, 51, { Square(100, 0, 3) }, set);
  AddLevel(frame, 51.7, { Square(101, 1, 1) }, set);
  AddLevel(frame, 52, { Square(101, 1, 1) }, set);
  for (const auto& level : Compare(mesh, set))
  {
    EXPECT_LT(level.SymmetricDifference.value(), 1e-10) << level.Level;
  }
  EXPECT_LT(Distance(mesh, set)->FarthestEdge, 1e-12);
}

TEST(SectionComparison, PlanesOfSeveralDirections)
{
  ContourSet set;
  AddLevel({}, 0.5, { Square(0, 0, 1) }, set);
  AddLevel({ { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } }, 1, { Square(0, 0, 1) }, set);
  AddLevel({ { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } }, 0.25, { Square(0, 0, 0.5) }, set);
  const auto levels = Compare(MakeCube(), set);
  EXPECT_EQ(levels[0].SymmetricDifference.value(), 0);
  EXPECT_EQ(levels[1].SymmetricDifference.value(), 0);
  EXPECT_DOUBLE_EQ(levels[2].Percent.value(), 300);
}

TEST(SectionComparison, SinglePrecisionSurface)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 0.1 });
  for (auto& p : mesh.Points)
  {
    p[2] = static_cast<float>(p[2]);
  }
  ContourSet set;
  AddLevel({}, 0.1, { Square(0, 0, 1) }, set); // a nanometre off the float's value
  EXPECT_EQ(Compare(mesh, set, 1e-7)[0].SymmetricDifference.value(), 0);
}

TEST(SectionComparison, OpenSurfaceBoundsNothing)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.erase(mesh.Triangles.begin() + 4); // of a wall
  ContourSet set;
  AddLevel({}, 0.5, { Square(0, 0, 1) }, set);
  const auto levels = Compare(mesh, set);
  EXPECT_FALSE(levels[0].SurfaceArea.has_value());
  EXPECT_FALSE(levels[0].SymmetricDifference.has_value());
  EXPECT_FALSE(levels[0].Percent.has_value());
}

TEST(SectionComparison, NothingToCompare)
{
  EXPECT_TRUE(Compare(MakeCube(), ContourSet()).empty());
  EXPECT_FALSE(Distance(MakeCube(), ContourSet()).has_value());
  ContourSet set;
  AddLevel({}, 0.5, { Square(0, 0, 1) }, set);
  EXPECT_FALSE(Distance(TriangleMesh(), set).has_value());
  EXPECT_DOUBLE_EQ(Compare(TriangleMesh(), set)[0].Percent.value(), 100);
}

TEST(TriangleTree, DistanceOfCornersIsExactlyZero)
{
  const TriangleMesh mesh = MakeLinkedTori();
  const TriangleTree tree(mesh);
  for (const auto& p : mesh.Points)
  {
    EXPECT_EQ(tree.DistanceTo(p, std::numeric_limits<double>::infinity()), 0);
  }
}

TEST(TriangleTree, DistanceIsThatOfTheNearestTriangle)
{
  const TriangleMesh mesh = MakeSphere(60, 30);
  const TriangleTree tree(mesh);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (int i = 0; i < 200; ++i)
  {
    const Point3 p{ coordinate(random), coordinate(random), coordinate(random) };
    // The distance to a dense sampling of the surface can only be larger, and not by much.
    double sampled = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.Triangles)
    {
      for (int u = 0; u <= 8; ++u)
      {
        for (int v = 0; u + v <= 8; ++v)
        {
          const Point3 x = (u / 8.0) * mesh.Points[t[0]] +
            ((v / 8.0) * mesh.Points[t[1]] + ((8 - u - v) / 8.0) * mesh.Points[t[2]]);
          sampled = std::min(sampled, Norm(x - p));
        }
      }
    }
    const double distance = tree.DistanceTo(p, std::numeric_limits<double>::infinity());
    EXPECT_LE(distance, sampled + 1e-14);
    EXPECT_NEAR(distance, sampled, 0.01);
  }
}
