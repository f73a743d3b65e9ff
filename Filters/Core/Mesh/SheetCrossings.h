// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SheetCrossings.h
 * @brief Edges along which sheets of a surface pass through one another though no two triangles
 * cross.
 *
 * A manifold cut (thesis 11.3) takes the faces around an edge of four apart into two sheets that
 * touch there. If it joins the wrong ones the sheets cross instead, and no pair of triangles tells:
 * all merely touch. The order of the faces around the edge does.
 */
#ifndef recon_SheetCrossings_h
#define recon_SheetCrossings_h

#include "Mesh/TriangleMesh.h"

#include <utility>
#include <vector>

namespace recon
{
struct SheetCrossings
{
  int Edges = 0; ///< pairs of coordinates along which sheets cross
  std::vector<std::pair<int, int>>
    Triangles; ///< number of the edge, triangle that meets it; sorted
};

/**
 * Look at every edge, by coordinates, at which more than two triangles meet.
 *
 * Two triangles that share the edge by index are a sheet. Two sheets cross where, in the exact
 * order of directions around the edge, the triangles of the one are separated by those of the
 * other. Sheets that lie on each other on one side do not count, they overlap; nor do edges of one
 * or more than two triangles by index.
 *
 * @throws Error where an index is out of range or a coordinate not finite.
 */
SheetCrossings FindSheetCrossings(const TriangleMesh& mesh);
}

#endif
