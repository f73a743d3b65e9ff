// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VertexMargins.h
 * @brief The two margins of every contour vertex, in its contour's plane (thesis 9.1).
 */
#ifndef recon_VertexMargins_h
#define recon_VertexMargins_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"

#include <vector>

namespace recon
{
/// A contour vertex with the margins on its two sides.
struct VertexMargins
{
  Point3 Vertex{};
  Point3 Inner{};
  Point3 Outer{};
  double InnerDistance = 0; ///< to the contour; 0 = there is no room for this margin
  double OuterDistance = 0;
  double InnerValue = 0; ///< estimated distance to the surface: less than that to the contour where
  double OuterValue = 0; ///< the surface lies nearer above or below
  int Contour = -1;
  int Level = -1;
};

/**
 * The margins at all vertices, level after level and contour after contour: as near to `distance`
 * as there is room for, on the proper side of all edges of the level. @throws Aborted
 */
std::vector<VertexMargins> PlaceMargins(
  const ContourSet& contours, double distance, Monitor& monitor);
}

#endif
