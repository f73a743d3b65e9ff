// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that touch, overlap or cross themselves and one another.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"
#include "Planar/EvenOddRule.h"

using namespace recon;
using namespace recon::testing;

namespace
{
/// The result has the same inside as the even-odd rule on the loops as they came, at points off all
/// lines.
void ExpectSameInside(const std::vector<std::vector<Point2>>& loops, const ContourSet& set,
  const std::vector<Point2>& where)
{
  ContourSet given;
  for (const std::vector<Point2>& loop : loops)
  {
    Contour contour;
    for (const Point2& p : loop)
    {
      contour.Points.push_back(static_cast<int>(given.Planar.size()));
      given.Planar.push_back(p);
    }
    given.Contours.push_back(contour);
  }
  const auto parity = [](const ContourSet& s, const Point2& q)
  {
    int count = 0;
    for (const Contour& c : s.Contours)
    {
      count += Encloses(s, c, q);
    }
    return count % 2;
  };
  for (const Point2& q : where)
  {
    ASSERT_EQ(parity(given, q), parity(set, q)) << "at " << q[0] << " " << q[1];
  }
}

std::vector<Point2> RandomPoints(double low, double high, int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  std::vector<Point2> points;
  for (int i = 0; i < count; ++i)
  {
    const double x = uniform(random);
    points.push_back({ x, uniform(random) });
  }
  return points;
}

TEST(EvenOddRule, KeyholeBecomesOutlineAndHole)
{
  const ContourSet set = SoupMaker()
                           .Loop({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 0 }, { 1, 1 },
                             { 1, 2 }, { 2, 2 }, { 2, 1 }, { 1, 1 } })
                           .Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 2u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 15);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_TRUE(Reports(set, "touches or crosses itself"));
  EXPECT_TRUE(Reports(set, "into 2 contours"));
}

TEST(EvenOddRule, KeyholeBridgeOfOtherPointsOnTheWayBack)
{
  // The bridge is one edge on the way in, and has a point in its middle on the way back.
  const ContourSet set = SoupMaker()
                           .Loop({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 0 }, { 2, 2 },
                             { 2, 3 }, { 3, 3 }, { 3, 2 }, { 2, 2 }, { 1, 1 } })
                           .Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 2u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 15);
}

TEST(EvenOddRule, SpikeGoes)
{
  const ContourSet set =
    SoupMaker().Loop({ { 0, 0 }, { 2, 0 }, { 5, -3 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_EQ(set.Contours[0].Points.size(), 4u);
  EXPECT_TRUE(Reports(set, "1 edge walked more than once"));
}

TEST(EvenOddRule, SpikeAlongAnEdgeGoes)
{
  // Walks past the corner and back along the same line.
  const ContourSet set =
    SoupMaker().Loop({ { 0, 0 }, { 3, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 4);
}

TEST(EvenOddRule, BowTieBecomesTwoTriangles)
{
  const ContourSet set = SoupMaker().Loop({ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 2 } }, 9).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 2u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 2);
  EXPECT_EQ(set.Points.size(), 5u) << "the crossing is one shared point";
  EXPECT_EQ(std::count(set.Points.begin(), set.Points.end(), Point3{ 1, 1, 9 }), 1);
}

TEST(EvenOddRule, RingThatTouchesItself)
{
  // A square with a triangular hole that hangs on a corner point.
  const ContourSet hole =
    SoupMaker()
      .Loop({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 0 }, { 1, 2 }, { 2, 1 } })
      .Build();
  CheckContourSet(hole, 0);
  ASSERT_EQ(hole.Contours.size(), 2u);
  EXPECT_EQ(hole.Points.size(), 6u);
  EXPECT_DOUBLE_EQ(SolidArea(hole), 16 - 1.5);
  // Two squares walked in one go.
  const ContourSet two =
    SoupMaker()
      .Loop({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1 }, { 0, 1 } })
      .Build();
  CheckContourSet(two, 0);
  EXPECT_EQ(two.Contours.size(), 2u);
  EXPECT_DOUBLE_EQ(SolidArea(two), 2);
}

TEST(EvenOddRule, VertexOnAnEdgeOfAnother)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 4, 4)).Loop({ { 4, 2 }, { 6, 1 }, { 6, 3 } }).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 2u);
  EXPECT_EQ(set.Contours[0].Points.size(), 5u) << "the touching point is shared";
  EXPECT_DOUBLE_EQ(SolidArea(set), 18);
  EXPECT_TRUE(Reports(set, "1 point on an edge"));
}

