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
#include "Polyhedral/SlabDiagram.h"
#include "Polyhedral/SlabState.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// What was there before points were added for ends and bare parts, for the next run.
struct EarlierRounds
{
  struct Slab
  {
    std::size_t
      Lower; ///< index into Levels of its lower level; beyond these, the one that is there now
    std::size_t Upper;
    SlabTetrahedra Diagram;
  };
  std::vector<std::vector<LevelTriangulation>> Levels; ///< by level, the first round first
  std::vector<std::vector<Slab>> Slabs;                ///< by slab
};

struct PolyhedralStages
{
  /// How levels were shifted onto one another; planar coordinates of Levels are shifted ones.
  LevelAlignment Alignment;
  std::unique_ptr<ContourSet> Shifted; ///< the contours as the stages see them, where they were
  ContourMapping Mapping;
  std::vector<LevelState> Levels;
  std::vector<SlabState> Slabs; ///< slab i lies between levels i and i + 1
  EarlierRounds Earlier;        ///< empty where nobody asked for it
  int Rounds = 0; ///< in which tetrahedra were made, as points were added for ends and bare parts
  std::vector<std::string> Report;
  std::vector<std::pair<std::string, double>> StageSeconds; ///< wall time by stage
  std::size_t Forgotten =
    0; ///< of so many levels, and of the slabs below them, little is left: see StagesMemory.h
};

/// Hears of levels as they are finished: that the first so many are, and the slabs between them. Returns how many of
/// these nobody needs any more (ForgetBelow); called in the thread of the caller.
using StagesSink = std::function<std::size_t(const PolyhedralStages& stages, std::size_t levels)>;

/// @throws Error where the contours are not parallel or span fewer than two levels; Aborted.
/// Progress runs from 0 to progressEnd.
PolyhedralStages BuildPolyhedralStages(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, double progressEnd = 1, TetrahedraWanted wanted = TetrahedraWanted::All,
  bool keepsEarlier = false, const StagesSink& sink = {});

/// What is joined in each slab of a stack that a part was taken from, and its Spacing().
struct JoinsOfPart
{
  std::vector<SlabJoins> Joins; ///< by slab of the part
  double Spacing = 0;
  /// Of a slab of the part, between levels like these, what is known of it already; may be empty.
  /// Threads ask at once.
  std::function<std::optional<SlabTetrahedra>(
    int slab, const LevelTriangulation& lower, const LevelTriangulation& upper)>
    KnownDiagram;
};

/**
 * Levels and slabs of some neighbouring levels of a stack, with Earlier, without Mapping and Report. Those near its
 * first and last level are others than in the whole stack (KeptStages.h); ends must not be
 * extrapolated.
 */
PolyhedralStages BuildStagesOfPart(const ContourSet& part, const JoinsOfPart& joins,
  const PolyhedralOptions& options, Monitor& monitor, double progressEnd, TetrahedraWanted wanted);

/// @throws Error where the method cannot begin with such contours.
void RequireParallelLevels(const ContourSet& contours);
}

#endif
