// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MeshCleanUp.h
 * @brief Slivers out of an isosurface, without leaving the surface or its topology.
 */
#ifndef recon_MeshCleanUp_h
#define recon_MeshCleanUp_h

#include "Base/Monitor.h"
#include "Implicit/ZeroSet/Remeshing.h"

#include <cstdint>
#include <vector>

namespace recon
{
struct CleanUpOptions
{
  double EdgeLength = 1; ///< what edges should have (units of the input)
  int Rounds = 3;
  int Threads = 0;             ///< 0 = all of the machine; the result does not depend on it
  std::vector<Point3> Anchors; ///< points of the surface that should become vertices (none = empty)
  /// By triangle, the face of the bounds that it lies in (EditableMesh); empty = none does.
  std::vector<char> Faces;
};

struct CleanUpResult
{
  std::size_t Anchored = 0;
  std::int64_t Crossing = 0; ///< pairs of triangles that cross or overlap
};

/**
 * Collapses short edges where the link condition holds (so a manifold stays one, of the same
 * genus), flips diagonals, spreads vertices in their tangent planes and projects them back. Border
 * vertices and those of creases stay. Where two sheets are near each other no change is made that lets triangles cross,
 * and the whole is looked at in the end: a mesh that did not cross itself does not afterwards.
 *
 * @param normals at the points, out of the solid; kept up to date. No triangle may turn against
 * them.
 */
CleanUpResult CleanUp(TriangleMesh& mesh, std::vector<Vector3>& normals, const Projector& project,
  const CleanUpOptions& options, Monitor& monitor);
}

#endif
