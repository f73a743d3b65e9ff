// SPDX-License-Identifier: GPL-3.0-or-later
/*
 * Notation. s, t the triangles, S and T their planes, L the line in which S and T meet.
 *
 * In different planes the triangles meet, if at all, in a segment of L: the common part of
 * I = s n T and J = t n S. This is the interval test of Guigue and Devillers (Fast and Robust
 * Triangle-Triangle Overlap Test Using Orientation Predicates, 2003), told apart further:
 * - I has inner points of s only where corners of s lie strictly on both sides of T;
 * - the common part is longer than a point only where the intervals overlap strictly.
 */
#include "Mesh/TrianglePair.h"

#include "Base/Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace recon
{
namespace
{
using Corners = std::array<const Point3*, 3>;
using Signs = std::array<int, 3>;

Corners CornersOf(const TriangleMesh& mesh, int t)
{
  const auto& corners = mesh.Triangles[t];
  return { &mesh.Points[corners[0]], &mesh.Points[corners[1]], &mesh.Points[corners[2]] };
}

Signs SidesOf(const Corners& plane, const Corners& corners)
{
  Signs signs{};
  for (int k = 0; k < 3; ++k)
  {
    // A common corner, by index or by place, lies in the plane; the filter could not settle that.
    const Point3& p = *corners[k];
    const bool common = p == *plane[0] || p == *plane[1] || p == *plane[2];
    signs[k] = common ? 0 : Orientation3(*plane[0], *plane[1], *plane[2], p);
  }
  return signs;
}

/// The same as far as the filter settles it. @returns whether that is all
bool FilterSides(const Corners& plane, const Corners& corners, Signs& signs)
{
  bool settled = true;
  for (int k = 0; k < 3; ++k)
  {
    const Point3& p = *corners[k];
    const bool common = p == *plane[0] || p == *plane[1] || p == *plane[2];
    signs[k] = common ? 0 : FilteredOrientation3(*plane[0], *plane[1], *plane[2], p);
    settled = settled && (common || signs[k] != 0);
  }
  return settled;
}

bool AllOnOneSide(const Signs& signs)
{
  return signs[0] != 0 && signs[0] == signs[1] && signs[1] == signs[2];
}

bool IsFlat(const Corners& c)
{
  return Collinear(*c[0], *c[1], *c[2]);
}

/**
 * A triangle turned so that its first corner is on the positive side of the other's plane, or on
 * it, and the two others on the negative side, or on it; the other's plane is turned over for it if
 * need be.
 */
struct Turned
{
  Corners Corner;
  Signs Side;
  bool PlaneTurnedOver;

  /// Corners strictly on both sides.
  bool Straddles() const { return this->Side[0] > 0 && std::min(this->Side[1], this->Side[2]) < 0; }
  /// Its interval on the line is longer than a point.
  bool HasInterval() const { return this->Side[0] > 0; }
};

Turned Turn(const Corners& corners, const Signs& signs)
{
  for (const int flip : { 1, -1 })
  {
    for (int k = 0; k < 3; ++k)
    {
      const int first = flip * signs[k];
      const int second = flip * signs[(k + 1) % 3];
      const int third = flip * signs[(k + 2) % 3];
      // At least one of the others strictly below where the first is on the plane, or the first
      // strictly above.
      const bool alone =
        second <= 0 && third <= 0 && (first > 0 || (first == 0 && second < 0 && third < 0));
      if (alone)
      {
        return { { corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3] },
          { first, second, third }, flip < 0 };
      }
    }
  }
  // Not reached: all zero is coplanar and all of one sign is apart, which the caller has ruled out.
  return { corners, signs, false };
}

PairRelation RelateAcrossPlanes(
  const Corners& s, const Corners& t, const Signs& sidesOfS, const Signs& sidesOfT, int shared)
{
  Turned a = Turn(s, sidesOfS);
  Turned b = Turn(t, sidesOfT);
  if (a.PlaneTurnedOver)
  {
    std::swap(b.Corner[1], b.Corner[2]);
    std::swap(b.Side[1], b.Side[2]);
  }
  if (b.PlaneTurnedOver)
  {
    std::swap(a.Corner[1], a.Corner[2]);
    std::swap(a.Side[1], a.Side[2]);
  }
  const int low = Orientation3(*a.Corner[0], *a.Corner[1], *b.Corner[0], *b.Corner[1]);
  const int high = Orientation3(*a.Corner[0], *a.Corner[2], *b.Corner[2], *b.Corner[0]);
  if (low > 0 || high > 0)
  {
    return PairRelation::Clean;
  }
  const bool isSegment = low < 0 && high < 0 && a.HasInterval() && b.HasInterval();
  if (!isSegment)
  {
    // One point; where they share a corner, it is that.
    return shared > 0 ? PairRelation::Clean : PairRelation::Touching;
  }
  return a.Straddles() && b.Straddles() ? PairRelation::Crossing : PairRelation::Touching;
}

class Projection
{
public:
  explicit Projection(int axis) : Axis(axis) {}

  /// Along the first axis that leaves the triangle an area, counterclockwise.
  explicit Projection(const Corners& c)
  {
    for (this->Axis = 0; this->Axis < 2; ++this->Axis)
    {
      if (Orientation2((*this)(*c[0]), (*this)(*c[1]), (*this)(*c[2])) != 0)
      {
        return;
      }
    }
  }

  Point2 operator()(const Point3& p) const
  {
    return { p[(this->Axis + 1) % 3], p[(this->Axis + 2) % 3] };
  }

private:
  int Axis;
};

/// Whether in the projection a line along a side of one triangle has it on the one side and the other
/// triangle strictly on the other, apart from corners that are both's (by index).
bool AreParted(const Corners& one, const Corners& other, const Projection& project)
{
  for (int k = 0; k < 3; ++k)
  {
    const Point3* from = one[k];
    const Point3* to = one[(k + 1) % 3];
    const int own = Orientation2(project(*from), project(*to), project(*one[(k + 2) % 3]));
    const auto isBeyond = [&](const Point3* p) {
      return p == from || p == to ||
        Orientation2(project(*from), project(*to), project(*p)) == -own;
    };
    if (own != 0 && std::all_of(other.begin(), other.end(), isBeyond))
    {
      return true;
    }
  }
  return false;
}

/// Whether their shadows show that they meet in no more than what they share by index: what lies nearly
/// in one plane is told by them at once. Which axis they are cast along is a matter of speed only.
bool AreApartInShadow(const Corners& s, const Corners& t)
{
  const Vector3 normal = Cross(*s[1] - *s[0], *s[2] - *s[0]);
  int axis = std::abs(normal[1]) > std::abs(normal[0]) ? 1 : 0;
  axis = std::abs(normal[2]) > std::abs(normal[axis]) ? 2 : axis;
  const Projection project(axis);
  return AreParted(s, t, project) || AreParted(t, s, project);
}

using Flat = std::array<Point2, 3>;

Flat Flatten(const Corners& c, const Projection& project)
{
  Flat flat{ project(*c[0]), project(*c[1]), project(*c[2]) };
  if (Orientation2(flat[0], flat[1], flat[2]) < 0)
  {
    std::swap(flat[1], flat[2]);
  }
  return flat;
}

/// The smallest over the edges of a of the largest side of b's corners: -1 apart, 0 touching, 1
/// neither.
int LeastSide(const Flat& a, const Flat& b)
{
  int least = 1;
  for (int k = 0; k < 3; ++k)
  {
    int side = -1;
    for (const auto& p : b)
    {
      side = std::max(side, Orientation2(a[k], a[(k + 1) % 3], p));
    }
    least = std::min(least, side);
  }
  return least;
}

/// Whether an edge of a and one of b run from point v in the same direction.
bool ShareADirection(const Flat& a, const Flat& b, const Point2& v)
{
  for (const auto& p : a)
  {
    for (const auto& q : b)
    {
      // Lexicographic order tells the two directions of a line apart exactly.
      if (p != v && q != v && (p < v) == (q < v) && Orientation2(v, p, q) == 0)
      {
        return true;
      }
    }
  }
  return false;
}

PairRelation RelateInPlane(
  const Corners& s, const Corners& t, int shared, const Point3* sharedCorner)
{
  const Projection project(s);
  const Flat a = Flatten(s, project);
  const Flat b = Flatten(t, project);
  // Two convex polygons are apart, or merely touch, exactly where a line along an edge of one parts
  // them.
  const int side = std::min(LeastSide(a, b), LeastSide(b, a));
  if (side > 0)
  {
    return PairRelation::Overlapping;
  }
  if (side < 0 || shared == 2)
  {
    return PairRelation::Clean;
  }
  if (shared == 1 && !ShareADirection(a, b, project(*sharedCorner)))
  {
    return PairRelation::Clean;
  }
  return PairRelation::Touching;
}
}

