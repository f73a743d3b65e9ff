// SPDX-License-Identifier: GPL-3.0-or-later
// The tetrahedra of the joint Voronoi diagram against CGAL's 3D Delaunay triangulation, and where
// points are cospherical by exact volumes and matching faces.
#include "PolyhedralShapes.h"
#include "SlabInvariants.h"

#include <gtest/gtest.h>

#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
struct NodeCounts
{
  int T1, T2, T12;
  bool operator==(const NodeCounts& other) const
  {
    return this->T1 == other.T1 && this->T2 == other.T2 && this->T12 == other.T12;
  }
};

std::ostream& operator<<(std::ostream& out, const NodeCounts& counts)
{
  return out << counts.T1 << " T1, " << counts.T2 << " T2, " << counts.T12 << " T12";
}

/// Builds the slab between bare points, checks it and compares it with CGAL at several heights.
/// Returns how many nodes of each kind there are.
NodeCounts ExpectSound(
  const LevelTriangulation& level1, const LevelTriangulation& level2, bool ties)
{
  const SlabTetrahedra slab = BuildJointVoronoi(level1, level2);
  const SlabView view{ level1, level2, slab };
  const int tied = ExpectSoundSlab(view);
  EXPECT_EQ(tied > 0, ties) << tied << " tetrahedra with five or more cospherical corners";
  if (tied == 0)
  {
    for (const double height : { 0.01, 1.0, 7.3 })
    {
      SCOPED_TRACE(height);
      ExpectSameAsCGAL(view, 0, height);
    }
  }
  return { slab.NumberOfT1, slab.NumberOfT2, view.Count() - slab.NumberOfT1 - slab.NumberOfT2 };
}

NodeCounts ExpectSound(const Ring& points1, const Ring& points2, bool ties)
{
  return ExpectSound(TriangulatePoints(points1), TriangulatePoints(points2), ties);
}

Ring RandomPoints(int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Ring points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ coordinate(random), coordinate(random) });
  }
  return points;
}

/// Random points with whole coordinates, each place once.
Ring GridPoints(int count, int size, std::mt19937& random)
{
  std::uniform_int_distribution<int> coordinate(0, size);
  std::set<Point2> places;
  while (static_cast<int>(places.size()) < count)
  {
    places.insert(
      { static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random)) });
  }
  return { places.begin(), places.end() };
}

/// Points of the circle x^2 + y^2 = 65^2 with whole coordinates: exactly cocircular.
Ring CocircularPoints()
{
  Ring points;
  for (int x = -65; x <= 65; ++x)
  {
    for (int y = -65; y <= 65; ++y)
    {
      if (x * x + y * y == 65 * 65)
      {
        points.push_back({ static_cast<double>(x), static_cast<double>(y) });
      }
    }
  }
  return points;
}

Ring Moved(Ring ring, double dx, double dy)
{
  for (Point2& p : ring)
  {
    p = { p[0] + dx, p[1] + dy };
  }
  return ring;
}
}

TEST(JointVoronoi, TwoTriangles)
{
  EXPECT_EQ(
    ExpectSound({ { 0, 0 }, { 4, 0.1 }, { 1, 3 } }, { { 1, -0.5 }, { 3, 2.7 }, { 0, 2 } }, false)
      .T1,
    1);
}

TEST(JointVoronoi, EqualsCGALOnRandomPoints)
{
  std::mt19937 random(11);
  for (int run = 0; run < 40; ++run)
  {
    SCOPED_TRACE("run " + std::to_string(run));
    const Ring lower = RandomPoints(3 + run * 3, random);
    const Ring upper = RandomPoints(3 + (run * 7) % 90, random);
    ExpectSound(lower, upper, false);
  }
}

TEST(JointVoronoi, EqualsCGALWhereLevelsDoNotOverlap)
{
  std::mt19937 random(12);
  for (const double shift : { 1.5, 10.0, 1000.0 })
  {
    SCOPED_TRACE(shift);
    ExpectSound(RandomPoints(40, random), Moved(RandomPoints(50, random), shift, 0.3), false);
  }
}

