// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VoronoiEdgeWalk.h
 * @brief A Voronoi edge of one level on its way through the Voronoi cells of the other.
 */
#ifndef recon_VoronoiEdgeWalk_h
#define recon_VoronoiEdgeWalk_h

#include "Polyhedral/JointCells.h"

#include <optional>

namespace recon
{
/**
 * The line of a Voronoi edge, dual to a-b, and the cells that it crosses.
 *
 * It runs so that b is on its left; the side of a Voronoi vertex of the other level is whether it
 * is nearer to b. Around a cell, counterclockwise, the line leaves where the side changes from a to
 * b. A cell on the hull has two corners at infinity after its last triangle.
 */
class VoronoiEdgeWalk
{
public:
  struct Exit
  {
    int Cell = -1;         ///< the next cell, or -1 to infinity
    int SideA = -1;        ///< triangle before the exit, or -1 at infinity
    int DelaunayEdge = -1; ///< of the other level, canonical
  };

  /// own: the level of a and b. Both points must outlive the walk.
  VoronoiEdgeWalk(const JointCells& cells, int own, const Point2& a, const Point2& b)
    : Level(cells.LevelAt(1 - own)),
      Stars(cells.Stars(1 - own)),
      Distance(cells.Distance(1 - own)),
      A(a),
      B(b)
  {
  }

  /// cameFrom: Exit::SideA of the step that led here, or -1. None where the line misses the cell.
  std::optional<Exit> Leave(int cell, int cameFrom = -1) const;

private:
  bool NearerToB(int triangle) const { return this->Distance.IsNearer(triangle, this->B, this->A); }
  Exit Across(int cell, int i) const;
  std::optional<Exit> LeaveHullCell(int cell) const;
  bool AtInfinity(int u, int v, bool sideOfBeginning) const;

  const LevelTriangulation& Level;
  const VertexStars& Stars;
  const CircumcentreDistance& Distance;
  const Point2& A;
  const Point2& B;
};
}

#endif
