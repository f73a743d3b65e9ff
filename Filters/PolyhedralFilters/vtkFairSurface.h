// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFairSurface
 * @brief Parallel contours in, a smooth closed surface with the topology of vtkPolyhedralSurface
 * out.
 *
 * Input: as of vtkPolyhedralSurface, and so are the properties that say what is joined to what and
 * how the surface ends.
 *
 * Output: even triangles in the coordinates and unit of the input that bound a solid: closed,
 * oriented outward, a manifold of the same topology as the polyhedral surface, not crossing itself.
 * It bends as little as contours allow: each contour vertex lies within Tolerance of it, or Report
 * counts those that do not.
 * - field data: `Report`, `LevelNormal`, `LevelOffset`, `ContourCount`, `LeftOutCount`,
 *   `Tolerance`, `EdgeLength` and `Tension` (what was chosen), `FarthestVertex` (distance of a
 *   contour vertex from the surface), `BeyondTolerance` (contour vertices), `ThinTriangles` (with an
 *   angle below 5 degrees), `HeldBackPoints`.
 *
 * Errors (a sentence through vtkErrorMacro, and no output): those of vtkPolyhedralSurface.
 */
#ifndef vtkFairSurface_h
#define vtkFairSurface_h

#include "PolyhedralFiltersModule.h" // for the export macro
#include "vtkPolyhedralAlgorithm.h"

class POLYHEDRALFILTERS_EXPORT vtkFairSurface : public vtkPolyhedralAlgorithm
{
public:
  static vtkFairSurface* New();
  vtkTypeMacro(vtkFairSurface, vtkPolyhedralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How far the surface may leave a drawn contour, in the units of the input. Negative, the default,
   * is automatic: half the staircase step of contours that follow pixels, a twentieth of the slices'
   * distance of others.
   */
  vtkSetClampMacro(Tolerance, double, -1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * What edges of the triangles should have, in the units of the input. 0, the default, is
   * automatic: three tenths of the slices' distance, more where there would be too many triangles.
   */
  vtkSetClampMacro(EdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /// From 0, as smooth as may be, to 1, as the polyhedral surface. Negative, the default, is
  /// automatic.
  vtkSetClampMacro(Tension, double, -1.0, 1.0);
  vtkGetMacro(Tension, double);
  ///@}

protected:
  vtkFairSurface() = default;
  ~vtkFairSurface() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkFairSurface(const vtkFairSurface&) = delete;
  void operator=(const vtkFairSurface&) = delete;

  double Tolerance = -1;
  double EdgeLength = 0;
  double Tension = -1;
};

#endif
