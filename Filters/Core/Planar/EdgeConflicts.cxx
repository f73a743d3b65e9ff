// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/EdgeConflicts.h"

#include "Base/Monitor.h"
#include "Base/Predicates.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
using EdgeBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;

/// The box about an edge, with so much around it.
EdgeBox BoxAbout(const Point2& a, const Point2& b, double near, int edge)
{
  return { CGAL::Bbox_2(std::min(a[0], b[0]) - near, std::min(a[1], b[1]) - near,
             std::max(a[0], b[0]) + near, std::max(a[1], b[1]) + near),
    edge };
}

/// Found as many as were asked for.
struct Enough
{
};

class ConflictFinder
{
public:
  ConflictFinder(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges,
    const std::vector<double>& tolerances, std::size_t mostCrossings)
    : Points(points),
      Edges(edges),
      Tolerances(tolerances),
      MostCrossings(mostCrossings)
  {
  }

  EdgeConflicts Find()
  {
    try
    {
      this->Search();
    }
    catch (const EnoughTwins&)
    {
      // What else there is shows once these are merged.
    }
    std::sort(this->Found.Crossings.begin(), this->Found.Crossings.end(),
      [](const auto& x, const auto& y)
      { return std::tie(x.First, x.Second) < std::tie(y.First, y.Second); });
    std::sort(this->Found.Touches.begin(), this->Found.Touches.end(),
      [](const auto& x, const auto& y)
      { return std::tie(x.Edge, x.Vertex, x.Other) < std::tie(y.Edge, y.Vertex, y.Other); });
    std::sort(this->Found.SamePlace.begin(), this->Found.SamePlace.end(),
      [](const auto& x, const auto& y)
      {
        return std::tie(x.First, x.Second, x.FirstEdge, x.OtherEdge) <
          std::tie(y.First, y.Second, y.FirstEdge, y.OtherEdge);
      });
    return std::move(this->Found);
  }

private:
  /// So many points near one another that all pairs of them would take time and memory in their square.
  struct EnoughTwins
  {
  };

  void Search()
  {
    std::vector<EdgeBox> boxes, settled;
    boxes.reserve(this->Edges.size());
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      const Point2& a = this->At(this->Edges[i].A);
      const Point2& b = this->At(this->Edges[i].B);
      const double near = this->ToleranceOf(this->Edges[i]);
      const CGAL::Bbox_2 box(std::min(a[0], b[0]) - near, std::min(a[1], b[1]) - near,
        std::max(a[0], b[0]) + near, std::max(a[1], b[1]) + near);
      (this->Edges[i].IsSettled ? settled : boxes).emplace_back(box, static_cast<int>(i));
      this->AddTwins(this->Edges[i].A, this->Edges[i].B, static_cast<int>(i), static_cast<int>(i));
    }
    const auto test = [this](const EdgeBox& x, const EdgeBox& y)
    { this->Test(std::min(x.info(), y.info()), std::max(x.info(), y.info())); };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), test);
    if (!settled.empty())
    {
      CGAL::box_intersection_d(boxes.begin(), boxes.end(), settled.begin(), settled.end(), test);
    }
  }

  const Point2& At(int p) const { return this->Points[p]; }

  double ToleranceOf(const PlanarEdge& e) const { return this->Tolerances[e.Tag]; }
  double ToleranceOf(int i, int j) const
  {
    return std::min(this->ToleranceOf(this->Edges[i]), this->ToleranceOf(this->Edges[j]));
  }

  void Test(int i, int j)
  {
    const PlanarEdge& e = this->Edges[i];
    const PlanarEdge& f = this->Edges[j];
    if (e.A == f.A || e.A == f.B || e.B == f.A || e.B == f.B)
    {
      this->TestFan(i, j);
      return;
    }
    if (this->AreTwins(i, j) || this->NearlyTouch(i, j))
    {
      return;
    }
    const Point2& a = this->At(e.A);
    const Point2& b = this->At(e.B);
    const Point2& c = this->At(f.A);
    const Point2& d = this->At(f.B);
    const int abc = Orientation2(a, b, c);
    const int abd = Orientation2(a, b, d);
    if (abc * abd > 0)
    {
      return;
    }
    const int cda = Orientation2(c, d, a);
    const int cdb = Orientation2(c, d, b);
    if (cda * cdb > 0)
    {
      return;
    }
    if (abc * abd < 0 && cda * cdb < 0)
    {
      if (this->Found.Crossings.size() == this->MostCrossings)
      {
        throw Error("Contours cross one another more than " + std::to_string(this->MostCrossings) +
          " times, which is no outline of anything.");
      }
      this->Found.Crossings.push_back({ i, j });
      return;
    }
    this->Touch(abc, i, j, f.A);
    this->Touch(abd, i, j, f.B);
    this->Touch(cda, j, i, e.A);
    this->Touch(cdb, j, i, e.B);
  }

  bool AreTwins(int i, int j)
  {
    const PlanarEdge& e = this->Edges[i];
    const PlanarEdge& f = this->Edges[j];
    bool any = false;
    for (int p : { e.A, e.B })
    {
      for (int q : { f.A, f.B })
      {
        any = this->AddTwins(p, q, i, j) || any;
      }
    }
    return any;
  }

  bool AddTwins(int p, int q, int i, int j)
  {
    if (!(Distance(this->At(p), this->At(q)) <= this->ToleranceOf(i, j)))
    {
      return false;
    }
    this->Found.SamePlace.push_back({ std::min(p, q), std::max(p, q), i, j });
    if (this->Found.SamePlace.size() > this->MostCrossings)
    {
      throw EnoughTwins();
    }
    return true;
  }

  bool NearlyTouch(int i, int j)
  {
    const PlanarEdge& e = this->Edges[i];
    const PlanarEdge& f = this->Edges[j];
    const bool first = this->TouchIfNear(i, j, f.A);
    const bool second = this->TouchIfNear(i, j, f.B);
    const bool third = this->TouchIfNear(j, i, e.A);
    const bool fourth = this->TouchIfNear(j, i, e.B);
    return first || second || third || fourth;
  }

  bool TouchIfNear(int edge, int other, int vertex)
  {
    const PlanarEdge& e = this->Edges[edge];
    const Point2& a = this->At(e.A);
    const Point2 along{ this->At(e.B)[0] - a[0], this->At(e.B)[1] - a[1] };
    const Point2 to{ this->At(vertex)[0] - a[0], this->At(vertex)[1] - a[1] };
    const double length2 = along[0] * along[0] + along[1] * along[1];
    const double forward = along[0] * to[0] + along[1] * to[1];
    const double aside = along[0] * to[1] - along[1] * to[0];
    if (forward <= 0 || forward >= length2 ||
      std::abs(aside) > this->ToleranceOf(edge, other) * std::sqrt(length2))
    {
      return false;
    }
    this->Found.Touches.push_back({ edge, other, vertex });
    return true;
  }

  /// Two edges of one end point overlap where they leave it in the same direction.
  void TestFan(int i, int j)
  {
    const PlanarEdge& e = this->Edges[i];
    const PlanarEdge& f = this->Edges[j];
    const int common = (e.A == f.A || e.A == f.B) ? e.A : e.B;
    const int p = e.A == common ? e.B : e.A;
    const int q = f.A == common ? f.B : f.A;
    if (this->AddTwins(p, q, i, j))
    {
      return;
    }
    const bool first = this->TouchIfNear(i, j, q);
    const bool second = this->TouchIfNear(j, i, p);
    if (!first && !second && Orientation2(this->At(common), this->At(p), this->At(q)) == 0)
    {
      this->Touch(0, i, j, q);
      this->Touch(0, j, i, p);
    }
  }

  void Touch(int turn, int edge, int other, int vertex)
  {
    const PlanarEdge& e = this->Edges[edge];
    if (turn == 0 && StrictlyBetween(this->At(e.A), this->At(e.B), this->At(vertex)))
    {
      this->Found.Touches.push_back({ edge, other, vertex });
    }
  }

  const std::vector<Point2>& Points;
  const std::vector<PlanarEdge>& Edges;
  const std::vector<double>& Tolerances;
  std::size_t MostCrossings;
  EdgeConflicts Found;
};
}

