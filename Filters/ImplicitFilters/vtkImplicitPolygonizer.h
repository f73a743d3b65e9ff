// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImplicitPolygonizer
 * @brief The surface of an implicit function as triangles (thesis 9.3).
 *
 * Input: a model of vtkImplicitFunctionFit, also from a file.
 *
 * Output: triangles in the coordinates of the model, closed, manifold, oriented outward, with point
 * `Normals` from the function's gradient; field data `CellSize`, `SmallestAngle` (degrees) and
 * `Report`. Every constraint of value 0 is a seed, so every component that a contour touches is
 * meshed and no sheet far from all contours.
 *
 * Errors: no model; a CellSize that is negative or would take too many cells (with their number);
 * empty bounds; no surface near the seeds.
 */
#ifndef vtkImplicitPolygonizer_h
#define vtkImplicitPolygonizer_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkContourAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitPolygonizer : public vtkContourAlgorithm
{
public:
  static vtkImplicitPolygonizer* New();
  vtkTypeMacro(vtkImplicitPolygonizer, vtkContourAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DetailType
  {
    Full = 0,
    Medium = 1,
    Coarse = 2
  };

  ///@{
  /**
   * How much the surface may cost. Full, the default, does what the other properties say. Medium
   * makes cells of at least 1/100 of the contours' diagonal, Coarse of 1/50 and leaves the
   * triangles as the cells cut them. All are closed, manifold and oriented, and Report tells a
   * preview.
   */
  vtkSetClampMacro(Detail, int, Full, Coarse);
  vtkGetMacro(Detail, int);
  ///@}

  ///@{
  /**
   * Edge of a cell in the units of the input; 0, the default: from the distance of the contour
   * points and the size of their bounding box. A size that would take too many cells is refused
   * with their number.
   */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Use Bounds instead of the contours' bounding box, enlarged. Off by default.
   */
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  ///@}

  ///@{
  /**
   * Where the surface is followed: xmin, xmax, ymin, ymax, zmin, zmax.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Close the solid where it reaches the bounds. On by default; off leaves a border there.
   */
  vtkSetMacro(ClosedAtBounds, bool);
  vtkGetMacro(ClosedAtBounds, bool);
  vtkBooleanMacro(ClosedAtBounds, bool);
  ///@}

  ///@{
  /**
   * Remove slivers: no triangle with an angle under a degree. On by default.
   */
  vtkSetMacro(CleanUp, bool);
  vtkGetMacro(CleanUp, bool);
  vtkBooleanMacro(CleanUp, bool);
  ///@}

  ///@{
  /**
   * Move the nearest mesh point onto each contour point where that leaves good triangles. Off by
   * default.
   */
  vtkSetMacro(SnapToContours, bool);
  vtkGetMacro(SnapToContours, bool);
  vtkBooleanMacro(SnapToContours, bool);
  ///@}

  ///@{
  /**
   * More cells than this are refused, before and while they are made.
   */
  vtkSetMacro(MaximumCells, double);
  vtkGetMacro(MaximumCells, double);
  ///@}

  ///@{
  /**
   * Number of threads; 0, the default, takes all of the machine. The result does not depend on it.
   */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

protected:
  vtkImplicitPolygonizer() = default;
  ~vtkImplicitPolygonizer() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkImplicitPolygonizer(const vtkImplicitPolygonizer&) = delete;
  void operator=(const vtkImplicitPolygonizer&) = delete;

  int Detail = Full;
  double CellSize = 0.0;
  bool UseBounds = false;
  double Bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  bool ClosedAtBounds = true;
  bool CleanUp = true;
  bool SnapToContours = false;
  double MaximumCells = 4e6;
  int Threads = 0;
};

#endif
