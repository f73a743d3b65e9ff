// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/DirectSums.h"

#include "Base/Parallel.h"
#include "Base/SimdClones.h"

#include <algorithm>
#include <array>
#include <cmath>

// Points are taken eight at a time, so that the compiler can work on them side by side; each
// point's own sum runs over the centres in their order. So a result does not depend on which points
// stand beside it, nor on the width of the processor's registers: the wide version is the same
// arithmetic (no fused operations).

namespace recon
{
namespace
{
constexpr std::size_t Lanes = 8; ///< doubles in the widest register (512 bits)

struct Block
{
  std::array<double, Lanes> X{};
  std::array<double, Lanes> Y{};
  std::array<double, Lanes> Z{};
};

Block Load(const Point3* points, std::size_t count)
{
  Block block;
  for (std::size_t l = 0; l < Lanes; ++l)
  {
    // A short last block is filled up with its last point; those sums are not stored.
    const Point3& p = points[std::min(l, count - 1)];
    block.X[l] = p[0];
    block.Y[l] = p[1];
    block.Z[l] = p[2];
  }
  return block;
}

/// Points that one thread takes at a time; any number gives the same sums.
constexpr std::size_t PointsPerPiece = 64;
constexpr const char* Stage = "evaluating the fit";

using Sums = std::array<double, Lanes>;

RECON_CLONES_EXACT void SumTriharmonic(
  const Point3* centres, const double* weights, std::size_t n, const Block& at, Sums& out)
{
  Sums sum{};
  Sums lost{};
  for (std::size_t j = 0; j < n; ++j)
  {
    const double cx = centres[j][0];
    const double cy = centres[j][1];
    const double cz = centres[j][2];
    const double w = weights[j];
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double x = at.X[l] - cx;
      const double y = at.Y[l] - cy;
      const double z = at.Z[l] - cz;
      const double r2 = x * x + y * y + z * z;
      const double term = w * (r2 * std::sqrt(r2)) - lost[l];
      const double next = sum[l] + term;
      lost[l] = (next - sum[l]) - term;
      sum[l] = next;
    }
  }
  out = sum;
}

RECON_CLONES_EXACT void SumWendland(const Point3* centres, const double* weights, std::size_t n,
  double inverseRadius, const Block& at, Sums& out)
{
  Sums sum{};
  for (std::size_t j = 0; j < n; ++j)
  {
    const double cx = centres[j][0];
    const double cy = centres[j][1];
    const double cz = centres[j][2];
    const double w = weights[j];
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double x = at.X[l] - cx;
      const double y = at.Y[l] - cy;
      const double z = at.Z[l] - cz;
      const double q = std::sqrt(x * x + y * y + z * z) * inverseRadius;
      const double rest = q < 1 ? 1 - q : 0;
      const double rest2 = rest * rest;
      sum[l] += w * (rest2 * rest2 * (4 * q + 1));
    }
  }
  out = sum;
}

struct GradientSums
{
  Sums X;
  Sums Y;
  Sums Z;
};

RECON_CLONES_EXACT void SumTriharmonicGradients(
  const Point3* centres, const double* weights, std::size_t n, const Block& at, GradientSums& out)
{
  Sums sx{};
  Sums sy{};
  Sums sz{};
  for (std::size_t j = 0; j < n; ++j)
  {
    const double cx = centres[j][0];
    const double cy = centres[j][1];
    const double cz = centres[j][2];
    const double w = 3 * weights[j];
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double x = at.X[l] - cx;
      const double y = at.Y[l] - cy;
      const double z = at.Z[l] - cz;
      const double slope = w * std::sqrt(x * x + y * y + z * z);
      sx[l] += slope * x;
      sy[l] += slope * y;
      sz[l] += slope * z;
    }
  }
  out.X = sx;
  out.Y = sy;
  out.Z = sz;
}

void SumOtherGradients(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const Block& at, GradientSums& out)
{
  out = GradientSums{};
  for (std::size_t j = 0; j < centres.size(); ++j)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double x = at.X[l] - centres[j][0];
      const double y = at.Y[l] - centres[j][1];
      const double z = at.Z[l] - centres[j][2];
      const double slope = weights[j] * phi.SlopeOverRadius(x * x + y * y + z * z);
      out.X[l] += slope * x;
      out.Y[l] += slope * y;
      out.Z[l] += slope * z;
    }
  }
}
}

void SumKernels(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const Point3* points, std::size_t count, double* sums)
{
  for (std::size_t from = 0; from < count; from += Lanes)
  {
    const std::size_t here = std::min(Lanes, count - from);
    const Block block = Load(points + from, here);
    Sums out{};
    if (phi.Kind == Kernel::Triharmonic)
    {
      SumTriharmonic(centres.data(), weights.data(), centres.size(), block, out);
    }
    else
    {
      SumWendland(centres.data(), weights.data(), centres.size(), 1 / phi.Radius, block, out);
    }
    std::copy_n(out.begin(), here, sums + from);
  }
}

void SumKernelGradients(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const Point3* points, std::size_t count, Vector3* gradients)
{
  for (std::size_t from = 0; from < count; from += Lanes)
  {
    const std::size_t here = std::min(Lanes, count - from);
    const Block block = Load(points + from, here);
    GradientSums out{};
    if (phi.Kind == Kernel::Triharmonic)
    {
      SumTriharmonicGradients(centres.data(), weights.data(), centres.size(), block, out);
    }
    else
    {
      SumOtherGradients(phi, centres, weights, block, out);
    }
    for (std::size_t l = 0; l < here; ++l)
    {
      gradients[from + l] = { out.X[l], out.Y[l], out.Z[l] };
    }
  }
}

std::vector<double> SumAllKernels(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const std::vector<Point3>& points, int threads,
  Monitor& monitor)
{
  std::vector<double> sums(points.size());
  const auto sum = [&](std::size_t from, std::size_t to)
  { SumKernels(phi, centres, weights, points.data() + from, to - from, sums.data() + from); };
  ParallelForBlocks(points.size(), PointsPerPiece, threads, sum, monitor, { 0, 1, Stage });
  return sums;
}

std::vector<Vector3> SumAllKernelGradients(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const std::vector<Point3>& points, int threads,
  Monitor& monitor)
{
  std::vector<Vector3> sums(points.size());
  const auto sum = [&](std::size_t from, std::size_t to) {
    SumKernelGradients(phi, centres, weights, points.data() + from, to - from, sums.data() + from);
  };
  ParallelForBlocks(points.size(), PointsPerPiece, threads, sum, monitor, { 0, 1, Stage });
  return sums;
}
}
