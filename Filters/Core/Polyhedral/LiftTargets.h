// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LiftTargets.h
 * @brief How far every point of a level should be lifted out of its plane on one side.
 *
 * Internal points (thesis 6.2): to the fraction dA / (dA + dB) of the slab, dA and dB being the
 * distances to the contours of the own level and of the neighbour (shape-based interpolation, where
 * it is exact). That holds on every side on which the point lies outside the neighbour's contours,
 * whichever level asked for it: one that stayed in the plane would hold back the ridge beside it.
 *
 * Ends: a region from which no solid leaves on a side is capped there, flat, by half a slice (all
 * of its points go up by half the slab), tapered (see EndShare), or extrapolated (see EndShapes.h;
 * tapered where nothing is behind). Tapered and extrapolated also round off the parts of a region
 * that end although the region goes on (see PartialEnds.h).
 */
#ifndef recon_LiftTargets_h
#define recon_LiftTargets_h

#include "Planar/PlanarContourDistance.h"
#include "Polyhedral/EndShapes.h"
#include "Polyhedral/LevelState.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <vector>

namespace recon
{
/// A level and what lies on the side in question.
struct LiftSide
{
  const LevelState* Level;
  const LevelState* Neighbour;    ///< on that side, null where there is none
  const LevelState* Behind;       ///< on the other side, null where there is none
  int Towards;                    ///< 1 above, -1 below
  double CapThickness;            ///< of which a cap takes half
  const EndShapesOfLevel* Shapes; ///< of extrapolated ends on that side, null where there are none
};

/// The largest EndShare.
double HighestShareOfEnd(bool beyondOutermostLevel);

/**
 * How far a tapered end reaches beyond its plane at a point, as a share of the slab.
 *
 * The wall goes on as it came, at half its slope as a dome flattens: where the neighbour behind is
 * wider by s at a point d inside the contour, that is d / (2 s). At most half a slab, which is what
 * an end reaches on average that lies anywhere between two slices; a quarter beyond the first and
 * the last level, as people draw these near to the true ends. Measured on the sets of
 * Data/TRUTH.md.
 *
 * distance: of the point to its own level's contours. behind: null where there is no level.
 */
double EndShare(const Point2& point, double distance, const PlanarContourDistance* behind,
  bool beyondOutermostLevel);

/// Of every point the height to lift it to, NaN where it stays.
std::vector<double> FindLiftTargets(const LiftSide& side, const PolyhedralOptions& options);
}

#endif
