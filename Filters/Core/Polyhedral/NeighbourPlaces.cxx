// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/NeighbourPlaces.h"

namespace recon
{
namespace
{
std::vector<int> InternalPointsOf(const LevelTriangulation& level)
{
  std::vector<int> internal;
  for (std::size_t p = 0; p < level.Points.size(); ++p)
  {
    if (level.Kind[p] == LevelTriangulation::Internal)
    {
      internal.push_back(static_cast<int>(p));
    }
  }
  return internal;
}

/// neighbour: null where there is none. triangles: of it, that hold the internal points.
std::vector<unsigned char> OutsideOf(const LevelTriangulation& level,
  const LevelTriangulation* neighbour, const std::vector<int>& triangles)
{
  std::vector<unsigned char> outside(level.Points.size(), 0);
  if (!neighbour)
  {
    return outside;
  }
  const std::vector<int> internal = InternalPointsOf(level);
  for (std::size_t i = 0; i < internal.size(); ++i)
  {
    outside[internal[i]] = triangles[i] < 0 || !neighbour->Inside[triangles[i]] ? 1 : 0;
  }
  return outside;
}
}

std::vector<NeighbourPlaces> LocateInNeighbours(const std::vector<LevelState>& levels,
  const std::vector<std::vector<Point2>>& points, const StageRunner& runner, double progress)
{
  std::vector<NeighbourPlaces> places(levels.size());
  // By the level that is asked: no two threads may ask one triangulation.
  runner.ForAll(levels.size(), progress, progress, "shaping branches and ends",
    [&](std::size_t i)
    {
      if (i > 0)
      {
        places[i - 1].Above = levels[i].Triangulator->Locate(points[i - 1]);
      }
      if (i + 1 < levels.size())
      {
        places[i + 1].Below = levels[i].Triangulator->Locate(points[i + 1]);
      }
    });
  return places;
}

void FindPointsOutsideNeighbours(
  std::vector<LevelState>& levels, const StageRunner& runner, double progress)
{
  std::vector<std::vector<Point2>> points(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    for (int p : InternalPointsOf(levels[i].Triangulation))
    {
      points[i].push_back(levels[i].Triangulation.Points[p]);
    }
  }
  const auto places = LocateInNeighbours(levels, points, runner, progress);
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    LevelState& level = levels[i];
    const auto* below = i > 0 ? &levels[i - 1].Triangulation : nullptr;
    const auto* above = i + 1 < levels.size() ? &levels[i + 1].Triangulation : nullptr;
    level.OutsideBelow = OutsideOf(level.Triangulation, below, places[i].Below);
    level.OutsideAbove = OutsideOf(level.Triangulation, above, places[i].Above);
  }
}
}
