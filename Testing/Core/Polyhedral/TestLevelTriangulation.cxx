// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's algorithms 4 (contour edges in the Delaunay triangulation), 5 (no obtuse angle
// facing one) and 6 (internal points) by their postconditions.
#include "LevelInvariants.h"
#include "PolyhedralShapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Both levels of a pair with the internal points that they ask for of each other.
void ExpectSoundLevels(const RingStack& stack)
{
  const ContourSet contours = BuildStack(stack);
  ASSERT_EQ(contours.Levels.size(), stack.size());
  for (const bool internalPoints : { false, true })
  {
    SCOPED_TRACE(internalPoints ? "with internal points" : "contours only");
    const auto levels = TriangulateLevels(contours, internalPoints);
    for (std::size_t l = 0; l < levels.size(); ++l)
    {
      SCOPED_TRACE("level " + std::to_string(l));
      ExpectSoundLevel(levels[l], contours, static_cast<int>(l));
    }
  }
}

int CountKind(const LevelTriangulation& level, LevelTriangulation::PointKindType kind)
{
  return static_cast<int>(std::count(level.Kind.begin(), level.Kind.end(), kind));
}

/**
 * Algorithm 6 leaves nothing out without a reason: a vertex of the neighbour's external skeleton
 * that lies in IR is a vertex here, or on one within rounding, or in a contour edge's circle.
 */
void ExpectInsertedWhereAllowed(
  const LevelTriangulation& level, const std::vector<Point2>& candidates)
{
  double extent = 0;
  for (const Point2& p : level.Points)
  {
    extent = std::max({ extent, std::abs(p[0]), std::abs(p[1]) });
  }
  int inside = 0;
  for (const Point2& candidate : candidates)
  {
    const InexactKernel::Point_2 p(candidate[0], candidate[1]);
    const auto where = LocateInPlane<InexactKernel>(level, 0, p);
    if (where.Triangle < 0 || !level.Inside[where.Triangle])
    {
      continue;
    }
    ++inside;
    bool explained = false;
    for (const Point2& q : level.Points)
    {
      explained = explained || std::hypot(q[0] - candidate[0], q[1] - candidate[1]) < 1e-6 * extent;
    }
    for (std::size_t t = 0; t < level.Triangles.size() && !explained; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto ends = EndsOf(level, static_cast<int>(t), k);
        explained = explained ||
          (level.EdgeContour[t][k] >= 0 &&
            CGAL::side_of_bounded_circle(Planar(level, ends[0]), Planar(level, ends[1]), p) !=
              CGAL::ON_UNBOUNDED_SIDE);
      }
    }
    EXPECT_TRUE(explained) << "candidate " << candidate[0] << ", " << candidate[1];
  }
  EXPECT_GT(inside, 0) << "the shape asks for no internal point, so this shows nothing";
}
}

TEST(LevelTriangulation, KeepsARegularPolygonAsItIs)
{
  const ContourSet contours = BuildStack({ { RegularPolygon(12, 1) }, { RegularPolygon(12, 1) } });
  const auto level = TriangulateLevels(contours, false)[0];
  ExpectSoundLevel(level, contours, 0);
  EXPECT_EQ(level.Points.size(), 12u);
  EXPECT_EQ(level.Triangles.size(), 10u);
}

TEST(LevelTriangulation, RefinesWhereAnAngleIsObtuse)
{
  // The apex lies in the circle over the long side, so the side must be cut.
  const Ring flat{ { 0, 0 }, { 10, 0 }, { 5, 1 } };
  const ContourSet contours = BuildStack({ { flat }, { flat } });
  const auto level = TriangulateLevels(contours, false)[0];
  ExpectSoundLevel(level, contours, 0);
  EXPECT_GT(CountKind(level, LevelTriangulation::AddedOnContour), 0);
}

TEST(LevelTriangulation, HoldsOnNeedles)
{
  ExpectSoundLevels({ { Needles(40, 10, 0.5) }, { Needles(37, 9, 1) } });
}

TEST(LevelTriangulation, HoldsOnASliverOfASpike)
{
  for (const double width : { 1e-2, 1e-4, 1e-6 })
  {
    SCOPED_TRACE(width);
    ExpectSoundLevels({ { SpikedSquare(3, width) }, { Rectangle(-1, -1, 3, 1) } });
  }
}

TEST(LevelTriangulation, HoldsOnPixelStaircases)
{
  ExpectSoundLevels({ { PixelDisc(12, 0.2) }, { PixelDisc(9, 0.2, { 0.2, 0 }) } });
}

TEST(LevelTriangulation, HoldsOnNestedContours)
{
  std::vector<Ring> nested;
  for (int i = 0; i < 8; ++i)
  {
    nested.push_back(RegularPolygon(40, 8 - i, 0.01 * i));
  }
  const ContourSet contours = BuildStack({ nested, { RegularPolygon(30, 8.5) } });
  EXPECT_EQ(contours.Contours[7].Depth, 7);
  ExpectSoundLevels({ nested, { RegularPolygon(30, 8.5) } });
}

