// SPDX-License-Identifier: GPL-3.0-or-later
// Whole contour sets: shapes whose contours, areas and nesting are known.
#include "ContourInvariants.h"
#include "SoupMaker.h"

#include <chrono>
#include <limits>

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr double Exact = 0;

TEST(ContourSetBuilder, SquareStaysAsItIs)
{
  const ContourSet set = SoupMaker().Loop(Rectangle(0, 0, 2, 1), 7).Build();
  CheckContourSet(set, Exact);
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_EQ(set.Contours[0].Points, (std::vector<int>{ 0, 1, 2, 3 }));
  EXPECT_EQ(set.Points[2], (Point3{ 2, 1, 7 }));
  EXPECT_EQ(set.Contours[0].SignedArea, 2);
  EXPECT_EQ(set.Levels[0].Offset, 7);
  EXPECT_EQ(set.Levels[0].Frame.Normal, (Vector3{ 0, 0, 1 }));
  EXPECT_TRUE(set.Report.empty());
}

TEST(ContourSetBuilder, NestedSquaresAlternate)
{
  SoupMaker maker;
  for (int i = 0; i < 6; ++i)
  {
    std::vector<Point2> square = Rectangle(-i - 1, -i - 1, i + 1, i + 1);
    if (i % 2 == 0)
    {
      std::reverse(square.begin(), square.end());
    }
    maker.Loop(square);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, Exact);
  ASSERT_EQ(set.Contours.size(), 6u);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(set.Contours[At(i)].Depth, 5 - i);
    EXPECT_EQ(set.Contours[At(i)].Parent, i == 5 ? -1 : i + 1);
  }
  EXPECT_DOUBLE_EQ(SolidArea(set), 144 - 100 + 64 - 36 + 16 - 4);
  EXPECT_TRUE(set.Report.empty());
}

TEST(ContourSetBuilder, LevelsIncreaseWhateverTheOrder)
{
  SoupMaker maker;
  for (double z : { 5.0, -3.0, 8.25, 0.1 })
  {
    maker.Loop(Circle(1, 2, 3, 40), z);
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, Exact);
  ASSERT_EQ(set.Levels.size(), 4u);
  EXPECT_EQ(set.Levels[0].Offset, -3.0);
  EXPECT_EQ(set.Levels[1].Offset, 0.1);
  EXPECT_EQ(set.Levels[3].Offset, 8.25);
  EXPECT_EQ(set.Contours[0].Source, 1);
}

TEST(ContourSetBuilder, AxesGetExactFrames)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    SoupMaker maker;
    for (double offset : { 1.7, 0.3 })
    {
      std::vector<Point3> loop;
      for (const Point2& p : Circle(0.1, 0.2, 1, 17))
      {
        Point3 q{ offset, offset, offset };
        q[(axis + 1) % 3] = p[0];
        q[(axis + 2) % 3] = p[1];
        loop.push_back(q);
      }
      maker.Chain(loop, true);
    }
    const ContourSet set = maker.Build();
    CheckContourSet(set, Exact);
    ASSERT_EQ(set.Levels.size(), 2u);
    EXPECT_EQ(set.Levels[0].Frame.Normal[axis], 1);
    EXPECT_EQ(set.Levels[0].Offset, 0.3);
    EXPECT_EQ(set.Planar[0][0], set.Points[0][(axis + 1) % 3]);
    EXPECT_EQ(set.Planar[0][1], set.Points[0][(axis + 2) % 3]);
  }
}

TEST(ContourSetBuilder, TiltedPlanesGroup)
{
  const PlanarFrame frame = []
  {
    PlanarFrame f;
    f.Normal = (1 / std::sqrt(14.0)) * Vector3{ 1, 2, 3 };
    f.U = (1 / std::sqrt(5.0)) * Vector3{ 2, -1, 0 };
    f.V = Cross(f.Normal, f.U);
    return f;
  }();
  SoupMaker maker;
  for (double offset : { 2.0, -1.0, 4.5 })
  {
    for (double radius : { 1.0, 3.0 })
    {
      std::vector<Point3> loop;
      for (const Point2& p : Circle(100, -50, radius, 60))
      {
        loop.push_back(frame.ToSpace(p, offset));
      }
      maker.Chain(loop, true);
    }
  }
  const ContourSet set = maker.Build();
  CheckContourSet(set, 1e-12);
  ASSERT_EQ(set.Levels.size(), 3u);
  EXPECT_NEAR(Dot(set.Levels[0].Frame.Normal, frame.Normal), 1, 1e-14);
  EXPECT_NEAR(set.Levels[0].Offset, -1, 1e-12);
  EXPECT_EQ(set.Contours[0].Depth + set.Contours[1].Depth, 1);
}
}

TEST(ContourSetBuilder, PointsOffTheirSliceArePutOnIt)
{
  for (const double off : { 0.0, 1e-6, 0.02 })
  {
    SoupMaker maker;
    for (const double z : { 0.0, 3.0, 6.0 })
    {
      maker.Loop(Circle(0, 0, 5, 24), z).Loop(Circle(12, 0, 5, 24), z == 3 ? z + off : z);
    }
    const ContourSet set = maker.Build();
    ASSERT_EQ(set.Levels.size(), 3u);
    for (const Contour& contour : set.Contours)
    {
      for (const int p : contour.Points)
      {
        EXPECT_EQ(set.Points[p][2], set.Levels[contour.Level].Offset);
      }
    }
    const bool said = std::any_of(set.Report.begin(), set.Report.end(),
      [](const std::string& line) { return line.find("put on it") != std::string::npos; });
    EXPECT_EQ(said, off > 0);
  }
}