TEST(EvenOddRule, ContoursThatTouchInAPointStayAsTheyAre)
{
  const ContourSet diagonal =
    SoupMaker().Loop(Rectangle(0, 0, 1, 1)).Loop(Rectangle(1, 1, 2, 2)).Build();
  CheckContourSet(diagonal, 0);
  EXPECT_EQ(diagonal.Contours.size(), 2u);
  EXPECT_EQ(diagonal.Points.size(), 7u);
  EXPECT_TRUE(diagonal.Report.empty()) << "nothing was changed";
}

TEST(EvenOddRule, NeighboursWithACommonBorderMerge)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 1, 1)).Loop(Rectangle(1, 0, 2, 1)).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 2);
  EXPECT_TRUE(Reports(set, "Contours of cells 0 and 1 (8 points, at offset 0): touch or cross"));
}

TEST(EvenOddRule, CrossingSquaresLeaveTwoCorners)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 2, 2)).Loop(Rectangle(1, 1, 3, 3)).Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 2u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 6);
  EXPECT_TRUE(Reports(set, "2 crossings"));
}

TEST(EvenOddRule, WhatVanishesIsNamed)
{
  // A square is covered by its two halves.
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 1, 1))
                           .Loop(Rectangle(2, 0, 3, 1))
                           .Loop(Rectangle(0, 0, 1, 0.5))
                           .Loop(Rectangle(0, 0.5, 1, 1))
                           .Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 1u);
  EXPECT_TRUE(
    Reports(set, "Contours of cells 0, 2 and 3 (12 points, at offset 0): cancel one another"));
}

TEST(EvenOddRule, NeighboursApartByRoundingMerge)
{
  // The second square's corners are the last bit off the first one's border, its other side whole.
  const double off = 4 + 1e-15;
  const ContourSet set = SoupMaker()
                           .Loop(Rectangle(0, 0, 4, 4))
                           .Loop({ { off, 1 }, { 8, 1 }, { 8, 4 + 1e-15 }, { off, 4 - 1e-15 } })
                           .Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_NEAR(SolidArea(set), 28, 1e-12);
  EXPECT_TRUE(Reports(set, "1 point merged with another, at most "));
  EXPECT_TRUE(Reports(set, "1 point on an edge"));
}

TEST(EvenOddRule, SlitsThatAreDrawnStay)
{
  const ContourSet set =
    SoupMaker().Loop(Rectangle(0, 0, 4, 4)).Loop(Rectangle(4 + 1e-5, 0, 8, 4)).Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 2u);
  EXPECT_TRUE(set.Report.empty());
}

TEST(EvenOddRule, RandomStarsKeepTheirInside)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    std::vector<std::vector<Point2>> loops;
    SoupMaker maker;
    for (unsigned l = 0; l < 1 + seed % 3; ++l)
    {
      loops.push_back(RandomPoints(0, 1, 5 + static_cast<int>(seed % 30), 1000 * seed + l));
      maker.Loop(loops.back());
    }
    const ContourSet set = maker.Build();
    CheckContourSet(set, 0);
    ExpectSameInside(loops, set, RandomPoints(0, 1, 300, 77 * seed));
    // Twenty random points in a row never make a simple polygon here; five may.
    EXPECT_TRUE(!set.Report.empty() || loops[0].size() < 20);
  }
}

