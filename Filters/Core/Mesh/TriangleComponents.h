// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TriangleComponents.h
 * @brief What triangles of a mesh hang together.
 */
#ifndef recon_TriangleComponents_h
#define recon_TriangleComponents_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
struct TriangleComponents
{
  std::vector<int> Of; ///< a triangle: the number of its component, in the order of first triangles
  int Count = 0;
};

/// Triangles that share points, by index. For all figures of components see CheckTopology.
TriangleComponents FindTriangleComponents(const TriangleMesh& mesh);
}

#endif
