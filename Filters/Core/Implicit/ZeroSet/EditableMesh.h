// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EditableMesh.h
 * @brief A triangle mesh whose triangles are replaced in place.
 */
#ifndef recon_EditableMesh_h
#define recon_EditableMesh_h

#include "Mesh/TriangleMesh.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace recon
{
/**
 * @class EditableMesh
 * @brief Points with normals, triangles that die, points that lose theirs, and Compact() at the end.
 *
 * Names of algorithms on such meshes: u, v, w are points, t a triangle. The mesh stays a manifold
 * with border as long as Merge is called where LinkAllows it.
 */
class EditableMesh
{
public:
  using Triangle = std::array<int, 3>;
  using Changes = std::vector<std::pair<int, Triangle>>; ///< triangles by number, as they were

  /**
   * Both are edited in place and outlive this.
   *
   * @param normals at the points, out of the solid
   * @param faces by triangle: 0, or the face of the bounds that it lies in (Lattice::FaceInside);
   * empty = none does. Edges between triangles of two numbers are creases.
   */
  EditableMesh(
    TriangleMesh& mesh, std::vector<Vector3>& normals, const std::vector<char>& faces = {});

  std::vector<int> Neighbours(int v) const; ///< in rising order
  /// The triangles on an edge.
  std::vector<int> TrianglesAt(int u, int v) const;
  /// All edges (u < v), shorter than a limit, shortest first.
  std::vector<std::pair<int, int>> EdgesShorterThan(double limit) const;
  bool IsAlive(int t) const { return this->T[t][0] >= 0; }

  double AngleOf(const Triangle& t) const; ///< the least, radians
  double LongestEdge(const Triangle& t) const;
  Vector3 AreaNormal(const Triangle& t) const;

  /// Is it an edge of the border, or a crease?
  bool IsBorderEdge(int u, int v) const;
  /// The surface's normal at a corner of a triangle: that of its face of the bounds, where it lies
  /// in one.
  Vector3 NormalAt(int v, int face) const;
  /// Would merging an edge's ends leave a manifold of the same genus, border and creases?
  bool LinkAllows(int u, int v) const;

  /// u's triangles become v's, those on the edge go.
  void Merge(int u, int v);
  void Replace(int t, const Triangle& by);
  Changes Remember(const std::vector<int>& triangles) const;
  void Restore(const Changes& before);
  /// Without normals, which are the caller's. Changed is told of all triangles around.
  void MoveTo(int v, const Point3& to);

  /// Dead triangles and points without triangles go; nothing else may be called afterwards.
  void Compact();

  static bool Has(const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }
  static int Third(const Triangle& t, int u, int v);
  /// Does v follow u round the triangle?
  static bool Follows(const Triangle& t, int u, int v);

  std::vector<Point3>& P;
  std::vector<Vector3>& N;
  std::vector<Triangle>& T;
  std::vector<std::vector<int>> Around; ///< triangles, by point
  std::vector<char> Faces;              ///< by triangle
  /// By point: 0, or whether it is on the border (OnBorder) or on a crease (OnCrease).
  std::vector<char> Border;
  static constexpr char OnBorder = 1;
  static constexpr char OnCrease = 2;
  std::vector<char> Pinned; ///< points that may not go or move; the caller's
  /// Called with every triangle that is, from now on, another one or elsewhere.
  std::function<void(int)> Changed;

private:
  void FindBorder(int v);
  void Attach(int t);
  void Detach(int t);
};

/// The normal, out of the solid, of a face of the bounds (Lattice::FaceInside).
Vector3 FaceNormal(int face);
}

#endif
