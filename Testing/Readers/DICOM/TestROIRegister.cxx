// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ROIRegister.h"

#include <gtest/gtest.h>

#include <limits>

TEST(ROIRegister, NumbersAreKeptWhereTheyAreFree)
{
  recon::ROIRegister empty;
  EXPECT_EQ(empty.NewNumber(0), 1);
  recon::ROIRegister taken;
  taken.Take(7, "Lung");
  EXPECT_EQ(taken.NewNumber(3), 3);
  EXPECT_EQ(taken.NewNumber(7), 8);
  EXPECT_EQ(taken.NewNumber(-1), 9);
  EXPECT_EQ(taken.NewNumber(0), 10);
}

TEST(ROIRegister, NumbersThatSomethingRefersToAreNotFree)
{
  recon::ROIRegister taken;
  taken.TakeNumber(1);
  EXPECT_EQ(taken.NewNumber(0), 2);
  taken.TakeNumber(std::numeric_limits<int>::max());
  EXPECT_EQ(taken.NewNumber(0), 3);
  EXPECT_EQ(taken.NewNumber(std::numeric_limits<int>::max()), 4);
  taken.TakeNumber(std::numeric_limits<int>::min());
  EXPECT_EQ(taken.NewNumber(-3), 5);
}

TEST(ROIRegister, NamesGetANumberWhereTheyAreTaken)
{
  recon::ROIRegister taken;
  taken.Take(7, "Lung");
  EXPECT_EQ(taken.NewName("Heart"), "Heart");
  EXPECT_EQ(taken.NewName("LUNG"), "LUNG (2)");
  EXPECT_EQ(taken.NewName("lung"), "lung (3)");
  const std::string longest(recon::LongestROIName, 'x');
  EXPECT_EQ(taken.NewName(longest), longest);
  const std::string shortened = taken.NewName(longest);
  EXPECT_EQ(shortened, std::string(recon::LongestROIName - 4, 'x') + " (2)");
}
