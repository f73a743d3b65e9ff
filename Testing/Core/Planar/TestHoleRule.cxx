// SPDX-License-Identifier: GPL-3.0-or-later
// The same loops by each rule: which area is solid, and what is said about it.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"

using namespace recon;
using namespace recon::testing;

namespace
{
ContourSet Build(const SoupMaker& maker, HoleRule rule)
{
  ContourSetOptions options;
  options.Holes = rule;
  Monitor monitor;
  ContourSet set = BuildContourSet(maker.Soup, options, monitor);
  CheckContourSet(set, 0);
  return set;
}

/// Solid area by even-odd, winding and keyhole.
std::array<double, 3> Areas(const SoupMaker& maker)
{
  EXPECT_EQ(
    SolidArea(Build(maker, HoleRule::Automatic)), SolidArea(Build(maker, HoleRule::EvenOdd)));
  return { SolidArea(Build(maker, HoleRule::EvenOdd)), SolidArea(Build(maker, HoleRule::Winding)),
    SolidArea(Build(maker, HoleRule::Keyhole)) };
}

std::vector<Point2> Reversed(std::vector<Point2> loop)
{
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// 10 x 10 with a hole of 4 x 4, by a bridge from (0, 5) to (3, 5).
std::vector<Point2> Keyhole()
{
  return { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 }, { 0, 5 }, { 3, 5 }, { 3, 7 }, { 7, 7 },
    { 7, 3 }, { 3, 3 }, { 3, 5 }, { 0, 5 } };
}

using Three = std::array<double, 3>;

TEST(HoleRule, NestedInTheSameDirection)
{
  const SoupMaker maker = SoupMaker().Loop(Rectangle(0, 0, 10, 10)).Loop(Rectangle(3, 3, 7, 7));
  EXPECT_EQ(Areas(maker), (Three{ 84, 100, 100 }));
  EXPECT_EQ(Build(maker, HoleRule::Automatic).Levels[0].HoleNote,
    "Even-odd (automatic): 1 hole (1 drawn in the direction of the wall around).");
  const ContourSet winding = Build(maker, HoleRule::Winding);
  EXPECT_EQ(winding.Levels[0].HoleNote, "Winding: no holes, 1 contour within solid left out.");
  ASSERT_EQ(winding.Report.size(), 1u);
  EXPECT_NE(winding.Report[0].find("lies within solid by the winding rule"), std::string::npos);
}

TEST(HoleRule, NestedInOppositeDirections)
{
  const SoupMaker maker =
    SoupMaker().Loop(Rectangle(0, 0, 10, 10)).Loop(Reversed(Rectangle(3, 3, 7, 7)));
  EXPECT_EQ(Areas(maker), (Three{ 84, 84, 100 }));
  EXPECT_EQ(Build(maker, HoleRule::Winding).Levels[0].HoleNote,
    "Winding: 1 hole (1 drawn opposite to the wall around).");
}

TEST(HoleRule, TheWholeLevelMayRunTheOtherWay)
{
  const SoupMaker maker = SoupMaker()
                            .Loop(Reversed(Rectangle(0, 0, 10, 10)))
                            .Loop(Rectangle(3, 3, 7, 7))
                            .Loop(Reversed(Rectangle(4, 4, 6, 6)));
  EXPECT_EQ(Areas(maker), (Three{ 88, 88, 100 }));
}

TEST(HoleRule, BridgesAreCutByAll)
{
  const SoupMaker maker = SoupMaker().Loop(Keyhole());
  EXPECT_EQ(Areas(maker), (Three{ 84, 84, 84 }));
  for (HoleRule rule : { HoleRule::EvenOdd, HoleRule::Winding, HoleRule::Keyhole })
  {
    const ContourSet set = Build(maker, rule);
    ASSERT_EQ(set.Contours.size(), 2u);
    EXPECT_NE(set.Levels[0].HoleNote.find("1 hole (1 by keyholes)"), std::string::npos)
      << set.Levels[0].HoleNote;
  }
}

TEST(HoleRule, IslandsInKeyholesStay)
{
  const SoupMaker maker = SoupMaker().Loop(Keyhole()).Loop(Rectangle(4, 4, 6, 6));
  EXPECT_EQ(Areas(maker), (Three{ 88, 88, 88 }));
}

TEST(HoleRule, ContoursWithinTheSolidOfAKeyhole)
{
  const SoupMaker maker =
    SoupMaker().Loop(Keyhole()).Loop(Rectangle(8, 1, 9, 2)).Loop(Reversed(Rectangle(8, 4, 9, 5)));
  EXPECT_EQ(Areas(maker), (Three{ 82, 83, 84 }));
}

TEST(HoleRule, OverlappingContours)
{
  // Two squares that share 4 x 4.
  const SoupMaker same = SoupMaker().Loop(Rectangle(0, 0, 8, 8)).Loop(Rectangle(4, 4, 12, 12));
  EXPECT_EQ(Areas(same), (Three{ 96, 112, 112 }));
  const SoupMaker opposite =
    SoupMaker().Loop(Rectangle(0, 0, 8, 8)).Loop(Reversed(Rectangle(4, 4, 12, 12)));
  EXPECT_EQ(Areas(opposite), (Three{ 96, 96, 112 }));
  const ContourSet united = Build(same, HoleRule::Winding);
  ASSERT_EQ(united.Contours.size(), 1u);
  EXPECT_EQ(united.Contours[0].Points.size(), 8u);
  ASSERT_EQ(united.Report.size(), 1u);
  EXPECT_NE(united.Report[0].find("resolved by the winding rule into 1 contour"), std::string::npos)
    << united.Report[0];
}

TEST(HoleRule, NeighboursWithACommonEdge)
{
  const SoupMaker maker = SoupMaker().Loop(Rectangle(0, 0, 2, 2)).Loop(Rectangle(2, 0, 4, 2));
  EXPECT_EQ(Areas(maker), (Three{ 8, 8, 8 }));
  EXPECT_EQ(Build(maker, HoleRule::Winding).Contours.size(), 1u);
}

TEST(HoleRule, ContoursThatTouchTheirHolesWall)
{
  // The inner square stands on the outer one's lower edge.
  const SoupMaker maker = SoupMaker().Loop(Rectangle(0, 0, 10, 10)).Loop(Rectangle(3, 0, 7, 4));
  EXPECT_EQ(Areas(maker), (Three{ 84, 100, 100 }));
}

TEST(HoleRule, LoopsThatWindTwice)
{
  // Around the inner square twice: even-odd leaves a ring.
  const SoupMaker maker = SoupMaker().Loop({ { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 }, { 0, 3 },
    { 3, 3 }, { 7, 3 }, { 7, 7 }, { 3, 7 }, { 3, 3 }, { 0, 3 } });
  const Three areas = Areas(maker);
  EXPECT_EQ(areas[0], 84);
  EXPECT_EQ(areas[1], 100) << "both turns go the same way";
  EXPECT_EQ(areas[2], 84) << "a loop by itself goes by even-odd";
}

TEST(HoleRule, ExclusiveOrGoesByEvenOddAlways)
{
  SoupMaker maker = SoupMaker()
                      .Loop(Rectangle(0, 0, 10, 10), 0)
                      .Loop(Rectangle(3, 3, 7, 7), 0)
                      .Loop(Rectangle(0, 0, 10, 10), 1)
                      .Loop(Rectangle(3, 3, 7, 7), 1);
  maker.Soup.Chains[0].ExclusiveOr = maker.Soup.Chains[1].ExclusiveOr = true;
  const ContourSet set = Build(maker, HoleRule::Winding);
  EXPECT_EQ(set.Levels[0].Contours.size(), 2u);
  EXPECT_EQ(set.Levels[1].Contours.size(), 1u) << "only planes with such contours";
  EXPECT_EQ(set.Levels[0].HoleNote,
    "Even-odd, as CLOSEDPLANAR_XOR contours ask for: 1 hole (1 drawn in the direction of the wall "
    "around).");
  ASSERT_EQ(set.Report.size(), 2u);
  EXPECT_TRUE(std::any_of(set.Report.begin(), set.Report.end(),
    [](const std::string& line) { return line.find("CLOSEDPLANAR_XOR") != std::string::npos; }));
  EXPECT_TRUE(Build(maker, HoleRule::Automatic).Report.empty());
}

TEST(HoleRule, RandomLoopsByDefinition)
{
  // Solid or not, at random places, against the winding numbers of the input itself.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0, 10);
  for (int round = 0; round < 30; ++round)
  {
    SoupMaker maker;
    std::vector<std::vector<Point2>> loops;
    for (int l = 0; l < 4; ++l)
    {
      std::vector<Point2> loop;
      for (int p = 0; p < 7; ++p)
      {
        loop.push_back({ anywhere(random), anywhere(random) });
      }
      maker.Loop(loop);
      loops.push_back(loop);
    }
    const auto turns = [](const std::vector<Point2>& loop, const Point2& q)
    {
      int count = 0;
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point2& a = loop[i];
        const Point2& b = loop[(i + 1) % loop.size()];
        if ((a[1] <= q[1]) != (b[1] <= q[1]))
        {
          const bool up = b[1] > a[1];
          count += (Orientation2(a, b, q) > 0) == up ? (up ? 1 : -1) : 0;
        }
      }
      return count;
    };
    const ContourSet winding = Build(maker, HoleRule::Winding);
    const ContourSet keyhole = Build(maker, HoleRule::Keyhole);
    for (int i = 0; i < 200; ++i)
    {
      const Point2 q{ anywhere(random), anywhere(random) };
      int sum = 0;
      bool any = false;
      for (const std::vector<Point2>& loop : loops)
      {
        const int n = turns(loop, q);
        sum += n;
        any = any || n % 2 != 0;
      }
      const auto isSolid = [&](const ContourSet& set)
      {
        int depth = 0;
        for (const Contour& contour : set.Contours)
        {
          std::vector<Point2> loop;
          for (int p : contour.Points)
          {
            loop.push_back(set.Planar[At(p)]);
          }
          depth += turns(loop, q) != 0;
        }
        return depth % 2 == 1;
      };
      EXPECT_EQ(isSolid(winding), sum != 0) << "round " << round << ", place " << i;
      EXPECT_EQ(isSolid(keyhole), any) << "round " << round << ", place " << i;
    }
  }
}
}
