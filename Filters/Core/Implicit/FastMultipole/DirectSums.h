// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DirectSums.h
 * @brief The inner loops: sums of weighted kernels over all centres (equation 8.2 without its
 * polynomial).
 */
#ifndef recon_DirectSums_h
#define recon_DirectSums_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Implicit/Kernel.h"

#include <cstddef>
#include <vector>

namespace recon
{
/// sums[i] = sum_j weights[j] phi(|points[i] - centres[j]|), in the order of j whatever the count.
void SumKernels(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const Point3* points, std::size_t count, double* sums);

/// The gradients of the same sums.
void SumKernelGradients(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const Point3* points, std::size_t count, Vector3* gradients);

/// The sums at many points, in threads (0 = all of the machine); the same for any number of them.
/// @throws Aborted
std::vector<double> SumAllKernels(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const std::vector<Point3>& points, int threads,
  Monitor& monitor);
std::vector<Vector3> SumAllKernelGradients(const Kernel& phi, const std::vector<Point3>& centres,
  const std::vector<double>& weights, const std::vector<Point3>& points, int threads,
  Monitor& monitor);
}

#endif
