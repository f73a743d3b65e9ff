// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfacePlaces.h
 * @brief The place of a mesh nearest to a point, on the sheet that faces the same way.
 */
#ifndef recon_SurfacePlaces_h
#define recon_SurfacePlaces_h

#include "Mesh/TriangleMesh.h"
#include "Mesh/TriangleTree.h"

#include <array>
#include <vector>

namespace recon
{
/// A point of a mesh: a triangle, and the shares of its corners.
struct SurfacePlace
{
  int Triangle = -1; ///< -1: none was found
  std::array<double, 3> Shares{ 0, 0, 0 };
  double Distance = 0;

  Point3 On(const TriangleMesh& mesh) const
  {
    const auto& t = mesh.Triangles[this->Triangle];
    return this->Shares[0] * mesh.Points[t[0]] +
      (this->Shares[1] * mesh.Points[t[1]] + this->Shares[2] * mesh.Points[t[2]]);
  }
};

/// Of a triangle, the place nearest to p; without Triangle.
SurfacePlace NearestOfTriangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c);

/// Unit normals at the points: those of the triangles around, by the angles they have there.
std::vector<Vector3> PointNormals(const TriangleMesh& mesh);

/**
 * @class SurfacePlaces
 * @brief Finds places of a mesh, which outlives it and stays as it is.
 */
class SurfacePlaces
{
public:
  explicit SurfacePlaces(const TriangleMesh& mesh);

  /// Within `radius`, of the triangles that do not face away from the normal; of equally near ones
  /// the first. @param guess a triangle that may be near, which saves time; -1: none is known
  SurfacePlace Nearest(const Point3& p, const Vector3& normal, double radius, int guess = -1) const;

  /// The normal there, between those at the corners.
  Vector3 NormalAt(const SurfacePlace& place) const;

  const TriangleMesh& Mesh;

private:
  TriangleTree Tree;
  std::vector<Vector3> Normals; ///< at the points
  std::vector<Vector3> Facing;  ///< of the triangles
};
}

#endif
