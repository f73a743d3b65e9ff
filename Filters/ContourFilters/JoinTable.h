// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JoinTable.h
 * @brief Decisions of the mapping as a vtkTable, and overrides out of one.
 */
#ifndef JoinTable_h
#define JoinTable_h

#include "ContourFiltersModule.h" // for export macro
#include "Contours/CarriedMapping.h"
#include "Contours/ContourMapping.h"

#include <optional>
#include <string>

class vtkDataObject;
class vtkPolyData;
class vtkTable;

namespace recon
{
/**
 * Appends a table's rows to the forced and forbidden joins.
 *
 * Columns `LowerContour`, `UpperContour` (ContourId; either order) and `Join` (1 force, 0 forbid)
 * of any type that holds whole numbers, also text such as a CSV file gives; where there is no
 * `Join`, `Joined` is it, so that a table that WriteJoins made is followed as it is. A row with -1
 * for a contour or an empty `Join` asks for nothing. Further columns do not matter.
 *
 * @throws Error where a column is missing or a value is no number of that kind
 */
CONTOURFILTERS_EXPORT void ReadJoinOverrides(vtkTable* table, ContourMappingOptions& options);

/**
 * A row a decision: `Slab`, `LowerContour`, `UpperContour` (the walls; -1: the empty region),
 * `LowerContours`, `UpperContours` (text: the wall, then the contours directly inside it),
 * `OverlapArea`, `LowerRatio`, `UpperRatio`, `Solid` (1 solid, 0 hole), `Rule` (text), `Joined`,
 * `Words`, and the same as `Decision`.
 */
CONTOURFILTERS_EXPORT void WriteJoins(const ContourMapping& mapping, vtkTable* table);

/**
 * The decisions about pairs of contours as field data of the contours, so that they are not
 * forgotten by what comes next: `JoinLower`, `JoinUpper` (ContourId) and `JoinJoined` (0 or 1).
 */
CONTOURFILTERS_EXPORT void WriteMapping(const ContourMapping& mapping, vtkDataObject* output);

/// What WriteMapping wrote; nothing where no mapping came with the contours.
[[nodiscard]] CONTOURFILTERS_EXPORT std::optional<CarriedMapping> CarriedMappingOf(
  vtkPolyData* input);

/**
 * Appends what WriteMapping wrote on the input to the forced and forbidden joins, but for pairs
 * that these name already.
 *
 * @param contours that the input became; their order may be another
 * @return a sentence for Report; empty where no mapping came with the contours
 */
[[nodiscard]] CONTOURFILTERS_EXPORT std::string ReadMapping(
  vtkPolyData* input, const ContourSet& contours, ContourMappingOptions& options);
}

#endif
