// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelInvariants.h
 * @brief The postconditions of the thesis's algorithms 4, 5 and 6, checked exactly on a finished
 * level.
 *
 * Every check goes from the definition and not through the code under test. Counts of what is wrong
 * are compared with 0, so that one broken level gives one line a check and not thousands.
 */
#ifndef recon_Testing_LevelInvariants_h
#define recon_Testing_LevelInvariants_h

#include "Contours/ContourSet.h"
#include "Polyhedral/LevelTriangulation.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace recon::testing
{
using InexactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline InexactKernel::Point_2 Planar(const LevelTriangulation& level, int p)
{
  return { level.Points[p][0], level.Points[p][1] };
}

/// Ends of the edge opposite corner k.
inline std::array<int, 2> EndsOf(const LevelTriangulation& level, int triangle, int k)
{
  const auto& corners = level.Triangles[triangle];
  return { { corners[(k + 1) % 3], corners[(k + 2) % 3] } };
}

inline int BackOf(const LevelTriangulation& level, int neighbour, int triangle)
{
  const auto& back = level.Neighbours[neighbour];
  return static_cast<int>(std::find(back.begin(), back.end(), triangle) - back.begin());
}

/// A triangulation of a disc: counterclockwise triangles, neighbours that know each other, and as
/// many edges and triangles as Euler says.
inline void ExpectTriangulation(const LevelTriangulation& level)
{
  int turned = 0, strangers = 0, hull = 0;
  const int count = static_cast<int>(level.Triangles.size());
  for (int t = 0; t < count; ++t)
  {
    const auto& c = level.Triangles[t];
    turned += CGAL::orientation(Planar(level, c[0]), Planar(level, c[1]), Planar(level, c[2])) !=
      CGAL::LEFT_TURN;
    for (int k = 0; k < 3; ++k)
    {
      const int n = level.Neighbours[t][k];
      hull += n < 0;
      if (n >= 0)
      {
        const int back = BackOf(level, n, t);
        const auto ends = EndsOf(level, t, k);
        strangers +=
          back == 3 || EndsOf(level, n, back) != std::array<int, 2>{ { ends[1], ends[0] } };
      }
    }
  }
  EXPECT_EQ(turned, 0) << "triangles that are flat or clockwise";
  EXPECT_EQ(strangers, 0) << "neighbours that do not share the edge";
  EXPECT_EQ(2 * static_cast<int>(level.Points.size()) - 2 - hull, count)
    << "not a disc that holds every point";
  int lost = 0;
  for (std::size_t p = 0; p < level.Points.size(); ++p)
  {
    const int t = level.StarTriangle[p];
    lost += t < 0 ||
      std::count(level.Triangles[t].begin(), level.Triangles[t].end(), static_cast<int>(p)) != 1;
  }
  EXPECT_EQ(lost, 0) << "points without a triangle";
}

/// No vertex inside the circumcircle of a neighbouring triangle, contour edges included.
inline void ExpectDelaunay(const LevelTriangulation& level)
{
  int wrong = 0;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    const auto& c = level.Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      const int n = level.Neighbours[t][k];
      if (n >= 0)
      {
        const int opposite = level.Triangles[n][BackOf(level, n, static_cast<int>(t))];
        wrong += CGAL::side_of_oriented_circle(Planar(level, c[0]), Planar(level, c[1]),
                   Planar(level, c[2]), Planar(level, opposite)) == CGAL::ON_POSITIVE_SIDE;
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "edges that are not Delaunay";
}

/// The edges that carry a contour's number, each once, as unordered pairs of points.
inline std::map<int, std::set<std::pair<int, int>>> ContourEdgesOf(const LevelTriangulation& level)
{
  std::map<int, std::set<std::pair<int, int>>> edges;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (level.EdgeContour[t][k] >= 0)
      {
        const auto ends = EndsOf(level, static_cast<int>(t), k);
        edges[level.EdgeContour[t][k]].insert(std::minmax(ends[0], ends[1]));
      }
    }
  }
  return edges;
}

/// Distance of p from the line a-b, and its place along it (0 at a, 1 at b).
inline std::pair<double, double> PlaceOnEdge(const Point2& a, const Point2& b, const Point2& p)
{
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double px = p[0] - a[0], py = p[1] - a[1];
  const double length = std::hypot(dx, dy);
  return { std::abs(dx * py - dy * px) / length, (dx * px + dy * py) / (length * length) };
}

/**
 * Algorithm 4: each contour is a closed chain of edges that passes its vertices in their order, bit
 * by bit where they were given; what lies between two of them lies on the edge, in order.
 */
