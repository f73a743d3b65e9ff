// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourSamples.h
 * @brief The drawn contours as points that a surface is asked to pass.
 */
#ifndef recon_ContourSamples_h
#define recon_ContourSamples_h

#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/// A place on a contour.
struct ContourSample
{
  Point3 Place;
  Vector3 Outward; ///< unit, in the contour's plane, out of the solid
  double Length;   ///< of the contour that it stands for
  int Level;
  bool IsVertex; ///< a vertex of the contour, not a place along an edge
  double Radius; ///< of a circle as long as the contour
};

/**
 * Every contour vertex that is a point of the surface (the others are left out of it), and places
 * along edges that are longer than `distance` (units of the input).
 */
std::vector<ContourSample> SampleContours(
  const ContourSet& contours, const TriangleMesh& through, double distance);
}

#endif
