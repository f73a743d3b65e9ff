// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VoronoiSections.h
 * @brief The crossings of Voronoi edges that bear on the boundary of the solid, found without
 * passing through the others.
 *
 * Along the Voronoi edge of a contour edge or an internal edge, its own level's solid ends in the
 * middle of the contour edge, and the other level's where the edge crosses a contour of that. A
 * crossing outside both is not solid, one inside either is, unless it is one with an external edge of the other
 * level. So what matters is where a contour of either level comes, or an edge of the other's external
 * skeleton, and one crossing before and one after it. Which side a crossing lies
 * on is decided exactly. Where the next of these comes is looked up, with a tolerance that is far
 * above all rounding: within it every crossing is looked at, and only beyond it are any passed
 * over. Both levels must have condition 2 (see LevelTriangulation.h), or a Voronoi edge may cross
 * its own contour elsewhere.
 */
#ifndef recon_VoronoiSections_h
#define recon_VoronoiSections_h

#include "Polyhedral/DelaunayEdges.h"
#include "Polyhedral/LevelSearch.h"
#include "Polyhedral/VoronoiEdgeWalk.h"

#include <array>
#include <optional>
#include <vector>

namespace recon
{
/// A T12 node: Origin and Corners of its tetrahedron.
struct JointCrossing
{
  std::array<int, 2> Edges;
  std::array<int, 4> Corners;
};

/// A Voronoi edge from one of its ends to the other.
struct VoronoiPath
{
  int Own;    ///< its level
  int Edge;   ///< canonical Delaunay edge
  int A, B;   ///< vertices of the level; B on the left
  int From;   ///< triangle
  int To;     ///< triangle, or -1: to infinity
  bool Forth; ///< From is the triangle after which the edge is numbered
};

/// From the triangle after which the edge is numbered.
VoronoiPath ForthAlong(const LevelTriangulation& level, int own, int edge);
VoronoiPath Reversed(const VoronoiPath& path);

/// The crossing where the path leaves a cell of the other level.
JointCrossing CrossingOf(
  const JointCells& cells, const VoronoiPath& path, int cell, const VoronoiEdgeWalk::Exit& exit);

/// By level: whether the crossing lies inside its contours or on them.
std::array<bool, 2> SidesOf(const JointCells& cells, const JointCrossing& crossing);

class VoronoiSections
{
public:
  /// The cells must outlive this.
  explicit VoronoiSections(const JointCells& cells);

  /// Adds what bears on the boundary along an edge, or all of its crossings; some may come twice.
  void Find(int own, int edge, bool all, std::vector<JointCrossing>& crossings) const;

private:
  struct Walker;

  std::optional<int> CellAt(const Walker& walker, double s, double after) const;
  void JumpTo(Walker& walker, double target, double after, bool back,
    std::vector<JointCrossing>& crossings) const;
  bool Jump(
    Walker& walker, double after, bool insideOther, std::vector<JointCrossing>& crossings) const;
  bool JumpOutside(
    Walker& walker, double after, bool insideOther, std::vector<JointCrossing>& crossings) const;
  LineInterval PositionOf(const Walker& walker, int from, int to) const;
  double EndOf(const Walker& walker) const;

  const JointCells& Cells;
  std::array<LevelSearch, 2> Search;
  std::array<bool, 2> Touching; ///< by level, whether a vertex belongs to several regions
  double Tolerance;             ///< length
};
}

#endif
