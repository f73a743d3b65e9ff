// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JointVoronoi.h
 * @brief The joint Voronoi diagram of two adjacent levels as tetrahedra (thesis 5.4 and 6.3).
 *
 * Notation (thesis section 5.4):
 *   level 1, level 2  the lower and the upper level of a slab
 *   T1 node           Voronoi vertex of level 1  -> triangle of level 1 + its apex on level 2
 *   T2 node           Voronoi vertex of level 2  -> triangle of level 2 + its apex on level 1
 *   T12 node          crossing of a Voronoi edge of level 1 and one of level 2 -> their Delaunay edges
 *   apex              Delaunay vertex of the other level nearest to the Voronoi vertex
 *
 * Special cases (section 6.3). Where a Voronoi vertex of one level is equally far from several
 * vertices of the other, algorithms 7-12 choose a valid configuration. Here one rule does: level 2
 * counts as moved by (-eps, -eps^2) in its plane, so that of two equally near vertices the
 * lexicographically larger one is nearer seen from level 1 and the smaller one seen from level 2.
 * No tie is left, for any number of cocircular and cospherical points.
 */
#ifndef recon_JointVoronoi_h
#define recon_JointVoronoi_h

#include "Polyhedral/JointCells.h"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace recon
{
/**
 * The tetrahedra between two levels: together they fill the convex hull of both levels' points and
 * are its 3D Delaunay triangulation (one of them, where points are cospherical).
 *
 * Or those of them only that bear on the boundary of the solid, see BoundaryVoronoi.h: then rows of
 * T12 along a Voronoi edge may be missing, all of which are kept. The tetrahedra at both ends of
 * such a gap are kept, too, and name each other. Rows that are not kept are missing without a sign.
 */
struct SlabTetrahedra
{
  enum NodeType : unsigned char
  {
    T1 = 1,
    T2 = 2,
    T12 = 12
  };

  /// Why a tetrahedron is not solid (thesis 5.5 and 6.4).
  enum ReasonType : unsigned char
  {
    Kept = 0,
    ExternalEdge = 1,        ///< an edge in the plane of a level runs outside its contours
    OutsideBothContours = 2, ///< T12 of two contour edges whose node lies outside both
    NonSolidConnection = 3,  ///< touches one of the levels in a point or an edge only
    NotJoined = 4            ///< its regions on the two levels are not mapped to each other
  };

  struct Tetrahedron
  {
    /// T1: three of level 1, apex. T2: three of level 2, apex. T12: a, b of level 1, u, v of
    /// level 2. Indices into the levels' LevelTriangulation::Points; all are positively oriented in
    /// space.
    std::array<int, 4> Corners;
    /// k: the tetrahedron across the face opposite corner k; -1 on the hull, for the base of T1 and
    /// T2, and where what is not kept is missing; GapTo(t) where t lies beyond a gap.
    std::array<int, 4> Neighbours;
    /// T1, T2: {triangle, -1}. T12: the Delaunay edges of level 1 and 2 as 3 * triangle + k, the
    /// lesser of the two such numbers that an edge has.
    std::array<int, 2> Origin;
    NodeType Node;
    ReasonType Reason;
  };

  std::vector<Tetrahedron> Tetrahedra; ///< T1 by triangle, then T2 by triangle, then T12
  int NumberOfT1 = 0;
  int NumberOfT2 = 0;

  bool HasGaps = false;                     ///< only what bears on the boundary is there
  std::vector<std::pair<int, int>> Links;   ///< tetrahedra that kept ones in gaps hold together
  std::set<std::pair<int, int>> GapRegions; ///< of the tetrahedra in gaps, as in SlabJoins

  static int GapTo(int tetrahedron) { return -2 - tetrahedron; }
  static bool IsGap(int neighbour) { return neighbour <= -2; }
  /// The neighbour itself, or the one beyond the gap; -1 where there is none.
  static int Beyond(int neighbour) { return IsGap(neighbour) ? -2 - neighbour : neighbour; }

  /// Whether corner k of t belongs to level 2.
  static bool OnLevel2(const Tetrahedron& t, int k)
  {
    return t.Node == T12 ? k >= 2 : (t.Node == T1) == (k == 3);
  }
};

SlabTetrahedra BuildJointVoronoi(
  const LevelTriangulation& level1, const LevelTriangulation& level2);

/// The same, or nothing where there are more T12 than that.
std::optional<SlabTetrahedra> BuildJointVoronoi(const JointCells& cells, std::size_t maximumT12);

/// T1 and T2, without neighbours.
void AddNodesOfVoronoiVertices(const JointCells& cells, SlabTetrahedra& slab);
}

#endif
