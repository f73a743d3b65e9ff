// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourMapping
 * @brief Which contours of adjacent levels belong together, and why, as data.
 *
 * Input port 0: vtkPolyData whose closed loops are polylines, polygons or loose two-point segments
 * on parallel planes, as for vtkContourHierarchy; its own output is best, since overrides name
 * contours by `ContourId`. Input port 1, optional: a vtkTable of overrides with columns
 * `LowerContour`, `UpperContour` and `Join` (1 force, 0 forbid); they add to those of the methods
 * below. The table of joins of output port 1 is such a table, with its column `Joined`, or with a
 * column `Join` added to it.
 *
 * Regions are what lies inside a contour and outside the contours directly inside that: solid ones
 * inside outer walls, holes inside the walls of holes. Two regions of the same kind on adjacent
 * levels are joined where their projections share more than OverlapThreshold of the smaller one's
 * area, holes only where the walls around them are joined, too. Areas are exact but for the
 * rounding of the sum.
 *
 * Output port 0: contours as vtkContourHierarchy writes them, with cell arrays `MappingGroupBelow`
 * and `MappingGroupAbove`: the mapping group of the contour with those of the level below, or above
 * (-1 on the first, or last, level). Groups are numbered from 0 through all slabs, lowest slab
 * first. Overrides that cannot be followed are in `Report`. Field data `JoinLower`, `JoinUpper` and
 * `JoinJoined` hold the decisions for vtkPolyhedralSurface behind it, which follows them.
 *
 * Output port 1: vtkTable, a row a decision: `Slab` (0 between the two lowest levels),
 * `LowerContour`, `UpperContour` (ContourId of the wall; -1 for a region with no partner),
 * `LowerContours`, `UpperContours` (text: the wall and the contours directly inside it),
 * `OverlapArea` (square units), `LowerRatio`, `UpperRatio` (OverlapArea / area of the region),
 * `Solid` (1 solid, 0 hole), `Rule` (text), `Joined` (0 or 1), `Words` (a sentence).
 *
 * An empty input gives an empty output. Errors (a sentence through vtkErrorMacro, and no output):
 * no usable contour, a table of overrides without its columns.
 *
 * Thesis chapter 3 (2D shape similarity).
 */
#ifndef vtkContourMapping_h
#define vtkContourMapping_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkContourJoinAlgorithm.h"

class CONTOURFILTERS_EXPORT vtkContourMapping : public vtkContourJoinAlgorithm
{
public:
  static vtkContourMapping* New();
  vtkTypeMacro(vtkContourMapping, vtkContourJoinAlgorithm);

protected:
  vtkContourMapping();
  ~vtkContourMapping() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkContourMapping(const vtkContourMapping&) = delete;
  void operator=(const vtkContourMapping&) = delete;
};

#endif
