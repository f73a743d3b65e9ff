// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be a contour is named and left out, and takes nothing else down.
#include "ContourInvariants.h"
#include "SoupMaker.h"

#include <algorithm>
#include <limits>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A good square at z = 3, cell 0, beside what the test adds.
SoupMaker GoodSquare()
{
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 1, 1), 3);
  return maker;
}

std::vector<Point2> Scribble(int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Point2> scribble;
  for (int i = 0; i < count; ++i)
  {
    scribble.push_back({ 1e-3 * static_cast<double>(random() % 100000),
      1e-3 * static_cast<double>(random() % 100000) });
  }
  return scribble;
}

void ExpectOnlyTheSquare(const SoupMaker& maker, const std::string& sentence)
{
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 1u);
  EXPECT_EQ(set.Contours[0].Source, 0);
  EXPECT_DOUBLE_EQ(SolidArea(set), 1);
  ASSERT_EQ(set.Report.size(), 1u) << "one sentence for one contour";
  EXPECT_EQ(set.Report[0], sentence);
}

std::string ErrorOf(const SoupMaker& maker, double tolerance = 0)
{
  try
  {
    maker.Build(true, tolerance);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

TEST(ContourSetBuilderInvalid, OnePoint)
{
  ExpectOnlyTheSquare(GoodSquare().Chain({ { 5, 5, 3 } }, false),
    "Contour of cell 1 (1 point, at offset 3): has only 1 distinct point, which enclose nothing; "
    "left out.");
}

TEST(ContourSetBuilderInvalid, TwoPoints)
{
  ExpectOnlyTheSquare(GoodSquare().Chain({ { 5, 5, 3 }, { 6, 5, 3 } }, true),
    "Contour of cell 1 (2 points, at offset 3): has only 2 distinct points, which enclose nothing; "
    "left out.");
}

TEST(ContourSetBuilderInvalid, NoPoints)
{
  ExpectOnlyTheSquare(GoodSquare().Chain({}, true),
    "Contour of cell 1 (0 points): has only 0 distinct points, which enclose nothing; left out.");
}

TEST(ContourSetBuilderInvalid, NotANumber)
{
  ExpectOnlyTheSquare(GoodSquare().Loop({ { 0, 5 }, { 1, 5 }, { NaN, 6 } }, 3),
    "Contour of cell 1 (3 points, at offset 3): has a coordinate that is not a finite number; left "
    "out.");
  ExpectOnlyTheSquare(GoodSquare().Loop({ { NaN, NaN }, { NaN, NaN }, { NaN, NaN } }, NaN),
    "Contour of cell 1 (3 points): has a coordinate that is not a finite number; left out.");
  ExpectOnlyTheSquare(GoodSquare().Loop({ { 0, 5 }, { 1, 5 }, { 0, Infinity } }, 3),
    "Contour of cell 1 (3 points, at offset 3): has a coordinate that is not a finite number; left "
    "out.");
  ExpectOnlyTheSquare(GoodSquare().Loop({ { 0, 5 }, { 1, 5 }, { 0, 1e200 } }, 3),
    "Contour of cell 1 (3 points, at offset 3): has a coordinate beyond 1e60; left out.");
}

TEST(ContourSetBuilderInvalid, PointThatDoesNotExist)
{
  SoupMaker maker = GoodSquare();
  maker.Loop(Rectangle(5, 5, 6, 6), 3);
  maker.Soup.Chains[1].Points[2] = 1000;
  ExpectOnlyTheSquare(maker,
    "Contour of cell 1 (4 points, at offset 3): refers to a point that does not exist; left out.");
  maker.Soup.Chains[1].Points[2] = -1;
  ExpectOnlyTheSquare(maker,
    "Contour of cell 1 (4 points, at offset 3): refers to a point that does not exist; left out.");
}

TEST(ContourSetBuilderInvalid, Open)
{
  ExpectOnlyTheSquare(
    GoodSquare().Chain({ { 5, 5, 3 }, { 6, 5, 3 }, { 6, 6, 3 }, { 5, 7, 3 } }, false),
    "Contour of cell 1 (4 points, at offset 3): is open, its ends are 2 apart; left out.");
}

TEST(ContourSetBuilderInvalid, NoArea)
{
  ExpectOnlyTheSquare(GoodSquare().Loop({ { 5, 5 }, { 6, 6 }, { 8, 8 } }, 3),
    "Contour of cell 1 (3 points, at offset 3): encloses no area (1 point on an edge, 2 edges "
    "walked "
    "more than once); left out.");
  ExpectOnlyTheSquare(GoodSquare().Loop({ { 5, 5 }, { 6, 6 }, { 8, 7 }, { 6, 6 } }, 3),
    "Contour of cell 1 (4 points, at offset 3): encloses no area (2 edges walked more than once, 1 "
    "point passed again); left out.");
}

TEST(ContourSetBuilderInvalid, TheSameTwice)
{
  SoupMaker turned = GoodSquare();
  turned.Loop({ { 1, 0 }, { 0, 0 }, { 0, 1 }, { 1, 1 } }, 3);
  ExpectOnlyTheSquare(
    turned, "Contour of cell 1 (4 points, at offset 3): is the same as that of cell 0; left out.");
}

TEST(ContourSetBuilderInvalid, NotPlanar)
{
  const ContourSet set = GoodSquare()
                           .Loop(Rectangle(0, 0, 1, 1), 4)
                           .Chain({ { 5, 5, 3 }, { 6, 5, 3.5 }, { 6, 6, 3 }, { 5, 6, 3.5 } }, true)
                           .Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Contours.size(), 2u);
  ASSERT_EQ(set.Report.size(), 1u);
  EXPECT_TRUE(Reports(set,
    "Contour of cell 2 (4 points, at offset 3): is not planar, its points lie "
    "up to 0.25 off their plane"));
}

TEST(ContourSetBuilderInvalid, OneSentenceAKindTheImportantFirst)
{
  SoupMaker maker = GoodSquare();
  for (int i = 0; i < 5; ++i)
  {
    const double x = 10.0 * (i + 1);
    maker.Chain({ { x, 5, 3 }, { x + 1.5 + i, 5, 3 } }, true);
  }
  maker.Loop({ { 0, 20 }, { 1, 20 }, { 1, 20 }, { 0, 21 } }, 3);
  maker.Loop({ { 5, 20 }, { 6, 20 }, { 6, 20 }, { 6, 20 }, { 5, 21 } }, 3);
  maker.Chain({ { 5, 50, 3 }, { 6, 50, 3 }, { 6, 51, 3 }, { 5, 57, 3 } }, false);
  const ContourSet set = maker.Build();
  CheckContourSet(set, 0);
  EXPECT_EQ(set.Report,
    (std::vector<std::string>{ "6 contours were left out, 3 are kept.",
      "5 contours, the first of cell 1 (2 points, at offset 3): has only 2 distinct points, which "
      "enclose "
      "nothing; "
      "left out. Likewise cell 2 (2 points, at offset 3), cell 3 (2 points, at offset 3) and 2 "
      "more.",
      "Contour of cell 8 (4 points, at offset 3): is open, its ends are 7 apart; left out.",
      "2 contours, the first of cell 6 (4 points, at offset 3): 1 point equal to the one before "
      "was removed. "
      "Likewise cell 7 (5 points, at offset 3)." }));
}

TEST(ContourSetBuilderInvalid, NothingUsableIsAnError)
{
  EXPECT_EQ(ErrorOf(SoupMaker()),
    "There are no contours: give closed polylines, polygons or loose segments.");
  EXPECT_EQ(ErrorOf(SoupMaker().Chain({ { 1, 2, 3 } }, false)),
    "No usable contour is left. Contour of cell 0 (1 point, near (1, 2, 3)): has only 1 distinct "
    "point, which enclose nothing; left out.");
  EXPECT_NE(ErrorOf(SoupMaker().Chain({ { 1, 2, 3 } }, false).Loop({ { NaN, 1 }, { 2, 3 } }))
              .find("(And 1 more sentence like this.)"),
    std::string::npos);
  EXPECT_NE(ErrorOf(SoupMaker().Loop({ { 0, 0 }, { 1, 1 }, { 2, 2 } })).find("No usable contour"),
    std::string::npos);
}

TEST(ContourSetBuilderInvalid, ToleranceThatIsNone)
{
  for (double tolerance : { -1.0, -1e-300, NaN, Infinity })
  {
    EXPECT_NE(ErrorOf(GoodSquare(), tolerance).find("plane tolerance"), std::string::npos);
  }
  EXPECT_EQ(ErrorOf(GoodSquare(), 0), "");
}

TEST(ContourSetBuilderInvalid, AScribbleIsOneSentence)
{
  const std::string said = ErrorOf(SoupMaker().Loop(Scribble(2500, 1)));
  EXPECT_NE(said.find("cannot be resolved: Contours cross"), std::string::npos) << said;
  EXPECT_EQ(said.find(".."), std::string::npos) << said;
}

TEST(ContourSetBuilderInvalid, ScribblesOnManySlicesHaveABoundTogether)
{
  // Each by itself crosses in some thousand places, which is allowed.
  SoupMaker maker;
  for (unsigned level = 0; level < 12; ++level)
  {
    maker.Loop(Scribble(100, level), level);
  }
  Monitor monitor;
  const ContourSet contours = BuildContourSet(maker.Soup, ContourSetOptions(), monitor);
  EXPECT_GE(contours.Levels.size(), 4u);
  EXPECT_LT(contours.Levels.size(), 9u);
  const bool isTold = std::any_of(contours.Report.begin(), contours.Report.end(),
    [](const std::string& line)
    { return line.find("more than 6200 places, all slices together") != std::string::npos; });
  EXPECT_TRUE(isTold);
}

TEST(ContourSetBuilderInvalid, TheUserMayStop)
{
  class Stopper : public Monitor
  {
  public:
    bool AbortRequested() override { return true; }
  };
  Stopper stopper;
  EXPECT_THROW(BuildContourSet(GoodSquare().Soup, ContourSetOptions(), stopper), Aborted);
}
}
