// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImplicitConstraints
 * @brief Constraint points of an implicit function from contours in any planes (thesis 9.1,
 * algorithm 13).
 *
 * Input: vtkPolyData whose closed loops are polylines, polygons or loose two-point segments, on two
 * or more planes of any orientation, in any unit.
 *
 * Output: points (with vertex cells) in the coordinates of the input, exactly three a contour
 * vertex: point arrays `Value` (0 on the contour, positive inside the solid, negative outside),
 * `Kind` (0, 1, -1), `ContourId`; field data `MarginDistance`, `SmallestContourArea` (of any contour,
 * in square units) and `Report` (a line for everything repaired, merged or left out).
 *
 * Errors (a sentence through vtkErrorMacro, and no output): no usable contour; all contours on one
 * plane; options of no sense.
 */
#ifndef vtkImplicitConstraints_h
#define vtkImplicitConstraints_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkImplicitMethodAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitConstraints : public vtkImplicitMethodAlgorithm
{
public:
  static vtkImplicitConstraints* New();
  vtkTypeMacro(vtkImplicitConstraints, vtkImplicitMethodAlgorithm);

protected:
  vtkImplicitConstraints() = default;
  ~vtkImplicitConstraints() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkImplicitConstraints(const vtkImplicitConstraints&) = delete;
  void operator=(const vtkImplicitConstraints&) = delete;
};

#endif
