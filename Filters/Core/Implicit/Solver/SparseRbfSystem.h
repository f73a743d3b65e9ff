// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SparseRbfSystem.h
 * @brief The factorisation of a kernel that ends: most pairs are 0.
 *
 * Notation: as in RbfSystem.h.
 */
#ifndef recon_SparseRbfSystem_h
#define recon_SparseRbfSystem_h

#include "Implicit/Solver/RbfSystem.h"

namespace recon
{
/// Sparse Cholesky of Phi alone (Wendland); the polynomial of the solution is 0. @returns
/// nullptr where the matrix is not positive definite to working precision.
std::unique_ptr<RbfSystem> FactoriseSparse(const RbfProblem& problem, Monitor& monitor);
}

#endif
