// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TurnedPieces.h
 * @brief Pieces of a surface that are inside out, or where they should not be.
 */
#ifndef recon_TurnedPieces_h
#define recon_TurnedPieces_h

#include "Mesh/TriangleComponents.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * A piece: whether it is closed and does not have the solid inside, or, within an odd number of others,
 * outside. Where triangles were moved or exchanged, that can come about without any crossing: a small
 * piece may be gone through in one step.
 */
std::vector<char> FindTurnedPieces(const TriangleMesh& mesh, const TriangleComponents& pieces);
}

#endif
