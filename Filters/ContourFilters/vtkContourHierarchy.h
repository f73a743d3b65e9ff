// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourHierarchy
 * @brief Any closed loops in, oriented and nested contours out.
 *
 * Input: vtkPolyData whose closed loops are polylines, polygons or loose two-point segments (what
 * Slice and Contour give), on planes of any number and orientation, in any unit, order and sense of
 * rotation.
 *
 * The filter chains and closes what is loose, finds the planes, resolves what touches, overlaps or
 * crosses within a plane by the HoleRule (bridges of keyhole contours are cut by every rule), nests
 * the contours of every plane, and turns outer walls counterclockwise and walls of holes clockwise
 * about the normal of their plane. Points that stay keep their coordinates to the last bit; nothing
 * is moved or smoothed.
 *
 * Output: closed polylines whose last point is the first, sorted by level, in the coordinates and
 * unit of the input.
 * - cell arrays: `Level` (by increasing offset along the normal where all planes are parallel, else
 * in the order of the input), `ContourId`, `Depth` (even = outer wall), `Parent` (ContourId or -1),
 * `SignedArea` (square units, negative for holes), and the arrays of the input cell that a contour
 * came from;
 * - field data: `LevelNormal`, `LevelOffset` and `LevelThickness` (a value a level), `LevelHoleRule` (a sentence a
 * level: the rule that was applied, and how its holes were drawn), `Report` (a line for every
 * contour repaired or left out, and why), and the arrays of the input.
 *
 * An empty input gives an empty output. Errors (a sentence through vtkErrorMacro, and no output):
 * cells, but not one usable contour.
 *
 * Thesis 2.1 (levels) and 3.1 (orientation and inclusion).
 */
#ifndef vtkContourHierarchy_h
#define vtkContourHierarchy_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkContourSetAlgorithm.h"

class CONTOURFILTERS_EXPORT vtkContourHierarchy : public vtkContourSetAlgorithm
{
public:
  static vtkContourHierarchy* New();
  vtkTypeMacro(vtkContourHierarchy, vtkContourSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Keep only contours whose planes are parallel to those of most contours, and list the others in
   * `Report`. Off by default: planes of any orientation are levels.
   */
  vtkSetMacro(ParallelPlanesOnly, bool);
  vtkGetMacro(ParallelPlanesOnly, bool);
  vtkBooleanMacro(ParallelPlanesOnly, bool);
  ///@}

protected:
  vtkContourHierarchy() = default;
  ~vtkContourHierarchy() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkContourHierarchy(const vtkContourHierarchy&) = delete;
  void operator=(const vtkContourHierarchy&) = delete;

  bool ParallelPlanesOnly = false;
};

#endif
