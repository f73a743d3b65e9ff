// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SectionDiscs.h
 * @brief Discs in which planes between the levels of a closed surface cut it or what it encloses.
 */
#ifndef recon_SectionDiscs_h
#define recon_SectionDiscs_h

#include "Base/Geometry.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace recon
{
/// What lies within a loop of a section that has no other inside.
struct SectionDisc
{
  int Slab;   ///< between offsets Slab and Slab + 1
  double Low; ///< no point of the mesh lies between these two heights, nor at them
  double High;
  double Area; ///< of the loop halfway between them, square units
  bool Solid;  ///< solid lies within the loop; else a hole
  /// The loop: edges that it crosses, the lower point first, in the direction in which the parts of
  /// triangles below it run along it.
  std::vector<std::array<int, 2>> Edges;
  std::vector<int> Triangles; ///< that it crosses, from Edges[i] to the next one
};

/// Of some planes in every slab, where the points of the mesh leave the largest gaps. In the order of
/// slabs, then heights, then first triangles.
std::vector<SectionDisc> FindSectionDiscs(
  const TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets);

/// Planar place of the crossing of an edge with a plane.
Point2 CrossingAt(const TriangleMesh& mesh, const PlanarFrame& frame,
  const std::array<int, 2>& edge, double height);
}

#endif
