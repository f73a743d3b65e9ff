// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImplicitFunction.h
 * @brief The function whose zero set is the surface (thesis 8.3, 9.2, algorithm 14).
 *
 * Notation:
 *   c_j      location of a constraint
 *   h_j      its value (Constraints.h: 0 on the surface, > 0 inside, < 0 outside)
 *   w_j      its weight
 *   p0..p3   the polynomial
 *   f(x) = sum_j w_j phi(|x - c_j|) + p0 + (p1, p2, p3) . (x - Origin)      (equation 8.2)
 */
#ifndef recon_ImplicitFunction_h
#define recon_ImplicitFunction_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Implicit/Kernel.h"

#include <array>
#include <string>
#include <vector>

namespace recon
{
/**
 * @class ImplicitFunction
 * @brief A fitted function as data: everything that is needed to evaluate it again.
 *
 * Coordinates and distances are in the units of the input, f has those of the constraints' values.
 */
class ImplicitFunction
{
public:
  Kernel Phi;
  std::vector<Point3> Centres;
  std::vector<double> Values; ///< h_j, what f was asked to be at the centres (after merging)
  std::vector<double> Weights;
  /// p0..p3, about Origin: far from zero (scanner coordinates) absolute coefficients would cancel.
  std::array<double, 4> Polynomial{ 0, 0, 0, 0 };
  Point3 Origin{ 0, 0, 0 };
  /// Largest |f(c_j) - h_j|, evaluated, never an estimate: by exact sums, at a sample that Report
  /// states where there are very many.
  double Residual = 0;
  int Iterations = 0; ///< steps of the iterative solver; 0: solved directly
  std::vector<std::string>
    Report; ///< a sentence for everything merged, or that the user should know

  double Value(const Point3& x) const;
  Vector3 Gradient(const Point3& x) const;

  /// f at many points; the result is the same, to the last bit, for any number of threads (0 =
  /// all).
  std::vector<double> Evaluate(const std::vector<Point3>& points, int threads) const;
  std::vector<Vector3> EvaluateGradients(const std::vector<Point3>& points, int threads) const;

  /// The polynomial about the origin of the coordinates, as other software prints it.
  std::array<double, 4> AbsolutePolynomial() const;

  /// @throws Error where the parts do not fit together (a model that was read from a file).
  void Validate() const;
};

struct FunctionOptions
{
  /// 1 is LU as it was before there was a choice.
  enum SolverType
  {
    /// Direct where that is estimated to be faster and fits into memory, else Iterative.
    Automatic = 0,
    /// The thesis's: LU of equation 8.4 as it stands.
    LU = 1,
    /// Cholesky's factorisation on the space orthogonal to the polynomials: half the work of LU.
    Direct = 2,
    /// Preconditioned conjugate gradients to Tolerance: time grows in proportion to the
    /// constraints.
    Iterative = 3
  };

  Kernel::KindType Kind = Kernel::Triharmonic;
  double SupportRadius = 0; ///< Wendland only; 0 = a quarter of the bounding box's diagonal
  SolverType Solver = Automatic;
  /**
   * The largest misfit that Iterative is content with, in the unit of the values; 0: a hundred
   * thousandth of half their range (1e-5 for +1 and -1).
   */
  double Tolerance = 0;
  /// 0: every constraint is a centre. Larger: the fewest centres that greed finds with which no
  /// constraint is missed by more than this, in the unit of the values (CentreReduction.h).
  double CentreReduction = 0;
  /**
   * 0: f takes the values exactly. Larger: added to the diagonal of the system in unit-ball
   * coordinates, so it has no unit (1e-6 irons out noise, 1e-3 is very smooth); the misfit at c_j
   * is Smoothing x w_j there.
   */
  double Smoothing = 0;
  /// Constraints nearer than this part of the bounding box's diagonal are one (else the matrix is
  /// singular).
  double MergeTolerance = 1e-9;
  /// A system that needs more is refused before it is built; 0: four fifths of what the machine has
  /// free.
  double MaxGigabytes = 0;
  int Threads = 0;
};

/// What Automatic comes to for so many constraints of the triharmonic kernel.
FunctionOptions::SolverType ChooseSolver(std::size_t constraints, const FunctionOptions& options);

/**
 * Algorithm 14. Solved in coordinates centred and scaled to the unit ball, for the conditioning,
 * with iterative refinement; given back in the units of the input.
 *
 * Wendland's function has no polynomial but a constant, the least of the values: far from all
 * constraints f is "outside", also deep inside a body that is thicker than the support radius.
 *
 * @throws Error on fewer than four constraints, coplanar ones, NaN, all values equal, a system too
 * large, and a matrix that cannot be factorised; Aborted. A Tolerance that is not reached is no
 * error: the best function found is returned, with a sentence in Report.
 */
ImplicitFunction FitImplicitFunction(const std::vector<Point3>& points,
  const std::vector<double>& values, const FunctionOptions& options, Monitor& monitor);
}

#endif