TEST(JointVoronoi, EqualsCGALWhereOneLevelIsMuchFiner)
{
  std::mt19937 random(13);
  ExpectSound(RandomPoints(4, random), RandomPoints(800, random), false);
  ExpectSound(RandomPoints(800, random), RandomPoints(4, random), false);
}

TEST(JointVoronoi, EqualsCGALFarFromTheOrigin)
{
  std::mt19937 random(14);
  ExpectSound(
    Moved(RandomPoints(60, random), 1e7, -1e7), Moved(RandomPoints(60, random), 1e7, -1e7), false);
}

TEST(JointVoronoi, EqualsCGALOnTriangulatedContours)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ContourSet contours = BuildStack(RandomStack(seed));
    const auto levels = TriangulateLevels(contours, true);
    for (std::size_t l = 0; l + 1 < levels.size(); ++l)
    {
      const SlabTetrahedra slab = BuildJointVoronoi(levels[l], levels[l + 1]);
      const SlabView view{ levels[l], levels[l + 1], slab };
      ExpectSoundSlab(view);
      ExpectSameAsCGAL(view, contours.Levels[l].Offset, contours.Levels[l + 1].Offset);
    }
  }
}

//------------------------------------------------------------------------------
// Thesis 6.3. Triangle 123 is level 1, the others level 2; a circle of radius 65 about the origin
// has many points with whole coordinates, so that the ties are exact.

TEST(JointVoronoiSpecialCases, VertexOnEdge)
{
  // Five cospherical points: the circumcentre of 123 lies on the Voronoi edge between B and D.
  const Ring lower{ { 65, 0 }, { -39, 52 }, { -39, -52 } };
  const Ring upper{ { 0, 30 }, { 0, -30 }, { 200, 1 }, { -200, 3 } };
  const NodeCounts counts = ExpectSound(lower, upper, true);
  EXPECT_EQ(counts.T1, 1);
  EXPECT_EQ(counts.T2, 2);
  // Algorithm 7: the half-plane that is not the apex's holds one or two Voronoi edges of 123.
  EXPECT_EQ(ExpectSound(upper, lower, true), (NodeCounts{ 2, 1, counts.T12 }));
}

namespace
{
/// Algorithm 8: around the common circumcentre, how often two Voronoi edges of one level follow
/// each other. 0 = 1a2b3c, 2 = 1ab23c.
int NeighboursOfOneLevel(const Ring& lower, const Ring& upper)
{
  std::vector<std::pair<double, int>> directions;
  for (int side : { 0, 1 })
  {
    const Ring& corners = side == 0 ? lower : upper;
    for (std::size_t i = 0; i < 3; ++i)
    {
      // The Voronoi edge leaves the centre of the circle through the middle of the Delaunay edge's
      // arc.
      const double from = std::atan2(corners[i][1], corners[i][0]);
      double to = std::atan2(corners[(i + 1) % 3][1], corners[(i + 1) % 3][0]);
      to += to < from ? FullTurn : 0;
      directions.emplace_back(std::fmod(0.5 * (from + to) + FullTurn, FullTurn), side);
    }
  }
  std::sort(directions.begin(), directions.end());
  int pairs = 0;
  for (std::size_t i = 0; i < 6; ++i)
  {
    pairs += directions[i].second == directions[(i + 1) % 6].second;
  }
  return pairs;
}
}

TEST(JointVoronoiSpecialCases, VertexOnVertexInTurn)
{
  // 1a2b3c: algorithm 9 makes a T1, a T2 and two T12, whichever apex is elected.
  const Ring lower{ { 65, 0 }, { -39, 52 }, { -39, -52 } };
  const Ring upper{ { -65, 0 }, { 39, -52 }, { 39, 52 } };
  ASSERT_EQ(NeighboursOfOneLevel(lower, upper), 0);
  EXPECT_EQ(ExpectSound(lower, upper, true), (NodeCounts{ 1, 1, 2 }));
  EXPECT_EQ(ExpectSound(upper, lower, true), (NodeCounts{ 1, 1, 2 }));
}

