// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ImplicitFunction.h"

#include "Implicit/FastMultipole/DirectSums.h"

#include <algorithm>
#include <cmath>

namespace recon
{
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
  Monitor silent;
  return this->Evaluate(points, threads, silent);
}

std::vector<double> ImplicitFunction::Evaluate(
  const std::vector<Point3>& points, int threads, Monitor& monitor) const
{
  std::vector<double> values =
    SumAllKernels(this->Phi, this->Centres, this->Weights, points, threads, monitor);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3 x = points[i] - this->Origin;
    values[i] += this->Polynomial[0] + this->Polynomial[1] * x[0] + this->Polynomial[2] * x[1] +
      this->Polynomial[3] * x[2];
  }
  return values;
}

std::vector<Vector3> ImplicitFunction::EvaluateGradients(
  const std::vector<Point3>& points, int threads) const
{
  Monitor silent;
  std::vector<Vector3> gradients =
    SumAllKernelGradients(this->Phi, this->Centres, this->Weights, points, threads, silent);
  for (Vector3& gradient : gradients)
  {
    for (int a = 0; a < 3; ++a)
    {
      gradient[a] += this->Polynomial[1 + a];
    }
  }
  return gradients;
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
