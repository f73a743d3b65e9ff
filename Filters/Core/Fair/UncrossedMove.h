// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file UncrossedMove.h
 * @brief Moves the points of a mesh as far as no triangles cross.
 */
#ifndef recon_UncrossedMove_h
#define recon_UncrossedMove_h

#include "Base/Monitor.h"
#include "Fair/KeptPlaces.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <vector>

namespace recon
{
struct UncrossedMove
{
  TriangleMesh Mesh;
  std::size_t HeldBack = 0; ///< points that were not moved all the way
};

/**
 * Points around triangles that cross, and those of closed components that turn inside out or get into
 * others, or pass over them, go half the way, a quarter, and so on, and in the end stay, over
 * a neighbourhood that grows: as the given mesh does not cross itself, it comes to an end.
 *
 * @param leastAngle (radians) below this no triangle's least angle may come by the move; 0: any may
 * @param keep places that the mesh passes, and goes on to pass: as it does before the move, that comes to
 * an end, too @throws Aborted
 */
UncrossedMove MoveUncrossed(const TriangleMesh& mesh, const std::vector<Point3>& places,
  double leastAngle, const PlacesToKeep& keep, int threads, Monitor& monitor);
}

#endif
