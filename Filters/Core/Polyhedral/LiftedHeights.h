// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LiftedHeights.h
 * @brief What was lifted out of the plane of a level.
 */
#ifndef recon_LiftedHeights_h
#define recon_LiftedHeights_h

#include <vector>

namespace recon
{
/// Of every point of a level its height in the slab above and in the one below, NaN where it is not
/// lifted there; empty where the level has no such slab or nothing was lifted.
struct LiftedHeights
{
  std::vector<double> Above;
  std::vector<double> Below;
};
}

#endif
