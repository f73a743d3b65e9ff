// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NeighbourPlaces.h
 * @brief Where points of a level lie on the levels next to it.
 */
#ifndef recon_NeighbourPlaces_h
#define recon_NeighbourPlaces_h

#include "Polyhedral/LevelState.h"
#include "Polyhedral/StageRunner.h"

#include <vector>

namespace recon
{
/// Of every point the triangle of the level below and above that holds it, or -1; empty where there
/// is no such level.
struct NeighbourPlaces
{
  std::vector<int> Below;
  std::vector<int> Above;
};

/// points: by level.
std::vector<NeighbourPlaces> LocateInNeighbours(const std::vector<LevelState>& levels,
  const std::vector<std::vector<Point2>>& points, const StageRunner& runner, double progress);

/// Sets OutsideAbove and OutsideBelow of every level.
void FindPointsOutsideNeighbours(
  std::vector<LevelState>& levels, const StageRunner& runner, double progress);
}

#endif
