// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourTips.h
 * @brief Contours at which the solid ends: needle thin, over or under a broad section.
 *
 * Where a slice just touches the top of a solid (the pole of a sphere, a lying cylinder), its
 * contour is a point or a line drawn as a ring of almost no area. The surface lies flat on the
 * plane there, so margins in the plane are as wrong as they can be: on phantoms with such slices
 * they cost 1% to 5% of the volume, and refining from there goes astray.
 */
#ifndef recon_ContourTips_h
#define recon_ContourTips_h

#include "Contours/ContourSet.h"

#include <vector>

namespace recon
{
struct ContourTip
{
  /// 1: the solid lies towards the level's normal; -1: the other way; 0: the contour is no tip.
  int Side = 0;
  /// The wall of the section beside it is far enough for the surface to lie flat on the plane.
  /// Where it is not (a tip upon an edge), the normal there is not known.
  bool Flat = false;
};

/**
 * Which contours are tips, from the nearest nearly parallel levels on both sides.
 *
 * A tip is an outer contour of mean half-width w (2 x area / length) that meets a section on one
 * side only, where w is small against the way to that section's wall (see TipSlenderness).
 *
 * @returns one a contour.
 */
std::vector<ContourTip> FindTips(const ContourSet& contours);

/// Gap of the levels: the median distance of contour vertices to the nearest vertex of another
/// level, in the units of the input; 0 where there is one level only.
double TypicalGap(const ContourSet& contours);
}

#endif
