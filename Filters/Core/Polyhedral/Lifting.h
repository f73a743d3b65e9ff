// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Lifting.h
 * @brief How far internal points are lifted out of their plane (thesis 6.2), and how safely.
 */
#ifndef recon_Lifting_h
#define recon_Lifting_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/LevelState.h"

namespace recon
{
/**
 * Heights of the internal points of a slab's two levels inside that slab.
 *
 * A move must not turn any tetrahedron at the point over, kept or not: the point is moved less, or
 * not at all, where it would. So the tetrahedra of the slab still fill space without overlap, and
 * the surface never crosses itself. Points are treated in their order, so the result is always the
 * same.
 *
 * targets1, targets2: of every point of level 1 and 2 the height wanted, NaN where it is not to be
 * lifted. Writes Lifted.Above of level 1 and Lifted.Below of level 2, each as long as the level's
 * points, NaN where not lifted.
 */
void LiftInternalPoints(LevelState& level1, LevelState& level2, const SlabTetrahedra& slab,
  const std::vector<double>& targets1, const std::vector<double>& targets2);
}

#endif
