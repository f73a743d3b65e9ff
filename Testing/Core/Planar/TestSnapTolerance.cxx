// SPDX-License-Identifier: GPL-3.0-or-later
// How near is one place, by each loop's size, by its coordinates, or as the user says.
#include "Core/Contours/SoupMaker.h"
#include "Planar/SnapTolerance.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
const std::vector<Point2> Points{ { 0, 0 }, { 3, 0 }, { 3, 4 }, { 1000, 0 }, { 1000.3, 0 },
  { 1000.3, 0.4 } };
const std::vector<std::vector<int>> Loops{ { 0, 1, 2 }, { 3, 4, 5 } };

TEST(SnapTolerance, EachLoopHasItsOwn)
{
  const std::vector<double> tolerances = SnapTolerances(Points, Loops, 0);
  ASSERT_EQ(tolerances.size(), 2u);
  EXPECT_DOUBLE_EQ(tolerances[0], 5e-7);
  EXPECT_NEAR(tolerances[1], 0.5e-7, 1e-12);
}

TEST(SnapTolerance, TheUserSaysForAll)
{
  EXPECT_EQ(SnapTolerances(Points, Loops, 0.25), (std::vector<double>{ 0.25, 0.25 }));
}

TEST(SnapTolerance, NeverBelowRounding)
{
  std::vector<Point2> far;
  for (const Point2& p : Points)
  {
    far.push_back({ p[0] + 5e9, p[1] + 5e9 });
  }
  for (double wanted : { 0.0, 1e-12 })
  {
    for (double tolerance : SnapTolerances(far, Loops, wanted))
    {
      EXPECT_GT(tolerance, 1e-4);
      EXPECT_LT(tolerance, 1e-3);
    }
  }
}

ContourSet Build(const SoupMaker& maker, double snapTolerance)
{
  ContourSetOptions options;
  options.SnapTolerance = snapTolerance;
  Monitor monitor;
  return BuildContourSet(maker.Soup, options, monitor);
}

TEST(SnapTolerance, IsAnOptionOfContourSets)
{
  // A slit of 0.01: drawn, unless the user says that 0.02 is one place.
  const SoupMaker maker = SoupMaker()
                            .Loop(Rectangle(0, 0, 4, 4))
                            .Loop(Rectangle(4.01, 0, 8, 4))
                            .Loop(Rectangle(0, 0, 8, 4), 1);
  EXPECT_EQ(Build(maker, 0).Contours.size(), 3u);
  const ContourSet set = Build(maker, 0.02);
  ASSERT_EQ(set.Contours.size(), 2u);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_NE(
    set.Report[0].find("2 points merged with another, at most 0.01 apart"), std::string::npos)
    << set.Report[0];
}

TEST(SnapTolerance, ThatIsNoneIsRefused)
{
  const SoupMaker maker = SoupMaker().Loop(Rectangle(0, 0, 4, 4)).Loop(Rectangle(0, 0, 8, 4), 1);
  EXPECT_THROW(Build(maker, -1), Error);
  EXPECT_THROW(Build(maker, std::nan("")), Error);
  EXPECT_THROW(Build(maker, HUGE_VAL), Error);
}
}
