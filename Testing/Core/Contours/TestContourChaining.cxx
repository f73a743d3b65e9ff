// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that arrive in pieces.
#include "ContourInvariants.h"
#include "SoupMaker.h"

using namespace recon;
using namespace recon::testing;

namespace
{
TEST(ContourChaining, ShuffledSegmentsChain)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SoupMaker maker;
    maker.Segments(SoupMaker::Lift(Circle(0, 0, 10, 101), 1), seed);
    maker.Segments(SoupMaker::Lift(Circle(0, 0, 4, 37), 1), seed + 100);
    maker.Segments(SoupMaker::Lift(Circle(0, 0, 4, 37), 2), seed + 200);
    const ContourSet set = maker.Build();
    CheckContourSet(set, 0);
    ASSERT_EQ(set.Contours.size(), 3u);
    ASSERT_EQ(set.Levels.size(), 2u);
    EXPECT_EQ(set.Contours[0].Points.size() + set.Contours[1].Points.size(), 138u);
    EXPECT_EQ(set.Contours[0].Depth + set.Contours[1].Depth, 1);
    EXPECT_TRUE(set.Report.empty());
  }
}

TEST(ContourChaining, PiecesInAnyDirectionChain)
{
  // Two halves of a square, both running from left to right.
  const ContourSet set = SoupMaker()
                           .Chain({ { 0, 0, 0 }, { 1, -1, 0 }, { 2, 0, 0 } }, false)
                           .Chain({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 } }, false)
                           .Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_EQ(set.Contours[0].Points.size(), 4u);
  EXPECT_DOUBLE_EQ(set.Contours[0].SignedArea, 2);
}

TEST(ContourChaining, FirstPointRepeatedIsNoFault)
{
  std::vector<Point2> square = Rectangle(0, 0, 1, 1);
  square.push_back(square[0]);
  for (bool closed : { true, false })
  {
    const ContourSet set = SoupMaker().Chain(SoupMaker::Lift(square, 0), closed).Build();
    CheckContourSet(set, 0);
    EXPECT_EQ(set.Contours[0].Points.size(), 4u);
    EXPECT_TRUE(set.Report.empty());
  }
}

TEST(ContourChaining, RepeatedPointsAreRemovedAndSaid)
{
  const ContourSet set =
    SoupMaker()
      .Loop({ { 0, 0 }, { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 1 }, { 1, 1 }, { 0, 1 }, { 0, 0 } })
      .Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours[0].Points.size(), 4u);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_TRUE(Reports(set, "Contour of cell 0 (8 points, at offset 0): 3 points equal"));
}

TEST(ContourChaining, SmallGapsCloseLargeOnesDoNot)
{
  const auto withGap = [](double gap)
  {
    return SoupMaker()
      .Loop(Rectangle(-5, -5, -4, -4))
      .Chain(
        { { 0, gap, 0 }, { 0, 1, 0 }, { 0.2, 1, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }, false)
      .Build();
  };
  const ContourSet closed = withGap(1e-6);
  CheckContourSet(closed, 0);
  ASSERT_EQ(closed.Contours.size(), 2u);
  EXPECT_EQ(closed.Contours[1].Points.size(), 5u);
  EXPECT_TRUE(Reports(closed, "was closed where ends lay within"));
  const ContourSet narrow = withGap(1e-2);
  CheckContourSet(narrow, 0);
  ASSERT_EQ(narrow.Contours.size(), 2u);
  EXPECT_EQ(narrow.Contours[1].Points.size(), 6u);
  EXPECT_EQ(narrow.Report,
    std::vector<std::string>{
      "Contour of cell 1 (6 points, at offset 0): was closed by a straight "
      "line, as its ends are 0.01 apart, no more than its points (0.99)." });
}

TEST(ContourChaining, ALineIsClosedOverItsOwnSpacingAndNotFurther)
{
  const auto arc = [](int missing)
  {
    std::vector<Point2> points = Circle(0, 0, 10, 50);
    points.resize(points.size() - static_cast<std::size_t>(missing));
    return SoupMaker().Loop(Rectangle(20, 20, 21, 21)).Chain(SoupMaker::Lift(points, 0), false);
  };
  const ContourSet closed = arc(0).Build();
  EXPECT_EQ(closed.Contours.size(), 2u) << "the ends are as far apart as the points";
  EXPECT_TRUE(Reports(closed, "closed by a straight line"));
  const ContourSet open = arc(1).Build();
  EXPECT_EQ(open.Contours.size(), 1u);
  EXPECT_TRUE(Reports(open, "Contour of cell 1 (49 points, at offset 0): is open, its ends are"));
  EXPECT_TRUE(open.Warning.empty()) << "one of two is not most";
  const ContourSet chord = arc(20).Build(true, 0, OpenLineRule::Chord);
  EXPECT_EQ(chord.Contours.size(), 2u);
  EXPECT_TRUE(Reports(chord, "closed by a straight line, as OpenLines asks"));
  // A triangle without its third side encloses nothing that its ends could tell.
  EXPECT_EQ(SoupMaker()
              .Loop(Rectangle(20, 20, 21, 21))
              .Chain({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.9, 0 } }, false)
              .Build()
              .Contours.size(),
    1u);
}

