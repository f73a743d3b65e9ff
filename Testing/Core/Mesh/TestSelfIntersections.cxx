// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshDefects.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SheetCrossings.h"
#include "Mesh/TrianglePair.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/variant.hpp>

#include <algorithm>
#include <random>
#include <variant>

using namespace recon;
using namespace recon::testing;

namespace
{
/// An intersection is a variant of the standard library since CGAL 6, of Boost before.
template <typename Part, typename... Parts>
const Part* PartOf(const std::variant<Parts...>* common)
{
  return std::get_if<Part>(common);
}
template <typename Part, typename Variant>
const Part* PartOf(const Variant* common)
{
  return boost::get<Part>(common);
}

SelfIntersections Find(const TriangleMesh& mesh, int threads = 0)
{
  Monitor monitor;
  SelfIntersectionOptions options;
  options.Threads = threads;
  return FindSelfIntersections(mesh, options, monitor);
}

/**
 * An oracle that shares nothing with the code it judges: construct the intersection in exact
 * arithmetic and look at it.
 */
class Oracle
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Segment = Kernel::Segment_3;
  using Triangle = Kernel::Triangle_3;

public:
  static PairRelation Relate(const TriangleMesh& mesh, int s, int t)
  {
    const Triangle a = At(mesh, s);
    const Triangle b = At(mesh, t);
    if (a.is_degenerate() || b.is_degenerate())
    {
      return PairRelation::Clean;
    }
    const auto common = CGAL::intersection(a, b);
    if (!common)
    {
      return PairRelation::Clean;
    }
    const auto shared = Shared(mesh, s, t);
    if (const auto* point = PartOf<Point>(&*common))
    {
      const bool clean = shared.size() == 1 && shared[0] == *point;
      return clean ? PairRelation::Clean : PairRelation::Touching;
    }
    if (const auto* segment = PartOf<Segment>(&*common))
    {
      const bool clean = shared.size() == 2 &&
        (Segment(shared[0], shared[1]) == *segment || Segment(shared[1], shared[0]) == *segment);
      const Point middle = CGAL::midpoint(segment->source(), segment->target());
      const bool coplanar = CGAL::coplanar(a[0], a[1], a[2], b[0]) &&
        CGAL::coplanar(a[0], a[1], a[2], b[1]) && CGAL::coplanar(a[0], a[1], a[2], b[2]);
      const bool crossing = !coplanar && IsInside(a, middle) && IsInside(b, middle);
      return crossing ? PairRelation::Crossing
        : clean       ? PairRelation::Clean
                      : PairRelation::Touching;
    }
    return PairRelation::Overlapping;
  }

private:
  static Point At(const Point3& p) { return { p[0], p[1], p[2] }; }

  static Triangle At(const TriangleMesh& mesh, int t)
  {
    const auto& c = mesh.Triangles[t];
    return { At(mesh.Points[c[0]]), At(mesh.Points[c[1]]), At(mesh.Points[c[2]]) };
  }

  static std::vector<Point> Shared(const TriangleMesh& mesh, int s, int t)
  {
    std::vector<Point> shared;
    for (const int p : mesh.Triangles[s])
    {
      const auto& other = mesh.Triangles[t];
      if (std::find(other.begin(), other.end(), p) != other.end())
      {
        shared.push_back(At(mesh.Points[p]));
      }
    }
    return shared;
  }

  /// p is in the plane of t; not on its border.
  static bool IsInside(const Triangle& t, const Point& p)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (Segment(t[k], t[k + 1]).has_on(p))
      {
        return false;
      }
    }
    return true;
  }
};

/// Triangles on a coarse grid meet in every degenerate way there is.
TriangleMesh MakeRandomSoup(int points, int triangles, int grid, unsigned seed, bool jitter)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(0, grid);
  std::uniform_int_distribution<int> corner(0, points - 1);
  std::uniform_real_distribution<double> small(-1e-15, 1e-15);
  TriangleMesh mesh;
  for (int p = 0; p < points; ++p)
  {
    Point3 x{};
    for (auto& c : x)
    {
      c = coordinate(random) * 0.1 + (jitter ? small(random) : 0);
    }
    mesh.Points.push_back(x);
  }
  while (static_cast<int>(mesh.Triangles.size()) < triangles)
  {
    const std::array<int, 3> t{ corner(random), corner(random), corner(random) };
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      mesh.Triangles.push_back(t);
    }
  }
  return mesh;
}

