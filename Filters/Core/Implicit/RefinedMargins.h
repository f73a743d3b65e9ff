// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RefinedMargins.h
 * @brief Constraints whose margins stand along the surface's normals instead of in the contours'
 * planes.
 */
#ifndef recon_RefinedMargins_h
#define recon_RefinedMargins_h

#include "Constraints.h"
#include "ImplicitFunction.h"

namespace recon
{
/**
 * @class RefinedMargins
 * @brief Turns the margins of in-plane constraints along the normals of a fit, vertex by vertex.
 *
 * Notation: d the margin distance; n_k the normal of the first fit at vertex k.
 *
 * A vertex keeps its margins in the plane
 *  - where the contour left no room for them there: thin walls say little about their normals, and
 *    what a fit makes of them feeds on itself;
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

  /// Puts the margins along the normals of a fit of Constraints().
  void Turn(const ImplicitFunction& first, int threads);

  /**
   * Puts those margins back into the plane that the second fit contradicts: its normal there is
   * another one, or an in-plane margin is on the wrong side of its surface.
   *
   * @returns how many vertices that were.
   */
  std::size_t TakeBack(const ImplicitFunction& second, int threads);

private:
  /// A contour vertex and the numbers of its constraints; -1 where it has no such margin.
  struct Vertex
  {
    int Boundary = -1;
    int Inner = -1;
    int Outer = -1;
    bool Fixed = false; ///< keeps the margins that it had at the start
    bool IsTurned = false;
    Vector3 Inward{ 0, 0, 0 };
  };

  void AddTips(const ContourSet& contours, const ConstraintSet& inPlane);
  void ListVertices();
  double RoomAt(const Vertex& vertex) const;
  void PlaceMargin(const class PointGrid& grid, std::size_t k, int constraint, int side);

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
