// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SlabState.h
 * @brief Everything that the method knows of the slab between two adjacent levels.
 */
#ifndef recon_SlabState_h
#define recon_SlabState_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/SlabJoins.h"

namespace recon
{
struct SlabState
{
  double Thickness = 0;
  SlabJoins Joins;
  SlabTetrahedra Diagram;
};
}

#endif
