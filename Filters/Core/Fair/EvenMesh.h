// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EvenMesh.h
 * @brief A surface once more, of triangles whose edges are all about as long.
 */
#ifndef recon_EvenMesh_h
#define recon_EvenMesh_h

#include "Base/Monitor.h"
#include "Fair/KeptPlaces.h"
#include "Mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace recon
{
struct EvenMesh
{
  TriangleMesh Mesh;
  std::vector<char> Parts;   ///< a triangle, where the given ones have parts
  std::int64_t Crossing = 0; ///< pairs of triangles that cross or overlap
};

/**
 * Long edges are halved, short ones collapsed, diagonals flipped, vertices spread along the surface
 * (Botsch and Kobbelt 2004); a manifold stays one, of the same genus, and where the given surface
 * does not cross itself neither does this one.
 *
 * @param parts of the given triangles, or empty: where they meet a crease runs, which stays where it is
 * @param keep places of the given surface, which are kept @param edgeLength what edges should have
 * @throws Aborted
 */
EvenMesh MakeEvenMesh(const TriangleMesh& given, const std::vector<char>& parts,
  const PlacesToKeep& keep, double edgeLength, int threads, Monitor& monitor);

/// Only flips diagonals, and takes small angles away, of a mesh that is even already; no other point
/// moves. The rest as above.
TriangleMesh MendMesh(const TriangleMesh& given, const std::vector<char>& parts,
  const PlacesToKeep& keep, double edgeLength, int threads, Monitor& monitor);
}

#endif
