// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file KeptPlaces.h
 * @brief Places that a mesh passes within a distance, and goes on to pass while it is changed.
 */
#ifndef recon_KeptPlaces_h
#define recon_KeptPlaces_h

#include "Base/Monitor.h"
#include "Fair/LinkedMesh.h"

#include <utility>
#include <vector>

namespace recon
{
struct PlacesToKeep
{
  std::vector<Point3> Places;
  double Within = 0; ///< in the units of the input; 0: each stays a point of the mesh

  /// How far a place is from a triangle; beyond all bounds where it has to be a corner, and is none.
  double DistanceTo(const Point3& place, const Point3& a, const Point3& b, const Point3& c) const;
};

/// Of each place a triangle that is nearest to it; -1 where none is near enough.
std::vector<int> FindWitnesses(
  const TriangleMesh& mesh, const PlacesToKeep& keep, int threads, Monitor& monitor);

/**
 * @class KeptPlaces
 * @brief Asks before a change of a LinkedMesh whether all places stay near enough.
 *
 * Each place has a triangle that is near enough, its witness; only places whose witness changes have to
 * be looked at. Those that have none from the beginning are passed over.
 */
class KeptPlaces
{
public:
  using Triangle = LinkedMesh::Triangle;
  using Change = std::pair<int, Triangle>; ///< a triangle's number, and its corners from now on

  KeptPlaces(const LinkedMesh& mesh, const PlacesToKeep& keep, int threads, Monitor& monitor);

  /// Whether the mesh may have triangles `after` in the place of those `before`, which it has still.
  bool MayChange(const std::vector<int>& before, const std::vector<Change>& after);
  /// What MayChange was asked about last has been done.
  void Commit();
  /// The same for triangles that were cut, and pass everything that they did before.
  void TakeCut(const std::vector<int>& triangles);

private:
  double DistanceTo(int place, const Triangle& t) const;
  int WitnessBeside(int place, const std::vector<Change>& after) const;
  void Gather(const std::vector<int>& triangles);
  void Give(int place, int triangle);

  const LinkedMesh& Mesh;
  PlacesToKeep Keep;
  std::vector<int> First;    ///< a triangle: of the places that it is the witness of; -1: of none
  std::vector<int> Next;     ///< a place: of the same triangle; -1 after the last
  std::vector<int> Gathered; ///< places that the change is about
  std::vector<int> Before;   ///< triangles
  std::vector<std::pair<int, int>> Pending; ///< place, witness
};
}

#endif
