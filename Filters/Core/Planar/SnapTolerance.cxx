// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/SnapTolerance.h"

#include "Base/BoundingBox.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace recon
{
namespace
{
// 512 times the rounding of one coordinate: that of crossings, and of edges split there.
const double Rounding = std::ldexp(1.0, -44);

double DiagonalOf(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  Box2 box;
  for (int p : loop)
  {
    box.Add(points[static_cast<std::size_t>(p)]);
  }
  return box.Diagonal();
}
}

std::vector<double> SnapTolerances(
  const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, double wanted)
{
  double largest = 0;
  for (const std::vector<int>& loop : loops)
  {
    for (int p : loop)
    {
      const Point2& x = points[static_cast<std::size_t>(p)];
      largest = std::max({ largest, std::abs(x[0]), std::abs(x[1]) });
    }
  }
  std::vector<double> tolerances;
  for (const std::vector<int>& loop : loops)
  {
    const double tolerance = wanted > 0 ? wanted : AutomaticSnapping * DiagonalOf(points, loop);
    tolerances.push_back(std::max(tolerance, Rounding * largest));
  }
  return tolerances;
}
}
