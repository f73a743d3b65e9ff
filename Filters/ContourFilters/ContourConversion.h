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
#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"

#include <string>
#include <vector>

class vtkAlgorithm;
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
 * Cells whose string array `GeometricType` says CLOSEDPLANAR_XOR become ExclusiveOr chains.
 *
 * Polygons, and polylines whose last point has the first one's index, are closed. Triangle strips
 * are no contours: they are left aside with a sentence.
 *
 * @throws Error for no points, no cells, or more points than an int can number.
 */
[[nodiscard]] CONTOURFILTERS_EXPORT ConvertedLoops ToLoopSoup(vtkPolyData* input);

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
 * `LevelHoleRule` (a sentence a level), `Report`.
 *
 * @param report sentences that go before those of the set
 */
CONTOURFILTERS_EXPORT void ToPolyData(
  const ContourSet& set, const std::vector<std::string>& report, vtkPolyData* output);

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

/**
 * Whether the input is a region of interest of a structure set that is points only (a marker, an
 * isocentre): vertices of `GeometricType` POINT and nothing else. It has no contours, and must not
 * stop the regions that have: the output is left empty, with the field data of the input, and the
 * filter warns in one sentence. Vertices of other origin stay an error.
 */
[[nodiscard]] CONTOURFILTERS_EXPORT bool PassPoints(
  vtkAlgorithm* filter, vtkPolyData* input, vtkDataObject* output);

/// What SetReport wrote; empty where there is none.
[[nodiscard]] CONTOURFILTERS_EXPORT std::vector<std::string> GetReport(vtkDataObject* data);
}

#endif
