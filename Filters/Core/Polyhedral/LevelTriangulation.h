// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelTriangulation.h
 * @brief The 2D Delaunay triangulation of one level and what its Voronoi diagram says.
 *
 * Notation (thesis chapter 5):
 *   condition 0/1  every contour edge is an edge of the triangulation        (5.1, algorithm 4)
 *   condition 2    no angle facing a contour edge is obtuse                  (5.2, algorithm 5)
 *   IR, ER         triangles inside, outside the contours
 *   EVS, IVS       external and internal Voronoi skeleton                    (5.3.1)
 *   internal point vertex of a neighbouring level's EVS that lies in IR here (5.3, algorithm 6)
 *
 * In today's terms conditions 0-2 are a conforming Gabriel triangulation: the circle that has a
 * contour edge as diameter holds no vertex inside.
 */
#ifndef recon_LevelTriangulation_h
#define recon_LevelTriangulation_h

#include "Contours/ContourSet.h"

#include <array>
#include <memory>
#include <vector>

namespace recon
{
/// The finished triangulation of a level. Coordinates are planar, in the frame of the level.
struct LevelTriangulation
{
  enum PointKindType
  {
    InputVertex = 0,
    AddedOnContour = 1, ///< thesis 5.1, 5.2
    Internal = 2        ///< thesis 5.3
  };

  enum AskedByType
  {
    LevelBelow = 1,
    LevelAbove = 2,
    Cover = 4,    ///< neither: gives a part of a contour that nothing faces a thickness
    EndCap = 8,   ///< neither: on the internal skeleton of a region that ends here
    External = 16 ///< neither: outside the contours, over a part of a neighbouring level that ends
  };

  std::vector<Point2> Points;
  std::vector<int> Source;            ///< index into ContourSet::Points, or -1 for an added point
  std::vector<unsigned char> Kind;    ///< PointKindType
  std::vector<unsigned char> AskedBy; ///< of an internal point: AskedByType bits
  std::vector<std::array<int, 3>> Triangles;   ///< counterclockwise
  std::vector<std::array<int, 3>> Neighbours;  ///< k: across the edge opposite corner k, or -1
  std::vector<std::array<int, 3>> EdgeContour; ///< k: contour of that edge, or -1
  std::vector<unsigned char> Inside;           ///< triangle belongs to IR
  std::vector<int>
    Region; ///< of a triangle of IR: the outer wall of its region (a contour), else -1
  std::vector<int> StarTriangle; ///< of a point: one triangle that has it as a corner
  bool IsGabriel = false;        ///< condition 2 holds, too

  /// Planar position of a Voronoi vertex (circumcentre of a triangle), rounded; not finite where
  /// the triangle is flat within rounding.
  Point2 VoronoiVertex(int triangle) const;
};

/// Circumcentre of a, b, c, rounded; not finite where they are collinear within rounding.
Point2 Circumcentre(const Point2& a, const Point2& b, const Point2& c);

/**
 * Builds the triangulation of a level in the two steps of the method: first contours and
 * conditions 0-2, then, once the neighbours' skeletons are known, internal points.
 */
class LevelTriangulator
{
public:
  /// Algorithms 4 and 5. @throws Error where contours run too near to each other that are no
  /// needles (named with the place).
  LevelTriangulator(const ContourSet& contours, int level);
  ~LevelTriangulator();
  LevelTriangulator(LevelTriangulator&&) noexcept;
  LevelTriangulator& operator=(LevelTriangulator&&) noexcept;

  /// Condition 2 takes too many points, or has no place for them, where contours run very near to each
  /// other: such a level has conditions 0 and 1 only.
  bool HasCondition2() const;

  /// Contours that were given up, as the level cannot be had with them (NeedleContours.h).
  const std::vector<int>& Needles() const;

  /// Of every point the triangle of the last Finish() that holds it, -1 outside the hull; nothing
  /// may have been inserted since.
  std::vector<int> Locate(const std::vector<Point2>& points) const;

  /**
   * Algorithm 6: insert those candidates that lie in IR.
   *
   * A candidate in the diametral circle of a contour edge is left out, so that conditions 0-2 stay
   * true without a second pass; so is one that lies on another point within rounding.
   */
  void AddInternalPoints(
    const std::vector<Point2>& candidates, LevelTriangulation::AskedByType askedBy);

  /// The same with candidates that lie in ER. No kept tetrahedron has such a point.
  void AddExternalPoints(const std::vector<Point2>& candidates);

  /**
   * Insert points of IR wherever they are, and see to conditions 0-2 again.
   *
   * For the parts of a contour that no solid covers; points nearer than rounding to what is there
   * already are left out.
   */
  void AddCoverPoints(const std::vector<Point2>& points);

  LevelTriangulation Finish() const;

private:
  void AddPoints(const std::vector<Point2>& candidates, LevelTriangulation::AskedByType askedBy);

  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};
}

#endif
