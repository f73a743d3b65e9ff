// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SlabInvariants.h
 * @brief What the tetrahedra between two levels must be, checked exactly.
 *
 * Level 1 is put at height 0, level 2 at height 1: which tetrahedra there are does not depend on
 * the distance of the planes (the comparison with CGAL tries others), and then every volume is a
 * polynomial of the given coordinates.
 */
#ifndef recon_Testing_SlabInvariants_h
#define recon_Testing_SlabInvariants_h

#include "LevelInvariants.h"
#include "Polyhedral/JointVoronoi.h"

#include <CGAL/convex_hull_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace recon::testing
{
using Rational = CGAL::Exact_rational;

struct SlabView
{
  const LevelTriangulation& Level1;
  const LevelTriangulation& Level2;
  const SlabTetrahedra& Slab;

  /// One number for the points of both levels.
  int Global(const SlabTetrahedra::Tetrahedron& t, int k) const
  {
    const int shift =
      SlabTetrahedra::OnLevel2(t, k) ? static_cast<int>(this->Level1.Points.size()) : 0;
    return t.Corners[k] + shift;
  }

  const Point2& PlanarOf(int global) const
  {
    const int count = static_cast<int>(this->Level1.Points.size());
    return global < count ? this->Level1.Points[global] : this->Level2.Points[global - count];
  }

  InexactKernel::Point_3 At(int global, double height1 = 0, double height2 = 1) const
  {
    const bool lower = global < static_cast<int>(this->Level1.Points.size());
    const Point2& p = this->PlanarOf(global);
    return { p[0], p[1], lower ? height1 : height2 };
  }

  std::array<int, 4> GlobalCorners(int tetrahedron) const
  {
    const auto& t = this->Slab.Tetrahedra[tetrahedron];
    return { { this->Global(t, 0), this->Global(t, 1), this->Global(t, 2), this->Global(t, 3) } };
  }

  /// The face opposite corner k, sorted.
  std::array<int, 3> Face(int tetrahedron, int k) const
  {
    const auto c = this->GlobalCorners(tetrahedron);
    std::array<int, 3> face{ { c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4] } };
    std::sort(face.begin(), face.end());
    return face;
  }

  int Count() const { return static_cast<int>(this->Slab.Tetrahedra.size()); }
};

/// T1, T2 and T12 are what their names say, and stand in the order that they promise.
inline void ExpectNodeTypes(const SlabView& view)
{
  const auto& slab = view.Slab;
  ASSERT_EQ(slab.NumberOfT1, static_cast<int>(view.Level1.Triangles.size()));
  ASSERT_EQ(slab.NumberOfT2, static_cast<int>(view.Level2.Triangles.size()));
  int wrong = 0;
  for (int i = 0; i < view.Count(); ++i)
  {
    const auto& t = slab.Tetrahedra[i];
    if (i < slab.NumberOfT1 + slab.NumberOfT2)
    {
      const bool first = i < slab.NumberOfT1;
      const auto& level = first ? view.Level1 : view.Level2;
      std::array<int, 3> base{ { t.Corners[0], t.Corners[1], t.Corners[2] } };
      std::array<int, 3> triangle = level.Triangles[first ? i : i - slab.NumberOfT1];
      std::sort(base.begin(), base.end());
      std::sort(triangle.begin(), triangle.end());
      wrong += t.Node != (first ? SlabTetrahedra::T1 : SlabTetrahedra::T2);
      wrong += base != triangle || t.Neighbours[3] >= 0;
      continue;
    }
    wrong += t.Node != SlabTetrahedra::T12;
    for (int side : { 0, 1 })
    {
      const auto& level = side == 0 ? view.Level1 : view.Level2;
      auto ends = EndsOf(level, t.Origin[side] / 3, t.Origin[side] % 3);
      std::array<int, 2> edge{ { t.Corners[2 * side], t.Corners[2 * side + 1] } };
      std::sort(ends.begin(), ends.end());
      std::sort(edge.begin(), edge.end());
      wrong += edge != ends;
    }
  }
  EXPECT_EQ(wrong, 0) << "tetrahedra that are not of their level's triangles and edges";
}

