// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SelfIntersections.h
 * @brief All pairs of triangles of a mesh that cross, overlap or touch, found exactly.
 */
#ifndef recon_SelfIntersections_h
#define recon_SelfIntersections_h

#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace recon
{
/// See PairRelation for what the three words mean.
struct IntersectingPair
{
  enum KindType
  {
    Touching,
    Overlapping,
    Crossing
  };
  int First;  ///< triangle, the smaller number
  int Second; ///< triangle
  KindType Kind;
};

/// Numbers of pairs of each kind.
struct PairCounts
{
  std::int64_t Crossing = 0;
  std::int64_t Overlapping = 0;
  std::int64_t Touching = 0;

  void Add(IntersectingPair::KindType kind)
  {
    (kind == IntersectingPair::Crossing      ? this->Crossing
        : kind == IntersectingPair::Touching ? this->Touching
                                             : this->Overlapping)++;
  }
  void Add(const PairCounts& other)
  {
    this->Crossing += other.Crossing;
    this->Overlapping += other.Overlapping;
    this->Touching += other.Touching;
  }
};

struct SelfIntersections : PairCounts
{
  std::vector<IntersectingPair> Pairs; ///< sorted; more than the options allow are only counted
  std::vector<int> DefectOfTriangle;   ///< DefectCrossing, DefectOverlapping, DefectTouching
  bool Complete = true;                ///< whether Pairs holds all that were counted
  /// A component: pairs of which at least one triangle is of it. Empty where no components were
  /// given.
  std::vector<PairCounts> CountsOfComponent;

  /// The surface runs through itself or lies on itself.
  bool Any() const { return this->Crossing + this->Overlapping > 0; }
};

struct SelfIntersectionOptions
{
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
  /// Pairs to keep of each of the pieces in which the mesh is searched; the counts are always of
  /// all.
  std::int64_t MaximumPairsAPiece = 100000;
  /// What MeshTopology::ComponentOfTriangle holds, where counts by component are wanted.
  const std::vector<int>* ComponentOfTriangle = nullptr;
  /// A triangle: whether pairs with it are looked at; where given, pairs of two others are passed over.
  const std::vector<char>* Of = nullptr;
};

/**
 * Connectivity is by index: triangles at equal coordinates under different indices, as a manifold
 * cut leaves them, touch; they cross only where their inner points meet. Triangles without area are
 * passed over.
 *
 * A pair is a local matter: where a surface passes through itself exactly along edges and corners
 * of its own, no two triangles have inner points in common and all pairs merely touch. Where edges
 * coincide FindSheetCrossings tells; where an edge lies within a face or part of another edge
 * nothing does.
 *
 * @throws Error where an index is out of range or a coordinate not finite; Aborted.
 */
SelfIntersections FindSelfIntersections(
  const TriangleMesh& mesh, const SelfIntersectionOptions& options, Monitor& monitor);

/// The same with default options.
SelfIntersections FindSelfIntersections(const TriangleMesh& mesh, Monitor& monitor);
}

#endif
