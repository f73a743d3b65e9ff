// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/PiecesAndHandles.h"

#include "Mesh/TriangleComponents.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace recon
{
PiecesAndHandles CountPiecesAndHandles(const TriangleMesh& mesh)
{
  std::vector<unsigned char> used(mesh.Points.size(), 0);
  for (const auto& triangle : mesh.Triangles)
  {
    for (const int p : triangle)
    {
      used[static_cast<std::size_t>(p)] = 1;
    }
  }
  const auto points = std::count(used.begin(), used.end(), 1);
  // Three edges a triangle, each of two triangles.
  const auto euler = points - static_cast<std::ptrdiff_t>(mesh.Triangles.size()) / 2;
  const int pieces = FindTriangleComponents(mesh).Count;
  return { pieces, pieces - static_cast<int>(euler / 2) };
}
}
