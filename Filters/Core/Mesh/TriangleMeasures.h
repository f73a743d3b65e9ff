// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TriangleMeasures.h
 * @brief Normal and box of one triangle of a mesh.
 */
#ifndef recon_TriangleMeasures_h
#define recon_TriangleMeasures_h

#include "Base/BoundingBox.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>

namespace recon
{
/// Outward, of length 1; zero where the triangle has no area that a double can tell.
inline Vector3 UnitNormalOf(const TriangleMesh& mesh, int triangle)
{
  const auto& corners = mesh.Triangles[static_cast<std::size_t>(triangle)];
  const Point3& a = mesh.Points[corners[0]];
  const Vector3 normal = Cross(mesh.Points[corners[1]] - a, mesh.Points[corners[2]] - a);
  const double length = Norm(normal);
  return length > 0 ? (1 / length) * normal : Vector3{ 0, 0, 0 };
}

inline Box3 BoxOf(const TriangleMesh& mesh, int triangle)
{
  Box3 box;
  for (const int p : mesh.Triangles[static_cast<std::size_t>(triangle)])
  {
    box.Add(mesh.Points[p]);
  }
  return box;
}
}

#endif
