// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RingPlane.h
 * @brief What one ring tells about the plane that it lies in.
 */
#ifndef recon_RingPlane_h
#define recon_RingPlane_h

#include "Contours/ContourChaining.h"
#include "Contours/ContourSet.h"

#include <algorithm>
#include <limits>

namespace recon
{
/// Smallest and largest offset of a ring's points along a direction.
struct OffsetRange
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
  double Size() const { return this->High - this->Low; }
  double Middle() const { return this->Low + 0.5 * (this->High - this->Low); }
  void Add(double x)
  {
    this->Low = std::min(this->Low, x);
    this->High = std::max(this->High, x);
  }
};

struct RingPlane
{
  Vector3 AreaVector{ 0, 0, 0 }; ///< along the normal, as long as the area that tells it
  bool HasNormal = false;        ///< false where the points lie on a line
  bool Trusted = false;          ///< wide enough, compared with the tolerance
  double Length = 0;             ///< from the first point to the farthest
  double Roughness = 0;          ///< farthest distance of a point from the ring's own plane
};

/**
 * The plane of a ring by Newell's area, or by its widest triangle where that area cancels (a bow
 * tie).
 *
 * @param tolerance a ring whose width is less than ten of these does not tell its plane by itself
 */
RingPlane FindRingPlane(const LoopSoup& soup, const Ring& ring, double tolerance);

/// Newell's vector area of a closed loop of the soup's points, about the first of them: along the
/// normal, as long as the area.
Vector3 NewellArea(const LoopSoup& soup, const std::vector<int>& ring);

OffsetRange RangeAlong(const LoopSoup& soup, const Ring& ring, const Vector3& normal);

/// The unit vector along v, turned so that its largest component is positive.
Vector3 CanonicalNormal(const Vector3& v);

/// The coordinate axis of the largest component.
Vector3 NearestAxis(const Vector3& unit);

/**
 * The step to which coordinates are rounded: .01 where all have two decimals, the spacing of single
 * precision numbers at the largest where all are such numbers, 0 where there is none to be seen.
 *
 * Whole numbers count as one decimal: they need not be rounded at all.
 */
double CoordinateStep(const LoopSoup& soup, const std::vector<Ring>& rings);
}

#endif
