// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions, groups and filters of thesis chapter 3, on its own figure and on small cases.
#include "Contours/ContourMapping.h"
#include "Contours/LevelGaps.h"
#include "Contours/MappingGroups.h"
#include "SoupMaker.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
std::size_t At(int i)
{
  return static_cast<std::size_t>(i);
}

ContourMapping Map(const ContourSet& set, const ContourMappingOptions& options = {})
{
  Monitor monitor;
  return BuildContourMapping(set, options, monitor);
}

/// The row about a pair of contours (-1: Phi), or a row of slab -1.
ContourJoin Find(const ContourMapping& mapping, int lower, int upper)
{
  for (const ContourJoin& join : mapping.Joins)
  {
    if (join.LowerRegion == lower && join.UpperRegion == upper)
    {
      return join;
    }
  }
  return {};
}

/// Figures 3.1 and 3.2: A to G on level i, 1 to 8 on level j.
class Figure : public ::testing::Test
{
protected:
  Figure()
  {
    this->Add('A', 0, 0, 10, 10);
    this->Add('B', 3, 3, 7, 7);
    this->Add('C', 12, -10, 48, 20);
    this->Add('D', 42, 0, 46, 4);
    this->Add('E', 16, -6, 36, 16);
    this->Add('F', 18, -4, 34, 14);
    this->Add('G', 19, -2, 24, 2);
    this->Add('1', -5, -15, 40, 25);
    this->Add('2', 3.25, 3.25, 4.75, 6.75);
    this->Add('3', 5.25, 3.25, 6.75, 6.75);
    this->Add('4', 16, -6, 25.5, 16);
    this->Add('5', 26.5, -6, 36, 16);
    this->Add('6', 0, -12, 8, -4);
    this->Add('7', 17.5, -4, 25, 14);
    this->Add('8', 27, -4, 34, 14);
    this->Set = this->Maker.Build();
    this->Mapping = Map(this->Set);
  }

  void Add(char name, double x0, double y0, double x1, double y1)
  {
    this->Names.push_back(name);
    this->Maker.Loop(Rectangle(x0, y0, x1, y1), name < 'A' ? 1 : 0);
  }

  char NameOf(int contour) const { return this->Names[At(this->Set.Contours[At(contour)].Source)]; }
  int IdOf(char name) const
  {
    for (std::size_t c = 0; c < this->Set.Contours.size(); ++c)
    {
      if (this->NameOf(static_cast<int>(c)) == name)
      {
        return static_cast<int>(c);
      }
    }
    return -1;
  }

  std::string TextOf(const std::vector<int>& contours) const
  {
    std::set<char> names;
    for (int c : contours)
    {
      names.insert(this->NameOf(c));
    }
    return names.empty() ? "Phi" : std::string(names.begin(), names.end());
  }
  std::multiset<std::string> TextsOf(const std::vector<MappingGroup>& groups) const
  {
    std::multiset<std::string> texts;
    for (const MappingGroup& group : groups)
    {
      EXPECT_EQ(group.Slab, 0);
      texts.insert(this->TextOf(group.LowerContours) + " vs " + this->TextOf(group.UpperContours));
    }
    return texts;
  }

  ContourJoin Row(char lower, char upper) const
  {
    return Find(
      this->Mapping, lower == '-' ? -1 : this->IdOf(lower), upper == '-' ? -1 : this->IdOf(upper));
  }

  SoupMaker Maker;
  std::string Names;
  ContourSet Set;
  ContourMapping Mapping;
};

TEST_F(Figure, RegionsAreThoseOfTheText)
{
  std::multiset<std::string> solid;
  std::multiset<std::string> open;
  for (const ContourRegion& region : this->Mapping.Regions)
  {
    std::vector<int> all = region.Holes;
    all.push_back(region.Wall);
    (region.Solid ? solid : open).insert(this->TextOf(all));
  }
  EXPECT_EQ(solid, (std::multiset<std::string>{ "AB", "CDE", "FG", "123456", "7", "8" }));
  EXPECT_EQ(open, (std::multiset<std::string>{ "EF", "B", "D", "G", "47", "58", "2", "3", "6" }));
  EXPECT_EQ(this->Mapping.Regions[At(this->IdOf('C'))].Area, 36 * 30 - 16 - 20 * 22);
}

