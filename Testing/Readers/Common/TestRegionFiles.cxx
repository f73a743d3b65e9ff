// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/RegionFiles.h"

#include <gtest/gtest.h>

using namespace recon;
using Names = std::vector<std::string>;

TEST(RegionFiles, OneRegionHasTheNameThatWasGiven)
{
  EXPECT_EQ(RegionFileNames("out/heart.brep", { "Left lung" }), Names{ "out/heart.brep" });
  EXPECT_TRUE(RegionFileNames("out/heart.brep", {}).empty());
}

TEST(RegionFiles, SeveralHaveNamesOfTheirOwn)
{
  EXPECT_EQ(RegionFileNames("out/a.b.brep", { "Left lung", "../PTV  1/2", "心臓" }),
    (Names{ "out/a.b-Left_lung.brep", "out/a.b-PTV_1_2.brep", "out/a.b-心臓.brep" }));
}

TEST(RegionFiles, NoTwoAreTheSame)
{
  EXPECT_EQ(RegionFileNames("x.brep", { "Lung", "lung", "LUNG", "", "/", "Lung-2" }),
    (Names{ "x-Lung.brep", "x-lung-2.brep", "x-LUNG-3.brep", "x-ROI.brep", "x-ROI-5.brep",
      "x-Lung-2-6.brep" }));
}

TEST(RegionFiles, LongNamesAreCutBetweenLetters)
{
  std::string region = "a";
  for (int i = 0; i < 200; ++i)
  {
    region += "é";
  }
  const std::string name = RegionFileNames("x.brep", { region, "b" }).front();
  EXPECT_EQ(name.size(), std::string("x-.brep").size() + 99);
  EXPECT_EQ(name.substr(name.size() - 7), "é.brep");
}

TEST(WriteRegionFiles, CostsOnlyTheRegionThatFails)
{
  std::vector<std::string> written;
  try
  {
    recon::WriteRegionFiles({ "heart", "lung", "liver" }, "a.stl",
      [&](std::size_t r, const std::string& file)
      {
        if (r == 1)
        {
          throw recon::Error("It is too large.");
        }
        written.push_back(file);
      });
    FAIL() << "nothing was said";
  }
  catch (const recon::Error& error)
  {
    EXPECT_STREQ(error.what(), "\"lung\": It is too large.");
  }
  EXPECT_EQ(written, (std::vector<std::string>{ "a-heart.stl", "a-liver.stl" }));
}
