// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FastKernelSum.h
 * @brief Sums of |x - c_j|^3 over many centres in time that grows with their number, not its
 * square.
 *
 * Notation:
 *   c_j, w_j   centres and their weights; n of them
 *   s(x)       sum_j w_j |x - c_j|^3
 *   a          the accuracy asked for
 */
#ifndef recon_FastKernelSum_h
#define recon_FastKernelSum_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"

#include <memory>
#include <vector>

namespace recon
{
/**
 * @class FastKernelSum
 * @brief A fast multipole method (Greengard and Rokhlin 1987) that needs of its kernel no more than
 * values (Fong and Darve 2009), for the triharmonic |r|^3.
 *
 * Far boxes of an adaptive octree act on one another through Chebyshev series of total degree p
 * (ChebyshevOperators.h); what is near is summed exactly. Series instead of the interpolation at
 * p^3 nodes of Fong and Darve, because the kernel's coefficients fall off so quickly that the
 * matrices between boxes are sparse to working accuracy: no singular value decomposition, a part
 * of the numbers at p = 7.
 *
 * **Accuracy.** The error of s(x) is at most a times the largest sum_j |w_j| |c_i - c_j|^3 of all
 * centres, whatever the weights (tested for a = 1e-3 to 5e-15, where rounding begins). The order p
 * falls with the size of the boxes, as the kernel does (a variable order: Tausch 2004). Weights of
 * contour constraints nearly cancel (three a point: inside, on, outside), so that s itself can be
 * 1e-5 of that sum: ask for an accuracy that much finer, and let SampledError() measure what came
 * of it against exact sums.
 *
 * **Time.** One thread, AVX-512, CPU seconds for SetWeights and ValuesAtCentres on a surface of
 * 100 800 centres: 0.10 at 1e-7, 0.20 at 1e-10, 0.45 at 1e-12; for a million 1.8 at 1e-10 and
 * 0.5 GB. All pairs take 0.56 ns each, so that they are faster below some 4 000 centres at 1e-8 and
 * 11 000 at 1e-12; the operators of orders above 10 (accuracies below 1e-9) take half a second once
 * in a process, those above 17 two more and 140 MB.
 *
 * Results are the same to the last bit for any number of threads; they may differ in the last bits
 * between processors that fuse a product and a sum and those that do not.
 */
class FastKernelSum
{
public:
  static constexpr double CoarsestAccuracy = 1e-3; ///< the coarsest that may be asked for
  static constexpr double FinestAccuracy = 5e-15;  ///< the finest that may be asked for
  /// Orders up to LargestQuickOrder are enough for it.
  static constexpr double FinestQuickAccuracy = 1.1e-13;

  /**
   * Sorts the centres and finds which boxes act on which; no weights yet (all 0).
   * @param centres finite; duplicates and any shape are allowed, none at all too
   * @param accuracy a, CoarsestAccuracy..FinestAccuracy
   * @param threads 0 = all of the machine
   */
  FastKernelSum(const std::vector<Point3>& centres, double accuracy, int threads);
  ~FastKernelSum();
  FastKernelSum(FastKernelSum&&) noexcept;
  FastKernelSum& operator=(FastKernelSum&&) noexcept;

  std::size_t Size() const;

  /// From the next SetWeights on. Tree and lists stay.
  void SetAccuracy(double accuracy);

  /// The moments of all boxes. @throws Aborted, after which weights must be set again.
  void SetWeights(const std::vector<double>& weights, Monitor& monitor);

  /// s(c_j), in the order in which the centres were given.
  std::vector<double> ValuesAtCentres(Monitor& monitor);

  /**
   * s at any points. The first call after SetWeights expands s in all boxes around the centres
   * (about three times ValuesAtCentres), the others only look up. What comes out is a function of
   * the point alone, whatever is asked for beside it. Points far from the centres, by a quarter of
   * their extent or more, are summed directly.
   */
  std::vector<double> Values(const std::vector<Point3>& points, Monitor& monitor);

  /// s and its gradient, whose error is at most 100 a / (largest extent of the centres) times the
  /// same sum.
  void ValuesAndGradients(const std::vector<Point3>& points, std::vector<double>& values,
    std::vector<Vector3>& gradients, Monitor& monitor);

  /**
   * The largest |values[j] - s(c_j)| with s summed exactly, over about so many centres spread over
   * all: what ValuesAtCentres was really off by, for n x samples kernels.
   */
  double SampledError(const std::vector<double>& valuesAtCentres, int samples) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Inside;
};
}

#endif
