// SPDX-License-Identifier: GPL-3.0-or-later
// Files of others whose levels once came out wrong, never, or ended the program.
#include "Contours/ContourSetBuilder.h"
#include "Core/Contours/ContourInvariants.h"
#include "Core/SetsOfData.h"

using namespace recon;
using namespace recon::testing;

namespace
{
class PlaneFaults : public SharedData
{
protected:
  static ContourSet Build(const std::string& file)
  {
    const std::vector<NamedSoup> soups =
      ReadSoups(std::string(CONTOUR_SHARED_DATA) + "/faults/" + file);
    EXPECT_EQ(soups.size(), 1u);
    Monitor monitor;
    return BuildContourSet(soups.at(0).second, {}, monitor);
  }

  static void ExpectTwelveCornersOnEveryLevel(const ContourSet& set, std::size_t levels)
  {
    ASSERT_EQ(set.Levels.size(), levels);
    ASSERT_EQ(set.Contours.size(), levels);
    for (std::size_t l = 0; l < levels; ++l)
    {
      CheckContourSet(set, static_cast<int>(l));
      EXPECT_NEAR(set.Contours[l].SignedArea, 300, 1e-4);
    }
    ASSERT_EQ(set.Report.size(), 1u);
    EXPECT_TRUE(Reports(set, "within rounding"));
    EXPECT_TRUE(Reports(set, "left out"));
  }
};

TEST_F(PlaneFaults, AnOutlineStoredTwiceWithOtherDecimals)
{
  ExpectTwelveCornersOnEveryLevel(Build("rt/twin_12_points.dcm"), 3);
  ExpectTwelveCornersOnEveryLevel(Build("rt/twin_11_slices.dcm"), 11);
}

TEST_F(PlaneFaults, TheEvenOddRuleEnds)
{
  const ContourSet set = Build("other/evenodd_hang.cnt");
  CheckContourSet(set, 0);
  // Two triangles of 3.7e9 x 1e9 / 2, less their overlap twice; the small one is lost beside them.
  EXPECT_NEAR(SolidArea(set) / 3.6019e18, 1, 1e-4);
  EXPECT_TRUE(Reports(set, "touch or cross one another"));
}

TEST_F(PlaneFaults, SliversBelowTheToleranceAreNamed)
{
  for (const char* file : { "other/sliver_crash.cnt", "other/sliver_hang.cnt" })
  {
    try
    {
      Build(file);
      ADD_FAILURE() << file;
    }
    catch (const Error& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("is narrower than the snap tolerance of 1e-07"), std::string::npos)
        << text;
    }
  }
}
}
