// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceBlocks.h
 * @brief The poly data of a data object that is one, or a composite of many, with their names.
 */
#ifndef SurfaceBlocks_h
#define SurfaceBlocks_h

#include "ContourFiltersModule.h" // for export macro

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace recon
{
struct NamedPolyData
{
  std::string Name; ///< empty where it has none
  vtkPolyData* Data;
};

/// All poly data, in order; other kinds of data and empty blocks are passed over.
CONTOURFILTERS_EXPORT std::vector<NamedPolyData> ListPolyData(vtkDataObject* object);

/**
 * Those of ListPolyData that have polygons; the others are regions of which nothing was made.
 *
 * @throws Error where there is none.
 */
CONTOURFILTERS_EXPORT std::vector<NamedPolyData> ListSurfaces(vtkDataObject* object);

CONTOURFILTERS_EXPORT std::vector<std::string> NamesOf(const std::vector<NamedPolyData>& blocks);

/**
 * The contours of each surface: the only ones there are, those of the same name, or else those at
 * the same position where there are as many of the one as of the other. nullptr where a surface has
 * none.
 *
 * @throws Error where there are contours, and not one surface finds its own.
 */
CONTOURFILTERS_EXPORT std::vector<vtkPolyData*> MatchContours(
  const std::vector<NamedPolyData>& surfaces, vtkDataObject* contours);
}

#endif
