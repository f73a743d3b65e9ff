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
 * `Kernel`, `SupportRadius`, `Residual` (the largest misfit, evaluated, in the unit of Value),
 * `Iterations` (of the iterative solver; 0: solved directly) and `Report`. f(x) = sum of Weight
 * times |x - centre|^3, plus p0 + (p1, p2, p3) . (x - Origin).
 *
 * Errors: no array Value; fewer than four points; all in one plane; all of one value; NaN; a system
 * too large for memory or singular.
 */
#ifndef vtkImplicitFunctionFit_h
#define vtkImplicitFunctionFit_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkContourAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitFunctionFit : public vtkContourAlgorithm
{
public:
  static vtkImplicitFunctionFit* New();
  vtkTypeMacro(vtkImplicitFunctionFit, vtkContourAlgorithm);
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
  int Solver = Automatic;
  double Tolerance = 0.0;
  double CentreReduction = 0.0;
  double Smoothing = 0.0;
  int Threads = 0;
};

#endif
