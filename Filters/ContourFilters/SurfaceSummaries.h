// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceSummaries.h
 * @brief What a surface is worth at a glance, as a line in its field data and in the panel.
 */
#ifndef SurfaceSummaries_h
#define SurfaceSummaries_h

#include "ContourFiltersModule.h" // for export macro
#include "Mesh/TriangleMesh.h"

#include <string>

class vtkDataObject;
class vtkPolyData;

namespace recon
{
/// Name of the field data array that AddSummary writes. It is of one surface, so it does not go along
/// to what is made of that (FinishOutput).
constexpr const char* SummaryName = "Summary";

/// Regions of a structure set are in millimetres, and objects of a program that says so.
[[nodiscard]] CONTOURFILTERS_EXPORT bool IsInMillimetres(vtkPolyData* data);

/// Field data `Summary`: whether the surface is closed, and its volume, see SummariseSurface.
/// @param input tells the unit
CONTOURFILTERS_EXPORT void AddSummary(
  const TriangleMesh& mesh, vtkPolyData* input, vtkPolyData* output);

/// "Heart: closed, 581.24 cm3": a line for every surface of poly data or a collection that has one.
[[nodiscard]] CONTOURFILTERS_EXPORT std::string SummariesOf(vtkDataObject* output);
}

#endif
