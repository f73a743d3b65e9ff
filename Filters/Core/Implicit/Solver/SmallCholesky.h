// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SmallCholesky.h
 * @brief Cholesky's factorisation of some hundred rows, for very many of them (InverseCholesky.h).
 *
 * Matrices are stored by columns, of which the lower triangle is used.
 *
 * The factorisation is not Eigen's LLT, which takes 1.5 times as long for 80 rows, 1.3 times for 150
 * and 1.2 times for 250, as it is not compiled for wide registers; the solution is Eigen's.
 */
#ifndef recon_SmallCholesky_h
#define recon_SmallCholesky_h

namespace recon
{
/// Right-hand sides that are solved for side by side.
constexpr int SolvedTogether = 8;

/**
 * One column of the projected kernels K (InverseCholesky.h) from row j on. @param data the
 * coordinates and the eight rows of l and q, each `size` long
 */
void FillProjectedColumn(const double* data, int size, int j, double lambda, double* column);

/// Cholesky's factor in place of the lower triangle. @returns false at the first pivot that is not
/// sure in doubles.
bool FactoriseSmall(double* a, int size);

/// x := L^-T x for SolvedTogether right-hand sides beside one another, rows [0, last].
void SolveTransposed(const double* factor, int size, int last, double* x);

double DotOf(const double* a, const double* b, int count);

/// a -= factor column.
void SubtractColumn(double* a, const double* column, double factor, int count);
}

#endif
