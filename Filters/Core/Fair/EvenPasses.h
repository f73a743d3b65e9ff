// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EvenPasses.h
 * @brief Passes over a mesh that make its edges as long as they should be and its angles large
 * (Botsch and Kobbelt 2004).
 */
#ifndef recon_EvenPasses_h
#define recon_EvenPasses_h

#include "Base/Monitor.h"
#include "Fair/CrossingWatch.h"
#include "Fair/KeptPlaces.h"
#include "Fair/LinkedMesh.h"
#include "Fair/SurfacePlaces.h"

#include <utility>
#include <vector>

namespace recon
{
/// The least angle that a fair surface's triangles should have, degrees.
constexpr double FairLeastAngle = 5;

/**
 * @class EvenPasses
 * @brief Splits, collapses, flips and spreads over a LinkedMesh, which keep the manifold's genus.
 *
 * No triangle turns against the surface's normals. Where these say nothing, as on needles and knife
 * edges, and where another sheet is near, no change is made by which triangles cross. None is made by
 * which a place to keep comes to lie farther away than it may.
 */
class EvenPasses
{
public:
  /// @param surface what points are put back onto; outlives this; null where none are spread
  /// @param parts see LinkedMesh @param edgeLength what edges should have
  EvenPasses(const TriangleMesh& mesh, const std::vector<char>& parts, const SurfacePlaces* surface,
    const PlacesToKeep& keep, double edgeLength, int threads, Monitor& monitor);

  void SplitLong();
  void CollapseShort();
  /// Where the smaller of two triangles' least angles becomes larger.
  void Flip();
  /// Every point that is not on a crease to the middle of those around it, along the surface.
  void Spread();
  /// Triangles below FairLeastAngle: flips their longest side, or collapses their shortest, or shifts a corner.
  void MendSlivers();

  LinkedMesh Mesh;
  std::vector<Vector3> Normals; ///< of the surface, at the mesh's points
  std::vector<char> Thin;       ///< points around which changes are looked at

private:
  using Triangle = LinkedMesh::Triangle;

  double AgreementOf(const Triangle& t) const;
  double AgreementWanted(const std::vector<int>& before, double cosine) const;
  double QualityOf(const std::vector<int>& triangles) const;
  double QualityOfCollapse(int from, int into, double cosine) const;
  bool Collapse(int u, int v, double cosine);
  bool FlipIfBetter(int t, int k, double cosine);
  int TerminalOf(int t) const;
  Point3 Middle(int v) const;
  bool Place(int v, Point3& place, Vector3& normal);
  double AngleScore(const std::vector<int>& triangles) const;
  template <typename Test>
  bool Put(int v, Point3& place, Vector3& normal, const Test& isWell);
  bool Shift(int t);
  bool AnyThin(const std::vector<int>& triangles) const;
  std::vector<KeptPlaces::Change> AfterCollapse(
    const std::vector<int>& around, int from, int into) const;
  bool Mend(int t, double cosine);

  CrossingWatch Watch;
  KeptPlaces Kept;
  std::vector<int> Home; ///< a point: triangle of the surface that it was last put on, -1 before
  const SurfacePlaces* Surface;
  double EdgeLength;
  int Threads;
  Monitor& Observer;
};
}

#endif
