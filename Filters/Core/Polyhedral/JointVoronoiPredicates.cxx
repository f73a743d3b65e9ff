// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/JointVoronoiPredicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;

/// More than the number of roundings on the longest path of any filtered expression here, each of
/// which errs by at most half an epsilon of the sum of absolute values.
constexpr double FilterFactor = 32 * std::numeric_limits<double>::epsilon();

/// Below this a bound may itself have lost bits to underflow, and the filter does not apply.
constexpr double SmallestBound = 1e-250;

/// The sign of value where the filter is sure, otherwise that of exact().
template <typename ExactSign>
int FilteredSign(double value, double sumOfAbsoluteValues, ExactSign exact)
{
  const double bound = FilterFactor * sumOfAbsoluteValues;
  if (bound > SmallestBound && std::abs(value) > bound)
  {
    return value > 0 ? 1 : -1;
  }
  return exact();
}

template <typename Number>
Number CrossDifference(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  return (Number(b[0]) - Number(a[0])) * (Number(d[1]) - Number(c[1])) -
    (Number(b[1]) - Number(a[1])) * (Number(d[0]) - Number(c[0]));
}

double DifferenceBound(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  return (std::abs(b[0] - a[0]) + std::abs(b[1] - a[1])) *
    (std::abs(d[0] - c[0]) + std::abs(d[1] - c[1]));
}

/// Sign of |2m - 2u|^2 - |2m - 2v|^2 with 2m = a + b: positive where v is nearer to the midpoint.
int SignOfMidpointDistance(const Point2& a, const Point2& b, const Point2& u, const Point2& v)
{
  // |s - 2u|^2 - |s - 2v|^2 = 4 (v - u) . (s - u - v), with s = a + b
  double value = 0;
  double bound = 0;
  for (int k = 0; k < 2; ++k)
  {
    const double difference = v[k] - u[k];
    const double rest = (a[k] - u[k]) + (b[k] - v[k]);
    value += difference * rest;
    bound += std::abs(difference) * (std::abs(a[k] - u[k]) + std::abs(b[k] - v[k]));
  }
  return FilteredSign(value, bound,
    [&]
    {
      Exact exact = 0;
      for (int k = 0; k < 2; ++k)
      {
        exact +=
          (Exact(v[k]) - Exact(u[k])) * (Exact(a[k]) + Exact(b[k]) - Exact(u[k]) - Exact(v[k]));
      }
      return static_cast<int>(CGAL::sign(exact));
    });
}
}

CircumcentreDistance::CircumcentreDistance(const LevelTriangulation& triangles, bool seenFromLevel1)
  : Triangles(triangles),
    SeenFromLevel1(seenFromLevel1)
{
  this->Circumcentres.reserve(triangles.Triangles.size());
  for (const auto& t : triangles.Triangles)
  {
    const Point2& o = triangles.Points[t[0]];
    const double bx = triangles.Points[t[1]][0] - o[0], by = triangles.Points[t[1]][1] - o[1];
    const double cx = triangles.Points[t[2]][0] - o[0], cy = triangles.Points[t[2]][1] - o[1];
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    this->Circumcentres.push_back({ bx * cy - by * cx, std::abs(bx * cy) + std::abs(by * cx),
      { b2 * cy - c2 * by, c2 * bx - b2 * cx },
      b2 * (std::abs(cx) + std::abs(cy)) + c2 * (std::abs(bx) + std::abs(by)) });
  }
}

bool CircumcentreDistance::IsNearer(int triangle, const Point2& p, const Point2& q) const
{
  // |c - p|^2 - |c - q|^2 = |p|^2 - |q|^2 - 2 c . (p - q); times Determinant, which is positive.
  const Circumcentre& c = this->Circumcentres[triangle];
  const Point2& o = this->Triangles.Points[this->Triangles.Triangles[triangle][0]];
  const double px = p[0] - o[0], py = p[1] - o[1], qx = q[0] - o[0], qy = q[1] - o[1];
  const double p2 = px * px + py * py, q2 = qx * qx + qy * qy;
  const double value =
    c.Determinant * (p2 - q2) - (c.Numerator[0] * (px - qx) + c.Numerator[1] * (py - qy));
  const double bound = FilterFactor *
    (c.DeterminantBound * (p2 + q2) +
      c.NumeratorBound * (std::abs(px) + std::abs(py) + std::abs(qx) + std::abs(qy)));
  if (bound > SmallestBound && std::abs(value) > bound)
  {
    return value < 0;
  }
  return this->IsNearerExactly(triangle, p, q);
}

