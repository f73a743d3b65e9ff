// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MassProperties.h
 * @brief Volume, area, centroid, bounds and smallest angle, sound far from the origin.
 *
 * With a, b, c the corners of a triangle relative to a point of its own component:
 * - area = sum |(b - a) x (c - a)| / 2
 * - volume = sum a . (b x c) / 6 (divergence theorem; positive where normals point outward)
 * - centroid = sum (a + b + c) / 4 * a . (b x c) / 6 / volume, of the enclosed solid
 * - smallest angle = that between the two longer sides of a triangle, the smallest of all
 *
 * Every component is measured from its own middle and sums are compensated (Neumaier), so a mesh at
 * 1e6 mm measures what it does at 0, but for the digits that its coordinates have lost there.
 */
#ifndef recon_MassProperties_h
#define recon_MassProperties_h

#include "Mesh/TriangleMesh.h"

#include <optional>
#include <vector>

namespace recon
{
/// In units of the input; angles in degrees.
struct MassFigures
{
  std::optional<double> Volume; ///< signed; empty where the surface encloses none
  double Area = 0;
  std::optional<Point3> Centroid; ///< of the enclosed solid; empty where there is none
  Point3 Low{ 0, 0, 0 };          ///< bounds
  Point3 High{ 0, 0, 0 };
  double SmallestAngle = 0; ///< 0 where a triangle has no area
};

/// The smallest angle of all triangles in degrees; 0 where one has no area, 180 where there is none.
double ComputeSmallestAngle(const TriangleMesh& mesh);

/// The divergence theorem's sum over each of `count` components, whether or not they enclose a
/// volume.
std::vector<double> ComputeSignedVolumes(
  const TriangleMesh& mesh, const std::vector<int>& componentOfTriangle, int count);

/**
 * The figures of every component, and last of the whole mesh.
 *
 * encloses says which components enclose a volume; where one does not, the whole has no volume
 * either. Triangles of component -1 count for the whole only.
 */
std::vector<MassFigures> ComputeMassProperties(const TriangleMesh& mesh,
  const std::vector<int>& componentOfTriangle, const std::vector<bool>& encloses);
}

#endif
