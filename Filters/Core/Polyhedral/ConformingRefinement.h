// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ConformingRefinement.h
 * @brief Points on contour edges until the triangulation has conditions 0-2 (thesis algorithms 4
 * and 5), exact and bounded on any input.
 *
 * CGAL's own refinement halves edges at rounded points. A rounded point leaves its edge's line, and
 * where another edge or vertex is nearer than rounding it comes to lie on it or beyond: the
 * triangulation is then no triangulation any more, and what follows hangs or crashes. And between
 * edges that run at a distance w it needs 1/w points, however small w is. So every point is checked
 * by exact predicates before it is inserted, and counted. As long as all is well, the points and
 * their order are CGAL's.
 */
#ifndef recon_ConformingRefinement_h
#define recon_ConformingRefinement_h

#include "Polyhedral/ConstrainedDelaunay.h"

#include <cstddef>

namespace recon
{
struct RefinementOutcome
{
  enum ProblemType
  {
    None,
    TooManyPoints, ///< the bound was reached
    NoPlace        ///< an edge cannot be cut: the point, rounded, does not lie among its triangles
  };
  ProblemType Problem = None;
  Point2 Place{ { 0, 0 } }; ///< of the problem
};

/// Afterwards the circle that has a constrained edge as diameter holds no vertex (conditions 0-2).
/// Stops at the first problem, with a sound triangulation. maximumPoints: of all of it.
RefinementOutcome RefineToGabriel(
  delaunay::Triangulation& triangulation, std::size_t maximumPoints);

/// Afterwards every constrained edge is Delaunay (conditions 0 and 1), which takes far fewer points
/// where contours run very near to each other.
RefinementOutcome RefineToDelaunay(
  delaunay::Triangulation& triangulation, std::size_t maximumPoints);
}

#endif