bool CircumcentreDistance::IsNearerExactly(int triangle, const Point2& p, const Point2& q) const
{
  const auto& t = this->Triangles.Triangles[triangle];
  const auto at = [](const Point2& point, double height)
  { return Kernel::Point_3(point[0], point[1], height); };
  const auto side = CGAL::side_of_bounded_sphere(at(this->Triangles.Points[t[0]], 0),
    at(this->Triangles.Points[t[1]], 0), at(this->Triangles.Points[t[2]], 0), at(q, 1), at(p, 1));
  if (side != CGAL::ON_BOUNDARY)
  {
    return side == CGAL::ON_BOUNDED_SIDE;
  }
  return this->SeenFromLevel1 ? p > q : p < q;
}

int SignAlongRightNormal(const Point2& u, const Point2& v, const Point2& a, const Point2& b)
{
  // right normal of (dx, dy) is (dy, -dx), so the product is (b - a) x (v - u)
  return FilteredSign(CrossDifference<double>(a, b, u, v), DifferenceBound(a, b, u, v),
    [&] { return static_cast<int>(CGAL::sign(CrossDifference<Exact>(a, b, u, v))); });
}

int SideOfNode(const Point2& a, const Point2& b, const Point2& u, const Point2& v)
{
  // The node is m + s n, m the midpoint of a-b and n its left normal; equally far from u and v
  // means |m - u|^2 - |m - v|^2 = 2 s n . (u - v).
  const int distance = SignOfMidpointDistance(a, b, u, v);
  const int along = -SignAlongRightNormal(a, b, v, u);
  return distance * along;
}

namespace
{
/// The crossing of a bisector with that of From and To: at N / D along it, from the middle of a-b
/// and in half lengths of a-b; with the shift of From and To by e, N grows by 2 e . (To - From).
template <typename Number>
struct AlongBisector
{
  std::array<Number, 2> Way; ///< To - From
  Number N;
  Number D;

  AlongBisector(const Point2& a, const Point2& b, const CellCrossing& c)
    : Way{ { Number(c.To[0]) - Number(c.From[0]), Number(c.To[1]) - Number(c.From[1]) } },
      N(Way[0] * ((Number(c.From[0]) - Number(a[0])) + (Number(c.To[0]) - Number(b[0]))) +
        Way[1] * ((Number(c.From[1]) - Number(a[1])) + (Number(c.To[1]) - Number(b[1])))),
      D((Number(b[1]) - Number(a[1])) * Way[0] - (Number(b[0]) - Number(a[0])) * Way[1])
  {
  }
};

/// Bounds on the sums of absolute values in N and D.
Point2 BoundsAlongBisector(const Point2& a, const Point2& b, const CellCrossing& c)
{
  Point2 bounds{ { 0, 0 } };
  for (int k = 0; k < 2; ++k)
  {
    const double way = std::abs(c.To[k] - c.From[k]);
    bounds[0] += way * (std::abs(c.From[k] - a[k]) + std::abs(c.To[k] - b[k]));
    bounds[1] += way * std::abs(b[1 - k] - a[1 - k]);
  }
  return bounds;
}

int CompareExactly(
  const Point2& a, const Point2& b, bool ofLevel1, const CellCrossing& p, const CellCrossing& q)
{
  const AlongBisector<Exact> first(a, b, p);
  const AlongBisector<Exact> second(a, b, q);
  const int sign = static_cast<int>(CGAL::sign(first.N * second.D - second.N * first.D));
  if (sign != 0)
  {
    return sign;
  }
  for (int k = 0; k < 2; ++k)
  {
    const int shifted =
      static_cast<int>(CGAL::sign(first.Way[k] * second.D - second.Way[k] * first.D));
    if (shifted != 0)
    {
      return ofLevel1 ? -shifted : shifted;
    }
  }
  return 0;
}
}

int CompareAlongBisector(
  const Point2& a, const Point2& b, bool ofLevel1, const CellCrossing& p, const CellCrossing& q)
{
  const AlongBisector<double> first(a, b, p);
  const AlongBisector<double> second(a, b, q);
  const Point2 bounds1 = BoundsAlongBisector(a, b, p);
  const Point2 bounds2 = BoundsAlongBisector(a, b, q);
  return FilteredSign(first.N * second.D - second.N * first.D,
    bounds1[0] * bounds2[1] + bounds2[0] * bounds1[1],
    [&] { return CompareExactly(a, b, ofLevel1, p, q); });
}
}