void CompareWithOracle(const TriangleMesh& mesh)
{
  const SelfIntersections found = Find(mesh);
  std::size_t next = 0;
  int kinds[4] = { 0, 0, 0, 0 };
  const int count = static_cast<int>(mesh.Triangles.size());
  for (int s = 0; s < count; ++s)
  {
    for (int t = s + 1; t < count; ++t)
    {
      const PairRelation expected = Oracle::Relate(mesh, s, t);
      ++kinds[static_cast<int>(expected)];
      ASSERT_EQ(RelateTriangles(mesh, s, t), expected) << s << " " << t;
      ASSERT_EQ(RelateTriangles(mesh, t, s), expected) << t << " " << s;
      if (expected == PairRelation::Clean)
      {
        continue;
      }
      ASSERT_LT(next, found.Pairs.size());
      EXPECT_EQ(found.Pairs[next].First, s);
      EXPECT_EQ(found.Pairs[next].Second, t);
      ++next;
    }
  }
  EXPECT_EQ(next, found.Pairs.size());
  EXPECT_EQ(found.Touching, kinds[static_cast<int>(PairRelation::Touching)]);
  EXPECT_EQ(found.Overlapping, kinds[static_cast<int>(PairRelation::Overlapping)]);
  EXPECT_EQ(found.Crossing, kinds[static_cast<int>(PairRelation::Crossing)]);
  EXPECT_GT(found.Crossing, 0) << "the input is no test";
}

bool AnyMarked(const SelfIntersections& found, int bit)
{
  return std::any_of(found.DefectOfTriangle.begin(), found.DefectOfTriangle.end(),
    [bit](int defect) { return (defect & bit) != 0; });
}
}

TEST(SelfIntersections, AgreesWithExactConstructionOnAGrid)
{
  CompareWithOracle(MakeRandomSoup(40, 120, 3, 1, false));
  CompareWithOracle(MakeRandomSoup(60, 120, 2, 2, false)); // equal coordinates under many indices
}

TEST(SelfIntersections, AgreesWithExactConstructionAHairFromDegeneracy)
{
  CompareWithOracle(MakeRandomSoup(40, 120, 3, 3, true));
}

TEST(SelfIntersections, AgreesWithExactConstructionInOnePlane)
{
  TriangleMesh mesh = MakeRandomSoup(30, 80, 6, 4, false);
  for (auto& p : mesh.Points)
  {
    p[2] = 0.5;
  }
  mesh.Triangles.push_back({ 30, 31, 32 }); // and one that crosses
  mesh.Points.push_back({ 0.11, 0.12, 0 });
  mesh.Points.push_back({ 0.31, 0.52, 0 });
  mesh.Points.push_back({ 0.23, 0.34, 1 });
  CompareWithOracle(mesh);
  EXPECT_GT(Find(mesh).Overlapping, 0);
}

TEST(SelfIntersections, BoxesThatCross)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  Append(mesh, MakeBox({ 1, 0.5, 0.25 }, { 3, 1.5, 1.125 }));
  const SelfIntersections found = Find(mesh);
  EXPECT_GT(found.Crossing, 0);
  EXPECT_EQ(found.Overlapping, 0);
  EXPECT_TRUE(AnyMarked(found, DefectCrossing));
  EXPECT_FALSE(AnyMarked(found, DefectOverlapping));
  EXPECT_TRUE(found.Any());
}

TEST(SelfIntersections, BoxesThatTouchInAFace)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 1, 0, 0 }, { 2, 1, 1 }));
  const SelfIntersections found = Find(mesh);
  EXPECT_EQ(found.Crossing, 0);
  EXPECT_GT(found.Overlapping, 0);
  EXPECT_GT(found.Touching, 0);
  EXPECT_TRUE(AnyMarked(found, DefectOverlapping));
}

TEST(SelfIntersections, BoxesThatShareAnEdgeTouch)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 1, 1, 0 }, { 2, 2, 1 }));
  const SelfIntersections cut = Find(mesh);
  EXPECT_FALSE(cut.Any());
  EXPECT_GT(cut.Touching, 0);
  const SelfIntersections welded = Find(WeldPoints(mesh));
  EXPECT_FALSE(welded.Any());
  EXPECT_EQ(welded.Touching, 0) << "what is shared by index is connected";
}

