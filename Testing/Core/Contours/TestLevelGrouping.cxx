// SPDX-License-Identifier: GPL-3.0-or-later
// Which offsets are one level: by the spacing, never by the size of the contours.
#include "Contours/LevelGrouping.h"

#include <gtest/gtest.h>

#include <random>

using namespace recon;

namespace
{
/// A contour in a box of that many units beside the origin; boxes of other places have nothing in
/// common.
LevelCandidate At(double offset, double place = 0, double size = 10)
{
  LevelCandidate candidate;
  candidate.Offset = offset;
  candidate.Low = { 100 * place, 0 };
  candidate.High = { 100 * place + size, size };
  return candidate;
}

LevelGrouping Group(const std::vector<double>& offsets, bool millimetres = false)
{
  std::vector<LevelCandidate> candidates;
  for (double offset : offsets)
  {
    candidates.push_back(At(offset));
  }
  return GroupLevels(candidates, 0, millimetres);
}

TEST(LevelGrouping, EvenSlicesAreLevelsHoweverNear)
{
  for (double unit : { 1.0, 1e-3, 1e-9, 1e6 })
  {
    const LevelGrouping levels = Group({ 0, 1 * unit, 1.3 * unit, 2 * unit, 3 * unit });
    EXPECT_EQ(levels.LevelOf, (std::vector<int>{ 0, 1, 2, 3, 4 })) << unit;
    EXPECT_TRUE(levels.Merged.empty());
    EXPECT_DOUBLE_EQ(levels.Spacing, 0.7 * unit);
  }
}

TEST(LevelGrouping, NearerThanATwentiethOfTheSpacingIsOne)
{
  const LevelGrouping one = Group({ 3, 0, 1, 2.049, 2, 4, 5, 6 });
  EXPECT_EQ(one.LevelOf, (std::vector<int>{ 3, 0, 1, 2, 2, 4, 5, 6 }));
  EXPECT_EQ(one.Merged, std::vector<int>{ 2 });
  EXPECT_NEAR(one.WidestMerge, 0.049, 1e-12);
  EXPECT_DOUBLE_EQ(one.Tolerance, 0.05);
  EXPECT_EQ(Group({ 3, 0, 1, 2.051, 2, 4, 5, 6 }).Count, 8);
}

TEST(LevelGrouping, MillimetresAreCapped)
{
  EXPECT_EQ(Group({ 0, 10, 10.2, 20, 30 }, false).Count, 4);
  EXPECT_EQ(Group({ 0, 10, 10.2, 20, 30 }, true).Count, 5);
  EXPECT_EQ(Group({ 0, 10, 10.09, 20, 30 }, true).Count, 4);
  EXPECT_DOUBLE_EQ(Group({ 0, 10, 10.09, 20, 30 }, true).Tolerance, MostLevelTolerance);
}

TEST(LevelGrouping, MoreContoursBesideTheirSliceThanOnIt)
{
  // The median of all distances is that of contours of one slice here.
  for (bool millimetres : { true, false })
  {
    std::vector<LevelCandidate> candidates;
    std::mt19937 random(5);
    for (int slice = 0; slice < 8; ++slice)
    {
      for (int contour = 0; contour < 6; ++contour)
      {
        const double off = (static_cast<double>(random() % 1001) / 1000 - 0.5) * 0.08;
        candidates.push_back(At(3 * slice + off, contour));
      }
    }
    const LevelGrouping levels = GroupLevels(candidates, 0, millimetres);
    EXPECT_EQ(levels.Count, 8);
    EXPECT_EQ(levels.Merged.size(), 8u);
    for (int i = 0; i < 48; ++i)
    {
      EXPECT_EQ(levels.LevelOf[i], i / 6);
    }
    EXPECT_NEAR(levels.Spacing, 2.95, 0.1);
  }
}

TEST(LevelGrouping, ManySlicesOfOneThingAreNoLevel)
{
  // Three stacks far apart: as many small distances as where contours lie beside their slice.
  EXPECT_EQ(Group({ 0, 1, 2, 3, 100, 101, 102, 103, 200, 201, 202, 203 }).Count, 12);
  EXPECT_EQ(Group({ 0, 1, 2, 3, 100, 101, 102, 103 }).Count, 8);
}

TEST(LevelGrouping, GrowingDepthsAreLevels)
{
  EXPECT_EQ(Group({ 0, 2, 5, 10, 20, 50, 100, 200, 500, 1000 }).Count, 10);
  EXPECT_EQ(Group({ 0, 1, 2, 5, 10, 50, 100, 200, 300, 400, 500, 600, 700, 800 }).Count, 14)
    << "what is not small beside the distances around it is no level";
}

TEST(LevelGrouping, NoiseOfAContourIsNoDistance)
{
  std::vector<LevelCandidate> candidates{ At(0), At(0.004, 1), At(0.002, 2) };
  EXPECT_EQ(GroupLevels(candidates, 0, false).Count, 3);
  for (LevelCandidate& candidate : candidates)
  {
    candidate.Noise = 0.003;
  }
  const LevelGrouping levels = GroupLevels(candidates, 0, false);
  EXPECT_EQ(levels.Count, 1);
  EXPECT_TRUE(levels.Merged.empty()) << "rounding needs no word";
  EXPECT_EQ(levels.Spacing, 0);
}

TEST(LevelGrouping, AGivenToleranceIsTaken)
{
  const std::vector<LevelCandidate> candidates{ At(0), At(0.3), At(1), At(2), At(2.5) };
  EXPECT_EQ(GroupLevels(candidates, 0.4, true).LevelOf, (std::vector<int>{ 0, 0, 1, 2, 3 }));
  EXPECT_EQ(GroupLevels(candidates, 1e-5, true).Count, 5);
  EXPECT_EQ(GroupLevels(candidates, 1, true).Count, 1);
}

TEST(LevelGrouping, RoomIsTheNearerNeighbour)
{
  const LevelGrouping levels = Group({ 0, 1, 3, 6 });
  EXPECT_EQ(levels.Room, (std::vector<double>{ 1, 1, 2, 3 }));
  EXPECT_FALSE(std::isfinite(Group({ 5 }).Room[0]));
  EXPECT_EQ(Group({}).Count, 0);
}
}
