// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FairSurface.h
 * @brief Parallel contours in, a smooth closed surface with the topology of the polyhedral one out.
 */
#ifndef recon_FairSurface_h
#define recon_FairSurface_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// As the default of Polyhedral Surface: sheets that touch become apart, by this part of the median
/// edge length, before they are moved.
constexpr double FairPinchGap = 1e-3;

struct FairOptions
{
  PolyhedralOptions Polyhedral; ///< what is joined to what, and how it ends
  /// How far the surface may leave a drawn contour, in the units of the input; negative: automatic,
  /// half the staircase step of contours that follow pixels, a twentieth of the slices' distance else.
  double Tolerance = -1;
  /// Of the triangles, in the units of the input; 0: automatic, see AutomaticEdgeLength.
  double EdgeLength = 0;
  /// 0 as smooth as may be ... 1 as the polyhedral surface; negative: automatic, by place, see
  /// TensionByBend.
  double Tension = -1;
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
};

struct FairSurface
{
  TriangleMesh Mesh;
  double Tolerance = 0; ///< what was chosen
  double EdgeLength = 0;
  double Tension = 0;     ///< mean of the points
  double Farthest = 0;    ///< distance of a contour vertex from the surface
  std::size_t Beyond = 0; ///< contour vertices farther away than Tolerance: none, but for rounding
  std::size_t Thin = 0;   ///< triangles with an angle below FairLeastAngle
  /// Points that stay nearer to the polyhedral surface, not to cross or to leave a contour.
  std::size_t HeldBack = 0;
  double EndCapVolume = 0;   ///< as of PolyhedralSurface
  double IsolatedVolume = 0; ///< as of PolyhedralSurface
  std::size_t LeftOut = 0;   ///< contours of which no point is one of the polyhedral surface
  std::vector<std::string> Report;
  std::vector<std::pair<std::string, double>> StageSeconds; ///< wall time by stage
};

/**
 * The polyhedral surface with even triangles, moved to where it bends evenly while every contour
 * vertex pulls at it (a thin plate under tension), and held back where it would cross itself.
 *
 * Guaranteed: the topology of the polyhedral surface, closed, manifold, outward, no triangles cross
 * if none does there; and every contour vertex that the polyhedral surface passes is within Tolerance: the
 * mesh that is moved is made so, and what would leave one is held back. Triangles with small angles are
 * counted, and in Report.
 *
 * @throws Error where the contours span fewer than two levels; Aborted.
 */
FairSurface BuildFairSurface(
  const ContourSet& contours, const FairOptions& options, Monitor& monitor);

/// Three tenths of the slices' distance; down to half of that where triangles are few, and more where
/// they would be very many.
double AutomaticEdgeLength(const TriangleMesh& surface, double spacing);
}

#endif