namespace
{
/// Corners of s and of t, those that they share first.
struct SharedCorners
{
  int Count = 0;
  std::array<const Point3*, 3> OfS{};
  std::array<const Point3*, 3> OfT{};
};

SharedCorners FindSharedCorners(const TriangleMesh& mesh, int s, int t)
{
  const auto& first = mesh.Triangles[s];
  const auto& second = mesh.Triangles[t];
  SharedCorners corners;
  corners.OfS.fill(&mesh.Points[first[0]]); // of triangles that have a corner twice
  corners.OfT.fill(&mesh.Points[second[0]]);
  std::size_t shared = 0, restOfS = 3, restOfT = 3;
  for (const int p : second)
  {
    const bool isShared = p == first[0] || p == first[1] || p == first[2];
    corners.OfT[isShared ? shared++ : --restOfT] = &mesh.Points[p];
  }
  corners.Count = static_cast<int>(shared);
  for (const int p : first)
  {
    const bool isShared = p == second[0] || p == second[1] || p == second[2];
    if (!isShared)
    {
      corners.OfS[--restOfS] = &mesh.Points[p];
    }
  }
  std::copy_n(corners.OfT.begin(), shared, corners.OfS.begin());
  return corners;
}

Vector3 UnitOf(const Vector3& v)
{
  return (1 / Norm(v)) * v;
}

/// The sign of the product is beyond doubt, though its vectors are differences that were rounded.
bool IsClearlyPositive(const Vector3& n, const Vector3& v)
{
  const double sum = std::fabs(n[0] * v[0]) + std::fabs(n[1] * v[1]) + std::fabs(n[2] * v[2]);
  return Dot(n, v) > 1e-14 * sum && sum > 1e-280;
}

/// One corner in common, and a plane through it clearly between all the others.
bool ArePartedAtCorner(const SharedCorners& corners)
{
  const Point3& v = *corners.OfS[0];
  const Vector3 a = *corners.OfS[1] - v, b = *corners.OfS[2] - v;
  const Vector3 c = *corners.OfT[1] - v, d = *corners.OfT[2] - v;
  const Vector3 n = UnitOf(c) + UnitOf(d) - (UnitOf(a) + UnitOf(b));
  return IsClearlyPositive(n, c) && IsClearlyPositive(n, d) && IsClearlyPositive(-1.0 * n, a) &&
    IsClearlyPositive(-1.0 * n, b);
}

/// Two corners in common, and the third ones not on one side of that edge: the angle of the triangles
/// is more than a right one.
bool ArePartedAtEdge(const SharedCorners& corners)
{
  const Point3& a = *corners.OfS[0];
  const Vector3 edge = *corners.OfS[1] - a;
  const Vector3 u = *corners.OfS[2] - a, v = *corners.OfT[2] - a;
  const double across = Dot(u, v) - Dot(u, edge) / Dot(edge, edge) * Dot(v, edge);
  return across < -1e-10 * Norm(u) * Norm(v);
}
}