TEST(ContourChaining, MostlyOpenIsSaidLoudly)
{
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 1, 1));
  for (int i = 1; i < 4; ++i)
  {
    const double x = 10.0 * i;
    maker.Chain({ { x, 0, 0 }, { x + 1, 0, 0 }, { x + 1, 9, 0 }, { x, 12, 0 } }, false);
  }
  const ContourSet set = maker.Build();
  EXPECT_EQ(set.Warning.find("3 of 4 contours are open and left out"), 0u) << set.Warning;
  EXPECT_EQ(set.Report[0], set.Warning);
  EXPECT_TRUE(maker.Build(true, 0, OpenLineRule::Chord).Warning.empty());
}

TEST(ContourChaining, OpenLinesOnlyAreNothingToDo)
{
  SoupMaker wires;
  wires.Chain({ { 0, 0, 0 }, { 1, 0, 1 }, { 2, 0, 5 } }, false).Chain({ { 9, 9, 9 } }, false);
  EXPECT_THROW(wires.Build(), NothingToDo);
  wires.Loop({ { 0, 0 }, { 1, 1 }, { 2, 2 } });
  try
  {
    wires.Build();
    ADD_FAILURE() << "a contour that encloses nothing";
  }
  catch (const NothingToDo&)
  {
    ADD_FAILURE() << "was meant to be a contour";
  }
  catch (const Error&)
  {
  }
}

TEST(ContourChaining, AnOpenChainOfSegmentsIsOneSentence)
{
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 1, 1));
  for (int i = 0; i < 30; ++i)
  {
    const double a = (i * 7) % 30;
    maker.Chain({ { a, 5, 0 }, { a + 1, 5, 0 } }, false);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 1u);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_TRUE(Reports(set, "(31 points, at offset 0): is open, its ends are 30 apart"));
}

TEST(ContourChaining, ALoopWithATailLosesTheTailOnly)
{
  SoupMaker maker;
  maker.Segments(SoupMaker::Lift(Circle(0, 0, 1, 12), 0), 5);
  const Point2 start = Circle(0, 0, 1, 12)[3];
  maker.Chain({ { start[0], start[1], 0 }, { 0, 2, 0 }, { 0, 3, 0 } }, false);
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_EQ(set.Contours[0].Points.size(), 12u);
  EXPECT_TRUE(Reports(set, "(3 points, at offset 0): is open"));
}

TEST(ContourChaining, SegmentsGivenTwiceCountOnce)
{
  SoupMaker maker;
  maker.Segments(SoupMaker::Lift(Rectangle(0, 0, 1, 1), 0), 3);
  maker.Segments(SoupMaker::Lift(Rectangle(0, 0, 1, 1), 0), 4);
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 1u);
  EXPECT_TRUE(Reports(set, "4 loose segments"));
}

TEST(ContourChaining, LoopsThatTouchInAPointStayTwo)
{
  // A checkerboard corner in loose segments: four edges meet there.
  SoupMaker maker;
  maker.Segments(SoupMaker::Lift(Rectangle(0, 0, 1, 1), 0), 3);
  maker.Segments(SoupMaker::Lift(Rectangle(1, 1, 2, 2), 0), 4);
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  ASSERT_EQ(set.Contours.size(), 2u);
  EXPECT_EQ(set.Points.size(), 7u);
  EXPECT_DOUBLE_EQ(SolidArea(set), 2);
}

TEST(ContourChaining, IndicesKeepCrossingPlanesApart)
{
  // Two circles in orthogonal planes that meet in two points, as pieces that share indices in their
  // own plane only.
  SoupMaker maker;
  for (int plane = 0; plane < 2; ++plane)
  {
    std::vector<int> ids;
    for (const Point2& p : Circle(0, 0, 1, 16))
    {
      // The points on the common line are bit-equal in both planes.
      ids.push_back(
        maker.AddPoint(plane == 0 ? Point3{ p[0], p[1], 0 }
                                  : Point3{ p[0], 0, std::abs(p[1]) < 1e-9 ? 0 : p[1] }));
    }
    maker.Soup.Points[At(ids[8])][1] = 0;
    maker.Soup.Points[At(ids[0])][1] = 0;
    for (std::size_t i = 0; i < 16; i += 4)
    {
      LoopSoup::Chain chain;
      chain.Source = static_cast<int>(maker.Soup.Chains.size());
      for (std::size_t k = 0; k <= 4; ++k)
      {
        chain.Points.push_back(ids[(i + k) % 16]);
      }
      maker.Soup.Chains.push_back(chain);
    }
  }
  const ContourSet set = maker.Build(false);
  CheckContourSet(set, 1e-12);
  EXPECT_FALSE(set.Parallel);
  ASSERT_EQ(set.Levels.size(), 2u);
  EXPECT_EQ(set.Contours[0].Points.size(), 16u);
  EXPECT_EQ(set.Contours[1].Points.size(), 16u);
}
}
