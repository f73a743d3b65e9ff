// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EdgeConflicts.h
 * @brief Where edges of a plane meet other than in a common end point.
 */
#ifndef recon_EdgeConflicts_h
#define recon_EdgeConflicts_h

#include "Base/Geometry.h"

#include <vector>

namespace recon
{
/// Share of an edge's length.
constexpr double NearlyTouching = 1e-7;

/// An edge between two points of a level.
struct PlanarEdge
{
  int A = -1;
  int B = -1;
  int Loop = -1;  ///< the loop it came from
  int Weight = 1; ///< times walked from A to B, less those from B to A
};

struct EdgeConflicts
{
  /// The inner points of two edges cross.
  struct Crossing
  {
    int First, Second; ///< edges
  };
  /// An end point of one edge lies inside another.
  struct Touch
  {
    int Edge;   ///< the edge that has the point inside
    int Other;  ///< the edge that ends there
    int Vertex; ///< the point
  };
  /// End points of two edges are one place within rounding.
  struct Twins
  {
    int First, Second;        ///< points, the smaller number first
    int FirstEdge, OtherEdge; ///< edges that end there
  };
  std::vector<Crossing> Crossings;
  std::vector<Touch> Touches;
  std::vector<Twins> SamePlace;

  bool Empty() const
  {
    return this->Crossings.empty() && this->Touches.empty() && this->SamePlace.empty();
  }
};

/**
 * All of them, in an order that does not depend on the search.
 *
 * Exact, but for edges without a common end point: what comes nearer than a ten millionth of their
 * length (NearlyTouching) touches. Contours that touch in a plane that is tilted, or that were
 * stored in single precision, no longer do to the last bit, and a triangulation of the slits
 * between them would not end.
 *
 * Points have distinct coordinates, edges distinct pairs of end points.
 */
EdgeConflicts FindEdgeConflicts(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges);

/// Where the lines of two edges meet: computed exactly, then rounded once.
Point2 CrossingPoint(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
}

#endif
