// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlanarEdges.h
 * @brief The contour edges of one level, asked for sides, distances and crossings.
 */
#ifndef recon_PlanarEdges_h
#define recon_PlanarEdges_h

#include "Contours/ContourSet.h"
#include "Planar/EdgeTree.h"

#include <vector>

namespace recon
{
/**
 * @class PlanarEdges
 * @brief All edges of a level in its in-plane coordinates. Sides and crossings are decided exactly.
 *
 * A vertex is named by its index in ContourSet::Points; contours that touch there share it.
 */
class PlanarEdges
{
public:
  struct Edge
  {
    int From; ///< point index; the solid is on the left of From -> To (ContourSet.h)
    int To;
  };

  PlanarEdges(const ContourSet& contours, int level);

  using SideType = EdgeTree::SideType;
  static constexpr SideType Outside = EdgeTree::Outside;
  static constexpr SideType On = EdgeTree::On;
  static constexpr SideType Inside = EdgeTree::Inside;

  /// By even-odd over all contours of the level.
  SideType SideOf(const Point2& p) const { return this->Tree.SideOf(p); }

  /// To the nearest edge that ends at the vertex.
  double DistanceToOwn(int vertex, const Point2& p) const;

  /// To the nearest of all other edges, but no more than limit.
  double DistanceToOthers(int vertex, const Point2& p, double limit) const;

  /// Does the segment from a vertex to p meet an edge that does not end at it?
  bool CrossesOthers(int vertex, const Point2& from, const Point2& p) const;

  /// Do two edges meet anywhere but in a shared vertex?
  bool SelfCrossing() const;

  const std::vector<Edge>& Edges() const { return this->All; }
  /// The edges that end at a vertex.
  const std::vector<int>& EdgesAt(int vertex) const;

private:
  std::vector<Edge> All;
  EdgeTree Tree;                          ///< of All, in that order
  std::vector<std::vector<int>> AtVertex; ///< by point index less FirstVertex
  int FirstVertex = 0;
};
}

#endif
