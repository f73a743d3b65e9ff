// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SquarePatches.h
 * @brief Which squares of a plane hang together, and which of these patches touch no contour.
 */
#ifndef recon_SquarePatches_h
#define recon_SquarePatches_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
/// An axis-parallel square of a plane.
struct PlaneSquare
{
  Point2 Middle{};
  double Size = 0; ///< length of an edge
  double Room = 0; ///< distance of its middle from the contours
};

/**
 * The area of the largest patch of squares, joined by edges or corners, that no contour passes: a
 * hole or an island that nobody drew. 0 where there is none. Squares next to a contour are at most
 * their own size away from it.
 */
double LargestDetachedPatch(std::vector<PlaneSquare> squares);
}

#endif
