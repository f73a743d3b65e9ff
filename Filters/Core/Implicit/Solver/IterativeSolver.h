// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file IterativeSolver.h
 * @brief Equation 8.4 of the thesis for as many constraints as there are, by conjugate gradients.
 *
 * Notation: as in RbfSystem.h and InverseCholesky.h. Conjugate gradients run on E^T Phi E, which is
 * positive definite; the weights stay orthogonal to the linear polynomials throughout.
 */
#ifndef recon_IterativeSolver_h
#define recon_IterativeSolver_h

#include "Implicit/Solver/RbfSystem.h"

namespace recon
{
struct IterativeResult
{
  RbfSolution Solution;
  double Misfit = 0; ///< largest |h - Phi w - lambda w - P p|, from the weights, not from recursion
  int Iterations = 0;
  bool Converged = false;
};

/**
 * Solve the triharmonic system to a largest misfit of `tolerance`, in the unit of h.
 *
 * Ends where the misfit is reached, or where it no longer falls (rounding, or constraints that
 * contradict each other at nearly one place): then Converged is false and the best weights found
 * are returned. The result is the same for any number of threads.
 *
 * @param problem at least five points, not all in one plane.
 * @throws Aborted.
 */
IterativeResult SolveIteratively(
  const RbfProblem& problem, const std::vector<double>& h, double tolerance, Monitor& monitor);

/// How much memory that takes, in gigabytes.
double IterativeGigabytes(std::size_t constraints);
}

#endif
