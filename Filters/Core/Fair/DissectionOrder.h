// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DissectionOrder.h
 * @brief An order of a mesh's points in which a factorisation of its equations stays sparse.
 */
#ifndef recon_DissectionOrder_h
#define recon_DissectionOrder_h

#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace recon
{
/// Points that are numbered together, after all those of its two parts.
struct DissectionNode
{
  int From; ///< the first of its places in the order
  int To;   ///< behind the last one
  int Parent = -1;
  std::array<int, 2> Parts{ -1, -1 }; ///< -1: none, it was not parted
  int Depth = 0;                      ///< below the last node, which all points come from
};

struct DissectionOrder
{
  std::vector<int> Rank;             ///< place in the order, a point
  std::vector<DissectionNode> Nodes; ///< parts come before what they are parts of
};

/**
 * Nested dissection (George 1973) by coordinates: the points of either side of a plane first, those
 * beside it, two edges deep, last; so also where equations reach two edges far.
 */
DissectionOrder DissectMesh(const TriangleMesh& mesh);
}

#endif
