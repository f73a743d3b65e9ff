// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImplicitContours
 * @brief Contours of an implicit function on parallel planes, or on those of a second input
 * (thesis 9.3.1).
 *
 * First input: a model of vtkImplicitFunctionFit. Second input (optional): contours, whose planes
 * are used, or an image, whose slices (along its third axis) are.
 *
 * Output: closed polylines in the coordinates of the model with cell arrays `Level`, `ContourId`,
 * `Depth`, `Parent`, `SignedArea` and field data `LevelNormal`, `LevelOffset`, `Report`: oriented
 * and nested, as Polyhedral Surface reads them.
 *
 * Errors: no model; no plane; no plane lies between the outermost contour points, or meets the
 * surface; a CellSize that would take too many
 * cells.
 */
#ifndef vtkImplicitContours_h
#define vtkImplicitContours_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkContourAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitContours : public vtkContourAlgorithm
{
public:
  static vtkImplicitContours* New();
  vtkTypeMacro(vtkImplicitContours, vtkContourAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Also trace on planes of the second input that lie beyond the outermost contour points of the
   * model, where the surface closes. Off by default, as nobody drew anything there: such planes are
   * left out, with a line in `Report`, but for those that the outermost points lie beside by less
   * than the planes' `ContourTolerance` (field data of vtkDICOMSlicePlanes), or by a twentieth of
   * the planes' distance where they do not tell one. A Range is followed in any case.
   */
  vtkSetMacro(Extrapolate, bool);
  vtkGetMacro(Extrapolate, bool);
  vtkBooleanMacro(Extrapolate, bool);
  ///@}

  ///@{
  /**
   * Contours of a smaller area are left out, with a line in `Report`; in square units of the input.
   * 0, the default: those that are smaller than a pixel of the images (cell array `PixelArea` of the
   * planes) and than half of any contour that was drawn; none where planes tell no pixels. Negative:
   * none.
   */
  vtkSetMacro(SmallestArea, double);
  vtkGetMacro(SmallestArea, double);
  ///@}

  ///@{
  /**
   * Normal of the planes, of any length, where there is no second input.
   */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /**
   * Use Range instead of the extent of the model's contours along PlaneNormal. Off by default.
   */
  vtkSetMacro(UseRange, bool);
  vtkGetMacro(UseRange, bool);
  vtkBooleanMacro(UseRange, bool);
  ///@}

  ///@{
  /**
   * First and last offset of the planes along the unit normal from the origin, in the units of the
   * input.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /**
   * Distance of the planes in the units of the input; 0, the default: 20 intervals over the range.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
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
  vtkImplicitContours();
  ~vtkImplicitContours() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkImplicitContours(const vtkImplicitContours&) = delete;
  void operator=(const vtkImplicitContours&) = delete;

  bool Extrapolate = false;
  double SmallestArea = 0.0;
  double PlaneNormal[3] = { 0.0, 0.0, 1.0 };
  bool UseRange = false;
  double Range[2] = { 0.0, 1.0 };
  double Spacing = 0.0;
  double CellSize = 0.0;
  bool UseBounds = false;
  double Bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  double MaximumCells = 4e6;
  int Threads = 0;
};

#endif
