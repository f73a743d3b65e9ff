// SPDX-License-Identifier: GPL-3.0-or-later
// The ground floor: Angles, BoundingBox, Geometry, Median, Parallel, PointGrid, Predicates, SpatialHash, Text.
#include "Base/Angles.h"
#include "Base/BoundingBox.h"
#include "Base/DisjointSets.h"
#include "Base/Geometry.h"
#include "Base/Median.h"
#include "Base/Parallel.h"
#include "Base/PointGrid.h"
#include "Base/PointHash.h"
#include "Base/Predicates.h"
#include "Base/SpatialHash.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <set>

using namespace recon;

TEST(BoundingBox, IsEmptyUntilAPointIsAdded)
{
  Box3 box;
  EXPECT_TRUE(box.IsEmpty());
  EXPECT_EQ(box.Diagonal(), 0);
  EXPECT_FALSE(box.Contains({ 0, 0, 0 }));
  EXPECT_FALSE(box.Meets(box));
  box.Add({ 1, 2, 3 });
  EXPECT_FALSE(box.IsEmpty());
  EXPECT_TRUE(box.Contains({ 1, 2, 3 }));
  EXPECT_EQ(box.Diagonal(), 0);
}

TEST(BoundingBox, HasTheExtremesOfItsPoints)
{
  const Box2 box = Box2::Around(std::vector<Point2>{ { 1, 5 }, { -2, 3 }, { 4, 4 } });
  EXPECT_EQ(box.Low, (Point2{ -2, 3 }));
  EXPECT_EQ(box.High, (Point2{ 4, 5 }));
  EXPECT_EQ(box.LongestExtent(), 6);
  EXPECT_DOUBLE_EQ(box.Diagonal(), std::hypot(6, 2));
  EXPECT_EQ(box.Middle(), (Point2{ 1, 4 }));
  EXPECT_EQ(box.SquaredDistanceTo({ 7, 4 }), 9);
  EXPECT_EQ(box.SquaredDistanceTo({ 7, 9 }), 25);
  EXPECT_EQ(box.SquaredDistanceTo({ 0, 4 }), 0);
}

TEST(BoundingBox, MeetsWhatTouchesIt)
{
  const Box2 box({ 0, 0 }, { 1, 1 });
  EXPECT_TRUE(box.Meets(Box2({ 1, 1 }, { 2, 2 })));
  EXPECT_FALSE(box.Meets(Box2({ 1.5, 0 }, { 2, 2 })));
  EXPECT_TRUE(box.Grown(0.5).Meets(Box2({ 1.5, 0 }, { 2, 2 })));
}

TEST(Geometry, FrameIsRightHandedAndExactAlongAxes)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (double sign : { -1.0, 1.0 })
    {
      Vector3 normal{ 0, 0, 0 };
      normal[k] = sign;
      const PlanarFrame frame = PlanarFrame::About(normal);
      EXPECT_EQ(Cross(frame.U, frame.V), normal);
      const Point3 p{ 0.1, 0.2, 0.3 };
      EXPECT_EQ(frame.ToSpace(frame.ToPlane(p), frame.OffsetOf(p)), p);
    }
  }
  const PlanarFrame frame = PlanarFrame::About({ 0.48, 0.6, 0.64 });
  EXPECT_NEAR(Dot(frame.U, frame.V), 0, 1e-15);
  EXPECT_NEAR(Dot(Cross(frame.U, frame.V), frame.Normal), 1, 1e-15);
}

TEST(Geometry, ParallelInTwoStrengths)
{
  const Vector3 z{ 0, 0, 1 };
  const Vector3 nearly{ std::sin(1e-3), 0, std::cos(1e-3) };
  EXPECT_TRUE(AreParallel(z, { 0, 0, -1 }, Parallelism::UpToRounding));
  EXPECT_FALSE(AreParallel(z, nearly, Parallelism::UpToRounding));
  EXPECT_TRUE(AreParallel(z, nearly, Parallelism::UpToDrawing));
  EXPECT_FALSE(AreParallel(z, { 0, 0.6, 0.8 }, Parallelism::UpToDrawing));
}

