// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourConversion.h
 * @brief The one place where vtkPolyData becomes the core's contours and meshes, and back.
 *
 * Coordinates pass unchanged, as doubles. Single precision points are widened, which is exact.
 * Everything here throws recon::Error with a sentence for the user where it cannot do its work; the
 * callers, which are RequestData methods, must not let it out.
 */
#ifndef ContourConversion_h
#define ContourConversion_h

#include "ContourFiltersModule.h" // for export macro
#include "Contours/ContourSetBuilder.h"
#include "Mesh/TriangleMesh.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace recon
{
/// Contours as they arrive, and what of the input cannot be a contour.
struct ConvertedLoops
{
  LoopSoup Soup;                   ///< Source is the number of the cell in the vtkPolyData
  std::vector<std::string> Report; ///< a sentence for every kind of cell that was left aside
};

/**
 * Lines and polygons become chains, vertices chains of one point (which the contour set reports).
 *
 * Cells whose string array `GeometricType` says CLOSEDPLANAR_XOR become ExclusiveOr chains, and the
 * unit is the millimetre where there is such an array. Levels that ToPolyData(ContourSet) wrote are
 * read again (cell array `Level`, field data `LevelNormal`, `LevelOffset`, `LevelThickness`), so
 * that no later filter decides anew which contours are one level.
 *
 * Polygons, and polylines whose last point has the first one's index, are closed. Triangle strips
 * are no contours: they are left aside with a sentence.
 *
 * @throws Error for no points, no cells, or more points than an int can number.
 */
[[nodiscard]] CONTOURFILTERS_EXPORT ConvertedLoops ToLoopSoup(vtkPolyData* input);

/**
 * The one way from poly data to a contour set. What the input's own `Report` says, and what
 * ToLoopSoup left aside, comes first in the set's Report, so that nothing is forgotten that an
 * earlier filter left out.
 *
 * @throws Error where there are no contours, also for a surface; Aborted
 */
[[nodiscard]] CONTOURFILTERS_EXPORT ContourSet ReadContours(
  vtkPolyData* input, const ContourSetOptions& options, Monitor& monitor);

/**
 * Contours as a file has them: closed chains become polylines, last point id = first, open ones
 * polylines, single points vertices. Attributes are the caller's.
 *
 * @return the chain of every cell, in the order of cells (vtkPolyData puts vertices before lines)
 */
CONTOURFILTERS_EXPORT std::vector<int> ToPolyData(const LoopSoup& soup, vtkPolyData* output);

/**
 * Closed polylines, last point id = first, with cell arrays `Level`, `ContourId`, `Depth`, `Parent`
 * (ContourId or -1), `SignedArea`, and field data `LevelNormal` (3 components), `LevelOffset`,
 * `LevelThickness`, `LevelHoleRule` (a sentence a level).
 */
CONTOURFILTERS_EXPORT void ToPolyData(const ContourSet& set, vtkPolyData* output);

/// Cell arrays of the input, for the cell that each contour came from; own arrays are not replaced.
CONTOURFILTERS_EXPORT void PassCellData(
  const ContourSet& set, vtkPolyData* input, vtkPolyData* output);

/// Field data `LevelNormal` (three components), `LevelOffset` and `LevelThickness` (farthest distance
/// of a point from its plane): a tuple and two values a level.
CONTOURFILTERS_EXPORT void AddLevels(const ContourSet& set, vtkDataObject* output);

/// Triangles, with double precision points; attributes are the caller's.
CONTOURFILTERS_EXPORT void ToPolyData(const TriangleMesh& mesh, vtkPolyData* output);

/**
 * Triangles only; other polygons and strips have to be triangulated before.
 *
 * @throws Error for a cell that is no triangle (it names the first), no triangles at all, or more
 * points than an int can number.
 */
[[nodiscard]] CONTOURFILTERS_EXPORT TriangleMesh ToTriangleMesh(vtkPolyData* input);

/// Field data `Report`: a string array, which replaces one that is there. None is written for no
/// lines.
CONTOURFILTERS_EXPORT void SetReport(const std::vector<std::string>& lines, vtkDataObject* data);

/// What SetReport wrote; empty where there is none.
[[nodiscard]] CONTOURFILTERS_EXPORT std::vector<std::string> GetReport(vtkDataObject* data);

/// The Report of the input, then these lines.
[[nodiscard]] CONTOURFILTERS_EXPORT std::vector<std::string> JoinReports(
  vtkDataObject* input, const std::vector<std::string>& lines);
}

#endif
