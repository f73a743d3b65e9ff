// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralSurface.h
 * @brief The whole Polyhedral Surface Method: parallel contours in, the closed boundary of a solid
 * out.
 */
#ifndef recon_PolyhedralSurface_h
#define recon_PolyhedralSurface_h

#include "../Contours/ContourSet.h"
#include "../Mesh/TriangleMesh.h"
#include "../Monitor.h"

#include <string>
#include <utility>
#include <vector>

namespace recon
{
struct PolyhedralOptions
{
  bool InternalPoints = true;     ///< thesis 5.3
  bool LiftInternalPoints = true; ///< thesis 6.2
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
};

/**
 * The boundary of the solid that the kept tetrahedra fill: closed, oriented outward, edge- and
 * vertex-manifold by index, not crossing itself. Every contour vertex that is not named in Report
 * is a point of it, to the last bit.
 */
struct PolyhedralSurface
{
  enum FaceKindType
  {
    Wall = 0, ///< between two levels
    Cap = 1   ///< in the plane of a level
  };
  enum PointKindType
  {
    InputVertex = 0,
    AddedOnContour = 1, ///< thesis 5.1, 5.2
    Internal = 2        ///< thesis 5.3
  };

  TriangleMesh Mesh;
  std::vector<int> Slab; ///< a triangle: number of the slab it bounds, 0 = between levels 0 and 1
  std::vector<int> FaceKind; ///< a triangle: FaceKindType
  std::vector<int>
    MappingGroup;             ///< a triangle: number of the group of contours that its slab joins
  std::vector<int> PointKind; ///< a point: PointKindType
  std::vector<std::string> Report;
  std::vector<std::pair<std::string, double>> StageSeconds; ///< wall time by stage
};

/// @throws Error where the contours span fewer than two levels; Aborted.
PolyhedralSurface BuildPolyhedralSurface(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor);
}

#endif