inline void ExpectContourChain(const LevelTriangulation& level, const ContourSet& contours,
  int contour, const std::set<std::pair<int, int>>& edges)
{
  std::map<int, std::vector<int>> next;
  for (const auto& e : edges)
  {
    next[e.first].push_back(e.second);
    next[e.second].push_back(e.first);
  }
  std::map<int, int> vertexOf;
  for (const auto& entry : next)
  {
    ASSERT_EQ(entry.second.size(), 2u) << "contour " << contour << " forks or ends";
    vertexOf[level.Source[entry.first]] = entry.first;
  }
  const std::vector<int>& points = contours.Contours[contour].Points;
  std::size_t walked = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const int from = points[i], to = points[(i + 1) % points.size()];
    ASSERT_TRUE(vertexOf.count(from) && vertexOf.count(to)) << "a contour vertex is missing";
    const Point2& a = contours.Planar[from];
    const Point2& b = contours.Planar[to];
    // Of the two ways out of `from`, the one along this edge.
    int previous = vertexOf[from];
    int current = next[previous][0];
    double place = 0;
    const auto arrives = [&](int way)
    {
      int last = vertexOf[from], at = way;
      while (level.Source[at] < 0)
      {
        const auto& ways = next[at];
        const int on = ways[0] == last ? ways[1] : ways[0];
        last = at;
        at = on;
      }
      return level.Source[at] == to;
    };
    current = arrives(next[previous][0]) ? next[previous][0] : next[previous][1];
    ++walked;
    while (level.Source[current] < 0)
    {
      ASSERT_EQ(level.Kind[current], LevelTriangulation::AddedOnContour);
      const auto where = PlaceOnEdge(a, b, level.Points[current]);
      const double size =
        std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(b[0]), std::abs(b[1]) });
      EXPECT_LE(where.first, 1e-14 * size) << "an added point is off its contour edge";
      EXPECT_GT(where.second, place);
      EXPECT_LT(where.second, 1);
      place = where.second;
      const auto& ways = next[current];
      const int on = ways[0] == previous ? ways[1] : ways[0];
      previous = current;
      current = on;
      ++walked;
    }
    ASSERT_EQ(level.Source[current], to) << "contour " << contour << " is not followed";
  }
  EXPECT_EQ(walked, edges.size()) << "contour " << contour << " has edges beside its chain";
}

inline void ExpectContourEdges(
  const LevelTriangulation& level, const ContourSet& contours, int number)
{
  const auto edges = ContourEdgesOf(level);
  ASSERT_EQ(edges.size(), contours.Levels[number].Contours.size());
  for (int c : contours.Levels[number].Contours)
  {
    ASSERT_TRUE(edges.count(c)) << "contour " << c << " has no edge";
    ExpectContourChain(level, contours, c, edges.at(c));
  }
  int moved = 0, mislabelled = 0;
  for (std::size_t p = 0; p < level.Points.size(); ++p)
  {
    const bool given = level.Source[p] >= 0;
    mislabelled += given != (level.Kind[p] == LevelTriangulation::InputVertex);
    moved += given && level.Points[p] != contours.Planar[level.Source[p]];
  }
  EXPECT_EQ(moved, 0) << "contour vertices that are not where they were given";
  EXPECT_EQ(mislabelled, 0);
}

/// Algorithm 5, condition 2: no vertex strictly inside the circle that has a contour edge as its
/// diameter. The two triangles at the edge decide it in a Delaunay triangulation; where the level
/// is small every vertex is tried as well.
inline void ExpectGabriel(const LevelTriangulation& level)
{
  std::set<std::pair<int, int>> edges;
  int obtuse = 0;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (level.EdgeContour[t][k] >= 0)
      {
        const auto ends = EndsOf(level, static_cast<int>(t), k);
        edges.insert(std::minmax(ends[0], ends[1]));
        obtuse += CGAL::side_of_bounded_circle(Planar(level, ends[0]), Planar(level, ends[1]),
                    Planar(level, level.Triangles[t][k])) == CGAL::ON_BOUNDED_SIDE;
      }
    }
  }
  EXPECT_EQ(obtuse, 0) << "obtuse angles that face a contour edge";
  if (edges.size() * level.Points.size() > 200000)
  {
    return;
  }
  int inside = 0;
  for (const auto& e : edges)
  {
    for (std::size_t p = 0; p < level.Points.size(); ++p)
    {
      inside += CGAL::side_of_bounded_circle(Planar(level, e.first), Planar(level, e.second),
                  Planar(level, static_cast<int>(p))) == CGAL::ON_BOUNDED_SIDE;
    }
  }
  EXPECT_EQ(inside, 0) << "vertices in the diametral circle of a contour edge";
}

