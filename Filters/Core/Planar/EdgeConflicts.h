// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EdgeConflicts.h
 * @brief Where edges of a plane meet other than in a common end point.
 */
#ifndef recon_EdgeConflicts_h
#define recon_EdgeConflicts_h

#include "Base/Geometry.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace recon
{
/// An edge between two points of a level.
struct PlanarEdge
{
  int A = -1;
  int B = -1;
  int Tag = -1; ///< what it is a part of: the number of a loop
  /// Times walked from A to B, less those from B to A; or how the label to its left differs from the
  /// one to its right.
  std::int64_t Weight = 1;
  bool IsSettled = false; ///< known to have no conflict with any other that is settled
};

/// The edges of a closed walk.
inline void AddLoopEdges(
  const std::vector<int>& loop, int tag, std::vector<PlanarEdge>& edges, std::int64_t weight = 1)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    edges.push_back({ loop[i], loop[(i + 1) % loop.size()], tag, weight });
  }
}

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
  /// Two points that are nearer than the tolerance.
  struct Twins
  {
    int First, Second;        ///< points, the smaller number first
    int FirstEdge, OtherEdge; ///< edges that end there; one and the same where that is so short
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
 * All of them but between two edges that are settled, in an order that does not depend on the search.
 *
 * What comes nearer than the tolerance touches; everything else is decided exactly. Where there is
 * no conflict, no point lies within the tolerance of another, or of an edge that it is no end of.
 *
 * Points have distinct coordinates, edges distinct pairs of end points.
 *
 * @param tolerances a number for every tag, in the units of the points; the smaller counts for two
 * Where more pairs of points are near than mostCrossings, SamePlace has that many of them, and the rest is for the next search.
 *
 * @throws Error where more crossings are found than mostCrossings
 */
EdgeConflicts FindEdgeConflicts(const std::vector<Point2>& points,
  const std::vector<PlanarEdge>& edges, const std::vector<double>& tolerances,
  std::size_t mostCrossings);

/// Whether so many of them cross in inner points. Points and edges may be there twice.
bool CrossMoreOftenThan(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges,
  std::size_t mostCrossings);

/// Where the lines of two edges meet: computed exactly, then rounded once.
Point2 CrossingPoint(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
}

#endif
