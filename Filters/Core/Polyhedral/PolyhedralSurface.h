// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralSurface.h
 * @brief The whole Polyhedral Surface Method: parallel contours in, the closed boundary of a solid
 * out.
 */
#ifndef recon_PolyhedralSurface_h
#define recon_PolyhedralSurface_h

#include "Base/Monitor.h"
#include "Contours/ContourMapping.h"
#include "Mesh/TriangleMesh.h"

#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// The defaults are the thesis's own method, with flat ends; those of the filter that users meet
/// are what comes nearest to the truth.
struct PolyhedralOptions
{
  enum MappingType
  {
    Proximity = 0, ///< the Voronoi diagrams alone decide what is joined
    Overlap = 1 ///< only regions that overlap by more than OverlapThreshold are (thesis chapter 3)
  };
  enum EndCapsType
  {
    Flat = 0,      ///< in the plane of the contour: no volume added
    HalfSlice = 1, ///< half a slice straight on, as planning systems count volumes
    Tapered = 2,   ///< rounded off: see EndShare and PartialEnds.h
    NoCaps = 3     ///< left open: the surface is then not closed
  };
  enum IsolatedContoursType
  {
    Drop = 0,   ///< left out, with a line in Report
    Extrude = 1 ///< half a slice each way
  };

  bool InternalPoints = true;     ///< thesis 5.3
  bool LiftInternalPoints = true; ///< thesis 6.2
  MappingType Mapping = Proximity;
  double OverlapThreshold = 0.1;                   ///< share of the smaller region, in [0, 1)
  std::vector<std::pair<int, int>> ForcedJoins;    ///< pairs of ContourId on adjacent levels
  std::vector<std::pair<int, int>> ForbiddenJoins; ///< wins over ForcedJoins
  /// Slabs thicker than this many median spacings are not bridged; 0 = all are.
  double MaximumGap = DefaultMaximumGap;
  EndCapsType EndCaps = Flat;
  IsolatedContoursType IsolatedContours = Drop;
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
};

/**
 * The boundary of the solid that the kept tetrahedra fill: closed, oriented outward, edge- and
 * vertex-manifold by index, not crossing itself. Every contour vertex that is not named in Report
 * is a point of it, to the last bit.
 *
 * In planes that are not perpendicular to an axis, where the points of regular shapes are in line
 * up to rounding only, sheets that touch in a common plane may cross by that rounding.
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
  /// A triangle: number of the slab it bounds, 0 = between levels 0 and 1; -1 and the number of
  /// slabs are caps that stand out below the first and above the last level.
  std::vector<int> Slab;
  std::vector<int> FaceKind; ///< a triangle: FaceKindType
  std::vector<int>
    MappingGroup;             ///< a triangle: number of the group of contours that its slab joins
  std::vector<int> PointKind; ///< a point: PointKindType
  double EndCapVolume =
    0; ///< cubic units that the caps of ends add to the solid between the levels
  double IsolatedVolume = 0; ///< cubic units of isolated contours that were extruded
  std::vector<std::string> Report;
  std::vector<std::pair<std::string, double>> StageSeconds; ///< wall time by stage
};

/// @throws Error where the contours span fewer than two levels; Aborted.
PolyhedralSurface BuildPolyhedralSurface(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor);
}

#endif
