// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/WindingBorder.h"

#include "Planar/EdgeSweep.h"

#include <cstdint>

namespace recon
{
std::vector<bool> FindWindingBorder(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  std::vector<bool> onBorder(edges.size(), false);
  std::vector<std::int64_t> above(edges.size(), 0); // the winding number
  for (const SweptEdge& swept : SweepEdges(points, edges))
  {
    // Nothing winds around what is infinitely far out.
    const std::int64_t below = swept.Below < 0 ? 0 : above[swept.Below];
    const PlanarEdge& edge = edges[swept.Edge];
    above[swept.Edge] = below + (RunsRight(points, edge) ? edge.Weight : -edge.Weight);
    onBorder[swept.Edge] = (below == 0) != (above[swept.Edge] == 0);
  }
  return onBorder;
}
}
