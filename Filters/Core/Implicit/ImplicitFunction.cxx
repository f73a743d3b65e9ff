// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ImplicitFunction.h"

#include "Base/Parallel.h"
#include "Implicit/FastMultipole/DirectSums.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Points that one thread takes at a time; any number gives the same sums.
constexpr int PointsPerPiece = 256;

template <typename Body>
void ForPieces(std::size_t points, int threads, const Body& body)
{
  const int pieces = static_cast<int>((points + PointsPerPiece - 1) / PointsPerPiece);
  const auto run = [&](int piece)
  {
    const std::size_t from = static_cast<std::size_t>(piece) * PointsPerPiece;
    body(from, std::min(points, from + PointsPerPiece));
  };
  if (pieces < 2 || threads == 1)
  {
    for (int piece = 0; piece < pieces; ++piece)
    {
      run(piece);
    }
    return;
  }
  Monitor silent;
  ParallelFor(pieces, threads, run, silent, { 0, 1, "evaluating the function" });
}
}

double ImplicitFunction::Value(const Point3& x) const
{
  return this->Evaluate({ x }, 1).front();
}

Vector3 ImplicitFunction::Gradient(const Point3& x) const
{
  return this->EvaluateGradients({ x }, 1).front();
}

std::vector<double> ImplicitFunction::Evaluate(const std::vector<Point3>& points, int threads) const
{
  std::vector<double> values(points.size());
  ForPieces(points.size(), threads,
    [&](std::size_t from, std::size_t to)
    {
      SumKernels(this->Phi, this->Centres, this->Weights, points.data() + from, to - from,
        values.data() + from);
      for (std::size_t i = from; i < to; ++i)
      {
        const Vector3 x = points[i] - this->Origin;
        values[i] += this->Polynomial[0] + this->Polynomial[1] * x[0] + this->Polynomial[2] * x[1] +
          this->Polynomial[3] * x[2];
      }
    });
  return values;
}

std::vector<Vector3> ImplicitFunction::EvaluateGradients(
  const std::vector<Point3>& points, int threads) const
{
  std::vector<Vector3> gradients(points.size());
  ForPieces(points.size(), threads,
    [&](std::size_t from, std::size_t to)
    {
      SumKernelGradients(this->Phi, this->Centres, this->Weights, points.data() + from, to - from,
        gradients.data() + from);
      for (std::size_t i = from; i < to; ++i)
      {
        for (int a = 0; a < 3; ++a)
        {
          gradients[i][a] += this->Polynomial[1 + a];
        }
      }
    });
  return gradients;
}

std::array<double, 4> ImplicitFunction::AbsolutePolynomial() const
{
  const Vector3 slope{ this->Polynomial[1], this->Polynomial[2], this->Polynomial[3] };
  return { this->Polynomial[0] - Dot(slope, this->Origin), slope[0], slope[1], slope[2] };
}

void ImplicitFunction::Validate() const
{
  if (this->Centres.empty() || this->Centres.size() != this->Weights.size())
  {
    throw Error("The implicit function has " + std::to_string(this->Centres.size()) +
      " centres and " + std::to_string(this->Weights.size()) +
      " weights: fit it again with Implicit Function.");
  }
  const auto finite = [](double x) { return std::isfinite(x); };
  const auto finitePoint = [&](const Point3& p) { return std::all_of(p.begin(), p.end(), finite); };
  if (!std::all_of(this->Centres.begin(), this->Centres.end(), finitePoint) ||
    !std::all_of(this->Weights.begin(), this->Weights.end(), finite) ||
    !std::all_of(this->Values.begin(), this->Values.end(), finite) ||
    !std::all_of(this->Polynomial.begin(), this->Polynomial.end(), finite) ||
    !finitePoint(this->Origin))
  {
    throw Error(
      "The implicit function holds numbers that are not finite: fit it again with Implicit "
      "Function.");
  }
  if (this->Phi.Kind == Kernel::Wendland && !(this->Phi.Radius > 0))
  {
    throw Error(
      "The implicit function's support radius is not positive: fit it again with Implicit "
      "Function.");
  }
}
}
