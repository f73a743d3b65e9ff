// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Angles.h
 * @brief Pi, degrees for those who read them, and the smallest angle of a triangle; everything is
 * computed in radians.
 */
#ifndef recon_Angles_h
#define recon_Angles_h

#include "Base/Geometry.h"

#include <limits>

namespace recon
{
constexpr double Pi = 3.14159265358979323846;
constexpr double RadiansPerDegree = Pi / 180;

/// Of the smallest angle of a triangle with these edges, one after another, and twice that area;
/// infinity where it has none. atan2(1, it) is the angle.
inline double CotangentOfSmallestAngle(
  const Vector3& ab, const Vector3& bc, const Vector3& ca, double doubledArea)
{
  if (doubledArea <= 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const std::array<double, 3> squared{ Dot(ab, ab), Dot(bc, bc), Dot(ca, ca) };
  const auto shortest = std::min_element(squared.begin(), squared.end()) - squared.begin();
  // The smallest angle is opposite the shortest side; the other two sides run one in, one out of
  // its corner.
  const double product = shortest == 0 ? Dot(bc, ca) : shortest == 1 ? Dot(ca, ab) : Dot(ab, bc);
  return -product / doubledArea;
}
}

#endif
