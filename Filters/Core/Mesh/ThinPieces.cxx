// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ThinPieces.h"

#include <cmath>
#include <cstddef>

namespace recon
{
bool HasThinPiece(const TriangleMesh& mesh, const std::vector<int>& pieceOfTriangle,
  const std::vector<double>& volumes, double thickness)
{
  std::vector<double> areas(volumes.size(), 0);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& corners = mesh.Triangles[t];
    const Point3& a = mesh.Points[corners[0]];
    const Vector3 twice = Cross(mesh.Points[corners[1]] - a, mesh.Points[corners[2]] - a);
    areas[pieceOfTriangle[t]] += Norm(twice) / 2;
  }
  for (std::size_t c = 0; c < areas.size(); ++c)
  {
    if (std::abs(volumes[c]) <= thickness * areas[c])
    {
      return true;
    }
  }
  return false;
}
}
