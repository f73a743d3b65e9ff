// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourTracer.h
 * @brief Contours of the implicit function on any planes (thesis 9.3.1).
 */
#ifndef recon_ContourTracer_h
#define recon_ContourTracer_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Implicit/ZeroSet/BoundedField.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace recon
{
struct TracePlane
{
  PlanarFrame Frame;
  double Offset = 0; ///< along Frame.Normal
};

struct TracerOptions
{
  /// Edge of the grid's squares, as PolygonizerOptions::CellSize; a half or a quarter of it on planes
  /// whose contours are small beside that.
  double CellSize = 0;
  std::optional<Bounds>
    Box;                   ///< contours are closed where they reach it; as PolygonizerOptions::Box
  double Tolerance = 1e-6; ///< of a root, in cells
  double MaximumCells = 4e6; ///< more are refused, as in PolygonizerOptions
  double SmallestArea = 0;   ///< contours that enclose less are left out, with a line in Report
  int Threads = 0;
};

/**
 * A planar grid a level, the function at its corners near the surface, a root on each edge whose
 * ends differ in sign, and from root to root until the contour is closed. Squares are cut into
 * triangles, so a contour never has to choose where to go on.
 *
 * Closed, oriented and nested contours (ContourSet.h), in planes of their own or, where all planes
 * are parallel, as a Parallel set that the polyhedral method reads. Parts of the zero set that no
 * seed's component reaches (phantom sheets) are not traced.
 *
 * @throws Error where there is no plane, no contour on any, or the grid would be absurdly fine;
 * Aborted.
 */
ContourSet TraceContours(const ImplicitFunction& function, const std::vector<Point3>& seeds,
  const std::vector<TracePlane>& planes, const TracerOptions& options, Monitor& monitor);

/// Parallel planes from an offset to another, both included where the spacing fits. @throws Error
/// on bad numbers.
std::vector<TracePlane> ParallelPlanes(
  const Vector3& normal, double from, double to, double spacing);

/// Those that lie between the outermost of the points, seen along their normals, or beyond them by
/// less than the tolerance (in the points' unit).
std::vector<TracePlane> PlanesWithin(
  const std::vector<TracePlane>& planes, const std::vector<Point3>& points, double tolerance);

/// Parallel planes through all of the seeds, or within range where it is given (along the normal, in
/// the units of the input). Spacing 0 takes a twentieth of that. @throws Error on bad numbers.
std::vector<TracePlane> ParallelPlanesThrough(const std::vector<Point3>& seeds,
  const Vector3& normal, const std::optional<std::array<double, 2>>& range, double spacing);

/**
 * Without the planes that lie beyond all drawn points, which report tells.
 *
 * @param tolerance how far beyond the outermost points a plane may lie; not given: a twentieth of
 * the planes' median distance
 * @throws Error where none is left
 */
std::vector<TracePlane> OnlyPlanesWithin(const std::vector<TracePlane>& planes,
  const std::vector<Point3>& drawn, std::optional<double> tolerance,
  std::vector<std::string>& report);

/// The planes of a contour set's levels.
std::vector<TracePlane> PlanesOf(const ContourSet& contours);

/// A frame about a normal of any length (PlanarFrame says which where it is an axis). @throws Error
/// on a zero one.
PlanarFrame FrameAbout(const Vector3& normal);
}

#endif
