// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PinchedPoints.h
 * @brief Points at which a surface that was opened hangs together by a corner only.
 */
#ifndef recon_PinchedPoints_h
#define recon_PinchedPoints_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * Gives every fan of triangles at a point a point of its own, so that the mesh is vertex-manifold.
 *
 * The mesh must be oriented and edge-manifold. The first fan keeps the point.
 *
 * @returns of every point that was added, which follow the others in their order, the point that it
 * is a copy of
 */
std::vector<int> CutPinchedPoints(TriangleMesh& mesh);
}

#endif
