// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarContourDistance.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace recon
{
namespace
{
/// Each once: as an edge of the triangle inside.
std::vector<PlanarSegment> ContourEdgesOf(const LevelTriangulation& level)
{
  std::vector<PlanarSegment> edges;
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (level.EdgeContour[t][k] >= 0 && level.Inside[t])
      {
        const auto& corners = level.Triangles[t];
        edges.push_back({ level.Points[corners[(k + 1) % 3]], level.Points[corners[(k + 2) % 3]] });
      }
    }
  }
  return edges;
}
}

PlanarContourDistance::PlanarContourDistance(const LevelTriangulation& level)
  : Edges(ContourEdgesOf(level))
{
}
}
