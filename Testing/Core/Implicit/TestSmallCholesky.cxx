// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/SmallCholesky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace recon;

namespace
{
/// B B^T + I, by columns.
std::vector<double> MakePositiveDefinite(int size)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> b(static_cast<std::size_t>(size) * size);
  for (double& x : b)
  {
    x = normal(random);
  }
  std::vector<double> a(b.size(), 0.0);
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      a[j * size + i] = i == j;
      for (int k = 0; k < size; ++k)
      {
        a[j * size + i] += b[k * size + i] * b[k * size + j];
      }
    }
  }
  return a;
}
}

TEST(SmallCholesky, FactorTimesItsTransposeIsTheMatrix)
{
  for (const int size : { 1, 2, 3, 4, 5, 13, 40 })
  {
    const std::vector<double> a = MakePositiveDefinite(size);
    std::vector<double> l = a;
    ASSERT_TRUE(FactoriseSmall(l.data(), size));
    for (int j = 0; j < size; ++j)
    {
      for (int i = j; i < size; ++i)
      {
        double sum = 0;
        for (int k = 0; k <= j; ++k)
        {
          sum += l[k * size + i] * l[k * size + j];
        }
        EXPECT_NEAR(sum, a[j * size + i], 1e-11 * size * std::fabs(a[j * size + j]));
      }
    }
  }
}

TEST(SmallCholesky, SolvesAllSidesAtOnce)
{
  const int size = 11;
  std::vector<double> l = MakePositiveDefinite(size);
  ASSERT_TRUE(FactoriseSmall(l.data(), size));
  std::vector<double> wanted(static_cast<std::size_t>(size) * SolvedTogether);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    wanted[i] = std::sin(static_cast<double>(i));
  }
  // x = L^T wanted, then solve.
  std::vector<double> x(wanted.size(), 0.0);
  for (int i = 0; i < size; ++i)
  {
    for (int k = i; k < size; ++k)
    {
      for (int s = 0; s < SolvedTogether; ++s)
      {
        x[i * SolvedTogether + s] += l[i * size + k] * wanted[k * SolvedTogether + s];
      }
    }
  }
  SolveTransposed(l.data(), size, size - 1, x.data());
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    EXPECT_NEAR(x[i], wanted[i], 1e-10);
  }
}

TEST(SmallCholesky, RefusesAPivotThatIsNotSure)
{
  std::vector<double> flat{ 1, 1, 1, 1 };
  EXPECT_FALSE(FactoriseSmall(flat.data(), 2));
  std::vector<double> negative{ -1 };
  EXPECT_FALSE(FactoriseSmall(negative.data(), 1));
}

TEST(SmallCholesky, DotAndSubtraction)
{
  const std::vector<double> a{ 1, 2, 3, 4, 5 }, b{ 5, 4, 3, 2, 1 };
  EXPECT_DOUBLE_EQ(DotOf(a.data(), b.data(), 5), 35);
  EXPECT_EQ(DotOf(a.data(), b.data(), 0), 0);
  std::vector<double> c = a;
  SubtractColumn(c.data(), b.data(), 2, 5);
  EXPECT_EQ(c, (std::vector<double>{ -9, -6, -3, 0, 3 }));
}
