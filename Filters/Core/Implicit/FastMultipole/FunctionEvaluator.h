// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FunctionEvaluator.h
 * @brief A fitted function made ready for very many points: surfaces and contours ask for millions.
 */
#ifndef recon_FunctionEvaluator_h
#define recon_FunctionEvaluator_h

#include "Implicit/FastMultipole/FastKernelSum.h"
#include "Implicit/ImplicitFunction.h"

#include <memory>
#include <vector>

namespace recon
{
/**
 * @class FunctionEvaluator
 * @brief f and its gradient, by fast sums where there are many centres and exactly where there are
 * few.
 *
 * Below FastFrom centres of |r|^3, and for Wendland's function, values are those of
 * ImplicitFunction::Evaluate. Above, they differ from it by at most about AskedError times the
 * half range of the constraints' values: the accuracy of the sum is chosen from the size of the
 * terms at a sample of centres, the error is measured against exact sums there, and the accuracy is
 * raised until it is small enough or as fine as it goes; LargestError() is what was measured.
 *
 * The value at a point is the same to the last bit whatever else is asked for, and for any number
 * of threads: a corner never has two signs. Calls use threads of their own; make them one after the
 * other.
 */
class FunctionEvaluator
{
public:
  /// From here on the fast sum is faster for as few as a hundred thousand points (measured).
  static constexpr std::size_t FastFrom = 6000;
  static constexpr double AskedError = 1e-6;

  /// @param function must outlive this. The fast sum is made on first use.
  FunctionEvaluator(const ImplicitFunction& function, int threads);
  ~FunctionEvaluator();

  /// @throws Aborted
  std::vector<double> Values(const std::vector<Point3>& points, Monitor& monitor) const;
  /// @throws Aborted
  void ValuesAndGradients(const std::vector<Point3>& points, std::vector<double>& values,
    std::vector<Vector3>& gradients, Monitor& monitor) const;

  /// Measured at centres, in the unit of the values; 0 where sums are exact.
  double LargestError(Monitor& monitor) const;

private:
  bool IsFast() const;
  FastKernelSum& Fast(Monitor& monitor) const;
  double PolynomialAt(const Point3& x) const;

  const ImplicitFunction& Function;
  int Threads;
  mutable std::unique_ptr<FastKernelSum> Sum;
  mutable double Error = 0;
};
}

#endif