TEST(Geometry, DistanceToSegmentBeyondItsEndsIsThatToTheEnd)
{
  EXPECT_EQ(SquaredDistanceToSegment({ 0, 2, 0 }, { -1, 0, 0 }, { 1, 0, 0 }), 4);
  EXPECT_EQ(SquaredDistanceToSegment({ 4, 4, 0 }, { -1, 0, 0 }, { 1, 0, 0 }), 25);
  EXPECT_EQ(SquaredDistanceToSegment({ 4, 4, 0 }, { 1, 0, 0 }, { 1, 0, 0 }), 25);
}

TEST(Geometry, LengthAlongClosesTheLoop)
{
  const std::vector<Point3> points{ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 4, 0 } };
  EXPECT_DOUBLE_EQ(LengthAlong(points, std::vector<int>{ 0, 1, 2 }), 12);
}

TEST(Median, IsTheLowerOneOfTheTwoInTheMiddle)
{
  EXPECT_EQ(Median({}), 0);
  EXPECT_EQ(Median({ 7 }), 7);
  EXPECT_EQ(Median({ 4, 1, 3, 2 }), 2);
  EXPECT_EQ(Median({ 9, 1, 5 }), 5);
}

TEST(Parallel, BlocksCoverEachIndexOnce)
{
  Monitor monitor;
  for (int threads : { 1, 2, 0 })
  {
    std::vector<std::atomic<int>> visits(1001);
    ParallelForBlocks(visits.size(), 64, threads,
      [&](std::size_t from, std::size_t to)
      {
        EXPECT_LE(to - from, 64u);
        for (std::size_t i = from; i < to; ++i)
        {
          ++visits[i];
        }
      },
      monitor, { 0, 1, "testing" });
    EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](const auto& v) { return v == 1; }));
  }
}

TEST(Parallel, RethrowsTheFailureOfAPiece)
{
  Monitor monitor;
  EXPECT_THROW(ParallelFor(100, 2,
                 [](int i)
                 {
                   if (i == 50)
                   {
                     throw Error("piece 50");
                   }
                 },
                 monitor, { 0, 1, "testing" }),
    Error);
}

TEST(PointGrid, FindsWhatALinearSearchFinds)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point3> points;
  for (int i = 0; i < 300; ++i)
  {
    points.push_back({ coordinate(random), coordinate(random), coordinate(random) });
  }
  const PointGrid grid(points, 0.21);
  for (const Point3& x : points)
  {
    std::set<int> expected, found;
    for (int i = 0; i < 300; ++i)
    {
      if (Dot(points[i] - x, points[i] - x) <= 0.09)
      {
        expected.insert(i);
      }
    }
    grid.ForNear(x, 0.3, [&](int i, double) { EXPECT_TRUE(found.insert(i).second); });
    EXPECT_EQ(found, expected);
  }
}

TEST(SpatialHash, VisitsEachCellOfARangeInOrder)
{
  using Hash = SpatialHash<2>;
  std::vector<Hash::Cell> cells;
  Hash::ForCells({ { -1, 0 }, { 0, 2 } },
    [&](const Hash::Cell& cell)
    {
      cells.push_back(cell);
      return false;
    });
  EXPECT_EQ(cells.size(), 6u);
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  Hash hash(0.5);
  hash.Put(7, hash.CellOf({ -0.1, 0.9 }));
  EXPECT_TRUE(hash.AnyIn({ -1, 1 }, [](int number) { return number == 7; }));
  EXPECT_FALSE(hash.AnyIn({ 3, 3 }, [](int number) { return number == 7; }));
}

