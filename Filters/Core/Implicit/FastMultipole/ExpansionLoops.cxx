// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/ExpansionLoops.h"

#include "Base/SimdClones.h"

#include <cmath>

namespace recon
{
namespace
{
constexpr int L = ExpansionLanes;
constexpr int Terms = LargestOrder + 1; ///< of a polynomial of that order

/// T_0..T_p at the lanes' places on one axis.
struct ChebyshevValues
{
  alignas(64) double T[Terms][L];
};

/// And their derivatives.
struct ChebyshevSlopes
{
  alignas(64) double D[Terms][L];
};
}

// The helpers repeat in each version of a loop: a function that is not cloned is not inlined into
// one that is.
#define RECON_FILL_VALUES(table, at)                                             \
  for (int b = 0; b < L; ++b)                                                    \
  {                                                                              \
    (table).T[0][b] = 1;                                                         \
    (table).T[1][b] = (at)[b];                                                   \
  }                                                                              \
  for (int k = 2; k <= order; ++k)                                               \
  {                                                                              \
    for (int b = 0; b < L; ++b)                                                  \
    {                                                                            \
      (table).T[k][b] = 2 * (at)[b] * (table).T[k - 1][b] - (table).T[k - 2][b]; \
    }                                                                            \
  }

RECON_CLONES_WIDEST void Apply(const SparseOperator& op, const double* x, double* y)
{
  const int rows = op.Rows();
  const std::int32_t* start = op.RowStart.data();
  const std::int32_t* column = op.Column.data();
  const double* value = op.Value.data();
  for (int i = 0; i < rows; ++i)
  {
    alignas(64) double sum[L] = {};
    for (std::int32_t e = start[i]; e < start[i + 1]; ++e)
    {
      const double v = value[e];
      const double* from = x + static_cast<std::size_t>(column[e]) * L;
      for (int b = 0; b < L; ++b)
      {
        sum[b] += v * from[b];
      }
    }
    for (int b = 0; b < L; ++b)
    {
      y[static_cast<std::size_t>(i) * L + b] = sum[b];
    }
  }
}

RECON_CLONES_WIDEST void Multiply(const DenseProduct& product)
{
  constexpr int Block = 4; ///< rows at once
  const std::size_t lda = product.LdA;
  const std::size_t ldb = product.LdB;
  const std::size_t ldc = product.LdC;
  for (int i = 0; i < product.Rows; i += Block)
  {
    // A short last block repeats its last row.
    const double* a[Block];
    double* c[Block];
    for (int r = 0; r < Block; ++r)
    {
      const std::size_t row = i + r < product.Rows ? i + r : product.Rows - 1;
      a[r] = product.A + row * lda;
      c[r] = product.C + row * ldc;
    }
    int j = 0;
    for (; j + L <= product.Columns; j += L)
    {
      alignas(64) double sum[Block][L] = {};
      const double* b = product.B + j;
      for (int k = 0; k < product.Depth; ++k, b += ldb)
      {
        for (int q = 0; q < L; ++q)
        {
          sum[0][q] += a[0][k] * b[q];
          sum[1][q] += a[1][k] * b[q];
          sum[2][q] += a[2][k] * b[q];
          sum[3][q] += a[3][k] * b[q];
        }
      }
      for (int r = 0; r < Block; ++r)
      {
        for (int q = 0; q < L; ++q)
        {
          c[r][j + q] = sum[r][q];
        }
      }
    }
    for (; j < product.Columns; ++j)
    {
      for (int r = 0; r < Block; ++r)
      {
        double sum = 0;
        for (int k = 0; k < product.Depth; ++k)
        {
          sum += a[r][k] * product.B[k * ldb + j];
        }
        c[r][j] = sum;
      }
    }
  }
}

RECON_CLONES_WIDEST void AddMoments(int order, const LanePoints& at, const Lane& w, double* moments)
{
  const double* weights = w.data();
  ChebyshevValues x;
  ChebyshevValues y;
  ChebyshevValues z;
  RECON_FILL_VALUES(x, at.X.data())
  RECON_FILL_VALUES(y, at.Y.data())
  RECON_FILL_VALUES(z, at.Z.data())
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; i + j <= order; ++j)
    {
      alignas(64) double wxy[L];
      for (int b = 0; b < L; ++b)
      {
        wxy[b] = weights[b] * x.T[i][b] * y.T[j][b];
      }
      for (int k = 0; i + j + k <= order; ++k)
      {
        // Halves onto halves, so that the compiler may add side by side.
        alignas(64) double part[L];
        for (int b = 0; b < L; ++b)
        {
          part[b] = wxy[b] * z.T[k][b];
        }
        for (int width = L / 2; width > 0; width /= 2)
        {
          for (int b = 0; b < width; ++b)
          {
            part[b] += part[b + width];
          }
        }
        *moments++ += part[0];
      }
    }
  }
}

