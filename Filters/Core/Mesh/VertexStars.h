// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VertexStars.h
 * @brief Points around which no triangles of a mesh meet but where they should.
 */
#ifndef recon_VertexStars_h
#define recon_VertexStars_h

#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * A point: whether the triangles around it are one disc that is seen along one of the axes without any
 * of them behind another. Then two of them meet in exactly the corner or edge that they share.
 *
 * By exact predicates, a few a triangle, where the pairs around a point are some fifteen. On a smooth mesh
 * nearly all points are such; of the others, as on borders and along folds, nothing is said.
 *
 * @throws Aborted
 */
std::vector<char> FindFlatStars(const TriangleMesh& mesh, int threads, Monitor& monitor);
}

#endif
