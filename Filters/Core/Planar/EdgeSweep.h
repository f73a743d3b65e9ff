// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EdgeSweep.h
 * @brief Which edge of a plane lies next below another: what labels of faces are handed on along.
 */
#ifndef recon_EdgeSweep_h
#define recon_EdgeSweep_h

#include "Planar/EdgeConflicts.h"

#include <vector>

namespace recon
{
/// An edge as the sweep meets it.
struct SweptEdge
{
  int Edge = -1;
  int Below = -1; ///< the edge next below its left end, -1 for none; met earlier
};

/**
 * One sweep from left to right (upward, where that is the same), with exact predicates: n log n.
 *
 * No point lies inside an edge, so either side of an edge is one face from end to end, and between an
 * edge and the one next below it is nothing. Whoever labels faces (by even-odd, by winding, by the
 * innermost loop) starts below the lowest edge with what is infinitely far out, hands the label above
 * `Below` on to below `Edge`, and changes it across `Edge`.
 *
 * @pre no two edges are equal, cross or overlap, and they meet in points that they share by index
 * @return the edges by their left ends, at one left end from low to high
 */
std::vector<SweptEdge> SweepEdges(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges);

/// Whether the edge was met walking from A to B, so that above it is on the left of that walk.
inline bool RunsRight(const std::vector<Point2>& points, const PlanarEdge& edge)
{
  return points[edge.A] < points[edge.B];
}
}

#endif
