// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DecimalString.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace
{
std::string Decimal(double value)
{
  std::string text;
  recon::AppendDecimalString(text, value);
  return text;
}
}

TEST(DecimalString, IsShortAndWithinHalfAMicrometreOfAMillimetre)
{
  EXPECT_EQ(Decimal(0), "0");
  EXPECT_EQ(Decimal(-0.0), "0");
  EXPECT_EQ(Decimal(-1e-9), "0");
  EXPECT_EQ(Decimal(100), "100");
  EXPECT_EQ(Decimal(-122.44), "-122.44");
  EXPECT_EQ(Decimal(0.1 + 0.2), "0.3");
  EXPECT_EQ(Decimal(1.0 / 3), "0.333333");
  EXPECT_EQ(Decimal(-recon::LargestCoordinate + 1e-6), "-99999998.999999");
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-7, 7.99);
  for (int i = 0; i < 10000; ++i)
  {
    const double value = std::pow(10, exponent(random)) * (i % 2 ? 1 : -1);
    const std::string text = Decimal(value);
    EXPECT_LE(text.size(), 16u) << text;
    EXPECT_NEAR(std::stod(text), value, 5.1e-7) << text;
  }
}
