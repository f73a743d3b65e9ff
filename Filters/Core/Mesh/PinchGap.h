// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PinchGap.h
 * @brief Draws apart sheets of a surface that touch in a point or an edge.
 *
 * Where wedges of solid meet in an edge or a point, a surface is cut into one that is a manifold by
 * its indices: each wedge has points of its own, in one place. Formats without indices (STL) and
 * programs that merge equal points lose that. So all but one of the points of such a place move
 * by a tiny distance: into their own wedge of solid, or, where the solid is around and empty wedges
 * touch, into their own empty wedge.
 *
 * Notation:
 *   place   a position that several points of the mesh have
 *   fan     the triangles at one point of a place: the border of one wedge
 *   gap     how far a point moves, in the units of the mesh; at most a tenth of its shortest edge
 */
#ifndef recon_PinchGap_h
#define recon_PinchGap_h

#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>

namespace recon
{
struct PinchGapResult
{
  std::size_t Places = 0; ///< where sheets touched
  std::size_t Left = 0;   ///< where they still do, as no way apart was found that crosses no sheet
};

/**
 * Move points so that no place has more than one, never through another sheet.
 *
 * One point of every place stays where it is. A move is judged by exact predicates; one that would
 * make triangles cross, overlap or touch, or turn a thin piece inside out, is tried the other way round, in other directions and at a
 * half, a quarter and an eighth, and then not made. None is made where a piece thinner than the gap would come to lie in another. After a thousand pairs of triangles looked at for each
 * triangle, and twenty million more, one that would is not made at once.
 *
 * @param mesh closed, oriented outward and manifold by its indices; triangles do not cross
 * @param gap positive
 * @param normal of planes that points should not leave where another way can be had, as what lies flat
 * in them would tilt; zero where there are none
 * @throws Aborted.
 */
PinchGapResult OpenPinches(TriangleMesh& mesh, double gap, const Vector3& normal, Monitor& monitor);

/// The median length of the edges of a mesh; 0 of an empty one.
double MedianEdgeLength(const TriangleMesh& mesh);
}

#endif
