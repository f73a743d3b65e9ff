// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImplicitSurface.h
 * @brief The whole Implicit Surface Method: contours in any planes in, a smooth closed surface out
 * (thesis part III).
 */
#ifndef recon_ImplicitSurface_h
#define recon_ImplicitSurface_h

#include "Implicit/Constraints/ContourFit.h"
#include "Implicit/ZeroSet/Polygonizer.h"

namespace recon
{
/// Half a gap is the mean where slices begin anywhere; sets of real slices were nearer to the truth
/// with less, as long as ends that are round have room (hand_ok, whose wrist is cut: mean distance
/// .0035 at .25, .0045 at .4, .0052 at .5; eight_15, which is round: largest .020, .0097, .0097).
constexpr double DefaultEndsBeyond = 0.4;

struct ImplicitSurfaceOptions
{
  ConstraintOptions Constraints;
  FunctionOptions Function;
  PolygonizerOptions Polygonizer;
  double EndsBeyond = DefaultEndsBeyond; ///< of ChooseBoundsOf
};

struct ImplicitSurface
{
  ImplicitMesh Mesh;
  ContourFit Fit;
  std::vector<std::string> Report; ///< of all stages, in their order
};

/**
 * Constraints, function and polygonizer in one call with one progress bar.
 *
 * With Polygonizer.Detail below Full the function, too, is that of a preview: through 700 or 1 000
 * of the contours' points (or a few more), those that show in such cells, fitted once, with
 * margins in the contours' planes.
 *
 * Where no bounds are given, the solid ends at the latest EndsBeyond gaps of the levels beyond the
 * first and the last of the levels that are parallel to a coordinate plane; but not on a side where
 * contours of other levels reach farther, as they tell its end.
 *
 * @throws Error as the stages do; Aborted.
 */
ImplicitSurface BuildImplicitSurface(
  const ContourSet& contours, const ImplicitSurfaceOptions& options, Monitor& monitor);

/// The box in which such contours' surface is tracked where none is given. @param endsBeyond the
/// outermost of levels that are parallel to a coordinate plane, in gaps
Bounds ChooseBoundsOf(const ContourSet& contours, double endsBeyond = DefaultEndsBeyond);

/// All contour vertices.
std::vector<Point3> SeedsOf(const ContourSet& contours);
}

#endif