RECON_CLONES_WIDEST void ExpandValues(
  int order, const double* local, const LanePoints& at, Lane& values)
{
  ChebyshevValues x;
  ChebyshevValues y;
  ChebyshevValues z;
  RECON_FILL_VALUES(x, at.X.data())
  RECON_FILL_VALUES(y, at.Y.data())
  RECON_FILL_VALUES(z, at.Z.data())
  alignas(64) double sum[L] = {};
  for (int i = 0; i <= order; ++i)
  {
    alignas(64) double plane[L] = {};
    for (int j = 0; i + j <= order; ++j)
    {
      alignas(64) double line[L] = {};
      for (int k = 0; i + j + k <= order; ++k)
      {
        const double c = *local++;
        for (int b = 0; b < L; ++b)
        {
          line[b] += c * z.T[k][b];
        }
      }
      for (int b = 0; b < L; ++b)
      {
        plane[b] += line[b] * y.T[j][b];
      }
    }
    for (int b = 0; b < L; ++b)
    {
      sum[b] += plane[b] * x.T[i][b];
    }
  }
  for (int b = 0; b < L; ++b)
  {
    values[b] = sum[b];
  }
}

// d_k = T_k': d_0 = 0, d_1 = 1, d_k = 2 T_{k-1} + 2 x d_{k-1} - d_{k-2}.
#define RECON_FILL_SLOPES(slopes, table, at)                                                 \
  for (int b = 0; b < L; ++b)                                                                \
  {                                                                                          \
    (slopes).D[0][b] = 0;                                                                    \
    (slopes).D[1][b] = 1;                                                                    \
  }                                                                                          \
  for (int k = 2; k <= order; ++k)                                                           \
  {                                                                                          \
    for (int b = 0; b < L; ++b)                                                              \
    {                                                                                        \
      (slopes).D[k][b] =                                                                     \
        2 * (table).T[k - 1][b] + 2 * (at)[b] * (slopes).D[k - 1][b] - (slopes).D[k - 2][b]; \
    }                                                                                        \
  }

