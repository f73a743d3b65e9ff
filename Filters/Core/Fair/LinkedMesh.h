// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LinkedMesh.h
 * @brief Triangles that know their neighbours, for many changes of a mesh in little time.
 */
#ifndef recon_LinkedMesh_h
#define recon_LinkedMesh_h

#include "Mesh/TriangleMesh.h"

#include <array>
#include <utility>
#include <vector>

namespace recon
{
/**
 * @class LinkedMesh
 * @brief A manifold, closed or with a border, whose edges are split, flipped and collapsed.
 *
 * Side k of a triangle lies opposite its corner k. Each change takes time by the triangles around
 * its ends.
 */
class LinkedMesh
{
public:
  using Triangle = std::array<int, 3>;
  static constexpr int None = -1; ///< no triangle, no point

  /// @param parts a number for each triangle, or empty: where it changes a crease runs, which is kept
  explicit LinkedMesh(const TriangleMesh& mesh, const std::vector<char>& parts = {});
  LinkedMesh(const LinkedMesh&) = delete;
  LinkedMesh& operator=(const LinkedMesh&) = delete;

  /// Triangles and points as they were, to be put back.
  struct Memory
  {
    std::vector<std::array<Triangle, 2>> Triangles; ///< corners and neighbours
    std::vector<int> Numbers;                       ///< of the triangles
    std::vector<std::pair<int, int>> Points;        ///< number, and a triangle of it
  };
  /// All that a flip across sides of them, or a collapse of a point that they are all around, changes.
  Memory Remember(const std::vector<int>& triangles) const;
  void PutBack(const Memory& memory);

  bool IsAlive(int t) const { return this->Triangles[t][0] >= 0; }
  bool IsAlivePoint(int v) const { return this->TriangleAt[v] >= 0; }
  int CornerOf(int t, int v) const;
  /// The triangles around a point, in turn; at a border from one end to the other.
  const std::vector<int>& Around(int v) const;
  /// Whether triangles of several parts meet there.
  bool IsOnCrease(int v) const;
  /// The points around a point.
  std::vector<int> Neighbours(int v) const;
  /// (triangle, side) of an edge, (None, 0) where there is none.
  std::pair<int, int> Find(int u, int v) const;

  Vector3 AreaNormal(const Triangle& t) const;
  double LeastTangent(const Triangle& t) const; ///< of the smallest angle
  /// The same of a triangle of this mesh, kept until the mesh changes there or Forget is told.
  double LeastTangent(int t) const
  {
    double& known = this->Tangent[t];
    return known >= 0 ? known : known = this->LeastTangent(this->Triangles[t]);
  }
  /// A corner of these has been moved.
  void Forget(const std::vector<int>& triangles)
  {
    for (const int t : triangles)
    {
      this->Tangent[t] = Unknown;
    }
  }
  double SideLength(int t, int k) const;
  int LongestSide(int t) const;

  /// Halves a side. @returns the new point, which is nowhere yet but in the middle.
  int Split(int t, int k);
  bool MayFlip(int t, int k) const;
  void Flip(int t, int k);
  /// Whether a point can go into its neighbour and leave a manifold of the same genus and border.
  bool MayCollapse(int from, int into) const;
  void Collapse(int from, int into);

  /// What is alive; the points' new numbers are in the order of the old ones.
  TriangleMesh Compact(std::vector<int>* oldNumbers = nullptr) const;
  /// Of the triangles that Compact gives.
  std::vector<char> CompactParts() const;

  TriangleMesh Mesh;
  std::vector<Point3>& Points;
  std::vector<Triangle>& Triangles; ///< dead ones: None
  std::vector<Triangle> Neighbour;  ///< of a triangle, across its sides; None at a border
  std::vector<char> Parts;          ///< a triangle
  std::vector<int> TriangleAt;      ///< a triangle of each point, None where it has none
  std::vector<char> OnBorder;       ///< a point

private:
  void Link();
  void Relink(int t, int was, int now);
  bool KeepsCrease(int from, int into) const;
  bool TakeAway(int t, int from, int into);

  static constexpr double Unknown = -1; ///< in the place of a tangent, which is never negative
  mutable std::vector<double> Tangent;  ///< of the smallest angle of a triangle, where it is known
  mutable std::vector<int> Ring;        ///< what Around gives, until it is called again
};

/// Of a triangle without area 0. Rises with the angle, and needs no arc tangent.
double TangentOfSmallestAngle(const Point3& a, const Point3& b, const Point3& c);

/// The smallest angle of a triangle, radians.
double SmallestAngle(const Point3& a, const Point3& b, const Point3& c);
}

#endif
