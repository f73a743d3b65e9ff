// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SheetLinks.h
 * @brief Joins pieces of a closed surface by thin straight tubes, between its levels.
 *
 * A tube leads from the middle of a triangle to that of one of another piece, through what is empty or,
 * from the wall of a cavity, through solid. Of two pieces it makes one; each further tube between pieces
 * that hang together makes a handle. The shortest that do not touch anything else are taken, the pieces
 * joined along a spanning tree.
 */
#ifndef recon_SheetLinks_h
#define recon_SheetLinks_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
struct SheetLink
{
  int Slab = -1; ///< between offsets Slab and Slab + 1
  Point3 From{};
  Point3 To{};
  bool ThroughSolid = false;
};

struct SheetLinks
{
  std::vector<SheetLink> Links;
  std::vector<int> PartOf; ///< of every triangle of the mesh now: the one that it was, or is beside
};

/// How many pieces fewer and handles more there shall be.
struct LinksWanted
{
  int Pieces = 0;
  int Handles = 0;
};

/**
 * Fewer where no tubes are left that touch nothing. Points stay; what is at the levels is not touched.
 *
 * @param offsets of the levels along the frame's normal, increasing
 * @pre every edge has two triangles
 */
SheetLinks LinkSheets(TriangleMesh& mesh, const PlanarFrame& frame,
  const std::vector<double>& offsets, const LinksWanted& wanted, Monitor& monitor);
}

#endif
