// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourSubset.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
/// Levels 0, 1, 2 with contours 0 1, 2, 3; contour 1 is a hole of 0.
ContourSet MakeSet()
{
  ContourSet set;
  set.Parallel = true;
  set.Levels.resize(3);
  for (int c = 0; c < 4; ++c)
  {
    Contour contour;
    contour.Level = c < 2 ? 0 : c - 1;
    contour.Depth = c == 1 ? 1 : 0;
    contour.Parent = c == 1 ? 0 : -1;
    contour.Source = 10 + c;
    set.Levels[contour.Level].Contours.push_back(c);
    set.Levels[contour.Level].Offset = 2.5 * contour.Level;
    set.Contours.push_back(contour);
  }
  return set;
}
}

TEST(ContourSubset, LevelsWithoutContoursAreGone)
{
  const ContourSet subset =
    SubsetOf(MakeSet(), [](const Contour& contour) { return contour.Source != 12; });
  ASSERT_EQ(subset.Levels.size(), 2u);
  EXPECT_EQ(subset.Levels[1].Offset, 5);
  EXPECT_TRUE(subset.Parallel);
  for (int l = 0; l < 2; ++l)
  {
    for (const int c : subset.Levels[l].Contours)
    {
      EXPECT_EQ(subset.Contours[c].Level, l);
    }
  }
}

TEST(ContourSubset, AHoleKeepsItsSideAndLosesItsParent)
{
  const ContourSet subset =
    SubsetOf(MakeSet(), [](const Contour& contour) { return contour.Depth == 1; });
  ASSERT_EQ(subset.Contours.size(), 1u);
  EXPECT_EQ(subset.Contours[0].Source, 11);
  EXPECT_EQ(subset.Contours[0].Depth, 1);
  EXPECT_EQ(subset.Contours[0].Parent, -1);
}

TEST(ContourSubset, OfNoneIsEmpty)
{
  const ContourSet subset = SubsetOf(MakeSet(), [](const Contour&) { return false; });
  EXPECT_TRUE(subset.Contours.empty());
  EXPECT_TRUE(subset.Levels.empty());
}
