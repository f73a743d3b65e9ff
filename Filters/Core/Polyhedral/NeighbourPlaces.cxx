// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/NeighbourPlaces.h"

namespace recon
{
namespace
{
bool IsInternal(const LevelTriangulation& level, std::size_t p)
{
  return level.Kind[p] == LevelTriangulation::Internal;
}

/// neighbour: null where there is none. triangles: of it, that hold the internal points.
std::vector<unsigned char> OutsideOf(const LevelTriangulation& level,
  const LevelTriangulation* neighbour, const std::vector<int>& triangles)
{
  std::vector<unsigned char> outside(level.Points.size(), 0);
  std::size_t i = 0;
  for (std::size_t p = 0; p < outside.size() && neighbour; ++p)
  {
    if (IsInternal(level, p))
    {
      outside[p] = triangles[i] < 0 || !neighbour->Inside[triangles[i]] ? 1 : 0;
      ++i;
    }
  }
  return outside;
}

template <typename PointsOf>
void LocateNeighbours(const std::vector<LevelState>& levels, std::size_t asked,
  const PointsOf& pointsOf, std::vector<NeighbourPlaces>& places)
{
  const LevelTriangulator& triangulator = *levels[asked].Triangulator;
  if (asked > 0)
  {
    places[asked - 1].Above = triangulator.Locate(pointsOf(levels[asked - 1]));
  }
  if (asked + 1 < levels.size())
  {
    places[asked + 1].Below = triangulator.Locate(pointsOf(levels[asked + 1]));
  }
}
}

std::vector<Point2> InternalPointsOf(const LevelState& level)
{
  const LevelTriangulation& triangulation = level.Triangulation;
  std::vector<Point2> internal;
  for (std::size_t p = 0; p < triangulation.Points.size(); ++p)
  {
    if (IsInternal(triangulation, p))
    {
      internal.push_back(triangulation.Points[p]);
    }
  }
  return internal;
}

void LocateInternalPoints(
  const std::vector<LevelState>& levels, std::size_t asked, std::vector<NeighbourPlaces>& places)
{
  LocateNeighbours(levels, asked, InternalPointsOf, places);
}

void LocateInternalSkeletons(
  const std::vector<LevelState>& levels, std::size_t asked, std::vector<NeighbourPlaces>& places)
{
  LocateNeighbours(
    levels, asked, [](const LevelState& level) { return level.InternalSkeleton; }, places);
}

void FindPointsOutsideNeighbours(
  std::vector<LevelState>& levels, std::size_t level, const NeighbourPlaces& places)
{
  LevelState& of = levels[level];
  const auto* below = level > 0 ? &levels[level - 1].Triangulation : nullptr;
  const auto* above = level + 1 < levels.size() ? &levels[level + 1].Triangulation : nullptr;
  of.OutsideBelow = OutsideOf(of.Triangulation, below, places.Below);
  of.OutsideAbove = OutsideOf(of.Triangulation, above, places.Above);
}
}