TEST_F(Figure, MappingGroupsAreThoseOfTheText)
{
  const std::vector<MappingGroup> all = FormMappingGroups(this->Mapping, this->Set);
  EXPECT_EQ(this->TextsOf(all),
    (std::multiset<std::string>{ "ABCDE vs 123456", "FG vs 78", "EF vs 4578", "B vs 23", "D vs Phi",
      "G vs Phi", "Phi vs 6" }));
}

TEST_F(Figure, RulesTwoAndThreeTreatDGAnd6)
{
  EXPECT_EQ(this->Row('G', '-').Rule, ContourJoin::InternalWall);
  EXPECT_EQ(this->Row('G', '-').InternalWallRule, 2);
  EXPECT_EQ(this->Row('D', '-').Rule, ContourJoin::InternalWall);
  EXPECT_EQ(this->Row('D', '-').InternalWallRule, 3);
  EXPECT_EQ(this->Row('-', '6').Rule, ContourJoin::InternalWall);
  EXPECT_EQ(this->Row('-', '6').InternalWallRule, 3);
  const std::string g = std::to_string(this->IdOf('G'));
  EXPECT_EQ(this->Row('G', '-').Words,
    "Hole " + g + " (z = 0) is closed towards z = 1: 100% of it faces solid there.");
  const std::string d = std::to_string(this->IdOf('D'));
  EXPECT_EQ(this->Row('D', '-').Words,
    "Hole " + d + " (z = 0) stays open towards z = 1: nothing of it faces solid there.");
  const std::vector<MappingGroup> kept =
    FilterInternalWalls(FormMappingGroups(this->Mapping, this->Set), this->Mapping);
  EXPECT_EQ(this->TextsOf(kept),
    (std::multiset<std::string>{
      "ABCDE vs 123456", "FG vs 78", "EF vs 4578", "B vs 23", "G vs Phi" }));
}

TEST_F(Figure, NoContourIsLeftInTwoGroups)
{
  EXPECT_EQ(this->TextsOf(this->Mapping.Groups),
    (std::multiset<std::string>{ "ABCDE vs 123456", "F vs 78", "G vs Phi" }));
}

TEST_F(Figure, JoinsSayWhatIsShared)
{
  const ContourJoin bridge = this->Row('F', '1');
  EXPECT_EQ(bridge.OverlapArea, 18);
  EXPECT_FALSE(bridge.Joined) << "only the web between the holes 4 and 5";
  EXPECT_DOUBLE_EQ(bridge.LowerRatio, 18.0 / (16 * 18 - 20));
  const ContourJoin hole = this->Row('E', '4');
  EXPECT_TRUE(hole.Joined);
  EXPECT_EQ(hole.OverlapArea, 65);
  EXPECT_EQ(hole.Words,
    "Hole " + std::to_string(this->IdOf('E')) + " (z = 0) is joined to hole " +
      std::to_string(this->IdOf('4')) + " (z = 1): they share 88% of the smaller one's area.");
}

TEST_F(Figure, HolesFollowTheWallsAroundThem)
{
  // Rule 1: without the join of C and 1, hole E cannot be joined to the holes of 1.
  ContourMappingOptions options;
  options.ForbiddenJoins = { { this->IdOf('1'), this->IdOf('C') } };
  options.ForcedJoins = { { this->IdOf('E'), this->IdOf('5') } };
  this->Mapping = Map(this->Set, options);
  for (char upper : { '4', '5' })
  {
    const ContourJoin row = this->Row('E', upper);
    EXPECT_FALSE(row.Joined);
    EXPECT_EQ(row.Rule, ContourJoin::InternalWall);
    EXPECT_EQ(row.InternalWallRule, 1);
    EXPECT_NE(row.Words.find("the walls around them"), std::string::npos) << row.Words;
  }
  EXPECT_TRUE(this->Row('B', '2').Joined);
  ASSERT_EQ(this->Mapping.Report.size(), 1u);
  EXPECT_NE(this->Mapping.Report[0].find("force that join, too"), std::string::npos);
  EXPECT_EQ(this->TextsOf(this->Mapping.Groups).count("AB vs 123456"), 1u);
  EXPECT_EQ(this->TextsOf(this->Mapping.Groups).count("CDE vs Phi"), 1u);
}

