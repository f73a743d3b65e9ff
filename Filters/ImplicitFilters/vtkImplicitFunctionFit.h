// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImplicitFunctionFit
 * @brief The implicit function through constraint points (thesis 8.3, 9.2, algorithm 14).
 *
 * Input: vtkPolyData with a point array `Value` (vtkImplicitConstraints gives it; any other source
 * will do).
 *
 * Output: the model, as data that can be saved as .vtp and used again: points = centres, point
 * arrays `Weight` and `Value`; field data `Polynomial` (p0..p3, about `Origin`), `Origin`,
 * `Kernel`, `SupportRadius`, `Residual` (the largest misfit, evaluated, in the unit of Value) and
 * `Report`. f(x) = sum of Weight times |x - centre|^3, plus p0 + (p1, p2, p3) . (x - Origin).
 *
 * Errors: no array Value; fewer than four points; all in one plane; all of one value; NaN; a system
 * too large for memory or singular.
 */
#ifndef vtkImplicitFunctionFit_h
#define vtkImplicitFunctionFit_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitFunctionFit : public vtkPolyDataAlgorithm
{
public:
  static vtkImplicitFunctionFit* New();
  vtkTypeMacro(vtkImplicitFunctionFit, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
    ProjectedCholesky = 0,
    LU = 1
  };

  ///@{
  /**
   * ProjectedCholesky (default) or the thesis's LU, which takes twice the work.
   */
  vtkSetClampMacro(Solver, int, ProjectedCholesky, LU);
  vtkGetMacro(Solver, int);
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
   * Number of threads; 0, the default, takes all of the machine. The result does not depend on it.
   */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

protected:
  vtkImplicitFunctionFit() = default;
  ~vtkImplicitFunctionFit() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkImplicitFunctionFit(const vtkImplicitFunctionFit&) = delete;
  void operator=(const vtkImplicitFunctionFit&) = delete;

  int Kernel = Triharmonic;
  double SupportRadius = 0.0;
  int Solver = ProjectedCholesky;
  double Smoothing = 0.0;
  int Threads = 0;
};

#endif
