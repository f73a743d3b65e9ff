// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TriangleClearance.h
 * @brief Whether two triangles are so far apart that moving their corners a little cannot make them meet.
 */
#ifndef recon_TriangleClearance_h
#define recon_TriangleClearance_h

#include "Base/Geometry.h"

#include <array>

namespace recon
{
/**
 * Whether a plane lies between the triangles with more than `distance` of room, by the directions that
 * tell triangles apart: across their faces, across their sides within them, and across a side of either.
 *
 * Rounding is allowed for, so true is certain. False may be said of triangles that are a little
 * farther apart than that.
 *
 * @param distance in the units of the points, not negative
 */
bool AreFartherApartThan(
  const std::array<Point3, 3>& s, const std::array<Point3, 3>& t, double distance);
}

#endif
