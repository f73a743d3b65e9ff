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

#include <array>
#include <cmath>

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
}

#endif
