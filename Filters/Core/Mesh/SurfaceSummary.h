// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceSummary.h
 * @brief What a surface is worth at a glance, in the time that it takes to read it once.
 *
 * Crossing triangles, nesting and single pinched points are the certificate's business (Certificate.h),
 * which takes as long as the surface itself did.
 */
#ifndef recon_SurfaceSummary_h
#define recon_SurfaceSummary_h

#include "Mesh/TriangleMesh.h"

#include <string>

namespace recon
{
/// How often the triangles do not meet two by two, each running along their edge the other way.
struct EdgeCensus
{
  int Open = 0;      ///< edges of one triangle
  int Irregular = 0; ///< edges of more than two triangles, or of two that disagree
};

/// Triangles must be within the points and have three different corners.
EdgeCensus CountEdges(const TriangleMesh& mesh);

/// "closed, 12.3 cm3", "closed, volume 12.3", "open (3 open edges), no volume".
/// @param millimetres the unit is known to be the millimetre
std::string SummariseSurface(const TriangleMesh& mesh, bool millimetres);
}

#endif
