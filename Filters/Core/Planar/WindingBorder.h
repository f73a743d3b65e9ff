// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file WindingBorder.h
 * @brief Where the winding number of directed edges changes from zero to something else.
 */
#ifndef recon_WindingBorder_h
#define recon_WindingBorder_h

#include "Planar/EdgeConflicts.h"

#include <vector>

namespace recon
{
/**
 * For every edge: whether the winding number is zero on exactly one side of it.
 *
 * @pre that of SweepEdges, no point lies inside an edge, and at every point as much weight comes in as goes
 * out
 */
std::vector<bool> FindWindingBorder(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges);
}

#endif
