// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SectionDiscs.h
 * @brief Discs in which planes between the levels of a closed surface cut it or what it encloses.
 */
#ifndef recon_SectionDiscs_h
#define recon_SectionDiscs_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace recon
{
/// Edges that a closed line in a section crosses, the lower point first, in the direction in which the
/// parts of triangles below it run along it.
struct SectionLoop
{
  std::vector<std::array<int, 2>> Edges;
  std::vector<int> Triangles; ///< that it crosses, from Edges[i] to the next one
};

/// What lies within a loop of a section.
struct SectionDisc
{
  int Slab;   ///< between offsets Slab and Slab + 1
  double Low; ///< no point of the mesh lies between these two heights, nor at them
  double High;
  double Area; ///< of the loop halfway between them, square units
  bool Solid;  ///< solid lies within the loop; else a hole
  SectionLoop Loop;
  std::vector<SectionLoop> Inside; ///< of a ring; these have none inside
};

/// Parallel planes that cut a mesh.
struct SectionPlanes
{
  enum SpacingType
  {
    Even,    ///< some in every slab
    Critical ///< one between every two heights at which loops of a slab meet, part, begin or end
  };

  PlanarFrame Frame; ///< heights of discs are along its normal
  SpacingType Spacing = Even;
  bool WithRings = false; ///< also what has loops inside that have none inside themselves
};

/**
 * Of planes in every slab, where the points of the mesh leave the largest gaps. In the order of slabs,
 * then heights, then first triangles. Planes may be tilted: a disc lies within its slab, and its loop
 * crosses no edge between two points of a level.
 *
 * @param normal of the levels, along which their offsets are
 * @throws Aborted
 */
std::vector<SectionDisc> FindSectionDiscs(const TriangleMesh& mesh, const SectionPlanes& planes,
  const Vector3& normal, const std::vector<double>& offsets, Monitor& monitor);

/// The same with some planes along the levels.
std::vector<SectionDisc> FindSectionDiscs(
  const TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets);

/// Planar place of the crossing of an edge with a plane.
Point2 CrossingAt(const TriangleMesh& mesh, const PlanarFrame& frame,
  const std::array<int, 2>& edge, double height);
}

#endif
