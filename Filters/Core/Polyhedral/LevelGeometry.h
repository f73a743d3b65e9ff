// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelGeometry.h
 * @brief A triangulation in its place along the common normal, and what was lifted out of it.
 */
#ifndef recon_LevelGeometry_h
#define recon_LevelGeometry_h

#include "Polyhedral/LevelTriangulation.h"

#include <vector>

namespace recon
{
struct LevelGeometry
{
  const LevelTriangulation* Triangulation;
  double Offset;
};

/// Of every point of a level its height in the slab above and in the one below, NaN where it is not
/// lifted there; empty where the level has no such slab or nothing was lifted.
struct LiftedHeights
{
  std::vector<double> Above;
  std::vector<double> Below;
};
}

#endif
