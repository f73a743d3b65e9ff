// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DelaunayEdges.h
 * @brief How the edges of a level's triangulation lie to its contours.
 *
 * An edge is numbered as in SlabTetrahedra::Tetrahedron::Origin.
 */
#ifndef recon_DelaunayEdges_h
#define recon_DelaunayEdges_h

#include "Polyhedral/LevelTriangulation.h"

namespace recon
{
enum class EdgeKind
{
  External,
  Internal,
  Contour
};

EdgeKind KindOf(const LevelTriangulation& level, int edge);

/// Contour that the edge is a part of, or -1.
int ContourAtEdge(const LevelTriangulation& level, int edge);

/// Region on the solid side of an edge that is not external.
int RegionAtEdge(const LevelTriangulation& level, int edge);

/// Whether the crossing of the edge's bisector with that of u and v lies outside contour edge
/// `edge`. Condition 2 puts the edge's Voronoi edge across its midpoint, so one side test tells.
bool IsNodeOutside(const LevelTriangulation& level, int edge, const Point2& u, const Point2& v);
}

#endif
