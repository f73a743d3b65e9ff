// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImplicitSurface
 * @brief The whole Implicit Surface Method in one filter: contours in any planes in, a smooth
 * closed surface out.
 *
 * Input: vtkPolyData whose closed loops are polylines, polygons or loose two-point segments, on two
 * or more planes of any orientation, in any unit.
 *
 * Output: triangles in the coordinates of the input, closed, manifold, oriented outward, without
 * slivers, with point `Normals`; field data `Residual`, `MarginDistance`, `CellSize`, `SmallestAngle`
 * (degrees), `ConstraintCount` and `Report` (of all stages).
 *
 * Errors (a sentence through vtkErrorMacro, and no output): no usable contour; all contours on one
 * plane; options of no sense; a system too large; a CellSize that would take too many cells.
 *
 * Thesis part III: chapters 8 and 9.
 */
#ifndef vtkImplicitSurface_h
#define vtkImplicitSurface_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkImplicitMethodAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitSurface : public vtkImplicitMethodAlgorithm
{
public:
  static vtkImplicitSurface* New();
  vtkTypeMacro(vtkImplicitSurface, vtkImplicitMethodAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DetailType
  {
    Full = 0,
    Medium = 1,
    Coarse = 2
  };

  ///@{
  /**
   * How much the surface may cost. Full, the default, does what the other properties say. Coarse
   * and Medium are previews while properties are set: some 700 or 1 000 of the contours' points,
   * margins in the planes, one fit, cells of at least 1/50 or 1/100 of the contours' diagonal;
   * Coarse leaves the triangles as the cells cut them and takes less than a second, Medium some
   * seconds. All are closed, manifold and oriented, and Report tells a preview. Normals, ThinOut,
   * ResampleSpacing, ResampleTolerance and CentreReduction are without effect in previews.
   */
  vtkSetClampMacro(Detail, int, Full, Coarse);
  vtkGetMacro(Detail, int);
  ///@}

  enum KernelType
  {
    Triharmonic = 0,
    Wendland = 1
  };

  ///@{
  /**
   * Triharmonic |r|^3 (default), or Wendland's compactly supported function with a sparse solver
   * (thesis 12.3).
   */
  vtkSetClampMacro(Kernel, int, Triharmonic, Wendland);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Support of Wendland's function, in the units of the input; 0: a quarter of the bounding box's
   * diagonal.
   */
  vtkSetMacro(SupportRadius, double);
  vtkGetMacro(SupportRadius, double);
  ///@}

  enum SolverType
  {
    Automatic = 0,
    LU = 1,
    Direct = 2,
    Iterative = 3
  };

  ///@{
  /**
   * Automatic (default): Direct, Cholesky's factorisation, for a few thousand constraints, as its
   * time grows with their cube, and Iterative, preconditioned conjugate gradients, for more. LU is
   * the thesis's, with twice the work of Direct. All give the same function, Iterative to
   * Tolerance.
   */
  vtkSetClampMacro(Solver, int, Automatic, Iterative);
  vtkGetMacro(Solver, int);
  ///@}

  ///@{
  /**
   * Largest misfit at a constraint that the iterative solver is content with, in the unit of Value;
   * 0, the default: a hundred thousandth of half the range of the values. Where it is not reached,
   * Report says so.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * 0, the default: every constraint is a centre of the function. Larger: the fewest centres, found
   * greedily (Carr and others 2001), with which no constraint is missed by more than this, in the
   * unit of Value. Report tells how many.
   */
  vtkSetMacro(CentreReduction, double);
  vtkGetMacro(CentreReduction, double);
  ///@}

  ///@{
  /**
   * 0, the default: constraints are met exactly. Larger values (1e-6 little, 1e-3 much) let the
   * function miss them and be smoother; no unit.
   */
  vtkSetMacro(Smoothing, double);
  vtkGetMacro(Smoothing, double);
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
   * Without Bounds, slices parallel to a coordinate plane: the solid ends, rounded off or else flat,
   * at most so many slice distances beyond the outermost ones; 0.4 by default. 0.5 is the half slice
   * that planning systems count, 0 ends at the outermost slices.
   */
  vtkSetMacro(EndsBeyond, double);
  vtkGetMacro(EndsBeyond, double);
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

protected:
  vtkImplicitSurface() = default;
  ~vtkImplicitSurface() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkImplicitSurface(const vtkImplicitSurface&) = delete;
  void operator=(const vtkImplicitSurface&) = delete;

  int Detail = Full;
  int Kernel = Triharmonic;
  double SupportRadius = 0.0;
  int Solver = Automatic;
  double Tolerance = 0.0;
  double CentreReduction = 0.0;
  double Smoothing = 0.0;
  double CellSize = 0.0;
  double EndsBeyond = 0.4;
  bool UseBounds = false;
  double Bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  bool ClosedAtBounds = true;
  bool CleanUp = true;
  bool SnapToContours = false;
  double MaximumCells = 4e6;
};

#endif
