// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MeshTopology.h
 * @brief The topology of a triangle mesh: closed, manifold, oriented, outward, and how often not.
 *
 * Connectivity is by index. A format without any (STL) is welded first, see WeldPoints.
 *
 * Words, for the thesis's chapter 11 and the tests:
 * - A triangle is collapsed where two of its corners are the same index. Collapsed triangles are
 * counted as degenerate and take no other part. Triangles of no area but with three corners are
 * degenerate too, and take part like any other.
 * - An edge is a pair of points that some triangle joins.
 * - A component is a maximal set of triangles connected through shared points.
 */
#ifndef recon_MeshTopology_h
#define recon_MeshTopology_h

#include "Mesh/TriangleMesh.h"

#include <optional>
#include <vector>

namespace recon
{
/// The figures of one component, or of the whole mesh.
struct TopologyFigures
{
  int Triangles = 0;           ///< all, collapsed ones included
  int Points = 0;              ///< that a triangle uses which is not collapsed
  int Edges = 0;               ///< between those points
  int Components = 0;          ///< 1 for a component
  int OpenEdges = 0;           ///< used by one triangle
  int OverusedEdges = 0;       ///< used by more than two triangles
  int MisorientedEdges = 0;    ///< whose triangles do not run along it both ways in turn
  int PinchedVertices = 0;     ///< whose triangles form more than one edge-connected fan
  int DuplicateTriangles = 0;  ///< that have the same three points as an earlier one
  int DegenerateTriangles = 0; ///< with repeated or exactly collinear corners
  int Euler = 0;               ///< Points - Edges + triangles that are not collapsed

  bool Closed = false; ///< every edge is used by an even number of triangles, and there is one
  bool EdgeManifold = false;   ///< no edge is used by more than two triangles
  bool VertexManifold = false; ///< no vertex is pinched
  /// Every edge of two triangles is run along once each way; of more, as often each way (or one
  /// off, where odd).
  bool Oriented = false;
  /// Closed, oriented, and normals point away from the solid: the signed volume is positive where
  /// an even number of other components lies around this one, negative (a cavity) where an odd
  /// number does.
  bool Outward = false;
  /// Sum over components of (2 - Euler) / 2; empty unless all are closed, manifold and oriented.
  std::optional<int> Genus;

  /// Whether "the volume inside" means anything: without it, the divergence theorem gives a number,
  /// no volume.
  bool EnclosesVolume() const { return this->Closed && this->Oriented; }
  bool Manifold() const { return this->EdgeManifold && this->VertexManifold; }
};

struct MeshTopology
{
  TopologyFigures Total;
  std::vector<TopologyFigures> Components; ///< in the order of their first triangle
  /// A triangle: its component, or -1 for a collapsed triangle that no other touches.
  std::vector<int> ComponentOfTriangle;
  std::vector<int> Nesting;          ///< a component: number of closed components around it
  std::vector<int> DefectOfTriangle; ///< TriangleDefect bits
};

/**
 * All topological figures of a mesh.
 *
 * Time is near linear. Nesting is found by exact ray casting, see FindComponentNesting.
 * @throws Error where an index is out of range or a coordinate is not finite.
 */
MeshTopology CheckTopology(const TriangleMesh& mesh);

/**
 * The same triangles, in the same order, on points of which no two have equal coordinates.
 *
 * Coordinates are compared exactly (-0 equals 0): nothing is moved, and points that merely lie
 * close together stay apart. Triangles may collapse by it; they are kept, so that triangle numbers
 * stay valid.
 */
TriangleMesh WeldPoints(const TriangleMesh& mesh);

/// @throws Error where an index is out of range or a coordinate of a used point is not finite.
void RequireUsable(const TriangleMesh& mesh);
}

#endif