RECON_CLONES_WIDEST void ExpandGradients(
  int order, const double* local, const LanePoints& at, Lane& values, LanePoints& gradients)
{
  ChebyshevValues x;
  ChebyshevValues y;
  ChebyshevValues z;
  RECON_FILL_VALUES(x, at.X.data())
  RECON_FILL_VALUES(y, at.Y.data())
  RECON_FILL_VALUES(z, at.Z.data())
  ChebyshevSlopes dx;
  ChebyshevSlopes dy;
  ChebyshevSlopes dz;
  RECON_FILL_SLOPES(dx, x, at.X.data())
  RECON_FILL_SLOPES(dy, y, at.Y.data())
  RECON_FILL_SLOPES(dz, z, at.Z.data())
  alignas(64) double sum[4][L] = {};
  for (int i = 0; i <= order; ++i)
  {
    // Sums over j and k of the coefficient with T T, D T and T D.
    alignas(64) double plane[3][L] = {};
    for (int j = 0; i + j <= order; ++j)
    {
      alignas(64) double line[L] = {};
      alignas(64) double slope[L] = {};
      for (int k = 0; i + j + k <= order; ++k)
      {
        const double c = *local++;
        for (int b = 0; b < L; ++b)
        {
          line[b] += c * z.T[k][b];
          slope[b] += c * dz.D[k][b];
        }
      }
      for (int b = 0; b < L; ++b)
      {
        plane[0][b] += line[b] * y.T[j][b];
        plane[1][b] += line[b] * dy.D[j][b];
        plane[2][b] += slope[b] * y.T[j][b];
      }
    }
    for (int b = 0; b < L; ++b)
    {
      sum[0][b] += plane[0][b] * x.T[i][b];
      sum[1][b] += plane[0][b] * dx.D[i][b];
      sum[2][b] += plane[1][b] * x.T[i][b];
      sum[3][b] += plane[2][b] * x.T[i][b];
    }
  }
  for (int b = 0; b < L; ++b)
  {
    values[b] = sum[0][b];
    gradients.X[b] = sum[1][b];
    gradients.Y[b] = sum[2][b];
    gradients.Z[b] = sum[3][b];
  }
}

RECON_CLONES_WIDEST void AddNearValues(const SourcePoints& sources, const SourceRange* ranges,
  std::size_t count, const LanePoints& at, Lane& values)
{

  const double* ax = at.X.data();
  const double* ay = at.Y.data();
  const double* az = at.Z.data();
  const double* sx = sources.X.data();
  const double* sy = sources.Y.data();
  const double* sz = sources.Z.data();
  const double* weights = sources.W.data();
  alignas(64) double sum[L] = {};
  for (std::size_t r = 0; r < count; ++r)
  {
    for (std::int32_t j = ranges[r].From; j < ranges[r].To; ++j)
    {
      const double cx = sx[j];
      const double cy = sy[j];
      const double cz = sz[j];
      const double w = weights[j];
      for (int b = 0; b < L; ++b)
      {
        const double x = ax[b] - cx;
        const double y = ay[b] - cy;
        const double z = az[b] - cz;
        const double r2 = x * x + y * y + z * z;
        sum[b] += w * (r2 * std::sqrt(r2));
      }
    }
  }
  for (int b = 0; b < L; ++b)
  {
    values[b] += sum[b];
  }
}

RECON_CLONES_WIDEST void AddNearGradients(const SourcePoints& sources, const SourceRange* ranges,
  std::size_t count, const LanePoints& at, Lane& values, LanePoints& gradients)
{
  const double* ax = at.X.data();
  const double* ay = at.Y.data();
  const double* az = at.Z.data();
  const double* sx = sources.X.data();
  const double* sy = sources.Y.data();
  const double* sz = sources.Z.data();
  const double* weights = sources.W.data();
  alignas(64) double sum[4][L] = {};
  for (std::size_t r = 0; r < count; ++r)
  {
    for (std::int32_t j = ranges[r].From; j < ranges[r].To; ++j)
    {
      const double cx = sx[j];
      const double cy = sy[j];
      const double cz = sz[j];
      const double w = weights[j];
      for (int b = 0; b < L; ++b)
      {
        const double x = ax[b] - cx;
        const double y = ay[b] - cy;
        const double z = az[b] - cz;
        const double r2 = x * x + y * y + z * z;
        const double wr = w * std::sqrt(r2);
        const double slope = 3 * wr;
        sum[0][b] += r2 * wr;
        sum[1][b] += slope * x;
        sum[2][b] += slope * y;
        sum[3][b] += slope * z;
      }
    }
  }
  for (int b = 0; b < L; ++b)
  {
    values[b] += sum[0][b];
    gradients.X[b] += sum[1][b];
    gradients.Y[b] += sum[2][b];
    gradients.Z[b] += sum[3][b];
  }
}
}
