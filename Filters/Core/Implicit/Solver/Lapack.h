// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Lapack.h
 * @brief The few routines of the system's BLAS and LAPACK that are called (any provider;
 * column-major).
 *
 * Declared here because Debian's providers do not agree on a C header; the Fortran names are the
 * standard.
 */
#ifndef recon_Lapack_h
#define recon_Lapack_h

extern "C"
{
  void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
  void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m,
    const int* n, const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
  void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha,
    const double* a, const int* lda, const double* beta, double* c, const int* ldc);
  void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
    const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
    const double* beta, double* c, const int* ldc);
  void dlaswp_(const int* n, double* a, const int* lda, const int* k1, const int* k2,
    const int* ipiv, const int* incx);
  void dpotrs_(const char* uplo, const int* n, const int* nrhs, const double* a, const int* lda,
    double* b, const int* ldb, int* info);
  void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
  void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda,
    const int* ipiv, double* b, const int* ldb, int* info);
}

#endif
