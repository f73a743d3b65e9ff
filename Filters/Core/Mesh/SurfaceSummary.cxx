// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SurfaceSummary.h"

#include "Base/Text.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/MassProperties.h"

#include <vector>

namespace recon
{
namespace
{
constexpr double CubicMillimetres = 1000; // in a cm3

std::string VolumeText(const TriangleMesh& mesh, bool millimetres)
{
  const std::vector<int> together(mesh.Triangles.size(), 0);
  const double volume = ComputeSignedVolumes(mesh, together, 1).front();
  return millimetres ? Text(volume / CubicMillimetres) + " cm3" : "volume " + Text(volume);
}
}

EdgeCensus CountEdges(const TriangleMesh& mesh)
{
  EdgeCensus census;
  ForEachEdge(SortEdges(mesh),
    [&](const EdgeGroup& edge)
    {
      census.Open += edge.Count() == 1 ? 1 : 0;
      census.Irregular += edge.Count() > 2 || !IsOriented(mesh, edge) ? 1 : 0;
    });
  return census;
}

std::string SummariseSurface(const TriangleMesh& mesh, bool millimetres)
{
  if (mesh.Triangles.empty())
  {
    return "no surface";
  }
  const EdgeCensus census = CountEdges(mesh);
  if (census.Irregular > 0)
  {
    return "no manifold (" + Counted(census.Irregular, "edge") +
      " not of two triangles), no volume";
  }
  if (census.Open > 0)
  {
    return "open (" + Counted(census.Open, "open edge") + "), no volume";
  }
  return "closed, " + VolumeText(mesh, millimetres);
}
}
