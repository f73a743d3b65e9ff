// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceSections.h
 * @brief The contours in which a plane cuts a closed surface.
 */
#ifndef recon_SurfaceSections_h
#define recon_SurfaceSections_h

#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"

namespace recon
{
/**
 * Adds a closed chain for every loop in which the plane cuts the surface, with its points in the
 * plane (but for rounding).
 *
 * Points of the mesh that lie in the plane count as above it, so the section is that of a plane a
 * hair below, every loop closes, and a face in the plane is the end of what is below it. Which
 * loops are outer walls and which are holes is the contour set's business.
 *
 * @param mesh each edge has two triangles; a chain that does not close is left out
 */
void AppendSection(
  const TriangleMesh& mesh, const PlanarFrame& frame, double offset, LoopSoup& soup);
}

#endif
