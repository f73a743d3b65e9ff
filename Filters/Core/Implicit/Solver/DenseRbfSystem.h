// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DenseRbfSystem.h
 * @brief The two ways to factorise a system of all pairs.
 *
 * Notation: as in RbfSystem.h.
 */
#ifndef recon_DenseRbfSystem_h
#define recon_DenseRbfSystem_h

#include "Implicit/Solver/RbfSystem.h"

#include <cstddef>

namespace recon
{
/**
 * Q2^T Phi Q2 is positive definite for |r|^3, so Cholesky does: n^3/3 operations on one triangle.
 * @returns nullptr where the matrix is not positive definite to working precision.
 */
std::unique_ptr<RbfSystem> FactoriseProjected(const RbfProblem& problem, Monitor& monitor);

/// LU with partial pivoting of the whole (n + 4) x (n + 4) matrix; nullptr where it is singular.
std::unique_ptr<RbfSystem> FactoriseLU(const RbfProblem& problem, Monitor& monitor);

/// How much memory the dense factorisations take, in gigabytes.
double ProjectedGigabytes(std::size_t constraints);
double LUGigabytes(std::size_t constraints);
}

#endif
