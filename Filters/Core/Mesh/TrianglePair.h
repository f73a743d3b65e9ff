// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TrianglePair.h
 * @brief The exact relation of two triangles of a mesh: clean, touching, overlapping or crossing.
 */
#ifndef recon_TrianglePair_h
#define recon_TrianglePair_h

#include "Mesh/TriangleMesh.h"

namespace recon
{
enum class PairRelation
{
  Clean,       ///< do not meet, or meet in exactly the corner or edge that they share by index
  Touching,    ///< meet elsewhere too, but no inner point of one is an inner point of the other
  Overlapping, ///< lie in one plane and have some area in common
  Crossing     ///< lie in different planes and have inner points in common: a segment
};

/**
 * The relation of triangles s and t of a mesh, by exact predicates only.
 *
 * Triangles without area have none: Clean. They are what CheckTopology counts as degenerate.
 */
PairRelation RelateTriangles(const TriangleMesh& mesh, int s, int t);
}

#endif
