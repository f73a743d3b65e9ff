// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VolumeInterval.h
 * @brief What parallel contours say about the volume of what they were drawn on: how much it is at
 * least and at most, and where another slice would tell more.
 *
 * The volume is the integral of the sections' area along the stack, and contours give that area on
 * their levels. Between two levels it is a parabola, as it is of every ellipsoid, cone and
 * paraboloid in any position: through three levels, and the mean of both parabolas that a slab has. What
 * is joined to what is Contour Mapping's decision, so branches go each their own way.
 *
 * Beyond its last section a region goes on along the parabola of the three sections before it, of
 * two along that of a ball, until nothing is left. The next slice, or the place where it would be,
 * does not show the region: where something of the parabola is left there, it is cut off before,
 * and half way where it does not end at all. That is the estimate. Nothing says that a shape does
 * not end on its last slice, or keeps its section, or goes on widening, up to the next one: these
 * are the bounds.
 *
 * Between two levels the bounds are half of what the parabola differs from a straight line away
 * from the estimate, more where a section all but vanishes, as the tip of a cone, or the side of a
 * cylinder that lies across the slices, may be there; and a hole that ends within the solid may do so anywhere. Nothing is assumed
 * about how smooth the shape is otherwise, and nothing can be: what no slice shows, such as a cavity
 * between two, no bound contains.
 */
#ifndef recon_VolumeInterval_h
#define recon_VolumeInterval_h

#include "Base/Monitor.h"
#include "Contours/CarriedMapping.h"
#include "Contours/ContourMapping.h"
#include "Contours/ContourSet.h"

#include <optional>
#include <vector>

namespace recon
{
/// A place along the stack where a slice would tell more.
struct VolumeDoubt
{
  double Offset = 0; ///< along the levels' normal, in the middle between slices
  double Width = 0;  ///< how much of Highest - Lowest comes from there, cubic units
};

/// All in cubic units of the input.
struct VolumeInterval
{
  double Estimate = 0;
  double Lowest = 0;
  double Highest = 0;
  std::vector<VolumeDoubt> Doubts; ///< the widest first, lower ones first of equal ones
};

/**
 * @return nothing for contours that are not Parallel, or on one level only
 * @throws Error where two levels cross in more places than can be told apart; Aborted
 */
std::optional<VolumeInterval> EstimateVolume(
  const ContourSet& contours, const ContourMappingOptions& mapping, Monitor& monitor);

/**
 * The same of contours as they arrived, with what an earlier mapping decided about them.
 *
 * @param asRead what they became where planes of any orientation are taken
 * @return nothing where these are not all parallel, or cannot be joined, either @throws Aborted
 */
std::optional<VolumeInterval> EstimateVolume(const LoopSoup& soup, const ContourSet& asRead,
  const std::optional<CarriedMapping>& carried, Monitor& monitor);
}

#endif
