// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that are there twice are one contour; walls with their holes are two.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"
#include "Planar/LoopTwins.h"

#include <ctime>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<Point2> Rounded(const std::vector<Point2>& loop, double unit)
{
  std::vector<Point2> rounded;
  for (const Point2& p : loop)
  {
    const double power = std::round(1 / unit);
    rounded.push_back({ std::round(p[0] * power) / power, std::round(p[1] * power) / power });
  }
  return rounded;
}

std::vector<Point2> Jittered(const std::vector<Point2>& loop, double off, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-off, off);
  std::vector<Point2> jittered;
  for (const Point2& p : loop)
  {
    const double x = p[0] + uniform(random);
    jittered.push_back({ x, p[1] + uniform(random) });
  }
  return jittered;
}

/// With the sentence that says so, the first of both is left.
void ExpectFirstIsLeft(const std::vector<Point2>& first, const std::vector<Point2>& second,
  const std::string& how, bool secondStays = false)
{
  const ContourSet set = SoupMaker().Loop(first).Loop(second).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_EQ(set.Contours[0].Source, secondStays ? 1 : 0);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_TRUE(
    Reports(set, std::string("is the same as that of cell ") + (secondStays ? "1" : "0") + how));
  EXPECT_TRUE(Reports(set, "left out"));
}

void ExpectRing(const std::vector<Point2>& wall, const std::vector<Point2>& hole)
{
  const ContourSet set = SoupMaker().Loop(wall).Loop(hole).Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 2u);
  EXPECT_TRUE(set.Report.empty());
}

TEST(LoopTwins, OtherDecimals)
{
  const std::vector<Point2> fine = Rounded(Circle(0, 0, 10, 12), 1e-6);
  for (double unit : { 1.0, 0.1, 0.01, 0.001 })
  {
    ExpectFirstIsLeft(fine, Rounded(fine, unit), " within rounding");
    ExpectFirstIsLeft(Rounded(fine, unit), fine, " within rounding", true);
  }
}

TEST(LoopTwins, ThePlaneHasDecimalsOfItsOwn)
{
  const std::vector<Point2> fine = Rounded(Circle(0, 0, 10, 12), 1e-6);
  const ContourSet set =
    SoupMaker().Loop(fine, -17.4375).Loop(Rounded(fine, 0.1), -17.4375).Build();
  EXPECT_EQ(set.Contours.size(), 1u);
  EXPECT_TRUE(Reports(set, "within rounding"));
}

TEST(LoopTwins, DecimalsThatWereCut)
{
  std::vector<Point2> cut = Circle(3, 4, 10, 40);
  for (Point2& p : cut)
  {
    p = { std::trunc(p[0] * 10) / 10, std::trunc(p[1] * 10) / 10 };
  }
  ExpectFirstIsLeft(Circle(3, 4, 10, 40), cut, " within rounding");
}

TEST(LoopTwins, SinglePrecision)
{
  std::vector<Point2> single = Circle(500, 400, 30, 50);
  for (Point2& p : single)
  {
    p = { static_cast<double>(static_cast<float>(p[0])),
      static_cast<double>(static_cast<float>(p[1])) };
  }
  ExpectFirstIsLeft(Circle(500, 400, 30, 50), single, " within rounding");
}

TEST(LoopTwins, OtherStartOtherWayRoundPointsDropped)
{
  std::vector<Point2> again = Rounded(Circle(0, 0, 10, 24), 0.01);
  std::rotate(again.begin(), again.begin() + 7, again.end());
  std::reverse(again.begin(), again.end());
  ExpectFirstIsLeft(Circle(0, 0, 10, 24), again, " within rounding");
  // Every third point dropped: the chords between the others lie within the first.
  std::vector<Point2> fewer;
  for (std::size_t i = 0; i < again.size(); ++i)
  {
    if (i % 3 != 0)
    {
      fewer.push_back(again[i]);
    }
  }
  ExpectFirstIsLeft(again, fewer, " traced again");
  ExpectFirstIsLeft(fewer, again, " traced again", true);
}

TEST(LoopTwins, TracedAgain)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    ExpectFirstIsLeft(
      Circle(0, 0, 2, 48), Jittered(Circle(0, 0, 2, 48), 0.06, seed), " traced again");
    ExpectFirstIsLeft(
      Circle(0, 0, 2, 48), Jittered(Circle(0, 0, 2.02, 37), 0.06, seed), " traced again");
  }
}

TEST(LoopTwins, ThreeAndFourTimes)
{
  SoupMaker maker;
  maker.Loop(Circle(0, 0, 2, 48));
  maker.Loop(Jittered(Circle(0, 0, 2, 48), 0.04, 1));
  maker.Loop(Rounded(Circle(0, 0, 2, 48), 0.01));
  EXPECT_EQ(maker.Build().Contours.size(), 1u);
  EXPECT_EQ(maker.Build().Report.size(), 2u);
  maker.Loop(Jittered(Circle(0, 0, 2, 48), 0.04, 2));
  EXPECT_EQ(maker.Build().Contours.size(), 1u);
}