/// Below 0: x 0..10. Above 1: x 8..18, 2: x 30..40. All 10 high, so 0 and 1 share a fifth.
ContourSet ThreeSquares()
{
  return SoupMaker()
    .Loop(Rectangle(0, 0, 10, 10), 45)
    .Loop(Rectangle(8, 0, 18, 10), 48)
    .Loop(Rectangle(30, 0, 40, 10), 48)
    .Build();
}

TEST(ContourMapping, ThresholdDecides)
{
  const ContourSet set = ThreeSquares();
  ContourMappingOptions options;
  options.OverlapThreshold = 0.19;
  const ContourJoin joined = Find(Map(set, options), 0, 1);
  EXPECT_TRUE(joined.Joined);
  EXPECT_EQ(joined.Rule, ContourJoin::ByOverlap);
  EXPECT_EQ(joined.OverlapArea, 20);
  EXPECT_EQ(joined.LowerRatio, 0.2);
  EXPECT_EQ(joined.UpperRatio, 0.2);
  EXPECT_EQ(joined.Words,
    "Contour 0 (z = 45) is joined to contour 1 (z = 48): they share 20% of the smaller one's "
    "area.");
  options.OverlapThreshold = 0.2;
  const ContourMapping apart = Map(set, options);
  EXPECT_FALSE(Find(apart, 0, 1).Joined);
  EXPECT_EQ(Find(apart, 0, 1).Words,
    "Contour 0 (z = 45) is not joined to contour 1 (z = 48): they share 20% of the smaller one's "
    "area, and more than 20% is asked for.");
  EXPECT_EQ(Find(apart, 0, -1).Rule, ContourJoin::NoPartner);
  EXPECT_EQ(Find(apart, -1, 2).Words,
    "Contour 2 (z = 48) ends towards z = 45: nothing there is joined to it.");
  EXPECT_EQ(apart.Groups.size(), 3u);
}

TEST(ContourMapping, ForcedAndForbidden)
{
  const ContourSet set = ThreeSquares();
  ContourMappingOptions options;
  options.ForcedJoins = { { 2, 0 } };
  options.ForbiddenJoins = { { 0, 1 } };
  const ContourMapping mapping = Map(set, options);
  EXPECT_TRUE(mapping.Report.empty());
  EXPECT_TRUE(Find(mapping, 0, 2).Joined);
  EXPECT_EQ(Find(mapping, 0, 2).Rule, ContourJoin::Forced);
  EXPECT_EQ(Find(mapping, 0, 2).OverlapArea, 0);
  EXPECT_EQ(Find(mapping, 0, 2).Words,
    "Contour 0 (z = 45) is joined to contour 2 (z = 48) because the join is forced; they do not "
    "overlap.");
  EXPECT_FALSE(Find(mapping, 0, 1).Joined);
  EXPECT_EQ(Find(mapping, 0, 1).Rule, ContourJoin::Forbidden);
  ASSERT_EQ(mapping.Groups.size(), 2u);
  EXPECT_EQ(mapping.Groups[0].LowerContours, (std::vector<int>{ 0 }));
  EXPECT_EQ(mapping.Groups[0].UpperContours, (std::vector<int>{ 2 }));
}

