// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/DenseFront.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <random>

using namespace recon;

namespace
{
/// Rows of a positive definite matrix, the first of which are square.
Eigen::MatrixXd Panel(int rows, int width)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  const auto any = [&]() { return value(random); };
  Eigen::MatrixXd panel = Eigen::MatrixXd::NullaryExpr(rows, width, any);
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(width, width, any);
  panel.topRows(width) = half * half.transpose() + Eigen::MatrixXd::Identity(width, width);
  return panel;
}
}

TEST(DenseFront, FactorisesAsEigenDoes)
{
  for (const int width : { 1, 3, 8, 31, 32, 33, 100, 257 })
  {
    for (const int below : { 0, 1, 7, 64, 130 })
    {
      const Eigen::MatrixXd given = Panel(width + below, width);
      Eigen::MatrixXd made = given;
      ASSERT_TRUE(FactorisePanel(made.data(), width + below, width));
      Eigen::MatrixXd wanted = given;
      const Eigen::MatrixXd factor = Eigen::LLT<Eigen::MatrixXd>(given.topRows(width)).matrixL();
      wanted.topRows(width) = factor;
      wanted.bottomRows(below) = factor.triangularView<Eigen::Lower>()
                                   .solve(given.bottomRows(below).transpose())
                                   .transpose();
      made.topRows(width) = made.topRows(width).triangularView<Eigen::Lower>().toDenseMatrix();
      EXPECT_LT((made - wanted).norm(), 1e-11 * wanted.norm()) << width << " + " << below;
    }
  }
}

TEST(DenseFront, SaysWhereNoFactorIs)
{
  Eigen::MatrixXd panel = Panel(60, 50);
  panel(40, 40) = -1;
  EXPECT_FALSE(FactorisePanel(panel.data(), 60, 50));
}

TEST(DenseFront, SubtractsTheLowerTriangle)
{
  for (const int count : { 1, 5, 8, 63, 64, 65, 200 })
  {
    for (const int width : { 1, 2, 48, 130 })
    {
      const Eigen::MatrixXd panel = Panel(count + width, width);
      const Eigen::MatrixXd rows = panel.bottomRows(count);
      const Eigen::MatrixXd square = Eigen::MatrixXd::Constant(count, count, 0.5);
      Eigen::MatrixXd made = square;
      SubtractOwnProduct(made.data(), count, panel.data() + width, count + width, width);
      Eigen::MatrixXd wanted = square;
      wanted.triangularView<Eigen::Lower>() -= rows * rows.transpose();
      EXPECT_LT((made - wanted).norm(), 1e-12 * (1 + wanted.norm())) << count << " x " << width;
    }
  }
}

TEST(DenseFront, AddsOneAfterTheOtherOnEveryProcessor)
{
  const int count = 77;
  const int width = 130;
  const Eigen::MatrixXd panel = Panel(count + width, width);
  Eigen::MatrixXd made = Eigen::MatrixXd::Constant(count, count, 0.5);
  SubtractOwnProduct(made.data(), count, panel.data() + width, count + width, width);
  for (int j = 0; j < count; ++j)
  {
    for (int i = j; i < count; ++i)
    {
      volatile double sum = 0;
      for (int k = 0; k < width; ++k)
      {
        const volatile double product = panel(width + i, k) * panel(width + j, k);
        sum = sum + product;
      }
      ASSERT_EQ(made(i, j), 0.5 - sum) << i << ", " << j;
    }
  }
}
