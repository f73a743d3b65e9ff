// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ThinPieces.h
 * @brief Whether a mesh has pieces so thin that a sheet which moves a little may pass them whole.
 */
#ifndef recon_ThinPieces_h
#define recon_ThinPieces_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/// Whether some piece holds no more than its area times `thickness`.
bool HasThinPiece(const TriangleMesh& mesh, const std::vector<int>& pieceOfTriangle,
  const std::vector<double>& volumes, double thickness);
}

#endif
