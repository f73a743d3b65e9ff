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
  int Rounds = 0; ///< in which tetrahedra were made, as points were added for ends and bare parts
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

/// What is joined in each slab of a stack that a part was taken from, and its Spacing().
struct JoinsOfPart
{
  std::vector<SlabJoins> Joins; ///< by slab of the part
  double Spacing = 0;
};

/**
 * Levels and slabs of some neighbouring levels of a stack, without Mapping and Report. Those near its
 * first and last level are others than in the whole stack (KeptStages.h); ends must not be
 * extrapolated.
 */
PolyhedralStages BuildStagesOfPart(const ContourSet& part, const JoinsOfPart& joins,
  const PolyhedralOptions& options, Monitor& monitor, double progressEnd, TetrahedraWanted wanted);

/// Lines on what became of contours, for stages that have all else.
void AddReports(
  const ContourSet& contours, const PolyhedralOptions& options, PolyhedralStages& stages);

/// @throws Error where the method cannot begin with such contours.
void RequireParallelLevels(const ContourSet& contours);
}

#endif
