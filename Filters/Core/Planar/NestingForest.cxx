// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/NestingForest.h"

#include "Base/Predicates.h"
#include "Planar/EdgeSweep.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>

namespace recon
{
namespace
{
/// The turn at the smallest point: the exact sense of a simple loop.
int SenseOf(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  const auto smallest = std::min_element(
    loop.begin(), loop.end(), [&points](int p, int q) { return points[p] < points[q]; });
  const auto i = static_cast<std::size_t>(smallest - loop.begin());
  const std::size_t n = loop.size();
  return Orientation2(points[loop[(i + n - 1) % n]], points[loop[i]], points[loop[(i + 1) % n]]);
}

double ExactArea(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  using Rational = CGAL::Exact_rational;
  Rational twice(0);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = points[loop[i]];
    const Point2& b = points[loop[(i + 1) % loop.size()]];
    twice += Rational(a[0]) * Rational(b[1]) - Rational(b[0]) * Rational(a[1]);
  }
  return CGAL::to_double(Rational(twice / 2));
}
}

double SignedAreaOf(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  const Point2& o = points[loop[0]];
  double area = 0;
  double size = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    const Point2& a = points[loop[i]];
    const Point2& b = points[loop[i + 1]];
    const double left = 0.5 * (a[0] - o[0]) * (b[1] - o[1]);
    const double right = 0.5 * (b[0] - o[0]) * (a[1] - o[1]);
    area += left - right;
    size += std::abs(left) + std::abs(right);
  }
  // Slivers, whose terms cancel, are summed exactly.
  const int sense = SenseOf(points, loop);
  return area * sense > 1e-4 * size ? area : ExactArea(points, loop);
}

NestingForest BuildNestingForest(
  const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops)
{
  std::vector<PlanarEdge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    AddLoopEdges(loops[l], static_cast<int>(l), edges);
  }
  NestingForest forest;
  forest.Parent.assign(loops.size(), -1);
  forest.Depth.assign(loops.size(), -1);
  for (const SweptEdge& swept : SweepEdges(points, edges))
  {
    // The first edge of a loop that comes in is the lower one at its leftmost point.
    const int loop = edges[swept.Edge].Tag;
    if (forest.Depth[loop] >= 0)
    {
      continue;
    }
    int parent = -1;
    if (swept.Below >= 0)
    {
      // Counterclockwise: the inside is left of the walk.
      const PlanarEdge& below = edges[swept.Below];
      parent = RunsRight(points, below) ? below.Tag : forest.Parent[below.Tag];
    }
    forest.Parent[loop] = parent;
    forest.Depth[loop] = parent < 0 ? 0 : forest.Depth[parent] + 1;
  }
  return forest;
}
}
