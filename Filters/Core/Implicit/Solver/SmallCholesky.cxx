// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/SmallCholesky.h"

#include "Base/SimdClones.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// The wide version may fuse operations: a preconditioner's last bits matter to nobody, as long as
// they are the same for any number of threads.

namespace recon
{
namespace
{
/// Kernels in the unit ball are up to 8, so a pivot below this has lost most of its digits to
/// rounding, as where two points are 1e-4 of the ball apart: such a group is factorised again in
/// long double.
constexpr double LeastSurePivot = 1e-12;

/// a[0..count) -= the product of four columns with four factors.
RECON_CLONES_FUSED void SubtractFour(
  double* a, const double* columns, std::size_t stride, const double* factors, int count)
{
  const double* c0 = columns;
  const double* c1 = columns + stride;
  const double* c2 = columns + 2 * stride;
  const double* c3 = columns + 3 * stride;
  const double f0 = factors[0];
  const double f1 = factors[1];
  const double f2 = factors[2];
  const double f3 = factors[3];
  for (int i = 0; i < count; ++i)
  {
    a[i] -= f0 * c0[i] + f1 * c1[i] + f2 * c2[i] + f3 * c3[i];
  }
}

/// Column k of the factor, from a column that all before it have been subtracted from.
/// @return false where its pivot is not sure.
bool FinishColumn(double* column, int k, int size)
{
  if (!(column[k] > LeastSurePivot))
  {
    return false;
  }
  column[k] = std::sqrt(column[k]);
  const double factor = 1 / column[k];
  for (int i = k + 1; i < size; ++i)
  {
    column[i] *= factor;
  }
  return true;
}
}

RECON_CLONES_FUSED void SubtractColumn(double* a, const double* column, double factor, int count)
{
  for (int i = 0; i < count; ++i)
  {
    a[i] -= factor * column[i];
  }
}

RECON_CLONES_FUSED void FillProjectedColumn(
  const double* data, int size, int j, double lambda, double* column)
{
  const double* x = data;
  const double* y = data + size;
  const double* z = data + 2 * static_cast<std::size_t>(size);
  const double* l = data + 3 * static_cast<std::size_t>(size);
  const double* q = data + 7 * static_cast<std::size_t>(size);
  const double xj = x[j];
  const double yj = y[j];
  const double zj = z[j];
  const double l0 = l[j];
  const double l1 = l[j + size];
  const double l2 = l[j + 2 * size];
  const double l3 = l[j + 3 * size];
  const double q0 = q[j];
  const double q1 = q[j + size];
  const double q2 = q[j + 2 * size];
  const double q3 = q[j + 3 * size];
  for (int i = j; i < size; ++i)
  {
    const double dx = x[i] - xj;
    const double dy = y[i] - yj;
    const double dz = z[i] - zj;
    const double r2 = dx * dx + dy * dy + dz * dz;
    const double li0 = l[i];
    const double li1 = l[i + size];
    const double li2 = l[i + 2 * size];
    const double li3 = l[i + 3 * size];
    const double mixed = li0 * q0 + li1 * q1 + li2 * q2 + li3 * q3 + q[i] * l0 + q[i + size] * l1 +
      q[i + 2 * size] * l2 + q[i + 3 * size] * l3;
    const double ll = li0 * l0 + li1 * l1 + li2 * l2 + li3 * l3;
    column[i] = (r2 * std::sqrt(r2) - mixed) + lambda * ll;
  }
  column[j] += lambda;
}

// Column after column; four at a time are subtracted from the rest.
bool FactoriseSmall(double* a, int size)
{
  constexpr int Width = 4; ///< columns at a time
  for (int from = 0; from < size; from += Width)
  {
    const int to = std::min(size, from + Width);
    for (int k = from; k < to; ++k)
    {
      double* column = a + static_cast<std::size_t>(k) * size;
      for (int q = from; q < k; ++q)
      {
        const double* done = a + static_cast<std::size_t>(q) * size;
        SubtractColumn(column + k, done + k, done[k], size - k);
      }
      if (!FinishColumn(column, k, size))
      {
        return false;
      }
    }
    if (to - from < Width)
    {
      break;
    }
    const double* block = a + static_cast<std::size_t>(from) * size;
    for (int j = to; j < size; ++j)
    {
      std::array<double, Width> factors{};
      for (int q = 0; q < Width; ++q)
      {
        factors[q] = block[j + static_cast<std::size_t>(q) * size];
      }
      SubtractFour(
        a + j + static_cast<std::size_t>(j) * size, block + j, size, factors.data(), size - j);
    }
  }
  return true;
}

void SolveTransposed(const double* factor, int size, int last, double* x)
{
  using Factor = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  using RightSides = Eigen::Matrix<double, Eigen::Dynamic, SolvedTogether, Eigen::RowMajor>;
  const Factor lower(factor, last + 1, last + 1, Eigen::OuterStride<>(size));
  Eigen::Map<RightSides> right(x, last + 1, SolvedTogether);
  lower.triangularView<Eigen::Lower>().transpose().solveInPlace(right);
}

RECON_CLONES_FUSED double DotOf(const double* a, const double* b, int count)
{
  double sums[SolvedTogether] = {};
  int i = 0;
  for (; i + SolvedTogether <= count; i += SolvedTogether)
  {
    for (int l = 0; l < SolvedTogether; ++l)
    {
      sums[l] += a[i + l] * b[i + l];
    }
  }
  double sum = 0;
  for (; i < count; ++i)
  {
    sum += a[i] * b[i];
  }
  for (const double s : sums)
  {
    sum += s;
  }
  return sum;
}
}
