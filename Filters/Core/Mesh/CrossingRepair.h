// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CrossingRepair.h
 * @brief Undoes the crossings that the rounding of its points has made in a surface.
 *
 * A surface that was decided in exact coordinates of a plane and is given out in those of space has
 * points that are off by their last digits. Sheets that run nearer to each other than that, or touch,
 * may then pass through one another.
 *
 * Notation:
 *   bad pair   two triangles that cross or overlap, by exact predicates
 *   place      a position, with all points of the mesh that have it
 *   reach      how far a point may be moved
 */
#ifndef recon_CrossingRepair_h
#define recon_CrossingRepair_h

#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <cstddef>
#include <vector>

namespace recon
{
struct CrossingRepairOptions
{
  /// Of a point of the mesh. Of those that may not, one stays in each place where there are some.
  std::vector<char> MayMove;
  /// Of a point of the mesh, whether it is where it was decided, to the last bit: triangles of which no
  /// corner is off do not cross one another, and are looked at only once one was moved. Empty: any may
  /// be off.
  std::vector<char> IsExact;
  double Reach = 0; ///< in the units of the mesh, positive
  /// Boxes are taken along its axes: those of the planes of a stack make the search quick. The result
  /// does not depend on it.
  PlanarFrame Frame;
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
};

struct CrossingRepairResult
{
  std::size_t Found = 0; ///< bad pairs
  std::size_t Left = 0;  ///< bad pairs for which no way was found
  std::size_t Moved = 0; ///< points, of which some were added
  double Farthest = 0;   ///< that a point was moved, in the units of the mesh
  /// Of each triangle that was added, behind those that were there, the one it was a part of.
  std::vector<int> PartOf;
  std::size_t AddedPoints = 0; ///< on edges, behind those that were there
};

/**
 * Move points, each as little as helps, until no two triangles cross or overlap.
 *
 * A point, or all points of its place together, goes where fewer of its triangles are in bad pairs
 * than before; so every move leaves fewer, and the search ends. Where all corners of a bad pair must
 * stay, points that may move are put on the edges that pass through the other triangle.
 *
 * Bounds: sixteen rounds, an added point for each two triangles and 64 more, and trials as many as
 * there are triangles and 20 000 more. What is bad beyond them stays, and is counted.
 *
 * @param mesh consistently oriented; as it was where no pair is bad
 * @throws Error where an index is out of range or a coordinate not finite; Aborted.
 */
CrossingRepairResult UndoCrossings(
  TriangleMesh& mesh, const CrossingRepairOptions& options, Monitor& monitor);
}

#endif
