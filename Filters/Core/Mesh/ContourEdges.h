// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourEdges.h
 * @brief The half-edges of a surface that a contour runs along.
 */
#ifndef recon_ContourEdges_h
#define recon_ContourEdges_h

#include "Base/PointHash.h"
#include "Mesh/BRep.h"
#include "Mesh/HalfEdges.h"

#include <unordered_map>
#include <vector>

namespace recon
{
/// Loops of positions, looked up on one mesh, which must outlive it.
class ContourEdges
{
public:
  /// @param components the component of each triangle; a loop stays on one.
  ContourEdges(
    const TriangleMesh& mesh, const HalfEdges& edges, const std::vector<int>& components);

  /// The half-edges along the loop, each from where the one before ends, round to the first; empty
  /// where there are none. Only where there is no other way is an end another point of the same
  /// position than the next start.
  std::vector<int> Find(const SpaceLoop& loop) const;

private:
  struct Search;

  bool FindFrom(Search& search, int start) const;
  bool Advances(const SpaceLoop& loop, int corner, int from, int to) const;

  const TriangleMesh& Mesh;
  const HalfEdges& Edges;
  const std::vector<int>& Components;
  /// Points of one position: more than one where a manifold was cut from touching pieces.
  std::unordered_map<Point3, std::vector<int>, PointHash> PointsAt;
  double Tolerance = 0;
};
}

#endif
