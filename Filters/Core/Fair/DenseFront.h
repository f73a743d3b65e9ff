// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DenseFront.h
 * @brief The dense work of a front of a sparse Cholesky factorisation (FrontalCholesky.h).
 *
 * Matrices are stored by columns, of which the lower triangle is used. Not Eigen's, as that is not compiled
 * for wide registers: fronts of 30 to 250 columns with twice as many rows below take about two thirds of its time.
 */
#ifndef recon_DenseFront_h
#define recon_DenseFront_h

namespace recon
{
/// Cholesky's factor of the first `width` of `rows` rows, in their place; the rows below become those of
/// the factor, too. @returns whether it is positive definite
bool FactorisePanel(double* panel, int rows, int width);

/// Of a square matrix the lower triangle, less that of the product of some rows with their own
/// transpose. @param rows `count` of them, in `width` columns, each `stride` behind the one before
void SubtractOwnProduct(double* square, int count, const double* rows, int stride, int width);
}

#endif
