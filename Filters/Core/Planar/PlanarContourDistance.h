// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlanarContourDistance.h
 * @brief Distances in the plane of a level to its contours.
 */
#ifndef recon_PlanarContourDistance_h
#define recon_PlanarContourDistance_h

#include "Planar/EdgeTree.h"
#include "Polyhedral/LevelTriangulation.h"

namespace recon
{
class PlanarContourDistance
{
public:
  explicit PlanarContourDistance(const LevelTriangulation& level);

  /// To the nearest point of any contour edge of the level, in units of the input.
  double operator()(const Point2& p) const { return this->Edges.Distance(p); }

private:
  EdgeTree Edges;
};
}

#endif