namespace
{
/// Four faces around the z axis, a quarter turn apart; each is on one of two copies of the axis.
TriangleMesh MakeFourFaces(const std::array<int, 4>& axisOfFace)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { 0, 1, 0.5 },
    { -1, 0, 0.5 }, { 0, -1, 0.5 } };
  for (int f = 0; f < 4; ++f)
  {
    mesh.Triangles.push_back({ 2 * axisOfFace[f], 2 * axisOfFace[f] + 1, 4 + f });
  }
  return mesh;
}
}

TEST(SheetCrossings, DependOnWhichFacesAreJoined)
{
  EXPECT_EQ(FindSheetCrossings(MakeFourFaces({ 0, 0, 1, 1 })).Edges, 0);
  EXPECT_EQ(FindSheetCrossings(MakeFourFaces({ 0, 1, 1, 0 })).Edges, 0);
  const SheetCrossings crossing = FindSheetCrossings(MakeFourFaces({ 0, 1, 0, 1 }));
  EXPECT_EQ(crossing.Edges, 1);
  EXPECT_EQ(crossing.Triangles.size(), 4u);
  EXPECT_FALSE(Find(MakeFourFaces({ 0, 1, 0, 1 })).Any()) << "the pairs alone do not tell";
  EXPECT_EQ(FindSheetCrossings(MakeFourFaces({ 0, 0, 0, 0 })).Edges, 0) << "one edge of four";
}

TEST(SheetCrossings, AnyRotationAndTiltAndFacesOnOneAnother)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 200; ++i)
  {
    TriangleMesh mesh = MakeFourFaces({ 0, 1, 0, 1 });
    const Vector3 shear{ coordinate(random), coordinate(random), coordinate(random) };
    const double turn = 4 * coordinate(random);
    for (auto& p : mesh.Points)
    {
      // Turned about the axis and sheared: which faces lie between which stays the same.
      p = { std::cos(turn) * p[0] - std::sin(turn) * p[1] + shear[0] * p[2],
        std::sin(turn) * p[0] + std::cos(turn) * p[1] + shear[1] * p[2], p[2] + shear[2] * p[0] };
    }
    EXPECT_EQ(FindSheetCrossings(mesh).Edges, 1);
    for (auto& t : mesh.Triangles)
    {
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    EXPECT_EQ(FindSheetCrossings(mesh).Edges, 1);
  }
  TriangleMesh flat = MakeFourFaces({ 0, 1, 0, 1 });
  flat.Points[5] = flat.Points[4]; // a face of each sheet in one place: they overlap
  EXPECT_EQ(FindSheetCrossings(flat).Edges, 0);
  EXPECT_EQ(Find(flat).Overlapping, 1);
}

TEST(SheetCrossings, LatticeBoxesThatCrossAlongTheirOwnEdges)
{
  // Two bars of unit cells that cross each other at right angles, the seam along edges of both.
  const auto bar = [](int x0, int x1, int y0, int y1, int z0, int z1)
  {
    return MakeFromCells({ 5, 5, 5 },
      [=](int x, int y, int z)
      { return x >= x0 && x < x1 && y >= y0 && y < y1 && z >= z0 && z < z1; });
  };
  TriangleMesh mesh = bar(0, 5, 1, 4, 1, 4);
  Append(mesh, bar(1, 4, 2, 3, 0, 5));
  const SelfIntersections pairs = Find(mesh);
  EXPECT_EQ(pairs.Crossing, 0) << "no triangle's interior is entered";
  EXPECT_EQ(pairs.Overlapping, 0);
  EXPECT_EQ(FindSheetCrossings(mesh).Edges, 2 * (3 + 1 + 3 + 1)) << "the seams above and below";
  TriangleMesh side = bar(0, 2, 0, 2, 0, 2);
  Append(side, bar(2, 4, 2, 4, 0, 2));
  EXPECT_EQ(FindSheetCrossings(side).Edges, 0) << "boxes edge to edge do not cross";
  for (const auto& sound : { MakeCube(), MakeSponge(2), MakeLinkedTori(), MakeTorus(1, 1) })
  {
    EXPECT_EQ(FindSheetCrossings(sound).Edges, 0);
  }
}

