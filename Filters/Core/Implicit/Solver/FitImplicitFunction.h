// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FitImplicitFunction.h
 * @brief From constraints to the function that takes their values (thesis 8.3, 9.2, algorithm 14).
 *
 * Notation: as in ImplicitFunction.h.
 */
#ifndef recon_FitImplicitFunction_h
#define recon_FitImplicitFunction_h

#include "Implicit/ImplicitFunction.h"

#include <cstddef>
#include <vector>

namespace recon
{
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
