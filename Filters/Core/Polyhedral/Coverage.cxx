// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/Coverage.h"

#include "Polyhedral/VertexStars.h"
#include "Polyhedral/VoronoiSkeleton.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace recon
{
namespace
{
/// Rings of a round end: parts of the way from the contour to the middle.
constexpr double Rings[] = { 0.2, 0.5 };

/// Triangles of the region of `seed`, which is a connected part of IR.
std::vector<int> RegionOf(
  const LevelTriangulation& level, int seed, std::vector<unsigned char>& visited)
{
  std::vector<int> region{ seed };
  visited[seed] = 1;
  for (std::size_t i = 0; i < region.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int n = level.Neighbours[region[i]][k];
      if (n >= 0 && level.Inside[n] && !visited[n])
      {
        visited[n] = 1;
        region.push_back(n);
      }
    }
  }
  return region;
}

bool IsLifted(const std::vector<double>& heights, int point)
{
  return !heights.empty() && !std::isnan(heights[point]);
}
}

Coverage FindCoverage(const LevelTriangulation& level, const SlabTetrahedra* below,
  const SlabTetrahedra* above, bool extrudeIsolated)
{
  const int count = static_cast<int>(level.Triangles.size());
  Coverage coverage;
  coverage.ExtrudesIsolated = extrudeIsolated;
  coverage.Covered.assign(count, 0);
  coverage.Isolated.assign(count, 0);
  coverage.Ends.assign(count, 0);
  for (int t = 0; t < count; ++t)
  {
    const bool solidAbove = above && above->Tetrahedra[t].Reason == SlabTetrahedra::Kept;
    const bool solidBelow =
      below && below->Tetrahedra[below->NumberOfT1 + t].Reason == SlabTetrahedra::Kept;
    coverage.Covered[t] =
      static_cast<unsigned char>((solidAbove ? LevelTriangulation::LevelAbove : 0) |
        (solidBelow ? LevelTriangulation::LevelBelow : 0));
  }
  std::vector<unsigned char> visited(count, 0);
  for (int t = 0; t < count; ++t)
  {
    if (!level.Inside[t] || visited[t])
    {
      continue;
    }
    const std::vector<int> region = RegionOf(level, t, visited);
    constexpr int bothSides = LevelTriangulation::LevelBelow | LevelTriangulation::LevelAbove;
    int touched = 0;
    for (int r : region)
    {
      touched |= coverage.Covered[r];
    }
    for (int r : region)
    {
      coverage.Isolated[r] = touched == 0 ? 1 : 0;
      coverage.Ends[r] = static_cast<unsigned char>(bothSides & ~touched);
    }
  }
  return coverage;
}

std::vector<Point2> FindCoverPoints(
  const LevelTriangulation& level, const Coverage& coverage, const LiftedHeights& lifted)
{
  std::vector<Point2> points;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    const auto& corners = level.Triangles[t];
    bool bare = level.Inside[t] && !coverage.Covered[t] && !coverage.Isolated[t];
    for (int p : corners)
    {
      bare = bare && !IsLifted(lifted.Above, p) && !IsLifted(lifted.Below, p);
    }
    for (int k = 0; k < 3 && bare; ++k)
    {
      if (level.EdgeContour[t][k] < 0)
      {
        const Point2& a = level.Points[corners[(k + 1) % 3]];
        const Point2& b = level.Points[corners[(k + 2) % 3]];
        points.push_back({ (a[0] + b[0]) / 2, (a[1] + b[1]) / 2 });
      }
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<Point2> FindEndCapPoints(
  const LevelTriangulation& level, const Coverage& coverage, double unit, bool rings)
{
  const std::vector<unsigned char> inSkeleton = FindInternalSkeleton(level, unit);
  std::vector<Point2> points;
  std::map<int, std::pair<double, Point2>>
    largest; // of a contour's point: the largest circle at it
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    if (!inSkeleton[t] || !coverage.Ends[t] || coverage.Isolated[t])
    {
      continue;
    }
    const Point2 middle = level.VoronoiVertex(static_cast<int>(t));
    points.push_back(middle);
    for (const int p : level.Triangles[t])
    {
      if (rings && level.Kind[p] != LevelTriangulation::Internal)
      {
        const Point2& corner = level.Points[p];
        const std::pair<double, Point2> circle{
          std::hypot(middle[0] - corner[0], middle[1] - corner[1]), middle
        };
        const auto [known, isNew] = largest.emplace(p, circle);
        known->second = std::max(known->second, circle);
      }
    }
  }
  for (const auto& [p, circle] : largest)
  {
    for (const double inwards : Rings)
    {
      const Point2& corner = level.Points[p];
      points.push_back({ corner[0] + inwards * (circle.second[0] - corner[0]),
        corner[1] + inwards * (circle.second[1] - corner[1]) });
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}
}
