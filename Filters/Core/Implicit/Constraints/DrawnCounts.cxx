// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/DrawnCounts.h"

#include "Contours/ContourMeasures.h"
#include "Implicit/ZeroSet/ContourTracer.h"

#include <cmath>

namespace recon
{
namespace
{
/// Contours count from so many squares of a cell on.
constexpr double LeastSquares = 2;
/// What counts on one side may be smaller by this factor on the other.
constexpr double Leeway = 0.5;
/// Planes nearer than this part of a cell are one.
constexpr double SamePlane = 1e-3;

int CountOf(const ContourSet& set, int level, double area)
{
  int count = 0;
  for (const int c : set.Levels[level].Contours)
  {
    count += std::abs(set.Contours[c].SignedArea) >= area ? 1 : 0;
  }
  return count;
}

/// -1: nothing was traced there.
int LevelAt(const ContourSet& set, const Vector3& normal, double height, double tolerance)
{
  for (int l = 0; l < static_cast<int>(set.Levels.size()); ++l)
  {
    if (std::abs(HeightOf(set.Levels[l], normal) - height) <= tolerance)
    {
      return l;
    }
  }
  return -1;
}
}

std::vector<OtherCount> FindOtherCounts(const ContourSet& drawn, const ImplicitFunction& function,
  const std::vector<Point3>& seeds, double cell, int threads, Monitor& monitor)
{
  TracerOptions options;
  options.CellSize = cell;
  options.Threads = threads;
  const ContourSet traced = TraceContours(function, seeds, PlanesOf(drawn), options, monitor);
  const Vector3& normal = drawn.Levels.front().Frame.Normal;
  const double large = LeastSquares * cell * cell;
  std::vector<OtherCount> others;
  for (int l = 0; l < static_cast<int>(drawn.Levels.size()); ++l)
  {
    const double height = HeightOf(drawn.Levels[l], normal);
    const int at = LevelAt(traced, normal, height, SamePlane * cell);
    const auto found = [&](double area) { return at < 0 ? 0 : CountOf(traced, at, area); };
    const bool lost = found(Leeway * large) < CountOf(drawn, l, large);
    const bool more = found(large) > CountOf(drawn, l, Leeway * large);
    if (lost || more)
    {
      const double least = lost ? Leeway * large : large;
      others.push_back({ height, CountOf(drawn, l, lost ? large : Leeway * large), found(least) });
    }
  }
  return others;
}
}