TEST(EvenOddRule, RandomWalksOnAGridKeepTheirInside)
{
  // Every kind of overlap at once: corners, common edges, points on edges, crossings, spikes.
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<std::vector<Point2>> loops;
    SoupMaker maker;
    for (unsigned l = 0; l < 1 + seed % 4; ++l)
    {
      std::vector<Point2> loop;
      for (unsigned i = 0; i < 4 + random() % 12; ++i)
      {
        const double x = random() % 5;
        loop.push_back({ x, static_cast<double>(random() % 5) });
      }
      loops.push_back(loop);
    }
    // One far square, so that there is always something left.
    loops.push_back(Rectangle(10, 10, 11, 11));
    for (const auto& loop : loops)
    {
      maker.Loop(loop);
    }
    const ContourSet set = maker.Build();
    CheckContourSet(set, 0);
    // Equal loops count once, so the oracle must not see them twice.
    if (!Reports(set, "is the same as"))
    {
      ExpectSameInside(loops, set, RandomPoints(0, 4, 200, 5 * seed));
    }
  }
}

/// The boundary of the set pixels as unit edges, chained by the code under test.
TEST(EvenOddRule, PixelEdgesOfARandomImage)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    std::mt19937 random(seed);
    constexpr int n = 24;
    std::vector<std::vector<int>> pixel(n + 2, std::vector<int>(n + 2, 0));
    int count = 0;
    SoupMaker maker;
    for (int i = 1; i <= n; ++i)
    {
      for (int j = 1; j <= n; ++j)
      {
        pixel[At(i)][At(j)] = random() % 2 == 0 ? 1 : 0;
        count += pixel[At(i)][At(j)];
      }
    }
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= n; ++j)
      {
        if (pixel[At(i)][At(j)] != pixel[At(i + 1)][At(j)])
        {
          maker.Chain({ { i + 1.0, j + 0.0, 0 }, { i + 1.0, j + 1.0, 0 } }, false);
        }
        if (pixel[At(i)][At(j)] != pixel[At(i)][At(j + 1)])
        {
          maker.Chain({ { i + 0.0, j + 1.0, 0 }, { i + 1.0, j + 1.0, 0 } }, false);
        }
      }
    }
    const ContourSet set = maker.Build();
    CheckContourSet(set, 0);
    EXPECT_DOUBLE_EQ(SolidArea(set), count);
  }
}

TEST(EvenOddRule, SliversOfNearlyEqualContours)
{
  // Two circles that differ by rounding noise cross everywhere, at all scales down to an ulp.
  std::vector<Point2> points = Circle(100, 100, 10, 400);
  const std::vector<Point2> again = points;
  std::mt19937 random(5);
  for (const Point2& p : again)
  {
    points.push_back({ p[0] + (static_cast<double>(random() % 7) - 3) * 1.42e-14,
      p[1] + (static_cast<double>(random() % 7) - 3) * 1.42e-14 });
  }
  // Points that come out equal have to be one; here they are a little apart, if they are.
  std::vector<std::vector<int>> loops(2);
  std::map<Point2, int> first;
  for (int i = 0; i < 800; ++i)
  {
    const int number = first.emplace(points[At(i)], i).first->second;
    loops[i / 400].push_back(number);
  }
  const EvenOddResult result = ApplyEvenOddRule(points, loops);
  EXPECT_TRUE(result.Loops.empty());
  ASSERT_EQ(result.Clusters.size(), 1u);
  EXPECT_GT(result.Clusters[0].Merged, 0u);
  EXPECT_LT(result.Clusters[0].Moved, 1e-13);
}

TEST(EvenOddRule, AHundredThousandPointsNestOrCrossAsTheyShould)
{
  // A star polygon and a circle that lies inside or crosses its 400 flanks, away from its points.
  // The square of the points would run into the test's time limit.
  constexpr int n = 100000;
  std::vector<Point2> wave;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    const double radius = 10 + std::sin(200 * angle);
    wave.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  for (bool crossing : { false, true })
  {
    SoupMaker maker;
    maker.Loop(wave).Loop(crossing ? Circle(0, 0, 10.2503, 5000) : Circle(0, 0, 8, 5000));
    EXPECT_EQ(maker.Build().Contours.size(), crossing ? 400u : 2u);
  }
}
}
