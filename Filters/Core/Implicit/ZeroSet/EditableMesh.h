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

  /// Both are edited in place and outlive this. @param normals at the points, out of the solid
  EditableMesh(TriangleMesh& mesh, std::vector<Vector3>& normals);

  std::vector<int> Neighbours(int v) const; ///< in rising order
  /// The triangles on an edge.
  std::vector<int> TrianglesAt(int u, int v) const;
  /// All edges (u < v), shorter than a limit, shortest first.
  std::vector<std::pair<int, int>> EdgesShorterThan(double limit) const;
  bool IsAlive(int t) const { return this->T[t][0] >= 0; }

  double AngleOf(const Triangle& t) const; ///< the least, radians
  double LongestEdge(const Triangle& t) const;
  Vector3 AreaNormal(const Triangle& t) const;

  /// Would merging an edge's ends leave a manifold of the same genus and border?
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
  std::vector<char> Border;
  std::vector<char> Pinned; ///< points that may not go or move; the caller's
  /// Called with every triangle that is, from now on, another one or elsewhere.
  std::function<void(int)> Changed;

private:
  void Attach(int t);
  void Detach(int t);
};
}

#endif
