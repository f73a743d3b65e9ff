// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/OutwardPieces.h"

#include "Mesh/MassProperties.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace recon
{
std::size_t TurnThinPiecesOutward(TriangleMesh& mesh, double thickness)
{
  const MeshTopology topology = CheckTopology(mesh);
  if (topology.Total.Outward)
  {
    return 0;
  }
  std::vector<bool> encloses;
  for (const TopologyFigures& component : topology.Components)
  {
    encloses.push_back(component.EnclosesVolume());
  }
  const std::vector<MassFigures> mass =
    ComputeMassProperties(mesh, topology.ComponentOfTriangle, encloses);
  std::vector<char> isTurned(encloses.size(), 0);
  for (std::size_t c = 0; c < encloses.size(); ++c)
  {
    isTurned[c] = encloses[c] && !topology.Components[c].Outward &&
        std::abs(*mass[c].Volume) <= thickness * mass[c].Area
      ? 1
      : 0;
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const int component = topology.ComponentOfTriangle[t];
    if (component >= 0 && isTurned[component])
    {
      std::swap(mesh.Triangles[t][1], mesh.Triangles[t][2]);
    }
  }
  return static_cast<std::size_t>(std::count(isTurned.begin(), isTurned.end(), 1));
}
}