/// Inside changes across contour edges and nowhere else, is false beyond the hull, and covers the
/// contours' area.
inline void ExpectSides(const LevelTriangulation& level, const ContourSet& contours, int number)
{
  int wrong = 0;
  double area = 0, expected = 0;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int n = level.Neighbours[t][k];
      const bool beyond = n >= 0 && level.Inside[n];
      wrong += (beyond != (level.Inside[t] != 0)) != (level.EdgeContour[t][k] >= 0);
      wrong += n >= 0 &&
        level.EdgeContour[n][BackOf(level, n, static_cast<int>(t))] != level.EdgeContour[t][k];
    }
    if (level.Inside[t])
    {
      const auto& c = level.Triangles[t];
      const Point2 &p = level.Points[c[0]], &q = level.Points[c[1]], &r = level.Points[c[2]];
      area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
    }
  }
  for (int c : contours.Levels[number].Contours)
  {
    expected += contours.Contours[c].SignedArea;
  }
  EXPECT_EQ(wrong, 0) << "edges with the wrong sides";
  EXPECT_NEAR(area, expected, 1e-9 * std::abs(expected));
}

/// Where a point of the plane lies: the triangle whose closure holds it (-1: outside the hull), and
/// the corners and edges that it lies on. Visibility walk, exact.
struct PlaneLocation
{
  int Triangle = -1;
  std::array<bool, 3> OnEdge{ { false, false, false } };
};

template <typename Kernel>
PlaneLocation LocateInPlane(
  const LevelTriangulation& level, int start, const typename Kernel::Point_2& point)
{
  const auto at = [&](int p)
  { return typename Kernel::Point_2(level.Points[p][0], level.Points[p][1]); };
  PlaneLocation location;
  location.Triangle = start;
  for (bool moved = true; moved && location.Triangle >= 0;)
  {
    moved = false;
    for (int k = 0; k < 3 && !moved; ++k)
    {
      const auto ends = EndsOf(level, location.Triangle, k);
      const auto side = CGAL::orientation(at(ends[0]), at(ends[1]), point);
      location.OnEdge[k] = side == CGAL::COLLINEAR;
      if (side == CGAL::RIGHT_TURN)
      {
        location.Triangle = level.Neighbours[location.Triangle][k];
        moved = true;
      }
    }
  }
  return location;
}

/// What condition 2 is for: the circumcentre of every triangle of IR lies in the closure of IR.
inline void ExpectCircumcentresInside(const LevelTriangulation& level)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto at = [&](int p) { return Exact::Point_2(level.Points[p][0], level.Points[p][1]); };
  int outside = 0;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    if (!level.Inside[t])
    {
      continue;
    }
    const auto& c = level.Triangles[t];
    const Exact::Point_2 centre = CGAL::circumcenter(at(c[0]), at(c[1]), at(c[2]));
    const PlaneLocation where = LocateInPlane<Exact>(level, static_cast<int>(t), centre);
    bool inside = where.Triangle >= 0 && level.Inside[where.Triangle];
    for (int k = 0; k < 3 && where.Triangle >= 0; ++k)
    {
      inside = inside || (where.OnEdge[k] && level.EdgeContour[where.Triangle][k] >= 0);
    }
    outside += !inside;
  }
  EXPECT_EQ(outside, 0) << "triangles of IR with their circumcentre outside";
}

/// Algorithm 6: internal points lie strictly inside IR, asked for by someone.
inline void ExpectInternalPointsInside(const LevelTriangulation& level)
{
  int outside = 0;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int p = level.Triangles[t][k];
      const bool internal = level.Kind[p] == LevelTriangulation::Internal;
      outside += internal && (!level.Inside[t] || level.EdgeContour[t][(k + 1) % 3] >= 0);
      EXPECT_EQ(internal, level.AskedBy[p] != 0) << "point " << p;
    }
  }
  EXPECT_EQ(outside, 0) << "internal points on a contour or outside";
}

/// All of the above.
inline void ExpectSoundLevel(
  const LevelTriangulation& level, const ContourSet& contours, int number)
{
  ExpectTriangulation(level);
  ExpectDelaunay(level);
  ExpectContourEdges(level, contours, number);
  ExpectGabriel(level);
  ExpectSides(level, contours, number);
  ExpectCircumcentresInside(level);
  ExpectInternalPointsInside(level);
}
}

#endif
