// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlanarDifference.h
 * @brief Areas of two regions of a plane, and of what belongs to one of them only.
 */
#ifndef recon_PlanarDifference_h
#define recon_PlanarDifference_h

#include "Planar/PlanarSegment.h"

#include <array>
#include <vector>

namespace recon
{
/// The borders of regions of a plane, each a heap of segments in any order.
struct PlanarRegions
{
  enum LayerType
  {
    Below,   ///< even-odd; the surface cut by the plane, seen from below
    Above,   ///< even-odd; seen from above
    InPlane, ///< nonzero winding; faces that lie in the plane, all counterclockwise
    Contour  ///< even-odd
  };
  struct Segment : PlanarSegment
  {
    LayerType Layer;
  };
  std::vector<Segment> Segments;
};

/// In square units.
struct PlanarDifference
{
  double SurfaceArea = 0;         ///< of the union of Below, Above and InPlane
  double ContourArea = 0;         ///< of Contour
  double SymmetricDifference = 0; ///< of what is in one of the two only
  bool SurfaceIsClosed =
    true; ///< else the borders of the surface's layers have ends, and areas mean nothing
};

/**
 * Apart from the arrangement of a level (Arrangement.h) with its labels (EdgeSweep.h), as only areas are asked
 * for, and as borders of a surface may be open. Made of these it was tried: it takes 2.6 to 5 times as long
 * where the borders lie upon one another, as a section upon its contour does (20 loops of 1000 points, each in three
 * layers: .23 s and .087 s), and 5 to 13 times where they cross. A sweep over strips between consecutive ordinates, split where segments cross.
 *
 * No intersection point becomes a vertex, so there is no topology that rounding could break: what
 * rounding moves is the border of a trapezium, by less than some 1e-13 of the extent, and the area
 * by as little times the border's length. Time is that of sorting, plus the segments that cross
 * each strip.
 */
PlanarDifference MeasurePlanarDifference(const PlanarRegions& regions);
}

#endif
