// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JointVoronoiPredicates.h
 * @brief The exact decisions behind the joint Voronoi diagram.
 */
#ifndef recon_JointVoronoiPredicates_h
#define recon_JointVoronoiPredicates_h

#include "Base/Geometry.h"
#include "Polyhedral/LevelTriangulation.h"

#include <vector>

namespace recon
{
/**
 * "Is p nearer than q to the circumcentre of triangle t?", never a tie.
 *
 * t is of one level, p and q of the other. This is one in-sphere test: t at height 0, p and q at
 * height 1, whatever the distance of the planes. A floating-point filter with a proven bound
 * decides nearly always, exact arithmetic the rest, and the displacement of level 2 what is exactly
 * equal.
 */
class CircumcentreDistance
{
public:
  /// seenFromLevel1: t belongs to level 1, so of two equally near vertices the larger one is
  /// nearer.
  CircumcentreDistance(const LevelTriangulation& triangles, bool seenFromLevel1);

  bool IsNearer(int triangle, const Point2& p, const Point2& q) const;

private:
  /// With the triangle's first corner as origin: circumcentre = Numerator / (2 Determinant).
  struct Circumcentre
  {
    double Determinant;
    double DeterminantBound; ///< sum of the absolute values of its terms
    Point2 Numerator;
    double NumeratorBound;
  };

  bool IsNearerExactly(int triangle, const Point2& p, const Point2& q) const;

  const LevelTriangulation& Triangles;
  bool SeenFromLevel1;
  std::vector<Circumcentre> Circumcentres;
};

/// Sign of (b - a) . (the normal of u-v that points to the right of u->v); exact.
int SignAlongRightNormal(const Point2& u, const Point2& v, const Point2& a, const Point2& b);

/**
 * Which side of the edge a-b the crossing of its bisector with the bisector of u-v lies on: +1 left
 * of a->b, -1 right, 0 on the edge. The bisectors must not be parallel. Exact.
 */
int SideOfNode(const Point2& a, const Point2& b, const Point2& u, const Point2& v);

/// Two vertices of the other level whose bisector a Voronoi edge crosses on its way from the cell
/// of From to that of To.
struct CellCrossing
{
  Point2 From;
  Point2 To;
};

/**
 * Whether the bisector of a and b, run through with b on its left, comes to p before it comes to q:
 * negative, or positive; 0 only where these are the same. Exact, and with the displacement of level
 * 2 where they are crossed in one place. ofLevel1: a and b belong to level 1.
 */
int CompareAlongBisector(
  const Point2& a, const Point2& b, bool ofLevel1, const CellCrossing& p, const CellCrossing& q);
}

#endif
