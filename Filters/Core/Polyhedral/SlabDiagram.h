// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SlabDiagram.h
 * @brief The tetrahedra between two levels, made in the way that suits these.
 */
#ifndef recon_SlabDiagram_h
#define recon_SlabDiagram_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/SlabJoins.h"

namespace recon
{
/// Which tetrahedra are made.
enum class TetrahedraWanted
{
  All,          ///< of every slab
  ForSurface,   ///< all, but where they are too many those only that bear on the boundary
  BoundaryOnly, ///< in every slab whose levels allow it; what tests compare with All
};

/// With Reason set, as EliminateTetrahedra does.
SlabTetrahedra BuildSlabDiagram(const LevelTriangulation& lower, const LevelTriangulation& upper,
  const SlabJoins& joins, TetrahedraWanted wanted);
}

#endif
