// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PiecesAndHandles.h
 * @brief How many sheets a closed surface has, and how many handles.
 */
#ifndef recon_PiecesAndHandles_h
#define recon_PiecesAndHandles_h

#include "Mesh/TriangleMesh.h"

namespace recon
{
struct PiecesAndHandles
{
  int Pieces = 0;  ///< components by index; the wall of a cavity is one of its own
  int Handles = 0; ///< of all together: the Euler number is 2 (Pieces - Handles)
};

/// @pre every edge has two triangles, and the triangles at every point are one fan
PiecesAndHandles CountPiecesAndHandles(const TriangleMesh& mesh);
}

#endif