TEST(ContourMapping, OverridesThatCannotBeFollowedAreReported)
{
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 10, 10), 0)
                           .Loop(Rectangle(2, 2, 8, 8), 0)
                           .Loop(Rectangle(0, 0, 10, 10), 1)
                           .Loop(Rectangle(0, 0, 10, 10), 2)
                           .Build();
  ContourMappingOptions options;
  options.ForcedJoins = { { 0, 3 }, { 0, 1 }, { 1, 2 }, { 7, 2 }, { -1, 2 }, { 0, 2 } };
  options.ForbiddenJoins = { { 2, 0 } };
  const ContourMapping mapping = Map(set, options);
  ASSERT_EQ(mapping.Report.size(), 6u);
  EXPECT_EQ(mapping.Report[0],
    "The forced join of contours 0 and 3 was left aside: they are on levels 0 and 2; only contours "
    "of adjacent levels can be joined.");
  EXPECT_NE(mapping.Report[1].find("levels 0 and 0"), std::string::npos);
  EXPECT_NE(mapping.Report[2].find("contour 1 is the wall of a hole"), std::string::npos);
  EXPECT_NE(mapping.Report[3].find("no contour 7; ContourId goes from 0 to 3"), std::string::npos);
  EXPECT_NE(mapping.Report[4].find("no contour -1"), std::string::npos);
  EXPECT_NE(mapping.Report[5].find("both forced and forbidden"), std::string::npos);
  EXPECT_FALSE(Find(mapping, 0, 2).Joined) << "forbidding wins";
}

/// One square a level, at 0, 1, 2, 8 and 9.
ContourSet Gapped()
{
  SoupMaker maker;
  for (double z : { 0.0, 1.0, 2.0, 8.0, 9.0 })
  {
    maker.Loop(Rectangle(0, 0, 1, 1), z);
  }
  return maker.Build();
}

TEST(ContourMapping, WideGapsAreNotBridged)
{
  ContourMappingOptions options;
  EXPECT_FALSE(Find(Map(Gapped(), options), 2, 3).Joined) << "wider than the default of 5";
  options.MaximumGap = 0;
  EXPECT_TRUE(Find(Map(Gapped(), options), 2, 3).Joined) << "no limit";
  options.MaximumGap = 6;
  EXPECT_TRUE(Find(Map(Gapped(), options), 2, 3).Joined) << "exactly as wide as allowed";
  options.MaximumGap = 5.9;
  const ContourMapping apart = Map(Gapped(), options);
  EXPECT_FALSE(Find(apart, 2, 3).Joined);
  EXPECT_EQ(Find(apart, 2, 3).Rule, ContourJoin::GapTooWide);
  EXPECT_EQ(Find(apart, 2, 3).Words,
    "Contour 2 (z = 2) is not joined to contour 3 (z = 8): the levels are 6 apart, more than 5.9 "
    "times the 1 between the levels beside them.");
  EXPECT_EQ(Find(apart, 2, -1).Words,
    "Contour 2 (z = 2) ends towards z = 8: the levels are too far apart to be joined.");
  EXPECT_TRUE(Find(apart, 3, 4).Joined);
  options.ForcedJoins = { { 2, 3 } };
  EXPECT_TRUE(Find(Map(Gapped(), options), 2, 3).Joined) << "a forced join wins over the gap";
}

/// Whether each slab is a gap: "0010".
std::string GapsOf(const std::vector<double>& offsets, double maximumGap = DefaultMaximumGap)
{
  SoupMaker maker;
  for (double z : offsets)
  {
    maker.Loop(Rectangle(0, 0, 1000, 1000), z);
  }
  std::string text;
  for (unsigned char gap : FindLevelGaps(maker.Build(), maximumGap).IsGap)
  {
    text += gap != 0 ? '1' : '0';
  }
  return text;
}

