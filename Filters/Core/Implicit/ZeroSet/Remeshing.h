// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Remeshing.h
 * @brief Passes over a mesh that make its edges even and its angles large: collapses, flips,
 * spreading (Botsch and Kobbelt 2004, without splits).
 */
#ifndef recon_Remeshing_h
#define recon_Remeshing_h

#include "Implicit/ZeroSet/CrossingGuard.h"
#include "Implicit/ZeroSet/EditableMesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace recon
{
/// Moves points onto the surface and gives the normals there; done[i] = 0 where it could not.
using Projector = std::function<void(
  std::vector<Point3>& points, std::vector<Vector3>& normals, std::vector<char>& done)>;

/// What a change may not turn a triangle away from.
struct Agreement
{
  /// Cosine that a triangle's normal must keep with the surface's normals at its corners.
  double WithSurface;
  /// The surface's normals are not asked, as they say nothing where a wall is thinner than a cell
  /// or the bounds cut it: no triangle may turn from itself, nor cross another one.
  bool OnlyWithItself;
};

constexpr Agreement Usual{ 0.35, false }; ///< normals are 70 degrees apart at the most
/// Where a sliver has to go at any (safe) price.
constexpr Agreement LastResort{ 0.05, false };
/// Where not even that mends it.
constexpr Agreement WithItself{ 0, true };

/**
 * @class Remesher
 * @brief Changes of a mesh that keep it a manifold of the same genus, on the surface, uncrossed in
 * thin places; and passes of such changes.
 */
class Remesher
{
public:
  /// As of CrossingGuard. @param edgeLength what edges should have @param faces as of EditableMesh
  Remesher(TriangleMesh& mesh, std::vector<Vector3>& normals, double edgeLength,
    const std::vector<char>& thin, const std::vector<char>& faces = {});

  ///@{
  /// Passes, until nothing changes or a few times.
  void CollapseShortEdges();
  void FlipEdges();
  /// Once: every vertex to the middle of its neighbours, along the surface.
  void Spread(const Projector& project);
  /// Moves the nearest free vertex of each anchor onto it, nearest pairs first. @returns how many.
  std::size_t Anchor(const std::vector<Point3>& anchors);
  ///@}

  ///@{
  /// Changes. @returns whether there was one.
  /// Collapses an edge onto that of its ends which leaves the better triangles, if either may be
  /// kept.
  bool Collapse(int u, int v, const Agreement& agreement);
  /// Flips the edge where that makes the smaller of the two triangles' least angles larger.
  bool Flip(int u, int v, const Agreement& agreement);
  /// Moves a vertex, unless triangles would cross: in thin places, or where that is always looked
  /// at.
  bool Move(int v, const Point3& to, const Vector3& normal, bool alwaysLook = false);
  ///@}

  /// The least angle around a vertex (radians), negative where a triangle has turned against the
  /// surface.
  double QualityAround(int v, const Agreement& agreement) const;
  /// The same if it were there; negative where a triangle would turn.
  double QualityOfMove(int v, const Point3& to);

  EditableMesh Edited;
  const double EdgeLength;

private:
  using Triangle = EditableMesh::Triangle;

  bool Agrees(const Triangle& t, int face, const Agreement& agreement) const;
  bool KeepsItself(const Triangle& before, const Triangle& after) const;
  bool IsNeedle(const Triangle& t) const;
  bool MayReplace(const std::vector<int>& before, const std::array<Triangle, 2>& after,
    const Agreement& agreement) const;
  bool Keep(const EditableMesh::Changes& before, const Agreement& agreement);
  double QualityOfCollapse(int u, int v, const Agreement& agreement) const;
  Point3 Relaxed(int v) const;

  CrossingGuard Guard;
};
}

#endif
