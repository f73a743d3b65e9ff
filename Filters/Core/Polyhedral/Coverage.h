// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Coverage.h
 * @brief Which parts of a level's contours have solid above or below them.
 *
 * A region is a connected part of IR: the inside of an outer wall without its holes. One that no
 * solid touches on either side is isolated and cannot be part of the surface. One that is touched
 * somewhere must be covered everywhere, as otherwise the surface would lose a part of the contour:
 * what is bare there gets points in its middle (cover points), which are lifted like internal
 * points and give it a thickness.
 */
#ifndef recon_Coverage_h
#define recon_Coverage_h

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/LiftedHeights.h"

#include <vector>

namespace recon
{
struct Coverage
{
  bool ExtrudesIsolated = false; ///< isolated regions are part of the surface, too
  /// A triangle: LevelTriangulation::AskedByType bits of the sides on which its T1 or T2 is kept.
  std::vector<unsigned char> Covered;
  std::vector<unsigned char> Isolated; ///< a triangle of IR: no triangle of its region is covered
  /// A triangle of IR: LevelTriangulation::AskedByType bits of the sides on which no solid leaves
  /// its region, so that it ends there.
  std::vector<unsigned char> Ends;

  /// A triangle of IR that the surface must have some solid at.
  bool MustCover(int triangle) const
  {
    return this->ExtrudesIsolated || !this->Isolated[static_cast<std::size_t>(triangle)];
  }
};

/// below, above: the slabs next to the level, null at the ends.
/// extrudeIsolated: regions that no solid touches stay, as slices.
Coverage FindCoverage(const LevelTriangulation& level, const SlabTetrahedra* below,
  const SlabTetrahedra* above, bool extrudeIsolated);

/**
 * Points that would cover the bare triangles of regions that are not isolated: the middles of their
 * edges that are not contour edges. A triangle with a lifted corner is not bare.
 */
std::vector<Point2> FindCoverPoints(
  const LevelTriangulation& level, const Coverage& coverage, const LiftedHeights& lifted);

/// Vertices of the internal Voronoi skeleton (VoronoiSkeleton.h) in regions that end on some side
/// and are not isolated: points for a tapered end. unit: of the last decimal of the points. rings:
/// points between them and the contours as well, so that an end can be round.
std::vector<Point2> FindEndCapPoints(
  const LevelTriangulation& level, const Coverage& coverage, double unit, bool rings);
}

#endif
