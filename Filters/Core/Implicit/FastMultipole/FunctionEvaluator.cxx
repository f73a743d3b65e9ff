// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/FunctionEvaluator.h"

#include "Implicit/FastMultipole/DirectSums.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Centres at which errors are measured; each costs a sum over all centres.
constexpr int Samples = 96;
/// A first accuracy is taken this much finer than the terms' size says, as most would need a second
/// one otherwise.
constexpr double Reserve = 0.5;

/// The largest sum of absolute terms at some centres.
double SizeOfTerms(const ImplicitFunction& function)
{
  std::vector<double> sizes = function.Weights;
  for (double& w : sizes)
  {
    w = std::abs(w);
  }
  const std::size_t n = function.Centres.size();
  std::vector<Point3> at;
  for (std::size_t i = 0; i < n; i += std::max<std::size_t>(1, n / 16))
  {
    at.push_back(function.Centres[i]);
  }
  std::vector<double> sums(at.size());
  SumKernels(function.Phi, function.Centres, sizes, at.data(), at.size(), sums.data());
  return *std::max_element(sums.begin(), sums.end());
}

/// What an error is small beside: half the range of what the function was fitted to.
double HalfRange(const ImplicitFunction& function)
{
  if (function.Values.empty())
  {
    return 1;
  }
  const auto [least, largest] = std::minmax_element(function.Values.begin(), function.Values.end());
  return *largest > *least ? 0.5 * (*largest - *least) : 1;
}

double Clamped(double accuracy, double finest)
{
  return std::min(FastKernelSum::CoarsestAccuracy, std::max(finest, accuracy));
}
}

FunctionEvaluator::FunctionEvaluator(const ImplicitFunction& function, int threads)
  : Function(function),
    Threads(threads)
{
}

FunctionEvaluator::~FunctionEvaluator() = default;

bool FunctionEvaluator::IsFast() const
{
  return this->Function.Phi.Kind == Kernel::Triharmonic &&
    this->Function.Centres.size() >= FastFrom;
}

FastKernelSum& FunctionEvaluator::Fast(Monitor& monitor) const
{
  if (this->Sum)
  {
    return *this->Sum;
  }
  const double allowed = AskedError * HalfRange(this->Function);
  // Terms that cancel less than is feared need no more than that; what is measured tells.
  double accuracy =
    Clamped(Reserve * allowed / SizeOfTerms(this->Function), FastKernelSum::FinestQuickAccuracy);
  auto sum = std::make_unique<FastKernelSum>(this->Function.Centres, accuracy, this->Threads);
  for (;;)
  {
    sum->SetWeights(this->Function.Weights, monitor);
    this->Error = sum->SampledError(sum->ValuesAtCentres(monitor), Samples);
    if (this->Error <= allowed || accuracy <= FastKernelSum::FinestAccuracy)
    {
      break;
    }
    accuracy =
      Clamped(std::min(0.1, 0.5 * allowed / this->Error) * accuracy, FastKernelSum::FinestAccuracy);
    sum->SetAccuracy(accuracy);
  }
  this->Sum = std::move(sum);
  return *this->Sum;
}

double FunctionEvaluator::PolynomialAt(const Point3& x) const
{
  const Vector3 d = x - this->Function.Origin;
  const std::array<double, 4>& p = this->Function.Polynomial;
  return p[0] + p[1] * d[0] + p[2] * d[1] + p[3] * d[2];
}

std::vector<double> FunctionEvaluator::Values(
  const std::vector<Point3>& points, Monitor& monitor) const
{
  if (!this->IsFast())
  {
    return this->Function.Evaluate(points, this->Threads);
  }
  std::vector<double> values = this->Fast(monitor).Values(points, monitor);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    values[i] += this->PolynomialAt(points[i]);
  }
  return values;
}

void FunctionEvaluator::ValuesAndGradients(const std::vector<Point3>& points,
  std::vector<double>& values, std::vector<Vector3>& gradients, Monitor& monitor) const
{
  if (!this->IsFast())
  {
    values = this->Function.Evaluate(points, this->Threads);
    gradients = this->Function.EvaluateGradients(points, this->Threads);
    return;
  }
  this->Fast(monitor).ValuesAndGradients(points, values, gradients, monitor);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    values[i] += this->PolynomialAt(points[i]);
    for (int a = 0; a < 3; ++a)
    {
      gradients[i][a] += this->Function.Polynomial[1 + a];
    }
  }
}

double FunctionEvaluator::LargestError(Monitor& monitor) const
{
  if (this->IsFast())
  {
    this->Fast(monitor);
  }
  return this->Error;
}
}
