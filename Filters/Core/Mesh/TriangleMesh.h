// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TriangleMesh.h
 * @brief Triangles by index; connectivity is by index only, coordinates may repeat.
 */
#ifndef recon_TriangleMesh_h
#define recon_TriangleMesh_h

#include "Base/Geometry.h"

#include <array>
#include <vector>

namespace recon
{
/// Corners run counterclockwise seen from outside the solid.
struct TriangleMesh
{
  std::vector<Point3> Points;
  std::vector<std::array<int, 3>> Triangles;
};
}

#endif