/// Every tetrahedron has a positive volume.
inline void ExpectPositive(const SlabView& view)
{
  int wrong = 0;
  for (int i = 0; i < view.Count(); ++i)
  {
    const auto c = view.GlobalCorners(i);
    wrong += CGAL::orientation(view.At(c[0]), view.At(c[1]), view.At(c[2]), view.At(c[3])) !=
      CGAL::POSITIVE;
  }
  EXPECT_EQ(wrong, 0) << "tetrahedra that are flat or turned over";
}

/// Each face belongs to two tetrahedra, which know each other across it, or to one, and then it
/// lies on the convex hull of both levels.
inline void ExpectFacesMatch(const SlabView& view)
{
  std::map<std::array<int, 3>, std::vector<std::array<int, 2>>> owners;
  for (int i = 0; i < view.Count(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      owners[view.Face(i, k)].push_back({ { i, k } });
    }
  }
  int overused = 0, strangers = 0;
  std::vector<std::array<int, 2>> single;
  for (const auto& entry : owners)
  {
    const auto& of = entry.second;
    overused += of.size() > 2;
    const auto neighbour = [&](const std::array<int, 2>& side)
    { return view.Slab.Tetrahedra[side[0]].Neighbours[side[1]]; };
    if (of.size() == 1)
    {
      strangers += neighbour(of[0]) >= 0;
      single.push_back(of[0]);
    }
    else
    {
      strangers += neighbour(of[0]) != of[1][0] || neighbour(of[1]) != of[0][0];
    }
  }
  EXPECT_EQ(overused, 0) << "faces of more than two tetrahedra";
  EXPECT_EQ(strangers, 0) << "faces whose two tetrahedra do not know each other";

  // The hull's corners are enough to tell whether a face supports all points.
  std::vector<int> corners;
  const int first2 = static_cast<int>(view.Level1.Points.size());
  for (int side : { 0, 1 })
  {
    const auto& level = side == 0 ? view.Level1 : view.Level2;
    for (std::size_t t = 0; t < level.Triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (level.Neighbours[t][k] < 0)
        {
          corners.push_back(EndsOf(level, static_cast<int>(t), k)[0] + side * first2);
        }
      }
    }
  }
  int inside = 0;
  for (const auto& s : single)
  {
    if (view.Slab.Tetrahedra[s[0]].Node != SlabTetrahedra::T12 && s[1] == 3)
    {
      continue; // the base of a T1 or T2 lies in the plane of its level
    }
    const auto c = view.GlobalCorners(s[0]);
    const auto f = view.Face(s[0], s[1]);
    const auto own =
      CGAL::orientation(view.At(f[0]), view.At(f[1]), view.At(f[2]), view.At(c[s[1]]));
    inside += std::any_of(corners.begin(), corners.end(),
      [&](int p)
      {
        const auto side =
          CGAL::orientation(view.At(f[0]), view.At(f[1]), view.At(f[2]), view.At(p));
        return side != CGAL::COPLANAR && side != own;
      });
  }
  EXPECT_EQ(inside, 0) << "faces of one tetrahedron that are not on the convex hull";
}

/// Twice the area of the convex polygon.
inline Rational TwiceArea(const std::vector<std::array<Rational, 2>>& polygon)
{
  Rational twice(0);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return twice;
}