TEST(LevelTriangulation, HoldsOnEdgesThatNearlyTouch)
{
  // Condition 2 cuts edges that face each other to about the length of the gap between them.
  const double gap = 1e-2;
  ExpectSoundLevels({ { Rectangle(0, 0, 1, 1), Rectangle(1 + gap, 0.1, 2, 0.9) },
    { Rectangle(0, 0, 2, 1), Rectangle(gap, gap, 2 - gap, 1 - gap) } });
}

TEST(LevelTriangulation, HoldsOnACornerThatNearlyTouches)
{
  for (const double gap : { 1e-3, 1e-6, 1e-9 })
  {
    SCOPED_TRACE(gap);
    ExpectSoundLevels({ { Rectangle(0, 0, 1, 1), { { 1 + gap, 0.5 }, { 2, 0.3 }, { 2, 0.8 } } },
      { Rectangle(0, 0, 2, 1), { { gap, 0.4 }, { 1, 0.1 }, { 1, 0.9 } } } });
  }
}

TEST(LevelTriangulation, HoldsWhereContoursShareAVertex)
{
  ExpectSoundLevels({ { Rectangle(0, 0, 1, 1), Rectangle(1, 1, 2, 2) },
    { Rectangle(0, 0, 2, 2), { { 0, 0 }, { 1, 0.5 }, { 0.5, 1 } } } });
}

TEST(LevelTriangulation, HoldsFarFromTheOrigin)
{
  Ring star;
  for (const Point2& p : Needles(9, 10, 2))
  {
    star.push_back({ p[0] + 1e6, p[1] - 1e6 });
  }
  ExpectSoundLevels({ { star }, { Rectangle(1e6 - 8, -1e6 - 8, 1e6 + 8, -1e6 + 8) } });
}

TEST(LevelTriangulation, HoldsOnRandomStacks)
{
  for (unsigned seed = 1; seed <= 25; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ContourSet contours = BuildStack(RandomStack(seed));
    const auto levels = TriangulateLevels(contours, true);
    for (std::size_t l = 0; l < levels.size(); ++l)
    {
      ExpectSoundLevel(levels[l], contours, static_cast<int>(l));
    }
  }
}

TEST(LevelTriangulation, InsertsEveryInternalPointThatMayBe)
{
  // Two discs above one outline: the skeleton between the discs lies inside the outline.
  const ContourSet contours = BuildStack({ { RegularPolygon(60, 4) },
    { RegularPolygon(30, 1.5, 0.1, { -2, 0 }), RegularPolygon(30, 1.5, 0.2, { 2, 0 }) } });
  LevelTriangulator lower(contours, 0);
  const auto candidates = ExternalSkeletonVertices(LevelTriangulator(contours, 1).Finish(), 0);
  lower.AddInternalPoints(candidates, LevelTriangulation::LevelAbove);
  const auto level = lower.Finish();
  ExpectSoundLevel(level, contours, 0);
  EXPECT_GT(CountKind(level, LevelTriangulation::Internal), 10);
  ExpectInsertedWhereAllowed(level, candidates);
}

TEST(LevelTriangulation, LeavesOutWhatEncroachesUponAContour)
{
  const ContourSet contours = BuildStack({ { Rectangle(0, 0, 2, 2) }, { Rectangle(0, 0, 2, 2) } });
  LevelTriangulator lower(contours, 0);
  const int before = static_cast<int>(lower.Finish().Points.size());
  lower.AddInternalPoints({ { 1, 0.5 }, { 1, 1e-12 }, { 1, -1 }, { 1e-17, 1 }, { 0, 0 } },
    LevelTriangulation::LevelAbove);
  EXPECT_EQ(static_cast<int>(lower.Finish().Points.size()), before);
  ExpectSoundLevel(lower.Finish(), contours, 0);
}

TEST(LevelTriangulation, RemembersWhoAskedForAPoint)
{
  const ContourSet contours = BuildStack({ { RegularPolygon(40, 4) }, { RegularPolygon(40, 4) } });
  LevelTriangulator lower(contours, 0);
  lower.AddInternalPoints({ { 0.5, 0 }, { 0, 1 } }, LevelTriangulation::LevelBelow);
  lower.AddInternalPoints({ { 0.5, 0 }, { 1, 1 } }, LevelTriangulation::LevelAbove);
  const auto level = lower.Finish();
  std::map<Point2, int> askedBy;
  for (std::size_t p = 0; p < level.Points.size(); ++p)
  {
    if (level.Kind[p] == LevelTriangulation::Internal)
    {
      askedBy[level.Points[p]] = level.AskedBy[p];
    }
  }
  const std::map<Point2, int> expected{ { { 0.5, 0 }, 3 },
    { { 0, 1 }, LevelTriangulation::LevelBelow }, { { 1, 1 }, LevelTriangulation::LevelAbove } };
  EXPECT_EQ(askedBy, expected);
}

TEST(LevelTriangulation, StaysSoundWithCoverPoints)
{
  const ContourSet contours = BuildStack({ { Needles(12, 10, 3) }, { Needles(12, 10, 3) } });
  LevelTriangulator lower(contours, 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  std::vector<Point2> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back({ coordinate(random), coordinate(random) });
  }
  lower.AddCoverPoints(points);
  const auto level = lower.Finish();
  ExpectSoundLevel(level, contours, 0);
  EXPECT_GT(CountKind(level, LevelTriangulation::Internal), 10);
}
