// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SliverRemoval.h
 * @brief Small angles out of a mesh that is already even.
 */
#ifndef recon_SliverRemoval_h
#define recon_SliverRemoval_h

#include "Implicit/ZeroSet/Remeshing.h"

namespace recon
{
/// Triangles with a smaller angle (degrees) are slivers.
constexpr double SliverAngle = 5;
/// And with a smaller one than this, needles, which go at any price but a crossing.
constexpr double NeedleAngle = 2;

/**
 * Flips the diagonal across each sliver, or collapses its shortest edge; where neither may be, and
 * it is a needle, the ends of its short edge are moved along the surface. In passes, until nothing
 * helps or a few times.
 */
void RemoveSlivers(Remesher& remesher, const Projector& project);
}

#endif
