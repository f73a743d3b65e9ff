// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Geometry.h
 * @brief The few value types that every part of the core shares.
 *
 * All coordinates are in the units of the input (millimetres for DICOM), double precision, in the
 * right-handed system of the input. Nothing here rounds, scales or recentres.
 */
#ifndef recon_Geometry_h
#define recon_Geometry_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace recon
{
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;
using Vector3 = std::array<double, 3>;

inline Vector3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Vector3 operator+(const Point3& a, const Point3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Vector3 operator*(double s, const Vector3& v)
{
  return { s * v[0], s * v[1], s * v[2] };
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Norm(const Vector3& v)
{
  return std::sqrt(Dot(v, v));
}

/**
 * An orthonormal right-handed frame (U, V, Normal) through the origin of the input's coordinates.
 *
 * Where Normal is a coordinate axis, U and V are coordinate axes too (z: x, y; x: y, z; y: z, x),
 * and both directions of the mapping are exact; for a tilted frame they round like any dot product.
 */
struct PlanarFrame
{
  Vector3 U{ 1, 0, 0 };
  Vector3 V{ 0, 1, 0 };
  Vector3 Normal{ 0, 0, 1 };

  /// The frame about a unit normal, always the same for the same normal.
  static PlanarFrame About(const Vector3& unitNormal);

  /// In-plane coordinates of p.
  Point2 ToPlane(const Point3& p) const { return { Dot(this->U, p), Dot(this->V, p) }; }
  /// Distance of the plane through p, perpendicular to Normal, from the origin (signed).
  double OffsetOf(const Point3& p) const { return Dot(this->Normal, p); }
  /// The point of space at in-plane coordinates p on the plane with that offset.
  Point3 ToSpace(const Point2& p, double offset) const
  {
    return p[0] * this->U + (p[1] * this->V + offset * this->Normal);
  }
};

inline PlanarFrame PlanarFrame::About(const Vector3& unitNormal)
{
  PlanarFrame frame;
  frame.Normal = unitNormal;
  std::size_t least = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (std::abs(unitNormal[k]) == 1)
    {
      frame.U = { 0, 0, 0 };
      frame.U[(k + 1) % 3] = 1;
      frame.V = { 0, 0, 0 };
      frame.V[(k + 2) % 3] = unitNormal[k];
      return frame;
    }
    least = std::abs(unitNormal[k]) < std::abs(unitNormal[least]) ? k : least;
  }
  Vector3 axis{ 0, 0, 0 };
  axis[least] = 1;
  const Vector3 u = Cross(axis, unitNormal);
  frame.U = (1 / Norm(u)) * u;
  frame.V = Cross(unitNormal, frame.U);
  return frame;
}

/// How nearly two unit vectors must agree, either way round, to count as parallel.
enum class Parallelism
{
  UpToRounding, ///< the same direction, computed twice: a sine below 1e-9
  UpToDrawing   ///< planes of one stack, as drawn or stored: a sine below 1e-2 (half a degree)
};

/// Whether two unit vectors have one direction or opposite ones.
inline bool AreParallel(const Vector3& a, const Vector3& b, Parallelism strength)
{
  return Norm(Cross(a, b)) < (strength == Parallelism::UpToRounding ? 1e-9 : 1e-2);
}

inline double SquaredDistanceToSegment(const Point3& p, const Point3& a, const Point3& b)
{
  const Vector3 ab = b - a;
  const double length = Dot(ab, ab);
  const double t = length > 0 ? std::clamp(Dot(p - a, ab) / length, 0.0, 1.0) : 0.0;
  const Vector3 rest = p - (a + t * ab);
  return Dot(rest, rest);
}

inline double Distance(const Point2& a, const Point2& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Length along the closed loop of those points, in their units.
template <typename Points, typename Indices>
double LengthAlong(const Points& points, const Indices& loop)
{
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += Norm(points[loop[(i + 1) % loop.size()]] - points[loop[i]]);
  }
  return length;
}
}

#endif
