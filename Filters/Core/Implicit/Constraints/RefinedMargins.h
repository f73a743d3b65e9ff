// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RefinedMargins.h
 * @brief Constraints whose margins know how the surface stands on the contours' planes.
 */
#ifndef recon_RefinedMargins_h
#define recon_RefinedMargins_h

#include "Implicit/Constraints/Constraints.h"
#include "Implicit/ImplicitFunction.h"

namespace recon
{
/**
 * @class RefinedMargins
 * @brief Tells the margins of in-plane constraints how the surface stands on their planes, vertex
 * by vertex.
 *
 * Notation: d the margin distance; at one vertex n the direction of the inner margin in the plane,
 * g the normal of a first fit towards the solid, u the direction of the margin when it is refined.
 *
 * A margin at t u gets the value t (u . g), its distance from the tangent plane, where it had t.
 * Where the surface is oblique to the plane that is less than t, and the in-plane value claims too
 * steep a function. A part of 0 leaves the margin where it was (u = n) and only values it anew, 1
 * stands it along g. Between them, the margin's place depends less on the first fit, whose normals
 * are worst where the slices are too far apart; on densely cut shapes half way was nearest to the
 * truth.
 *
 * A vertex keeps its margins as they were in the plane
 *  - where the contour left no room for them there: thin walls say little about their normals, and
 *    what a fit makes of them feeds on itself;
 *  - where they reach across a step (ConstraintOptions::ReachAcrossSteps);
 *  - where the second fit contradicts them (TakeBack).
 * Margins of tips (ContourTips.h) stand upright on the plane from the start, and those of tips upon
 * an edge are left out.
 */
class RefinedMargins
{
public:
  /// @param inPlane of BuildInPlaneConstraints, for these contours; unit: its values are +1 and -1.
  RefinedMargins(const ContourSet& contours, const ConstraintSet& inPlane, bool unit);

  /// To be fitted next.
  const ConstraintSet& Constraints() const { return this->Current; }
  std::size_t TipVertices() const { return this->Tips; }
  std::size_t Turned() const;
  std::size_t Vertices() const { return this->Places.size(); }

  /// Turns the margins by a part, 0 to 1, of the way from their planes to the normals of a fit of
  /// Constraints(), and values them by these. @throws Aborted
  void Turn(const ImplicitFunction& first, double part, int threads, Monitor& monitor);

  /**
   * Puts those margins back as they were in the plane that the second fit contradicts: its normal
   * there is another one, or an in-plane margin is on the wrong side of its surface.
   *
   * @returns how many vertices that were. @throws Aborted
   */
  std::size_t TakeBack(const ImplicitFunction& second, int threads, Monitor& monitor);

private:
  /// A contour vertex and the numbers of its constraints; -1 where it has no such margin.
  struct Vertex
  {
    int Boundary = -1;
    int Inner = -1;
    int Outer = -1;
    bool Fixed = false; ///< keeps the margins that it had at the start
    bool IsTurned = false;
    Vector3 Normal{ 0, 0, 0 }; ///< g, unit
  };

  void AddTips(const ContourSet& contours, const ConstraintSet& inPlane);
  void ListVertices();
  double DistanceOf(const Vertex& vertex, int constraint) const;
  bool CanTurn(const Vertex& vertex) const;
  void Refine(const class PointGrid& grid, std::size_t k, double part);
  void PlaceMargin(const class PointGrid& grid, std::size_t k, int constraint, const Vector3& way);

  ConstraintSet Start;
  ConstraintSet Current;
  std::vector<Vertex> All;
  std::vector<Point3> Places;
  std::vector<char> TipContours; ///< by contour
  std::size_t Tips = 0;
  bool Unit;
};
}

#endif
