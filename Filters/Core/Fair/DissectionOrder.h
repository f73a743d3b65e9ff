// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DissectionOrder.h
 * @brief An order of a mesh's points in which a factorisation of its equations stays sparse.
 */
#ifndef recon_DissectionOrder_h
#define recon_DissectionOrder_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * Nested dissection (George 1973) by coordinates: the points of either side of a plane first, those
 * beside it, two edges deep, last; so also where equations reach two edges far.
 *
 * @returns place in the order, a point
 */
std::vector<int> DissectionOrder(const TriangleMesh& mesh);
}

#endif
