// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LoopTracing.h
 * @brief Simple loops around the inside of a planar arrangement of edges.
 */
#ifndef recon_LoopTracing_h
#define recon_LoopTracing_h

#include "Planar/EdgeConflicts.h"

#include <vector>

namespace recon
{
/// A simple closed polygon, and the edges (numbers into the input) that it runs along.
struct TracedLoop
{
  std::vector<int> Points;
  std::vector<int> Edges; ///< Edges[i] joins Points[i] to the next
};

/**
 * Traces every edge once.
 *
 * Where several loops pass through a point, they turn off along the same bit of inside, so they
 * touch there and do not cross. Inside is even-odd within a connected piece of the arrangement:
 * which of two nested pieces is a hole does not matter here.
 *
 * @pre no two edges are equal, cross or overlap, no point lies inside an edge, and an even number
 * of edges meets at every point
 * @throws Error where that does not hold
 */
std::vector<TracedLoop> TraceLoops(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges);
}

#endif
