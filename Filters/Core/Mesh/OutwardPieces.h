// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file OutwardPieces.h
 * @brief Turns over what rounding has turned inside out.
 *
 * A piece of a surface that is as thin as its points are rounded may come out with its sides
 * exchanged, without any two triangles crossing. What it encloses is nothing that could be measured, but
 * a surface is outward everywhere or it is not.
 */
#ifndef recon_OutwardPieces_h
#define recon_OutwardPieces_h

#include "Mesh/TriangleMesh.h"

#include <cstddef>

namespace recon
{
/**
 * Turns the triangles of each closed, oriented component over that faces inwards (see
 * TopologyFigures::Outward) and holds no more than its area times `thickness`.
 *
 * @param thickness in the units of the mesh
 * @return number of components turned
 * @throws Error where an index is out of range or a coordinate is not finite.
 */
std::size_t TurnThinPiecesOutward(TriangleMesh& mesh, double thickness);
}

#endif
