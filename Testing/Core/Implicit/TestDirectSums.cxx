// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/DirectSums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace recon;

namespace
{
std::vector<Point3> MakePoints(int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ anywhere(random), anywhere(random), anywhere(random) });
  }
  return points;
}

/// Weights that nearly cancel, as those of margins do.
std::vector<double> MakeWeights(std::size_t count)
{
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i)
  {
    weights.push_back((i % 2 == 0 ? 1e6 : -1e6) + std::sin(static_cast<double>(i)));
  }
  return weights;
}

const std::vector<Kernel> Kernels{ { Kernel::Triharmonic, 1 }, { Kernel::Wendland, 0.8 } };
}

TEST(DirectSums, AreTheSumsOfTheFormula)
{
  const auto centres = MakePoints(301, 1);
  const auto weights = MakeWeights(centres.size());
  const auto points = MakePoints(37, 2);
  for (const Kernel& phi : Kernels)
  {
    std::vector<double> sums(points.size());
    std::vector<Vector3> gradients(points.size());
    SumKernels(phi, centres, weights, points.data(), points.size(), sums.data());
    SumKernelGradients(phi, centres, weights, points.data(), points.size(), gradients.data());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      long double sum = 0, magnitude = 0;
      std::array<long double, 3> gradient{};
      for (std::size_t j = 0; j < centres.size(); ++j)
      {
        const Vector3 d = points[i] - centres[j];
        const long double term = static_cast<long double>(weights[j]) * phi.Value(Dot(d, d));
        sum += term;
        magnitude += std::fabs(term);
        for (int k = 0; k < 3; ++k)
        {
          gradient[k] +=
            static_cast<long double>(weights[j]) * phi.SlopeOverRadius(Dot(d, d)) * d[k];
        }
      }
      EXPECT_NEAR(sums[i], static_cast<double>(sum), static_cast<double>(1e-15L * magnitude));
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(gradients[i][k], static_cast<double>(gradient[k]), 1e-5);
      }
    }
  }
}

TEST(DirectSums, DoNotDependOnHowManyAreAskedForNorOnThreads)
{
  const auto centres = MakePoints(200, 3);
  const auto weights = MakeWeights(centres.size());
  const auto points = MakePoints(1500, 4);
  Monitor monitor;
  for (const Kernel& phi : Kernels)
  {
    const auto all = SumAllKernels(phi, centres, weights, points, 1, monitor);
    EXPECT_EQ(SumAllKernels(phi, centres, weights, points, 4, monitor), all);
    const auto slopes = SumAllKernelGradients(phi, centres, weights, points, 1, monitor);
    EXPECT_EQ(SumAllKernelGradients(phi, centres, weights, points, 3, monitor), slopes);
    for (const std::size_t i : { 0, 7, 8, 1499 })
    {
      double one = 0;
      SumKernels(phi, centres, weights, &points[i], 1, &one);
      EXPECT_EQ(one, all[i]);
    }
  }
}
