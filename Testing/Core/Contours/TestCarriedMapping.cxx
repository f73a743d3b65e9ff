// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/CarriedMapping.h"

#include <gtest/gtest.h>

namespace
{
using Pairs = std::vector<std::pair<int, int>>;

/// Three contours that came as cells 2, 0 and 1.
recon::ContourSet Turned()
{
  recon::ContourSet set;
  set.Contours.resize(3);
  set.Contours[0].Source = 2;
  set.Contours[1].Source = 0;
  set.Contours[2].Source = 1;
  return set;
}

TEST(CarriedMapping, FollowsContoursToTheirNewNumbers)
{
  recon::ContourMappingOptions options;
  const std::string words =
    recon::FollowMapping({ { 10, 10 }, { 11, 12 }, { 1, 0 }, { 10, 11, 12 } }, Turned(), options);
  EXPECT_EQ(options.ForcedJoins, (Pairs{ { 1, 2 } }));
  EXPECT_EQ(options.ForbiddenJoins, (Pairs{ { 1, 0 } }));
  EXPECT_NE(words.find("is followed: 1 join, and 1 pair that is not joined."), std::string::npos)
    << words;
}

TEST(CarriedMapping, LeavesPairsThatAreNamedAlready)
{
  recon::ContourMappingOptions options;
  options.ForbiddenJoins = { { 2, 1 } };
  const std::string words =
    recon::FollowMapping({ { 10 }, { 11 }, { 1 }, { 10, 11, 12 } }, Turned(), options);
  EXPECT_TRUE(options.ForcedJoins.empty());
  EXPECT_EQ(options.ForbiddenJoins.size(), 1u);
  EXPECT_NE(words.find("0 joins, and 0 pairs"), std::string::npos) << words;
}

TEST(CarriedMapping, LeavesContoursThatAreGone)
{
  recon::ContourMappingOptions options;
  static_cast<void>(
    recon::FollowMapping({ { 10 }, { 99 }, { 1 }, { 10, 11, 12 } }, Turned(), options));
  EXPECT_TRUE(options.ForcedJoins.empty());
}

TEST(CarriedMapping, SaysWhereItCannotBeFollowed)
{
  recon::ContourMappingOptions options;
  EXPECT_NE(recon::FollowMapping({ { 10 }, { 11 }, { 1 }, {} }, Turned(), options)
              .find("is not followed: their ContourId is missing."),
    std::string::npos);
  EXPECT_TRUE(options.ForcedJoins.empty());
}
}
