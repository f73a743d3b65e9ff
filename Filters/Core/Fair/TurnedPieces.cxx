// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/TurnedPieces.h"

#include "Mesh/ComponentNesting.h"
#include "Mesh/MassProperties.h"

#include <algorithm>
#include <utility>

namespace recon
{
namespace
{
/// Whether each edge of a piece is that of two triangles.
bool IsClosed(const TriangleMesh& mesh, const TriangleComponents& pieces, int piece)
{
  std::vector<std::pair<int, int>> edges;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& corners = mesh.Triangles[t];
    for (int k = 0; k < 3 && pieces.Of[t] == piece; ++k)
    {
      edges.push_back(std::minmax(corners[k], corners[(k + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    if (i + 1 == edges.size() || edges[i] != edges[i + 1])
    {
      return false;
    }
  }
  return true;
}
}

std::vector<char> FindTurnedPieces(const TriangleMesh& mesh, const TriangleComponents& pieces)
{
  const std::vector<double> volumes = ComputeSignedVolumes(mesh, pieces.Of, pieces.Count);
  std::vector<int> around(pieces.Count, 0);
  if (pieces.Count > 1)
  {
    around = FindComponentNesting(mesh, pieces.Of, std::vector<bool>(pieces.Count, true));
  }
  std::vector<char> turned(pieces.Count, 0);
  for (int piece = 0; piece < pieces.Count; ++piece)
  {
    const bool isCavity = around[piece] % 2 != 0;
    const bool isWell = isCavity ? volumes[piece] < 0 : volumes[piece] > 0;
    turned[piece] = !isWell && IsClosed(mesh, pieces, piece) ? 1 : 0;
  }
  return turned;
}
}
