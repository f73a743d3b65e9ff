// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlaneCheck.h
 * @brief Do the vertices of a plane lie in the plane that the file gives?
 */
#ifndef recon_PlaneCheck_h
#define recon_PlaneCheck_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
enum class PlaneFit
{
  Fits,        ///< normal . p + d = 0
  WrongSign,   ///< normal . p - d = 0
  WrongOffset, ///< parallel to the vertices, but elsewhere
  WrongNormal  ///< not parallel to the vertices, or no normal at all
};

/// Within a thousandth of the extent of the vertices; the normal need not be a unit vector.
PlaneFit CheckPlane(const Vector3& normal, double d, const std::vector<Point3>& vertices);

/// The unit normal of vertices that lie in a plane, on the side of hint. (0, 0, 1) where they have
/// none.
Vector3 NormalOf(const std::vector<Point3>& vertices, const Vector3& hint);
}

#endif
