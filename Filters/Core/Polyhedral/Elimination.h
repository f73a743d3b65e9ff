// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Elimination.h
 * @brief Which tetrahedra of a slab are solid (thesis 5.5 and 6.4).
 */
#ifndef recon_Elimination_h
#define recon_Elimination_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/SlabJoins.h"

namespace recon
{
/**
 * Set Reason of every tetrahedron (thesis 5.5, 6.4).
 *
 * A T12 of two contour edges whose node lies outside both contours is not solid either: the thesis
 * keeps it, and it draws thin sheets and spikes across bays.
 *
 * What is missing in a gap of the slab counts as kept; whoever left it out sees to it that it is.
 */
void EliminateTetrahedra(const LevelTriangulation& level1, const LevelTriangulation& level2,
  const SlabJoins& joins, SlabTetrahedra& slab);
}

#endif
