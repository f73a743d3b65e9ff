// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NearConstraints.h
 * @brief Constraints that lie too near one another for a fit in double precision.
 */
#ifndef recon_NearConstraints_h
#define recon_NearConstraints_h

#include "Implicit/Constraints/Constraints.h"

namespace recon
{
/**
 * How far apart constraints must lie to be fitted to 1e-5 of the margin distance, in their units.
 *
 * Notation: s half of the bounding box's diagonal, d the margin distance, t a distance of two
 * constraints, both in parts of s.
 *
 * Where the slope between the two is other than that around them, by 1 as across the ridge of a
 * needle, they get weights of w = 1 / (2 t^2), as the energy of a unit difference is 2 t^3. Kernels
 * are up to 8, so the function is rounded to 8 w eps, and that is 1e-5 d at t = sqrt(4 eps / 1e-5
 * d). A small set has room for much: 1e-4 of d at d = 0.15; 90 000 constraints at d = 0.003 have
 * for a fifteenth of it.
 */
double LeastDistanceApart(const ConstraintSet& set);

/**
 * Sees to it that no two constraints are nearer than that unless they are in one place, and says so
 * in the set's report: a contour point takes the place of another one near it (two in one place
 * become one in a fit), a margin near another constraint is left out. The earlier one stays; points
 * before margins, as a margin says less.
 */
void ResolveNearConstraints(ConstraintSet& set);
}

#endif
