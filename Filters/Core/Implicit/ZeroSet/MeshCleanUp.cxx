// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/MeshCleanUp.h"

#include "Implicit/ZeroSet/SliverRemoval.h"

namespace recon
{
namespace
{
/// Where two sheets of the surface are nearer than this many edge lengths, no change may make
/// triangles cross.
constexpr double ThinPlace = 1;
/// Where triangles cross all the same, it is begun again with all places thin that are so many edge
/// lengths around, up to so many times.
constexpr double AroundCrossing = 4;
constexpr int MaximumAttempts = 3;

CleanUpResult CleanUpOnce(TriangleMesh& mesh, std::vector<Vector3>& normals,
  const Projector& project, const CleanUpOptions& options, const std::vector<char>& thin,
  Monitor& monitor)
{
  Remesher remesher(mesh, normals, options.EdgeLength, thin, options.Faces);
  for (int round = 0; round < options.Rounds; ++round)
  {
    monitor.Update(static_cast<double>(round) / (options.Rounds + 1), "cleaning up the mesh");
    remesher.CollapseShortEdges();
    remesher.FlipEdges();
    remesher.Spread(project);
    remesher.FlipEdges();
  }
  monitor.Update(
    static_cast<double>(options.Rounds) / (options.Rounds + 1), "cleaning up the mesh");
  RemoveSlivers(remesher, project);
  CleanUpResult result;
  if (!options.Anchors.empty())
  {
    result.Anchored = remesher.Anchor(options.Anchors);
    remesher.FlipEdges();
    remesher.Spread(project);
    RemoveSlivers(remesher, project);
  }
  remesher.Edited.Compact();
  return result;
}
}

CleanUpResult CleanUp(TriangleMesh& mesh, std::vector<Vector3>& normals, const Projector& project,
  const CleanUpOptions& options, Monitor& monitor)
{
  const TriangleMesh given = mesh;
  const std::vector<Vector3> givenNormals = normals;
  std::vector<char> thin = ThinPlaces(given.Points, givenNormals, ThinPlace * options.EdgeLength);
  CleanUpResult result;
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    mesh = given;
    normals = givenNormals;
    result = CleanUpOnce(mesh, normals, project, options, thin, monitor);
    result.Crossing = MarkCrossings(
      mesh, given.Points, AroundCrossing * options.EdgeLength, options.Threads, monitor, thin);
    if (result.Crossing == 0)
    {
      break;
    }
  }
  monitor.Update(1, "cleaning up the mesh");
  return result;
}
}