TEST(SelfIntersections, SoundShapesHaveNone)
{
  for (const auto& mesh : { MakeCube(), MakeSponge(2), MakeLinkedTori(), MakeTorus(1, 1),
         MakeMoebiusStrip(), MakeSphere(30, 15) })
  {
    const SelfIntersections found = Find(mesh);
    EXPECT_EQ(found.Crossing, 0);
    EXPECT_EQ(found.Overlapping, 0);
    EXPECT_EQ(found.Touching, 0);
    EXPECT_TRUE(found.Pairs.empty());
  }
}

TEST(SelfIntersections, FoldedTriangleOverlapsItsNeighbour)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.3, 0.3, 0 } };
  mesh.Triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
  EXPECT_EQ(Find(mesh).Overlapping, 1);
  mesh.Points[3] = { 0.3, -0.3, 0 };
  EXPECT_TRUE(Find(mesh).Pairs.empty());
}

TEST(SelfIntersections, SameForAnyNumberOfThreads)
{
  const TriangleMesh mesh = MakeRandomSoup(2000, 4000, 100, 5, true);
  const SelfIntersections one = Find(mesh, 1);
  EXPECT_GT(one.Crossing, 1000);
  for (const int threads : { 2, 3, 8 })
  {
    const SelfIntersections other = Find(mesh, threads);
    EXPECT_EQ(other.DefectOfTriangle, one.DefectOfTriangle);
    ASSERT_EQ(other.Pairs.size(), one.Pairs.size());
    for (std::size_t i = 0; i < one.Pairs.size(); ++i)
    {
      EXPECT_EQ(other.Pairs[i].First, one.Pairs[i].First);
      EXPECT_EQ(other.Pairs[i].Second, one.Pairs[i].Second);
      EXPECT_EQ(other.Pairs[i].Kind, one.Pairs[i].Kind);
    }
  }
}

TEST(SelfIntersections, CountsBeyondThePairsItKeeps)
{
  const TriangleMesh mesh = MakeRandomSoup(100, 500, 100, 6, false);
  const SelfIntersections all = Find(mesh);
  Monitor monitor;
  SelfIntersectionOptions options;
  options.MaximumPairsAPiece = 10;
  const SelfIntersections few = FindSelfIntersections(mesh, options, monitor);
  EXPECT_TRUE(all.Complete);
  EXPECT_FALSE(few.Complete);
  EXPECT_EQ(few.Crossing, all.Crossing);
  EXPECT_EQ(few.DefectOfTriangle, all.DefectOfTriangle);
  EXPECT_LT(few.Pairs.size(), all.Pairs.size());
}

TEST(SelfIntersections, OfSomeTrianglesOnlyTheirPairs)
{
  TriangleMesh mesh = MakeRandomSoup(100, 500, 20, 7, false);
  Append(mesh, MakeTorus(1, 0.3));
  const SelfIntersections all = Find(mesh);
  std::vector<char> of(mesh.Triangles.size(), 0);
  for (std::size_t t = 0; t < of.size(); t += 3)
  {
    of[t] = 1;
  }
  Monitor monitor;
  SelfIntersectionOptions options;
  options.Of = &of;
  const SelfIntersections some = FindSelfIntersections(mesh, options, monitor);
  std::size_t next = 0;
  for (const IntersectingPair& pair : all.Pairs)
  {
    if (of[pair.First] || of[pair.Second])
    {
      ASSERT_LT(next, some.Pairs.size());
      EXPECT_EQ(some.Pairs[next].First, pair.First);
      EXPECT_EQ(some.Pairs[next].Second, pair.Second);
      EXPECT_EQ(some.Pairs[next++].Kind, pair.Kind);
    }
  }
  EXPECT_EQ(next, some.Pairs.size());
  EXPECT_LT(next, all.Pairs.size());
}

TEST(SelfIntersections, CanBeAborted)
{
  struct : Monitor
  {
    bool AbortRequested() override { return true; }
  } monitor;
  EXPECT_THROW(FindSelfIntersections(MakeCube(), monitor), Aborted);
}
