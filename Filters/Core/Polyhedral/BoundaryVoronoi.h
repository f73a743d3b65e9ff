// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BoundaryVoronoi.h
 * @brief The tetrahedra between two levels that bear on the boundary of the solid.
 *
 * Where two smooth, densely sampled contours face each other, T12 grow with the square of the
 * sampling, though the surface does not: nearly all of them lie inside both contours, where all is
 * solid, or outside both, where nothing is. Here only those around the boundary are made
 * (VoronoiSections.h), joined by gaps (JointVoronoi.h). That nothing in a gap is missing from the
 * solid, and nothing that the surface needs is in a gap, is checked afterwards; a Voronoi edge for
 * which it does not hold gets all its tetrahedra, until all is well. So the surface is the same, to
 * the last bit.
 */
#ifndef recon_BoundaryVoronoi_h
#define recon_BoundaryVoronoi_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/SlabJoins.h"

namespace recon
{
/// With Reason set, as EliminateTetrahedra does. @pre both levels are IsGabriel
SlabTetrahedra BuildBoundaryVoronoi(const JointCells& cells, const SlabJoins& joins);
}

#endif
