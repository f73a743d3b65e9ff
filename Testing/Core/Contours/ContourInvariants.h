// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourInvariants.h
 * @brief What the comment on recon::ContourSet guarantees, checked from the definitions.
 *
 * Deliberately slow and simple where the code under test is clever: crossings by a plain scan of
 * boxes, nesting by counting crossings of a ray in exact arithmetic.
 */
#ifndef recon_ContourInvariants_h
#define recon_ContourInvariants_h

#include "Base/Predicates.h"
#include "Contours/ContourSet.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace recon::testing
{
inline std::size_t At(int i)
{
  return static_cast<std::size_t>(i);
}

/// Every contour edge of a level as (point, point, contour).
struct LevelEdge
{
  int A, B, Contour;
};

inline std::vector<LevelEdge> EdgesOf(const ContourSet& set, const Level& level)
{
  std::vector<LevelEdge> edges;
  for (int c : level.Contours)
  {
    const std::vector<int>& p = set.Contours[At(c)].Points;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      edges.push_back({ p[i], p[(i + 1) % p.size()], c });
    }
  }
  return edges;
}

/// Two edges may share an end point and nothing else.
inline bool EdgesMeetWrongly(const ContourSet& set, const LevelEdge& e, const LevelEdge& f)
{
  const Point2& a = set.Planar[At(e.A)];
  const Point2& b = set.Planar[At(e.B)];
  const Point2& c = set.Planar[At(f.A)];
  const Point2& d = set.Planar[At(f.B)];
  const int abc = Orientation2(a, b, c), abd = Orientation2(a, b, d), cda = Orientation2(c, d, a),
            cdb = Orientation2(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0)
  {
    return true;
  }
  const bool touches = (abc == 0 && StrictlyBetween(a, b, c)) ||
    (abd == 0 && StrictlyBetween(a, b, d)) || (cda == 0 && StrictlyBetween(c, d, a)) ||
    (cdb == 0 && StrictlyBetween(c, d, b));
  return touches || std::minmax(e.A, e.B) == std::minmax(f.A, f.B);
}

inline ::testing::AssertionResult EdgesAreClean(const ContourSet& set, const Level& level)
{
  std::vector<LevelEdge> edges = EdgesOf(set, level);
  const auto low = [&](const LevelEdge& e)
  { return std::min(set.Planar[At(e.A)][0], set.Planar[At(e.B)][0]); };
  const auto high = [&](const LevelEdge& e)
  { return std::max(set.Planar[At(e.A)][0], set.Planar[At(e.B)][0]); };
  std::sort(edges.begin(), edges.end(),
    [&](const LevelEdge& e, const LevelEdge& f) { return low(e) < low(f); });
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    for (std::size_t j = i + 1; j < edges.size() && low(edges[j]) <= high(edges[i]); ++j)
    {
      if (EdgesMeetWrongly(set, edges[i], edges[j]))
      {
        return ::testing::AssertionFailure()
          << "edges of contours " << edges[i].Contour << " and " << edges[j].Contour
          << " cross or overlap at offset " << level.Offset;
      }
    }
  }
  return ::testing::AssertionSuccess();
}

/// Is q strictly inside the polygon? -1 where it lies on it. Exact.
inline int Encloses(const ContourSet& set, const Contour& contour, const Point2& q)
{
  bool inside = false;
  const std::vector<int>& p = contour.Points;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point2& a = set.Planar[At(p[i])];
    const Point2& b = set.Planar[At(p[(i + 1) % p.size()])];
    if (a == q || (Orientation2(a, b, q) == 0 && StrictlyBetween(a, b, q)))
    {
      return -1;
    }
    if ((a[1] > q[1]) != (b[1] > q[1]))
    {
      const int turn = a[1] < b[1] ? Orientation2(a, b, q) : Orientation2(b, a, q);
      inside = (turn > 0) != inside;
    }
  }
  return inside ? 1 : 0;
}

/// Is contour a inside contour b? By the first vertex of a that is not on b, else by a's edge
/// midpoints.
inline bool LiesIn(const ContourSet& set, const Contour& a, const Contour& b)
{
  for (int p : a.Points)
  {
    const int where = Encloses(set, b, set.Planar[At(p)]);
    if (where >= 0)
    {
      return where == 1;
    }
  }
  for (std::size_t i = 0; i < a.Points.size(); ++i)
  {
    const Point2& u = set.Planar[At(a.Points[i])];
    const Point2& v = set.Planar[At(a.Points[(i + 1) % a.Points.size()])];
    const int where = Encloses(set, b, { 0.5 * (u[0] + v[0]), 0.5 * (u[1] + v[1]) });
    if (where >= 0)
    {
      return where == 1;
    }
  }
  ADD_FAILURE() << "two contours of the same outline";
  return false;
}

/// In exact arithmetic, rounded once.
inline double ShoelaceArea(const ContourSet& set, const Contour& contour)
{
  using Rational = CGAL::Exact_rational;
  const std::vector<int>& p = contour.Points;
  Rational twice(0);
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point2& a = set.Planar[At(p[i])];
    const Point2& b = set.Planar[At(p[(i + 1) % p.size()])];
    twice += (Rational(a[0]) + Rational(b[0])) * (Rational(b[1]) - Rational(a[1]));
  }
  return 0.5 * CGAL::to_double(twice);
}

