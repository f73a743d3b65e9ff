// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralStages.h
 * @brief Everything that the Polyhedral Surface Method computes before the surface is extracted.
 *
 * So that every stage can be looked at: triangulations with their Voronoi skeletons, tetrahedra
 * with the reason why each is kept or not, heights of lifted points.
 */
#ifndef recon_PolyhedralStages_h
#define recon_PolyhedralStages_h

#include "Base/Monitor.h"
#include "Contours/ContourMapping.h"
#include "Contours/LevelAlignment.h"
#include "Polyhedral/LevelState.h"
#include "Polyhedral/PolyhedralOptions.h"
#include "Polyhedral/SlabState.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
struct PolyhedralStages
{
  /// How levels were shifted onto one another; planar coordinates of Levels are shifted ones.
  LevelAlignment Alignment;
  std::unique_ptr<ContourSet> Shifted; ///< the contours as the stages see them, where they were
  ContourMapping Mapping;
  std::vector<LevelState> Levels;
  std::vector<SlabState> Slabs; ///< slab i lies between levels i and i + 1
  std::vector<std::string> Report;
  std::vector<std::pair<std::string, double>> StageSeconds; ///< wall time by stage
};

/// Which tetrahedra are made.
enum class TetrahedraWanted
{
  All,          ///< of every slab
  ForSurface,   ///< all, but where they are too many those only that bear on the boundary
  BoundaryOnly, ///< in every slab whose levels allow it; what tests compare with All
};

/// @throws Error where the contours are not parallel or span fewer than two levels; Aborted.
/// Progress runs from 0 to progressEnd.
PolyhedralStages BuildPolyhedralStages(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, double progressEnd = 1, TetrahedraWanted wanted = TetrahedraWanted::All);
}

#endif
