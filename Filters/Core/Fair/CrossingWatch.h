// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CrossingWatch.h
 * @brief Whether changes of a mesh make triangles cross, go through points, or turn small pieces.
 */
#ifndef recon_CrossingWatch_h
#define recon_CrossingWatch_h

#include "Base/BoundingBox.h"
#include "Fair/LinkedMesh.h"
#include "Implicit/ZeroSet/TriangleGrid.h"

#include <array>
#include <memory>
#include <vector>

namespace recon
{
/**
 * @class CrossingWatch
 * @brief Looks exactly at triangles of a LinkedMesh that were changed. It costs nothing until it is asked
 * first; from then on it has to be told of every change.
 */
class CrossingWatch
{
public:
  using Tetrahedron = std::array<Point3, 4>;

  CrossingWatch(const LinkedMesh& mesh, double edgeLength);

  bool WasAsked() const { return this->Grid != nullptr; }
  /// A triangle is no longer as it was.
  void Register(int t);
  void Register(const std::vector<int>& triangles);
  /// Whether one of these, which have changed, crosses another triangle.
  bool AnyCrosses(const std::vector<int>& triangles);
  /// What the triangles around a point go through when it goes to another place.
  std::vector<Tetrahedron> WayOf(const std::vector<int>& around, int v, const Point3& to) const;
  /// Whether that has points inside, of triangles that AnyCrosses knows of. Nothing crosses where a small
  /// piece is gone through as a whole; but then it is within another one.
  bool AnyPointWithin(const std::vector<Tetrahedron>& way) const;
  /// Whether a piece of no more points than one and those around it would turn inside out if that point
  /// went to another place: nothing crosses by that, and no point is gone through.
  bool TurnsPiece(const std::vector<int>& around, int v, const Point3& to) const;

private:
  Box3 BoxOf(int t) const;
  void PutChanged();
  bool Crosses(int t) const;

  const LinkedMesh& Mesh;
  double EdgeLength;
  std::unique_ptr<TriangleGrid> Grid; ///< made when it is first asked
  std::vector<int> Changed;           ///< triangles that the grid does not know yet as they are
  std::vector<char> IsChanged;        ///< a triangle
};
}

#endif
