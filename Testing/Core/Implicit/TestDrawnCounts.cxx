// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that grow together, are lost, or come without having been drawn are found by their number.
#include "Implicit/Constraints/ContourFit.h"
#include "Implicit/Constraints/DrawnCounts.h"
#include "Implicit/ImplicitSurface.h"
#include "ImplicitShapes.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
constexpr double Cell = 0.5;

/// Two columns beside each other on five slices, so far apart, or one of both.
ContourSet Columns(double gap)
{
  handmade::Maker maker;
  for (int i = 0; i < 5; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 3.0 * i);
    if (gap > 0)
    {
      maker.AddCircle(level, { -6 - 0.5 * gap, 0 }, 6, 40);
      maker.AddCircle(level, { 6 + 0.5 * gap, 0 }, 6, 40);
    }
    else
    {
      maker.AddCircle(level, { 0, 0 }, 12, 60);
    }
  }
  return maker.Finish();
}

std::vector<OtherCount> Compare(const ContourSet& drawn, const ContourSet& fitted, int threads = 1)
{
  Monitor monitor;
  const ContourFit fit = FitContours(fitted, ConstraintOptions(), FunctionOptions(), monitor);
  return FindOtherCounts(drawn, fit.Function, SeedsOf(fit.Contours), Cell, threads, monitor);
}
}

TEST(DrawnCounts, AreNoOthersWhereTheFunctionIsOfTheseContours)
{
  EXPECT_TRUE(Compare(Columns(3), Columns(3)).empty());
  EXPECT_TRUE(Compare(Columns(0), Columns(0)).empty());
}

TEST(DrawnCounts, TellContoursThatGrewTogetherAndThatNobodyDrew)
{
  const std::vector<OtherCount> together = Compare(Columns(3), Columns(0));
  ASSERT_EQ(together.size(), 5u);
  EXPECT_EQ(together[2].Height, 6);
  EXPECT_EQ(together[2].Drawn, 2);
  EXPECT_EQ(together[2].Traced, 1);

  const std::vector<OtherCount> apart = Compare(Columns(0), Columns(3), 2);
  ASSERT_EQ(apart.size(), 5u);
  EXPECT_EQ(apart[0].Drawn, 1);
  EXPECT_EQ(apart[0].Traced, 2);
}