EdgeConflicts FindEdgeConflicts(const std::vector<Point2>& points,
  const std::vector<PlanarEdge>& edges, const std::vector<double>& tolerances,
  std::size_t mostCrossings)
{
  return ConflictFinder(points, edges, tolerances, mostCrossings).Find();
}

bool CrossMoreOftenThan(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges,
  std::size_t mostCrossings)
{
  const auto at = [&](int p) { return points[static_cast<std::size_t>(p)]; };
  std::vector<EdgeBox> boxes;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    boxes.push_back(BoxAbout(at(edges[i].A), at(edges[i].B), 0, static_cast<int>(i)));
  }
  std::size_t crossings = 0;
  const auto count = [&](const EdgeBox& x, const EdgeBox& y)
  {
    const PlanarEdge& e = edges[static_cast<std::size_t>(x.info())];
    const PlanarEdge& f = edges[static_cast<std::size_t>(y.info())];
    const bool parts =
      Orientation2(at(e.A), at(e.B), at(f.A)) * Orientation2(at(e.A), at(e.B), at(f.B)) < 0 &&
      Orientation2(at(f.A), at(f.B), at(e.A)) * Orientation2(at(f.A), at(f.B), at(e.B)) < 0;
    crossings += parts ? 1 : 0;
    if (crossings > mostCrossings)
    {
      throw Enough();
    }
  };
  try
  {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), count);
  }
  catch (const Enough&)
  {
    return true;
  }
  return false;
}

Point2 CrossingPoint(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  using Rational = CGAL::Exact_rational;
  const Rational ux = Rational(b[0]) - Rational(a[0]);
  const Rational uy = Rational(b[1]) - Rational(a[1]);
  const Rational vx = Rational(d[0]) - Rational(c[0]);
  const Rational vy = Rational(d[1]) - Rational(c[1]);
  const Rational wx = Rational(c[0]) - Rational(a[0]);
  const Rational wy = Rational(c[1]) - Rational(a[1]);
  const Rational t = (wx * vy - wy * vx) / (ux * vy - uy * vx);
  return { CGAL::to_double(Rational(a[0]) + t * ux), CGAL::to_double(Rational(a[1]) + t * uy) };
}
}
