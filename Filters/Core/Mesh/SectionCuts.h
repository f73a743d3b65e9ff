// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SectionCuts.h
 * @brief Takes handles off a closed surface, by parting solid or filling holes between its levels.
 *
 * Between two levels the surface is cut by planes in closed loops. What lies within a loop
 * that has none inside is a disc, of solid or of a hole through it. Along its loop the surface is
 * opened, and both rims are closed by that disc, a little below the plane and a little above: solid
 * ends there, a hole is filled. A disc between two parts of the surface that hang together elsewhere as
 * well takes one handle away. Which loops may be cut without parting the surface is said by a spanning
 * tree of the largest discs (the cuts of a matroid), so the cheapest set is found, not searched for.
 *
 * Some planes a slab are tried first; then one between every two heights at which loops meet, part,
 * begin or end; then the same with planes tilted a little, as points between two levels often lie at one
 * height. Where only a loop with others inside is left, and those part the surface, what hangs at each
 * of them stays on one side of the cut, and is closed towards the other.
 */
#ifndef recon_SectionCuts_h
#define recon_SectionCuts_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
struct SectionCut
{
  int Slab = -1;     ///< between offsets Slab and Slab + 1
  double Height = 0; ///< of Place, along the normal
  double Area = 0;   ///< of the disc, square units
  bool Solid = true; ///< solid was parted; else a hole was filled
  Point3 Place{};    ///< a point of the rim
};

struct SectionCuts
{
  std::vector<SectionCut>
    Cuts; ///< in the order of the planes that were tried; of each the cheapest first
  std::vector<int> PartOf; ///< of every triangle of the mesh now: the one that it was, or is beside
};

/**
 * Cuts `handles` handles off, fewer where there are no more discs. Points stay; what is at the levels
 * is not touched.
 *
 * @param offsets of the levels along the frame's normal, increasing
 * @pre every edge has two triangles, and none cross
 */
SectionCuts CutHandles(TriangleMesh& mesh, const PlanarFrame& frame,
  const std::vector<double>& offsets, int handles, Monitor& monitor);
}

#endif
