// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SectionComparison.h
 * @brief The difference between contours and the surface cut again at their planes, and their
 * distance from it.
 *
 * In the plane of a level the solid is looked at from both sides at no distance at all: the cut
 * from below takes points of the surface that lie in the plane for points above it, the cut from
 * above takes them for points below. Where the surface goes through the plane both give the same;
 * where it ends in it, one of them gives the region and the other nothing. The region of the solid
 * is the union of both and of faces in the plane. This is "a hair beside" with the hair's width
 * brought to zero, so no slope of the surface enters into it.
 */
#ifndef recon_SectionComparison_h
#define recon_SectionComparison_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"

#include <optional>
#include <vector>

namespace recon
{
class TriangleTree;

struct SectionOptions
{
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
  /**
   * Points of the surface within this distance of a plane lie in it, in units of the input; to it
   * come the scatter of the level's own contour points about their plane and the rounding of a
   * double. For a surface that was stored in single precision pass what that costs: 6e-8 of its
   * largest coordinate.
   */
  double CoordinateRounding = 0;
};

/// The surface and the contours in the plane of one level; areas in square units of the input.
struct SectionDifference
{
  int Level = -1;
  double Offset = 0;      ///< of the plane, along the level's normal
  double ContourArea = 0; ///< even-odd
  /// Empty where the surface is open in this plane, so that it bounds no region there.
  std::optional<double> SurfaceArea;
  std::optional<double> SymmetricDifference; ///< area that belongs to one of the two only
  std::optional<double> Percent;             ///< of ContourArea
};

/// One entry a level, in order.
/// @throws Error where a coordinate of the mesh is not finite; Aborted.
std::vector<SectionDifference> CompareSections(const TriangleMesh& mesh, const ContourSet& contours,
  const SectionOptions& options, Monitor& monitor);

/// How far contours are from a surface, in units of the input.
struct ContourDistance
{
  int Vertices = 0; ///< contour vertices looked at
  double FarthestVertex = 0;
  double MeanVertex = 0;
  double FarthestEdge = 0;      ///< over the points at 1/4, 1/2 and 3/4 of every contour edge
  double MeanEdge = 0;          ///< the same, weighted by the length of the edge
  Point3 FarthestAt{ 0, 0, 0 }; ///< the vertex or point of an edge that is farthest
};

/// Empty where there is no surface or no contour.
std::optional<ContourDistance> MeasureContourDistance(const TriangleMesh& mesh,
  const TriangleTree& tree, const ContourSet& contours, int threads, Monitor& monitor);
}

#endif
