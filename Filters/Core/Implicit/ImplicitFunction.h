// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImplicitFunction.h
 * @brief The function whose zero set is the surface (thesis 8.3, 9.2, algorithm 14).
 *
 * Notation:
 *   c_j      location of a constraint
 *   h_j      its value (Constraints.h: 0 on the surface, > 0 inside, < 0 outside)
 *   w_j      its weight
 *   p0..p3   the polynomial
 *   f(x) = sum_j w_j phi(|x - c_j|) + p0 + (p1, p2, p3) . (x - Origin)      (equation 8.2)
 */
#ifndef recon_ImplicitFunction_h
#define recon_ImplicitFunction_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Implicit/Kernel.h"

#include <array>
#include <string>
#include <vector>

namespace recon
{
/**
 * @class ImplicitFunction
 * @brief A fitted function as data: everything that is needed to evaluate it again.
 *
 * Coordinates and distances are in the units of the input, f has those of the constraints' values.
 */
class ImplicitFunction
{
public:
  Kernel Phi;
  std::vector<Point3> Centres;
  std::vector<double> Values; ///< h_j, what f was asked to be at the centres (after merging)
  std::vector<double> Weights;
  /// p0..p3, about Origin: far from zero (scanner coordinates) absolute coefficients would cancel.
  std::array<double, 4> Polynomial{ 0, 0, 0, 0 };
  Point3 Origin{ 0, 0, 0 };
  /// Largest |f(c_j) - h_j|, evaluated, never an estimate: by exact sums, at a sample that Report
  /// states where there are very many.
  double Residual = 0;
  int Iterations = 0; ///< steps of the iterative solver; 0: solved directly
  std::vector<std::string>
    Report; ///< a sentence for everything merged, or that the user should know

  /// At one point, for whoever uses the core by itself; the nodes evaluate many at once.
  double Value(const Point3& x) const;
  Vector3 Gradient(const Point3& x) const;

  /// f at many points; the result is the same, to the last bit, for any number of threads (0 =
  /// all).
  std::vector<double> Evaluate(const std::vector<Point3>& points, int threads) const;
  std::vector<Vector3> EvaluateGradients(const std::vector<Point3>& points, int threads) const;
  /// With progress. @throws Aborted
  std::vector<double> Evaluate(
    const std::vector<Point3>& points, int threads, Monitor& monitor) const;

  /// @throws Error where the parts do not fit together (a model that was read from a file).
  void Validate() const;
};
}

#endif