TEST(Predicates, AreExactWhereRoundingWouldLie)
{
  // The classical line through nearly equal points: the determinant rounds to zero or to the wrong
  // sign, and the truth is the sign of the last bit.
  const Point2 a{ 12, 12 }, b{ 24, 24 };
  const double step = std::ldexp(1.0, -53);
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < 64; ++j)
    {
      const Point2 p{ 0.5 + i * step, 0.5 + j * step };
      const int truth = p[1] > p[0] ? 1 : p[1] < p[0] ? -1 : 0;
      EXPECT_EQ(Orientation2(a, b, p), truth);
    }
  }
  EXPECT_EQ(Orientation3({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1);
  EXPECT_EQ(Orientation3({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 5e-324 }), 1);
  EXPECT_TRUE(Collinear({ 0, 0, 0 }, { 0.1, 0.1, 0.1 }, { 0.3, 0.3, 0.3 }));
  EXPECT_TRUE(StrictlyBetween({ 0, 0 }, { 2, 2 }, { 1, 1 }));
  EXPECT_FALSE(StrictlyBetween({ 0, 0 }, { 2, 2 }, { 2, 2 }));
}

TEST(DisjointSets, TheLeastNumberRepresentsASet)
{
  DisjointSets sets(5);
  sets.Join(4, 2);
  sets.Join(2, 3);
  EXPECT_EQ(sets.Find(3), 2);
  EXPECT_EQ(sets.Find(4), 2);
  EXPECT_EQ(sets.Find(1), 1);
}

TEST(Text, NumbersCountsAndLists)
{
  EXPECT_EQ(Text(45.0), "45");
  EXPECT_EQ(Text(0.1234567), "0.123457");
  EXPECT_EQ(Text(Point3{ 1, 2.5, -3 }), "(1, 2.5, -3)");
  EXPECT_EQ(Counted(1, "contour"), "1 contour");
  EXPECT_EQ(Counted(0, "contour"), "0 contours");
  EXPECT_EQ(Listed(std::vector<int>{ 3, 5, 8 }, 6), "3, 5 and 8");
  EXPECT_EQ(Listed(std::vector<int>{ 3, 5, 8, 9 }, 2), "3, 5 and 2 more");
  EXPECT_EQ(Listed(std::vector<std::string>{ "a" }, 2), "a");
}

TEST(Angles, TheSmallestOfATriangleIsBetweenItsTwoLongerEdges)
{
  const auto smallest = [](const Point3& a, const Point3& b, const Point3& c)
  {
    const double area = Norm(Cross(b - a, c - a));
    return std::atan2(1.0, CotangentOfSmallestAngle(b - a, c - b, a - c, area)) / RadiansPerDegree;
  };
  const Point3 a{ 0, 0, 0 };
  const Point3 b{ std::sqrt(3.0), 0, 0 };
  const Point3 c{ 0, 1, 0 };
  EXPECT_NEAR(smallest(a, b, c), 30, 1e-13);
  EXPECT_NEAR(smallest(c, a, b), 30, 1e-13);
  EXPECT_NEAR(smallest(b, c, a), 30, 1e-13);
  EXPECT_EQ(smallest(a, b, b), 0);
}

TEST(SubMonitor, HandsOnItsShareOfTheWhole)
{
  struct Recorder : Monitor
  {
    std::vector<double> Seen;
    void OnProgress(double fraction, const char*) override { this->Seen.push_back(fraction); }
  } recorder;
  SubMonitor half(recorder, 0.5, 1);
  half.Update(0, "stage");
  half.Update(0.5, "stage");
  EXPECT_EQ(recorder.Seen, (std::vector<double>{ 0.5, 0.75 }));
}

TEST(PointHash, EqualPointsAreOneWhateverTheSignOfZero)
{
  const PointHash hash;
  EXPECT_EQ(hash({ 0.0, 1.5, -0.0 }), hash({ -0.0, 1.5, 0.0 }));
  std::set<std::size_t> seen;
  for (int i = 0; i < 1000; ++i)
  {
    seen.insert(hash({ 0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100) }));
  }
  EXPECT_EQ(seen.size(), 1000u);
}
