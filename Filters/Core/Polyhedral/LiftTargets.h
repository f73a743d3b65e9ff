// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LiftTargets.h
 * @brief How far every point of a level should be lifted out of its plane on one side.
 *
 * Internal points (thesis 6.2): to the fraction dA / (dA + dB) of the slab, dA and dB being the
 * distances to the contours of the own level and of the one that asked (shape-based interpolation,
 * where it is exact). Ends: a region from which no solid leaves on a side is capped there, flat, by
 * half a slice (all of its points go up by half the slab), or tapered (the points of its skeleton
 * go up by half the slab or by the slope times the distance to the contour, whichever is less).
 */
#ifndef recon_LiftTargets_h
#define recon_LiftTargets_h

#include "Coverage.h"
#include "PlanarContourDistance.h"
#include "PolyhedralSurface.h"
#include "SolidComplex.h"

#include <vector>

namespace recon
{
/// A level and what lies on the side in question.
struct LiftSide
{
  const LevelGeometry* Level = nullptr;
  const PlanarContourDistance* Distance = nullptr;
  const Coverage* Covered = nullptr;
  LevelTriangulation::AskedByType Towards = LevelTriangulation::LevelAbove;
  const PlanarContourDistance* OtherDistance =
    nullptr;          ///< of the neighbour, null where there is none
  double Slab = 0;    ///< signed distance to the neighbour's plane
  double EndSlab = 0; ///< signed thickness of which a cap takes half
};

/// Of every point the height to lift it to, NaN where it stays.
std::vector<double> FindLiftTargets(const LiftSide& side, const PolyhedralOptions& options);
}

#endif
