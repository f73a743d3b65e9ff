// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EdgeRoots.h
 * @brief Where the surface crosses the edges of a grid (thesis 9.3.1: the root of an edge).
 */
#ifndef recon_EdgeRoots_h
#define recon_EdgeRoots_h

#include "Base/Monitor.h"
#include "Implicit/ZeroSet/BoundedField.h"

#include <vector>

namespace recon
{
/// An edge with its ends on two sides of the surface, and g there.
struct CrossedEdge
{
  Point3 Inside;  ///< g > 0
  Point3 Outside; ///< g <= 0
  double InsideValue;
  double OutsideValue;
};

/**
 * One root an edge, by regula falsi that cannot stall (Illinois) and bisection behind it, on all
 * edges side by side, so that the function is evaluated in large batches.
 *
 * @param tolerance how far along its edge a root may be off, in the units of the input.
 */
std::vector<Point3> FindRoots(const BoundedField& field, const std::vector<CrossedEdge>& edges,
  double tolerance, Monitor& monitor);
}

#endif
