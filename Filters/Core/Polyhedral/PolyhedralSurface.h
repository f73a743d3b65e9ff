// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralSurface.h
 * @brief The whole Polyhedral Surface Method: parallel contours in, the closed boundary of a solid
 * out.
 */
#ifndef recon_PolyhedralSurface_h
#define recon_PolyhedralSurface_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"
#include "Polyhedral/LevelTriangulation.h"
#include "Polyhedral/PolyhedralOptions.h"
#include "Polyhedral/PolyhedralStages.h"

#include <string>
#include <utility>
#include <vector>

namespace recon
{
class KeptStages;

/**
 * The boundary of the solid that the kept tetrahedra fill: closed, oriented outward, edge- and
 * vertex-manifold by index, not crossing itself. Every contour vertex that is not named in Report
 * is a point of it, to the last bit.
 *
 * Topology is decided exactly in the planes of the levels. Points that were computed are rounded, and
 * where the coordinates of space are not those of the planes (planes that are not perpendicular to an
 * axis, levels shifted onto one another) all are, and contour vertices stay where they were given, up
 * to a thousandth of a slab beside their plane. What crosses for that is found by exact predicates in the coordinates that are given out, and
 * points that are no contour's move until nothing does (CrossingRepair.h), with a line in Report.
 */
struct PolyhedralSurface
{
  enum FaceKindType
  {
    Wall = 0, ///< between two levels
    Cap = 1   ///< in the plane of a level
  };
  TriangleMesh Mesh;
  /// A triangle: number of the slab it bounds, 0 = between levels 0 and 1; -1 and the number of
  /// slabs are caps that stand out below the first and above the last level.
  std::vector<int> Slab;
  std::vector<int> FaceKind; ///< a triangle: FaceKindType
  /// A triangle: number of its group in ContourMapping::Groups; -1 where there is none, see
  /// FaceGroups.h.
  std::vector<int> MappingGroup;
  std::vector<int> Piece;     ///< a triangle: number of the piece of solid within its slab
  std::vector<int> PointKind; ///< a point: LevelTriangulation::PointKindType
  double EndCapVolume =
    0; ///< cubic units that the caps of ends add to the solid between the levels
  double IsolatedVolume = 0; ///< cubic units of isolated contours that were extruded
  /// What ExpectedPieces and ExpectedHandles came to.
  std::vector<ContractDecision> Contract;
  std::vector<std::string> Report;
  std::vector<std::pair<std::string, double>> StageSeconds; ///< wall time by stage
};

/// @throws Error where the contours span fewer than two levels; Aborted.
/// The surface is the same whichever tetrahedra are wanted, and whatever is kept of another run.
PolyhedralSurface BuildPolyhedralSurface(const ContourSet& contours,
  const PolyhedralOptions& options, Monitor& monitor,
  TetrahedraWanted wanted = TetrahedraWanted::ForSurface, KeptStages* kept = nullptr);
}

#endif
