// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NeighbourPlaces.h
 * @brief Where points of a level lie on the levels next to it.
 */
#ifndef recon_NeighbourPlaces_h
#define recon_NeighbourPlaces_h

#include "Polyhedral/LevelState.h"

#include <cstddef>
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

/// Its internal points, in their order.
std::vector<Point2> InternalPointsOf(const LevelState& level);

/// Looks up on a level the internal points of those next to it, or the points of their InternalSkeleton: sets Above of
/// the level below and Below of the level above. No two threads may ask one level.
void LocateInternalPoints(
  const std::vector<LevelState>& levels, std::size_t asked, std::vector<NeighbourPlaces>& places);
void LocateInternalSkeletons(
  const std::vector<LevelState>& levels, std::size_t asked, std::vector<NeighbourPlaces>& places);

/// Sets OutsideAbove and OutsideBelow of a level. @param places of its internal points
void FindPointsOutsideNeighbours(
  std::vector<LevelState>& levels, std::size_t level, const NeighbourPlaces& places);
}

#endif