TEST(LevelGaps, AreMeasuredByTheSpacingBesideThem)
{
  EXPECT_EQ(GapsOf({ 0, 2, 5, 10, 20, 50, 100, 200, 500, 1000 }), "000000000") << "isobaths";
  EXPECT_EQ(GapsOf({ -1000, -500, -200, -100, -50, -20, -10, -5, -2, 0 }), "000000000");
  EXPECT_EQ(GapsOf({ 0, 1, 2, 3, 100, 101, 102, 103 }), "0001000") << "two stacks";
  EXPECT_EQ(GapsOf({ 0, 10, 20, 30, 230, 231, 232, 233, 234, 235 }), "000100000")
    << "whatever the median of all is";
  EXPECT_EQ(GapsOf({ 0, 1, 2, 3, 100, 200, 201, 202 }), "0001100") << "a lone slice is no bridge";
  EXPECT_EQ(GapsOf({ 0, 1, 2, 3, 8, 9, 10 }), "000000") << "a few slices that were skipped";
  EXPECT_EQ(GapsOf({ 0, 1, 2, 7, 12, 17, 22 }), "000000") << "and a stack that goes on coarsely";
  EXPECT_EQ(GapsOf({ 0, 1, 2, 2.1, 2.2, 2.3, 3, 4 }), "0000000") << "fine in the middle";
  EXPECT_EQ(GapsOf({ 0, 1, 11 }), "01");
  EXPECT_EQ(GapsOf({ 0, 100 }), "0") << "two slices";
  EXPECT_EQ(GapsOf({ 5 }), "");
  EXPECT_EQ(GapsOf({ 0, 1, 2, 3, 100, 101, 102, 103 }, 0), "0000000") << "no limit";
}

TEST(ContourMapping, ATipBesideItsContourIsJoined)
{
  const auto tipAt = [](double x)
  {
    return SoupMaker()
      .Loop(Rectangle(x, 0, x + 0.01, 1), 0)
      .Loop(Rectangle(-2, -2, 0, 2), 1)
      .Loop(Rectangle(-2, -2, 0, 2), 2)
      .Build();
  };
  const ContourMapping near = Map(tipAt(0.05), {});
  EXPECT_TRUE(Find(near, 0, 1).Joined);
  EXPECT_EQ(Find(near, 0, 1).Rule, ContourJoin::ByDistance);
  EXPECT_EQ(Find(near, 0, 1).Words,
    "Contour 0 (z = 0) is joined to contour 1 (z = 1): one of them overlaps nothing above or "
    "below, "
    "and they are 0.05 apart, next to nothing beside the 1 between their levels.");
  ASSERT_EQ(near.Groups.size(), 2u);
  EXPECT_EQ(near.Groups[0].LowerContours, (std::vector<int>{ 0 }));
  EXPECT_EQ(near.Groups[0].UpperContours, (std::vector<int>{ 1 }));
  EXPECT_EQ(near.Joins.size(), 2u) << "neither is said to end there";

  EXPECT_EQ(Find(Map(tipAt(0.15), {}), 0, -1).Rule, ContourJoin::NoPartner) << "not near enough";
  ContourMappingOptions options;
  options.ForbiddenJoins = { { 0, 1 } };
  EXPECT_FALSE(Find(Map(tipAt(0.05), options), 0, 1).Joined) << "forbidding wins";
}

TEST(ContourMapping, AFingerThatEndsIsNotJoinedToItsNeighbour)
{
  // Beside the next finger's contour by less than any slab, but it has a contour of its own below.
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 1, 1), 0)
                           .Loop(Rectangle(1.05, 0, 2, 1), 0)
                           .Loop(Rectangle(0, 0, 1, 1), 1)
                           .Loop(Rectangle(1.05, 0, 2, 1), 1)
                           .Loop(Rectangle(0, 0, 1, 1), 2)
                           .Build();
  EXPECT_EQ(Find(Map(set), 3, -1).Rule, ContourJoin::NoPartner);
}

TEST(ContourMapping, HolesThatFaceSolidInPart)
{
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 10, 10), 0)
                           .Loop(Rectangle(4, 2, 8, 8), 0)
                           .Loop(Rectangle(0, 0, 6, 10), 1)
                           .Build();
  const ContourJoin row = Find(Map(set), 1, -1);
  EXPECT_EQ(row.Rule, ContourJoin::NoPartner);
  EXPECT_EQ(row.InternalWallRule, 0);
  EXPECT_EQ(row.Words,
    "Hole 1 (z = 0) ends towards z = 1: it is closed where it faces solid there, which is 50% of "
    "it, and open elsewhere.");
}

