// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Predicates.h
 * @brief Exact signs of determinants, behind a floating-point filter that settles nearly all of
 * them. Every decision about topology is made by these.
 *
 * The filters are Shewchuk's static bounds (Adaptive Precision Floating-Point Arithmetic and Fast
 * Robust Geometric Predicates, 1997); what they leave open is decided by CGAL's exact predicates,
 * which are included in one source file only. All coordinates must be finite.
 */
#ifndef recon_Predicates_h
#define recon_Predicates_h

#include "Base/Geometry.h"

#include <cmath>

namespace recon
{
/// The exact answers, without a filter in front. Use those below instead.
int ExactOrientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
int ExactOrientation2(const Point2& a, const Point2& b, const Point2& c);
bool ExactCollinear(const Point3& a, const Point3& b, const Point3& c);

/// Sign of ((b - a) x (c - a)) . (d - a), or 0 where the filter does not settle it.
inline int FilteredOrientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d - a;
  const double vw0 = v[1] * w[2], vw1 = v[2] * w[1];
  const double vw2 = v[2] * w[0], vw3 = v[0] * w[2];
  const double vw4 = v[0] * w[1], vw5 = v[1] * w[0];
  const double det = u[0] * (vw0 - vw1) + u[1] * (vw2 - vw3) + u[2] * (vw4 - vw5);
  const double permanent = std::fabs(u[0]) * (std::fabs(vw0) + std::fabs(vw1)) +
    std::fabs(u[1]) * (std::fabs(vw2) + std::fabs(vw3)) +
    std::fabs(u[2]) * (std::fabs(vw4) + std::fabs(vw5));
  const double bound = 8e-16 * permanent;
  // Below 1e-280 the products may have lost digits to underflow, above 1e300 to overflow.
  if (std::fabs(det) > bound && permanent > 1e-280 && permanent < 1e300)
  {
    return det > 0 ? 1 : -1;
  }
  return 0;
}

/// Sign of ((b - a) x (c - a)) . (d - a): +1 where d is on the side that sees abc counterclockwise.
inline int Orientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  const int filtered = FilteredOrientation3(a, b, c, d);
  return filtered != 0 ? filtered : ExactOrientation3(a, b, c, d);
}

/// Sign of the area of abc: +1 where it runs counterclockwise.
inline int Orientation2(const Point2& a, const Point2& b, const Point2& c)
{
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  const double det = left - right;
  const double sum = std::fabs(left) + std::fabs(right);
  if (std::fabs(det) > 4e-16 * sum && sum > 1e-280 && sum < 1e300)
  {
    return det > 0 ? 1 : -1;
  }
  return ExactOrientation2(a, b, c);
}

/// Whether the triangle abc has no area at all.
inline bool Collinear(const Point3& a, const Point3& b, const Point3& c)
{
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const double left = (a[i] - c[i]) * (b[j] - c[j]);
    const double right = (a[j] - c[j]) * (b[i] - c[i]);
    const double sum = std::fabs(left) + std::fabs(right);
    if (std::fabs(left - right) > 4e-16 * sum && sum > 1e-280 && sum < 1e300)
    {
      return false;
    }
  }
  return ExactCollinear(a, b, c);
}

/// For p on the line through a and b: whether it lies strictly between them.
inline bool StrictlyBetween(const Point2& a, const Point2& b, const Point2& p)
{
  return (a < p && p < b) || (b < p && p < a);
}
}

#endif
