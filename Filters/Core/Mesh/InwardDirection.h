// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file InwardDirection.h
 * @brief The direction that leads farthest to the inner side of given planes through a point.
 */
#ifndef recon_InwardDirection_h
#define recon_InwardDirection_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
/// A unit vector to the inner side of as many of the planes as can be had, and how far it keeps
/// from the nearest of them (the sine; negative: outside of one). Zero where there is none.
Vector3 InwardOf(const std::vector<Vector3>& normals, double& clearance);
}

#endif