/// Corners of the convex hull, counterclockwise from the lowest (leftmost of several).
inline std::vector<std::array<Rational, 2>> HullOf(const LevelTriangulation& level)
{
  std::vector<InexactKernel::Point_2> points, hull;
  for (std::size_t p = 0; p < level.Points.size(); ++p)
  {
    points.push_back(Planar(level, static_cast<int>(p)));
  }
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  const auto lowest = std::min_element(hull.begin(), hull.end(),
    [](const auto& a, const auto& b)
    { return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x()); });
  std::rotate(hull.begin(), lowest, hull.end());
  std::vector<std::array<Rational, 2>> corners;
  for (const auto& p : hull)
  {
    corners.push_back({ { Rational(p.x()), Rational(p.y()) } });
  }
  return corners;
}

/// The Minkowski sum of convex polygons that start at their lowest corner.
inline std::vector<std::array<Rational, 2>> MinkowskiSum(
  const std::vector<std::array<Rational, 2>>& p, const std::vector<std::array<Rational, 2>>& q)
{
  std::vector<std::array<Rational, 2>> sum;
  std::size_t i = 0, j = 0;
  while (i < p.size() || j < q.size())
  {
    const auto& a = p[i % p.size()];
    const auto& b = q[j % q.size()];
    sum.push_back({ { a[0] + b[0], a[1] + b[1] } });
    const auto& a2 = p[(i + 1) % p.size()];
    const auto& b2 = q[(j + 1) % q.size()];
    const Rational turn = (a2[0] - a[0]) * (b2[1] - b[1]) - (a2[1] - a[1]) * (b2[0] - b[0]);
    const bool stepP = j == q.size() || (i < p.size() && turn >= 0);
    const bool stepQ = i == p.size() || (j < q.size() && turn <= 0);
    i += stepP;
    j += stepQ;
  }
  return sum;
}

/**
 * The volumes sum exactly to that of the convex hull of both levels.
 *
 * With P and Q the hulls of the levels, the hull's cross-section at height s is (1 - s) P + s Q, so
 * six times its volume is 2 |P| + 2 |Q| + 2 M, where |P + Q| = |P| + |Q| + 2 M.
 *
 * Together with positive volumes and matching faces this means that no two tetrahedra overlap: how
 * often a point is covered can change only across faces of one tetrahedron, which are on the hull,
 * so it is the same everywhere inside, and by the sum of the volumes it is once.
 */
inline void ExpectFillsHull(const SlabView& view)
{
  const auto difference = [&](int a, int b)
  {
    const Point2 &p = view.PlanarOf(a), &q = view.PlanarOf(b);
    return std::array<Rational, 2>{ { Rational(q[0]) - Rational(p[0]),
      Rational(q[1]) - Rational(p[1]) } };
  };
  Rational sum(0); // six times the volume
  for (int i = 0; i < view.Count(); ++i)
  {
    const auto c = view.GlobalCorners(i);
    const bool isT12 = view.Slab.Tetrahedra[i].Node == SlabTetrahedra::T12;
    const auto u = difference(c[0], c[1]);
    const auto v = isT12 ? difference(c[2], c[3]) : difference(c[0], c[2]);
    const Rational cross = u[0] * v[1] - u[1] * v[0];
    sum += cross < 0 ? -cross : cross;
  }
  const auto p = HullOf(view.Level1), q = HullOf(view.Level2);
  const Rational p2 = TwiceArea(p), q2 = TwiceArea(q);
  const Rational mixed2 = TwiceArea(MinkowskiSum(p, q)) - p2 - q2; // 4 M
  EXPECT_TRUE(sum == p2 + q2 + mixed2 / 2)
    << "the tetrahedra fill " << CGAL::to_double(sum) / 6 << " of the hull's "
    << CGAL::to_double(p2 + q2 + mixed2 / 2) / 6;
}