TEST(JointVoronoiSpecialCases, VertexOnVertexInPairs)
{
  // 1ab23c: the solutions are not alike; figure 6.5 has one of a single T12 and larger ones.
  const Ring lower{ { 65, 0 }, { -39, 52 }, { -60, -25 } };
  const Ring upper{ { 56, 33 }, { 16, 63 }, { 0, -65 } };
  ASSERT_EQ(NeighboursOfOneLevel(lower, upper), 2);
  for (const NodeCounts& counts :
    { ExpectSound(lower, upper, true), ExpectSound(upper, lower, true) })
  {
    EXPECT_EQ(counts.T1, 1);
    EXPECT_EQ(counts.T2, 1);
    EXPECT_GE(counts.T12, 1);
    EXPECT_LE(counts.T12, 3);
  }
}

TEST(JointVoronoiSpecialCases, EveryPairOfTrianglesOnOneCircle)
{
  // All ways in which two triangles share a circumcentre, corners in common included.
  const Ring circle = CocircularPoints();
  ASSERT_EQ(circle.size(), 36u);
  std::mt19937 random(15);
  for (int run = 0; run < 300; ++run)
  {
    SCOPED_TRACE("run " + std::to_string(run));
    const auto draw = [&]
    {
      Ring triangle = circle;
      std::shuffle(triangle.begin(), triangle.end(), random);
      triangle.resize(3);
      return triangle;
    };
    ExpectSound(draw(), draw(), true);
  }
}

TEST(JointVoronoiSpecialCases, ManyCocircularPoints)
{
  const Ring circle = CocircularPoints();
  ExpectSound(circle, circle, true);
  Ring half(circle.begin(), circle.begin() + 18), others;
  for (std::size_t i = 0; i < circle.size(); i += 2)
  {
    others.push_back(circle[i]);
  }
  ExpectSound(circle, others, true);
  ExpectSound(half, others, true);
  // Concentric circles have one circumcentre: every apex is a tie.
  Ring larger;
  for (const Point2& p : circle)
  {
    larger.push_back({ 2 * p[0], 2 * p[1] });
  }
  ExpectSound(circle, larger, true);
}

TEST(JointVoronoiSpecialCases, IdenticalLevels)
{
  std::mt19937 random(16);
  const Ring points = RandomPoints(80, random);
  const NodeCounts counts = ExpectSound(points, points, true);
  EXPECT_EQ(counts.T1, counts.T2);
  Ring grid;
  for (int x = 0; x < 7; ++x)
  {
    for (int y = 0; y < 5; ++y)
    {
      grid.push_back({ static_cast<double>(x), static_cast<double>(y) });
    }
  }
  ExpectSound(grid, grid, true);
  ExpectSound(grid, Moved(grid, 1, 0), true);
  ExpectSound(grid, Moved(grid, 0, -2), true);
  ExpectSound(grid, Moved(grid, 0.5, 0.5), true);
}

TEST(JointVoronoiSpecialCases, SquaresRotatedByFortyFiveDegrees)
{
  const Ring square{ { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };
  const Ring diamond{ { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  ExpectSound(square, diamond, true);
  ExpectSound(diamond, square, true);
  Ring outer;
  for (const Point2& p : diamond)
  {
    outer.push_back({ 2 * p[0], 2 * p[1] });
  }
  ExpectSound(square, outer, true);
}

TEST(JointVoronoiSpecialCases, RandomPointsOfAGrid)
{
  std::mt19937 random(17);
  for (int run = 0; run < 60; ++run)
  {
    SCOPED_TRACE("run " + std::to_string(run));
    // A full grid cannot be drawn without ties; three points of one line make no triangle.
    const auto draw = [&]
    {
      Ring points = GridPoints(6 + run, 12, random);
      points.push_back({ -1, 3 });
      points.push_back({ 5, -1 });
      return points;
    };
    const auto level1 = TriangulatePoints(draw()), level2 = TriangulatePoints(draw());
    const SlabTetrahedra slab = BuildJointVoronoi(level1, level2);
    const SlabView view{ level1, level2, slab };
    ExpectSoundSlab(view);
    ExpectSameAsCGAL(view, 0, 1);
  }
}
