// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/ContourPreview.h"

#include "Contours/ContourSubset.h"
#include "Implicit/Constraints/ContourResampling.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Sine of the angle below which levels are of one direction: they may be a little askew.
constexpr double SameDirection = 0.1;
/// Contours of an area below this part of a cell's face do not show.
constexpr double LeastArea = 0.25;
/// Spacings are tried from the one that would do for a single contour upward, by this factor.
constexpr double SpacingGrowth = 1.5;
constexpr int MostSpacings = 5;
/// Where that leaves too many points, fewer levels and contours count as showing: cells grow by
/// this factor, up to so many times.
constexpr double CellGrowth = 1.5;
constexpr int MostCellSizes = 5;

/// Levels of one direction, by their place along it.
struct Stack
{
  Vector3 Normal{};
  std::vector<std::pair<double, int>> Places;
};

Point3 MiddleOf(const ContourSet& contours)
{
  Point3 sum{ 0, 0, 0 };
  for (const Point3& p : contours.Points)
  {
    sum = sum + p;
  }
  return (1.0 / static_cast<double>(contours.Points.size())) * sum;
}

std::vector<Stack> StacksOf(const ContourSet& contours)
{
  // Where levels are askew, they are compared there where the contours are.
  const Point3 middle = MiddleOf(contours);
  std::vector<Stack> stacks;
  for (int l = 0; l < static_cast<int>(contours.Levels.size()); ++l)
  {
    const Level& level = contours.Levels[l];
    const Vector3& normal = level.Frame.Normal;
    auto stack = std::find_if(stacks.begin(), stacks.end(),
      [&](const Stack& s) { return Norm(Cross(s.Normal, normal)) < SameDirection; });
    if (stack == stacks.end())
    {
      stack = stacks.insert(stacks.end(), { normal, {} });
    }
    const double place = level.Offset - Dot(normal, middle);
    stack->Places.emplace_back(Dot(stack->Normal, normal) < 0 ? -place : place, l);
  }
  return stacks;
}

/// Which levels are a cell apart, the first and the last of every direction among them.
std::vector<char> LevelsApart(const ContourSet& contours, double cellSize)
{
  std::vector<char> kept(contours.Levels.size(), 0);
  for (Stack& stack : StacksOf(contours))
  {
    std::sort(stack.Places.begin(), stack.Places.end());
    double last = stack.Places.front().first;
    kept[stack.Places.front().second] = 1;
    kept[stack.Places.back().second] = 1;
    for (const auto& [place, level] : stack.Places)
    {
      if (place - last >= cellSize)
      {
        kept[level] = 1;
        last = place;
      }
    }
  }
  return kept;
}

double LengthOf(const ContourSet& contours)
{
  double length = 0;
  for (const Contour& contour : contours.Contours)
  {
    length += LengthAlong(contours.Points, contour.Points);
  }
  return length;
}

/// What shows in cells of a size: at least two levels, as fewer make no solid.
ContourSet ShownIn(const ContourSet& contours, double cellSize)
{
  const std::vector<char> kept = LevelsApart(contours, cellSize);
  const auto part = [&](double leastArea)
  {
    return SubsetOf(contours,
      [&](const Contour& c) { return kept[c.Level] && std::abs(c.SignedArea) >= leastArea; });
  };
  ContourSet shown = part(LeastArea * cellSize * cellSize);
  return shown.Levels.size() < 2 ? part(0) : shown;
}

/// Thinned out with growing spacings; the fewest points that were found.
ContourSet ThinOutTo(const ContourSet& contours, std::size_t mostPoints)
{
  ContourSet fewest = contours;
  double spacing = LengthOf(contours) / static_cast<double>(mostPoints);
  for (int k = 0; k < MostSpacings && fewest.Points.size() > mostPoints; ++k)
  {
    ContourSet thin = ThinOut(contours, spacing);
    if (thin.Points.size() < fewest.Points.size())
    {
      fewest = std::move(thin);
    }
    spacing *= SpacingGrowth;
  }
  return fewest;
}
}

ContourSet PreviewOf(const ContourSet& contours, double cellSize, std::size_t mostPoints)
{
  ContourSet thin = ThinOutTo(ShownIn(contours, cellSize), mostPoints);
  for (int k = 1; k < MostCellSizes && thin.Points.size() > mostPoints; ++k)
  {
    cellSize *= CellGrowth;
    thin = ThinOutTo(ShownIn(contours, cellSize), mostPoints);
  }
  return thin;
}
}