/// Of every face between two tetrahedra: where the far corner is to the near one's circumsphere.
inline CGAL::Oriented_side SideOfSphere(const SlabView& view, int tetrahedron, int k)
{
  const auto c = view.GlobalCorners(tetrahedron);
  const int n = view.Slab.Tetrahedra[tetrahedron].Neighbours[k];
  const auto face = view.Face(tetrahedron, k);
  for (int far : view.GlobalCorners(n))
  {
    if (std::find(face.begin(), face.end(), far) == face.end())
    {
      return CGAL::side_of_oriented_sphere(
        view.At(c[0]), view.At(c[1]), view.At(c[2]), view.At(c[3]), view.At(far));
    }
  }
  return CGAL::ON_POSITIVE_SIDE; // the same four corners: never right
}

/// The empty sphere condition; being true at every face it is true for all points. Returns the
/// tetrahedra at faces whose five points are cospherical.
inline std::vector<bool> ExpectDelaunay3(const SlabView& view)
{
  std::vector<bool> tied(view.Count(), false);
  int wrong = 0;
  for (int i = 0; i < view.Count(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (view.Slab.Tetrahedra[i].Neighbours[k] >= 0)
      {
        const auto side = SideOfSphere(view, i, k);
        wrong += side == CGAL::ON_POSITIVE_SIDE;
        tied[i] = tied[i] || side == CGAL::ON_ORIENTED_BOUNDARY;
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "spheres that hold a point";
  return tied;
}

/// All of the above; returns how many tetrahedra have a tie.
inline int ExpectSoundSlab(const SlabView& view)
{
  ExpectNodeTypes(view);
  ExpectPositive(view);
  ExpectFacesMatch(view);
  ExpectFillsHull(view);
  const auto tied = ExpectDelaunay3(view);
  return static_cast<int>(std::count(tied.begin(), tied.end(), true));
}

using TetrahedronSet = std::set<std::array<int, 4>>;

/// The independent oracle, with the levels at these heights.
inline TetrahedronSet TetrahedraOfCGAL(const SlabView& view, double height1, double height2)
{
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<int, InexactKernel>;
  using Cell = CGAL::Delaunay_triangulation_cell_base_3<InexactKernel>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
  std::vector<std::pair<InexactKernel::Point_3, int>> points;
  const int count = static_cast<int>(view.Level1.Points.size() + view.Level2.Points.size());
  for (int p = 0; p < count; ++p)
  {
    points.emplace_back(view.At(p, height1, height2), p);
  }
  const CGAL::Delaunay_triangulation_3<InexactKernel, Structure> delaunay(
    points.begin(), points.end());
  TetrahedronSet tetrahedra;
  for (auto cell : delaunay.finite_cell_handles())
  {
    std::array<int, 4> corners{};
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = cell->vertex(k)->info();
    }
    std::sort(corners.begin(), corners.end());
    tetrahedra.insert(corners);
  }
  return tetrahedra;
}

/**
 * The same tetrahedra as CGAL's 3D Delaunay triangulation.
 *
 * A tetrahedron none of whose faces has a tie is in every Delaunay triangulation of the points, so
 * those must be CGAL's as well; where there is no tie at all the two sets are equal.
 * Returns the number of tetrahedra with a tie.
 */
inline int ExpectSameAsCGAL(const SlabView& view, double height1, double height2)
{
  const auto tied = ExpectDelaunay3(view);
  const TetrahedronSet expected = TetrahedraOfCGAL(view, height1, height2);
  TetrahedronSet built;
  int missing = 0;
  for (int i = 0; i < view.Count(); ++i)
  {
    auto corners = view.GlobalCorners(i);
    std::sort(corners.begin(), corners.end());
    built.insert(corners);
    missing += !tied[i] && expected.count(corners) == 0;
  }
  EXPECT_EQ(static_cast<int>(built.size()), view.Count()) << "a tetrahedron is there twice";
  EXPECT_EQ(missing, 0) << "tetrahedra that CGAL has not";
  const int ties = static_cast<int>(std::count(tied.begin(), tied.end(), true));
  if (ties == 0)
  {
    EXPECT_TRUE(built == expected)
      << built.size() << " tetrahedra, " << expected.size() << " of CGAL";
  }
  return ties;
}
}

#endif