inline void CheckContour(const ContourSet& set, const Contour& contour)
{
  EXPECT_GE(contour.Points.size(), 3u);
  const std::set<int> distinct(contour.Points.begin(), contour.Points.end());
  EXPECT_EQ(distinct.size(), contour.Points.size()) << "a contour passes a point twice";
  const double area = ShoelaceArea(set, contour);
  EXPECT_NE(contour.SignedArea, 0);
  EXPECT_EQ(contour.SignedArea > 0, contour.Depth % 2 == 0) << "sign of area against depth";
  EXPECT_NEAR(contour.SignedArea, area, 1e-9 * std::abs(area) + 1e-300);
}

inline void CheckForest(const ContourSet& set, const Level& level)
{
  for (int c : level.Contours)
  {
    const Contour& contour = set.Contours[At(c)];
    int around = 0;
    int deepest = -1;
    for (int other : level.Contours)
    {
      const Contour& o = set.Contours[At(other)];
      if (other != c && std::abs(o.SignedArea) > std::abs(contour.SignedArea) &&
        LiesIn(set, contour, o))
      {
        ++around;
        deepest = deepest < 0 || set.Contours[At(deepest)].Depth < o.Depth ? other : deepest;
      }
    }
    EXPECT_EQ(contour.Depth, around) << "contour " << c;
    EXPECT_EQ(contour.Parent, deepest) << "contour " << c;
  }
}

inline void CheckLevel(const ContourSet& set, int number, double tolerance)
{
  const Level& level = set.Levels[At(number)];
  const PlanarFrame& f = level.Frame;
  EXPECT_NEAR(Norm(f.Normal), 1, 1e-14);
  EXPECT_NEAR(Norm(Cross(f.U, f.V) - f.Normal), 0, 1e-14);
  EXPECT_FALSE(level.Contours.empty());
  std::set<int> used;
  for (int c : level.Contours)
  {
    EXPECT_EQ(set.Contours[At(c)].Level, number);
    CheckContour(set, set.Contours[At(c)]);
    used.insert(set.Contours[At(c)].Points.begin(), set.Contours[At(c)].Points.end());
  }
  std::set<Point2> places;
  for (int p : used)
  {
    places.insert(set.Planar[At(p)]);
    EXPECT_NEAR(f.OffsetOf(set.Points[At(p)]), level.Offset, tolerance);
    EXPECT_NEAR(f.OffsetOf(set.Points[At(p)]), level.Offset,
      level.Thickness + 1e-14 * (1 + Norm(set.Points[At(p)])));
    const Point2 planar = f.ToPlane(set.Points[At(p)]);
    for (std::size_t k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(planar[k], set.Planar[At(p)][k], level.Grid + 1e-9 * (1 + std::abs(planar[k])));
    }
  }
  EXPECT_EQ(places.size(), used.size()) << "two points of a level have equal planar coordinates";
  EXPECT_TRUE(EdgesAreClean(set, level));
  CheckForest(set, level);
}

/// Everything that a ContourSet guarantees.
/// @param tolerance farthest distance of a point from its level
inline void CheckContourSet(const ContourSet& set, double tolerance)
{
  ASSERT_EQ(set.Points.size(), set.Planar.size());
  ASSERT_FALSE(set.Contours.empty());
  std::set<int> owner;
  std::size_t listed = 0;
  for (std::size_t l = 0; l < set.Levels.size(); ++l)
  {
    CheckLevel(set, static_cast<int>(l), tolerance);
    listed += set.Levels[l].Contours.size();
    if (set.Parallel && l > 0)
    {
      EXPECT_LT(set.Levels[l - 1].Offset, set.Levels[l].Offset);
      EXPECT_EQ(set.Levels[l - 1].Frame.Normal, set.Levels[l].Frame.Normal);
      EXPECT_EQ(set.Levels[l - 1].Frame.U, set.Levels[l].Frame.U);
    }
  }
  EXPECT_EQ(listed, set.Contours.size());
  EXPECT_TRUE(std::is_sorted(set.Contours.begin(), set.Contours.end(),
    [](const Contour& a, const Contour& b) { return a.Level < b.Level; }));
  std::map<int, int> levelOfPoint;
  for (const Contour& c : set.Contours)
  {
    for (int p : c.Points)
    {
      EXPECT_EQ(levelOfPoint.emplace(p, c.Level).first->second, c.Level);
    }
  }
  EXPECT_EQ(levelOfPoint.size(), set.Points.size()) << "points that no contour uses";
}

/// Sum of signed areas: the area of the solid.
inline double SolidArea(const ContourSet& set)
{
  return std::accumulate(set.Contours.begin(), set.Contours.end(), 0.0,
    [](double sum, const Contour& c) { return sum + c.SignedArea; });
}

/// Does any sentence of the report contain the text?
inline bool Reports(const ContourSet& set, const std::string& text)
{
  return std::any_of(set.Report.begin(), set.Report.end(),
    [&](const std::string& line) { return line.find(text) != std::string::npos; });
}
}

#endif