TEST(LoopTwins, AHoleAndItsTwinMakeOneHole)
{
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 10, 10))
                           .Loop(Circle(5, 5, 3, 60))
                           .Loop(Rounded(Circle(5, 5, 3, 60), 0.01))
                           .Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 2u);
  EXPECT_NEAR(SolidArea(set), 100 - 9 * 3.1358, 0.01);
}

TEST(LoopTwins, ThinWallsStay)
{
  ExpectRing(Circle(0, 0, 100, 200), Circle(0, 0, 99.9, 200));
  ExpectRing(Rounded(Circle(0, 0, 100, 200), 0.01), Rounded(Circle(0, 0, 99.9, 200), 0.01));
  ExpectRing({ { -11, 0 }, { 0, -11 }, { 11, 0 }, { 0, 11 } },
    { { -10, 0 }, { 0, -10 }, { 10, 0 }, { 0, 10 } });
  ExpectRing(Rectangle(0, 0, 30, 30), Rectangle(1, 1, 29, 29));
}

TEST(LoopTwins, OtherShapesThatOverlapStay)
{
  // A corner bitten off, a wall that crosses its hole in one place: by even-odd, as ever.
  const ContourSet bite =
    SoupMaker().Loop(Rectangle(0, 0, 10, 10)).Loop(Rectangle(9, 9, 11, 11)).Build();
  EXPECT_NEAR(SolidArea(bite), 102, 1e-9);
  std::vector<Point2> hole = Circle(0, 0, 9.8, 100);
  hole[10] = { hole[10][0] * 1.05, hole[10][1] * 1.05 };
  const ContourSet ring = SoupMaker().Loop(Circle(0, 0, 10, 100)).Loop(hole).Build();
  EXPECT_LT(SolidArea(ring), 15);
}

TEST(LoopTwins, EvenOddByDefinitionKeepsWhatIsTracedAgain)
{
  SoupMaker maker =
    SoupMaker().Loop(Circle(0, 0, 2, 48)).Loop(Jittered(Circle(0, 0, 2, 48), 0.06, 1));
  maker.Soup.Chains[1].ExclusiveOr = true;
  EXPECT_LT(SolidArea(maker.Build()), 2);
}

TEST(LoopTwins, ASpiralHardlyBesideItselfIsOneDisc)
{
  for (int turns : { 2, 3, 6 })
  {
    std::vector<Point2> spiral;
    for (int i = 0; i <= turns * 40; ++i)
    {
      const double angle = 2 * 3.14159265358979323846 * i / 40;
      const double radius = 5 + 1e-5 * i / 40;
      spiral.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    }
    const ContourSet set = SoupMaker().Loop(spiral).Build();
    CheckContourSet(set, 0);
    ASSERT_EQ(set.Contours.size(), 1u) << turns;
    EXPECT_NEAR(SolidArea(set), 78.22, 0.01);
    EXPECT_TRUE(Reports(set, "goes around once more within"));
  }
}

TEST(LoopTwins, UnitsOfNumbers)
{
  EXPECT_EQ(UnitOf({ 1, -20, 300 }), 1);
  EXPECT_DOUBLE_EQ(UnitOf({ 1, -20.5, 300 }), 0.1);
  EXPECT_DOUBLE_EQ(UnitOf({ -152.79, 0.01, 8.66 }), 0.01);
  EXPECT_DOUBLE_EQ(UnitOf({ 8.660254, 5, -10 }), 1e-6);
  EXPECT_DOUBLE_EQ(UnitOf({ 0.1 + 0.2 }), 0.1);
  EXPECT_EQ(UnitOf({ 1.0 / 3 }), 0);
  EXPECT_NEAR(UnitOf({ static_cast<double>(1.0f / 3) }), 4e-8, 1e-8);
  EXPECT_EQ(UnitOf({ 1e60 / 3 }), 0);
  EXPECT_EQ(UnitOf({}), 1);
}
}

TEST(LoopTwins, ScribblesOverOneAnotherAreNotComparedByArea)
{
  // Each crosses itself so often that its level ends in a sentence, whatever else it is.
  std::mt19937 random(5);
  std::normal_distribution<double> around(50, 10);
  std::vector<Point2> points;
  std::vector<std::vector<int>> loops(4);
  for (std::vector<int>& loop : loops)
  {
    for (int i = 0; i < 1000; ++i)
    {
      loop.push_back(static_cast<int>(points.size()));
      const double x = around(random);
      points.push_back({ x, around(random) });
    }
  }
  // Of the processor, as other tests may run beside this one.
  const std::clock_t start = std::clock();
  EXPECT_TRUE(FindLoopTwins(points, loops, { 0, 0, 0, 0 }, true).empty());
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 5);
}
