// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/EndShapes.h"

#include "Polyhedral/LiftTargets.h"
#include "Polyhedral/MapSlabs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
/// Points spread over a region to learn how much of it is how far from the contours.
constexpr int Samples = 1024;
/// Steps of a sequence that fills the unit square evenly (the plastic number's, R2).
constexpr double FirstStep = 0.7548776662466927;
constexpr double SecondStep = 0.5698402909980532;

double AreaOf(const LevelTriangulation& level, int triangle)
{
  const auto& [a, b, c] = level.Triangles[triangle];
  const Point2& p = level.Points[a];
  const Point2& q = level.Points[b];
  const Point2& r = level.Points[c];
  return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
}

/// A point of a triangle; u and v in [0, 1) evenly spread make such points.
Point2 PlaceIn(const LevelTriangulation& level, int triangle, double u, double v)
{
  if (u + v > 1)
  {
    u = 1 - u;
    v = 1 - v;
  }
  const auto& [a, b, c] = level.Triangles[triangle];
  Point2 place;
  for (int k = 0; k < 2; ++k)
  {
    place[k] = (1 - u - v) * level.Points[a][k] + u * level.Points[b][k] + v * level.Points[c][k];
  }
  return place;
}

std::vector<double> RoomsOf(const LevelState& state, const std::vector<int>& triangles)
{
  std::vector<double> reach; // area up to and including each triangle
  double total = 0;
  for (const int t : triangles)
  {
    total += std::max(0.0, AreaOf(state.Triangulation, t));
    reach.push_back(total);
  }
  std::vector<double> rooms;
  double u = 0;
  double v = 0;
  std::size_t at = 0;
  for (int i = 0; i < Samples; ++i)
  {
    u = std::fmod(u + FirstStep, 1.0);
    v = std::fmod(v + SecondStep, 1.0);
    while (at + 1 < reach.size() && reach[at] * Samples < total * (i + 0.5))
    {
      ++at;
    }
    rooms.push_back((*state.Distance)(PlaceIn(state.Triangulation, triangles[at], u, v)));
  }
  return rooms;
}
}

EndShape::EndShape(const SectionParabola& sections, double end, std::vector<double> rooms)
  : Sections(sections),
    End(end),
    Rooms(std::move(rooms))
{
  std::sort(this->Rooms.begin(), this->Rooms.end());
}

double EndShape::HeightAt(double distance) const
{
  // The samples stand for equal parts of the area, each at the middle of its rank.
  const auto next = std::lower_bound(this->Rooms.begin(), this->Rooms.end(), distance);
  const double count = static_cast<double>(this->Rooms.size());
  double rank = static_cast<double>(next - this->Rooms.begin());
  if (next != this->Rooms.end())
  {
    const double before = next == this->Rooms.begin() ? 0 : *(next - 1);
    rank += *next > before ? (distance - before) / (*next - before) - 0.5 : 0;
  }
  const double share = std::clamp(1 - rank / count, 0.0, 1.0);
  return std::min(this->End, this->Sections.PlaceOf(share * this->Sections.Area));
}

EndShapes::EndShapes(const ContourSet& contours, const ContourMapping& mapping,
  const PolyhedralOptions& options, Monitor& monitor)
  : LevelCount(static_cast<int>(contours.Levels.size())),
    Mapping(mapping.Regions.empty()
        ? BuildContourMapping(contours, MappingOptionsOf(options), monitor)
        : mapping),
    Gaps(FindLevelGaps(contours, options.MaximumGap)),
    Stack(contours, this->Mapping, this->Gaps)
{
}

/// Where nothing is left, or less than a slice beyond: see HighestShareOfEnd for shapes that do not
/// get smaller.
double EndShapes::EndOf(const SectionParabola& sections, int level, int step) const
{
  const double reach = this->Stack.ReachOf(level, step);
  const double end = sections.PlaceOf(0);
  const bool isOutermost = step > 0 ? level + 1 == this->LevelCount : level == 0;
  const double least = HighestShareOfEnd(isOutermost);
  return end <= reach ? end : reach * (least + (1 - least) * reach / end);
}

EndShapesOfLevel EndShapes::Find(const LevelState& state, int level, int step) const
{
  const int side = step > 0 ? LevelTriangulation::LevelAbove : LevelTriangulation::LevelBelow;
  const LevelTriangulation& triangulation = state.Triangulation;
  std::map<int, std::vector<int>> ending; // triangles by wall
  for (int t = 0; t < static_cast<int>(triangulation.Triangles.size()); ++t)
  {
    if (triangulation.Inside[t] && (state.Covered.Ends[t] & side) != 0 &&
      !state.Covered.Isolated[t] && triangulation.Region[t] >= 0)
    {
      ending[triangulation.Region[t]].push_back(t);
    }
  }
  EndShapesOfLevel shapes;
  for (const auto& [wall, triangles] : ending)
  {
    if (const auto sections = this->Stack.ParabolaAtEnd(wall, step)) // region i is inside contour i
    {
      shapes.emplace(
        wall, EndShape(*sections, this->EndOf(*sections, level, step), RoomsOf(state, triangles)));
    }
  }
  return shapes;
}
}
