// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/Specks.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
/// A square a side, in a plane that is tilted by three to four.
LoopSoup Squares(const std::vector<double>& sides)
{
  LoopSoup soup;
  for (const double side : sides)
  {
    LoopSoup::Chain chain;
    chain.Closed = true;
    for (const Point2 p : { Point2{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      chain.Points.push_back(static_cast<int>(soup.Points.size()));
      soup.Points.push_back({ 7 + side * p[0], 0.6 * side * p[1], 0.8 * side * p[1] });
    }
    soup.Chains.push_back(chain);
  }
  return soup;
}
}

TEST(Specks, AreLeftOutAndTold)
{
  LoopSoup soup = Squares({ 2, 0.5, 0.1, 3 });
  EXPECT_EQ(LeaveOutSpecks(1, soup),
    "2 computed contours of less than 1 square units left out, as nobody drew one so small.");
  ASSERT_EQ(soup.Chains.size(), 2u);
  EXPECT_EQ(soup.Chains[0].Points.front(), 0);
  EXPECT_EQ(soup.Chains[1].Points.front(), 12);
}

TEST(Specks, NoneIsNothingToTell)
{
  LoopSoup soup = Squares({ 2, 0.5 });
  EXPECT_EQ(LeaveOutSpecks(0, soup), "");
  EXPECT_EQ(soup.Chains.size(), 2u);
  soup.Chains[1].Closed = false;
  EXPECT_EQ(LeaveOutSpecks(1, soup), "") << "an open line encloses nothing that could be small";
}

TEST(Specks, AreSmallerThanAPixelAndThanWhatWasDrawn)
{
  EXPECT_EQ(SpeckArea(1, 9), 1);
  EXPECT_EQ(SpeckArea(1, 0.36), 0.18);
  EXPECT_EQ(SpeckArea(0, 9), 0);
  ContourSet set;
  EXPECT_EQ(SmallestArea(set), 0);
  set.Contours.resize(2);
  set.Contours[0].SignedArea = 5;
  set.Contours[1].SignedArea = -3;
  EXPECT_EQ(SmallestArea(set), 3);
}