TEST(ContourMapping, OneLevelHasNothingToMap)
{
  const ContourMapping mapping = Map(SoupMaker().Loop(Rectangle(0, 0, 1, 1), 0).Build());
  EXPECT_EQ(mapping.Regions.size(), 1u);
  EXPECT_TRUE(mapping.Joins.empty());
  EXPECT_TRUE(mapping.Groups.empty());
}

/// Rings of random place and size, a few hundred a level.
ContourSet ManyRings(int levels, int side)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  SoupMaker maker;
  for (int level = 0; level < levels; ++level)
  {
    for (int i = 0; i < side * side; ++i)
    {
      const double x = i % side + jitter(random);
      const double y = i / side + jitter(random);
      maker.Loop(Circle(x, y, 0.28, 12), level);
      maker.Loop(Circle(x, y, 0.15, 9), level);
    }
  }
  return maker.Build();
}

TEST(ContourMapping, ThreadsDoNotMatter)
{
  const ContourSet set = ManyRings(5, 8);
  ContourMappingOptions options;
  options.Threads = 1;
  const ContourMapping one = Map(set, options);
  options.Threads = 4;
  const ContourMapping four = Map(set, options);
  ASSERT_EQ(one.Joins.size(), four.Joins.size());
  for (std::size_t j = 0; j < one.Joins.size(); ++j)
  {
    EXPECT_EQ(one.Joins[j].Words, four.Joins[j].Words);
    EXPECT_EQ(one.Joins[j].OverlapArea, four.Joins[j].OverlapArea);
    EXPECT_EQ(one.Joins[j].Joined, four.Joins[j].Joined);
  }
  ASSERT_EQ(one.Groups.size(), four.Groups.size());
  for (std::size_t g = 0; g < one.Groups.size(); ++g)
  {
    EXPECT_EQ(one.Groups[g].LowerContours, four.Groups[g].LowerContours);
    EXPECT_EQ(one.Groups[g].UpperContours, four.Groups[g].UpperContours);
  }
}

TEST(ContourMapping, EveryContourIsInOneGroupOfEverySlab)
{
  const ContourSet set = ManyRings(3, 23);
  ASSERT_EQ(set.Contours.size(), 3u * 2 * 23 * 23);
  const ContourMapping mapping = Map(set);
  std::vector<int> below(set.Contours.size(), 0);
  std::vector<int> above(set.Contours.size(), 0);
  for (const MappingGroup& group : mapping.Groups)
  {
    for (int c : group.LowerContours)
    {
      EXPECT_EQ(set.Contours[At(c)].Level, group.Slab);
      ++above[At(c)];
    }
    for (int c : group.UpperContours)
    {
      EXPECT_EQ(set.Contours[At(c)].Level, group.Slab + 1);
      ++below[At(c)];
    }
  }
  for (std::size_t c = 0; c < set.Contours.size(); ++c)
  {
    EXPECT_EQ(above[c], set.Contours[c].Level < 2 ? 1 : 0) << "contour " << c;
    EXPECT_EQ(below[c], set.Contours[c].Level > 0 ? 1 : 0) << "contour " << c;
  }
}

TEST(ContourMapping, WrongOptionsAreRefused)
{
  const ContourSet set = ThreeSquares();
  for (double threshold : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    ContourMappingOptions options;
    options.OverlapThreshold = threshold;
    EXPECT_THROW(Map(set, options), Error) << threshold;
  }
  for (double gap : { -1.0, std::numeric_limits<double>::infinity() })
  {
    ContourMappingOptions options;
    options.MaximumGap = gap;
    EXPECT_THROW(Map(set, options), Error) << gap;
  }
  const ContourSet skew = SoupMaker()
                            .Loop(Rectangle(0, 0, 1, 1))
                            .Chain({ { 0, 0, 0 }, { 1, 0, 1 }, { 0, 3, 2 } }, true)
                            .Build(false);
  EXPECT_THROW(Map(skew), Error);
}

class Stopper : public Monitor
{
public:
  bool AbortRequested() override { return true; }
};

TEST(ContourMapping, StopsWhereAsked)
{
  Stopper stopper;
  EXPECT_THROW(BuildContourMapping(ThreeSquares(), {}, stopper), Aborted);
}
}
