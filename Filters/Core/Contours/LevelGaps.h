// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelGaps.h
 * @brief Which levels are too far apart to be bridged, by the spacing beside them.
 */
#ifndef recon_LevelGaps_h
#define recon_LevelGaps_h

#include "Contours/ContourSet.h"

#include <vector>

namespace recon
{
/// Slabs between neighbouring levels, lowest first.
struct LevelGaps
{
  std::vector<double> Thickness;
  /// Spacing beside a slab, which MaximumGap is a multiple of; 0 where there is no other slab.
  std::vector<double> Usual;
  std::vector<unsigned char> IsGap; ///< MaximumGap forbids to bridge it
};

/**
 * Of every slab whether it is thicker than maximumGap times the spacing beside it; 0 = none is.
 *
 * The spacing beside a slab is the thickness of the slab below or above it, whichever is larger, so
 * that a stack may go on more coarsely (depths of 0, 2, 5, 10, 20, 50 ... are one stack). But a
 * neighbour counts only if the slab beyond it, or at an end of the stack the median of all, shows that
 * it is no gap itself: a lone slice amid a gap bridges nothing. Where neither counts, the thinner one is taken.
 */
LevelGaps FindLevelGaps(const ContourSet& contours, double maximumGap);
}

#endif