namespace
{
/// Values of corners along a direction, beyond doubt between Low and High.
struct Extent
{
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  double Low = Infinity;
  double High = -Infinity;

  Extent(const Corners& corners, const Point3& from, const Vector3& n)
  {
    for (const Point3* p : corners)
    {
      const Vector3 v = *p - from;
      const double value = Dot(n, v);
      const double error =
        1e-14 * (std::fabs(n[0] * v[0]) + std::fabs(n[1] * v[1]) + std::fabs(n[2] * v[2])) + 1e-280;
      // What overflows may be anywhere.
      const bool isKnown = value - error <= value + error;
      this->Low = isKnown ? std::min(this->Low, value - error) : -Infinity;
      this->High = isKnown ? std::max(this->High, value + error) : Infinity;
    }
  }
};

/// A plane along an edge of the first and across its own plane is clearly between the triangles.
bool ArePartedAtEdgeOf(const Corners& first, const Corners& second)
{
  const Vector3 normal = Cross(*first[1] - *first[0], *first[2] - *first[0]);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point3& from = *first[k];
    const Vector3 outward = Cross(*first[(k + 1) % 3] - from, normal);
    if (Extent(first, from, outward).High < Extent(second, from, outward).Low)
    {
      return true;
    }
  }
  return false;
}
}

PairRelation RelateTriangles(const TriangleMesh& mesh, int s, int t)
{
  const SharedCorners corners = FindSharedCorners(mesh, s, t);
  const int shared = corners.Count;
  // What most neighbours are; exact signs of what lies in one plane that is tilted take long.
  if ((shared == 1 && ArePartedAtCorner(corners)) || (shared == 2 && ArePartedAtEdge(corners)))
  {
    return PairRelation::Clean;
  }
  const Corners a = CornersOf(mesh, s);
  const Corners b = CornersOf(mesh, t);
  if (shared == 0 && (ArePartedAtEdgeOf(a, b) || ArePartedAtEdgeOf(b, a)))
  {
    return PairRelation::Clean;
  }
  // In different planes, triangles with two common corners meet in that edge only.
  if (shared == 2 && Orientation3(*a[0], *a[1], *a[2], *corners.OfT[2]) != 0)
  {
    return PairRelation::Clean;
  }
  Signs sidesOfT{};
  if (!FilterSides(a, b, sidesOfT))
  {
    if (AreApartInShadow(a, b))
    {
      return PairRelation::Clean;
    }
    sidesOfT = SidesOf(a, b);
  }
  if (AllOnOneSide(sidesOfT))
  {
    return PairRelation::Clean;
  }
  const Signs sidesOfS = SidesOf(b, a);
  if (AllOnOneSide(sidesOfS))
  {
    return PairRelation::Clean;
  }
  if (IsFlat(a) || IsFlat(b))
  {
    return PairRelation::Clean;
  }
  if (sidesOfT == Signs{ 0, 0, 0 })
  {
    return RelateInPlane(a, b, shared, corners.OfT[0]);
  }
  return RelateAcrossPlanes(a, b, sidesOfS, sidesOfT, shared);
}
}
