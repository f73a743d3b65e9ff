// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Kernel.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
const Kernel Triharmonic{ Kernel::Triharmonic, 1 };
const Kernel Wendland{ Kernel::Wendland, 2 };
}

TEST(Kernel, HasTheValuesOfItsFormula)
{
  EXPECT_DOUBLE_EQ(Triharmonic.Value(4), 8);
  EXPECT_DOUBLE_EQ(Wendland.Value(0), 1);
  EXPECT_DOUBLE_EQ(Wendland.Value(1), 3.0 / 16); // (1 - 1/2)^4 (4/2 + 1)
}

TEST(Kernel, WendlandEndsAtItsRadius)
{
  EXPECT_EQ(Wendland.Value(4), 0);
  EXPECT_EQ(Wendland.Value(100), 0);
  EXPECT_EQ(Wendland.SlopeOverRadius(4), 0);
}

TEST(Kernel, SlopeIsTheDerivative)
{
  for (const Kernel& kernel : { Triharmonic, Wendland })
  {
    for (const double r : { 0.1, 0.7, 1.3, 1.9 })
    {
      const double h = 1e-5;
      const double difference =
        (kernel.Value((r + h) * (r + h)) - kernel.Value((r - h) * (r - h))) / (2 * h);
      EXPECT_NEAR(kernel.SlopeOverRadius(r * r) * r, difference, 1e-8);
    }
  }
}
