// SPDX-License-Identifier: GPL-3.0-or-later
// Margins that know how the surface stands on the planes, and the slices that choose between them.
#include "Implicit/Constraints/ContourFit.h"
#include "Implicit/Constraints/LeftOutSlices.h"
#include "ImplicitShapes.h"

#include <gtest/gtest.h>

using namespace recon;

namespace
{
constexpr double Radius = 12;

ContourSet Ball(int slices = 9)
{
  return handmade::SphereSlices({ 0, 0, 0 }, Radius, slices, 60);
}

/// Discs that grow from one slice to the next as on a flat shoulder, upright but for that.
ContourSet Shoulders()
{
  handmade::Maker maker;
  for (int l = 0; l < 12; ++l)
  {
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 4 * l), { 0, 0 }, (l / 4) % 2 ? 30 : 10, 60);
  }
  return maker.Finish();
}

/// A ball by three contours through its centre.
ContourSet CrossingCircles()
{
  handmade::Maker maker;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 normal{ 0, 0, 0 };
    normal[axis] = 1;
    maker.AddCircle(maker.AddLevel(normal, 0), { 0, 0 }, Radius, 24, 0.1);
  }
  return maker.Finish();
}

ConstraintSet InPlane(const ContourSet& contours)
{
  Monitor monitor;
  return BuildInPlaneConstraints(contours, ConstraintOptions(), monitor);
}

/// Of |x| - Radius: its normals are known.
ImplicitFunction FitOf(const ConstraintSet& set)
{
  Monitor monitor;
  return FitImplicitFunction(set.Points, set.Values, FunctionOptions(), monitor);
}

ContourFit FitOf(const ContourSet& contours, const ConstraintOptions& options = {})
{
  Monitor monitor;
  return FitContours(contours, options, FunctionOptions(), monitor);
}

bool Says(const ConstraintSet& set, const std::string& words)
{
  return std::any_of(set.Report.begin(), set.Report.end(),
    [&words](const std::string& line) { return line.find(words) != std::string::npos; });
}

ConstraintOptions KeepAllPoints()
{
  ConstraintOptions options;
  options.ThinOut = false;
  return options;
}
}

TEST(RefinedMargins, ValuesAreDistancesFromTheTangentPlane)
{
  const ContourSet ball = Ball();
  const ConstraintSet inPlane = InPlane(ball);
  const ImplicitFunction first = FitOf(inPlane);
  Monitor monitor;
  for (const double part : { 0.0, 0.5, 1.0 })
  {
    RefinedMargins margins(ball, inPlane, false);
    margins.Turn(first, part, 1, monitor);
    EXPECT_GT(margins.Turned(), margins.Vertices() / 2);
    const ConstraintSet& set = margins.Constraints();
    Point3 vertex{};
    for (std::size_t i = 0; i < set.Points.size(); ++i)
    {
      if (set.Kind[i] == ConstraintSet::Boundary)
      {
        vertex = set.Points[i];
        EXPECT_EQ(vertex, inPlane.Points[i]);
        continue;
      }
      const Vector3 g = first.Gradient(vertex);
      const Vector3 off = set.Points[i] - vertex;
      EXPECT_NEAR(set.Values[i], Dot(off, g) / Norm(g), 0.06 * Norm(off)) << part << ' ' << i;
      EXPECT_EQ(part == 0, set.Points[i] == inPlane.Points[i]);
      if (part == 1)
      {
        EXPECT_NEAR(std::abs(Dot(off, g)), Norm(off) * Norm(g), 1e-9);
      }
    }
  }
}

TEST(RefinedMargins, UnitValuesStayUnit)
{
  const ContourSet ball = Ball();
  ConstraintOptions unit;
  unit.Values = ConstraintOptions::Unit;
  const ContourFit fit = FitOf(ball, unit);
  for (std::size_t i = 0; i < fit.Constraints.Points.size(); ++i)
  {
    EXPECT_EQ(fit.Constraints.Values[i], fit.Constraints.Kind[i]);
  }
}

TEST(RefinedMargins, MarginsThatReachAcrossStepsStay)
{
  const ContourSet shoulders = Shoulders();
  ConstraintOptions options;
  options.ReachAcrossSteps = true;
  Monitor monitor;
  const ConstraintSet reaching = BuildInPlaneConstraints(shoulders, options, monitor);
  RefinedMargins margins(shoulders, reaching, false);
  margins.Turn(FitOf(reaching), 0.5, 1, monitor);
  std::size_t reached = 0;
  Point3 vertex{};
  for (std::size_t i = 0; i < reaching.Points.size(); ++i)
  {
    vertex = reaching.Kind[i] == ConstraintSet::Boundary ? reaching.Points[i] : vertex;
    if (Norm(reaching.Points[i] - vertex) > 1.5 * reaching.MarginDistance)
    {
      ++reached;
      EXPECT_EQ(margins.Constraints().Points[i], reaching.Points[i]);
      EXPECT_EQ(margins.Constraints().Values[i], reaching.Values[i]);
    }
  }
  EXPECT_GT(reached, 0u);
}

TEST(RefinedMargins, UprightAtATip)
{
  handmade::Maker maker;
  for (const double end : { -Radius, Radius })
  {
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, end), { 0, 0 }, 0.1, 6);
  }
  for (int i = -3; i <= 3; ++i)
  {
    maker.AddCircle(
      maker.AddLevel({ 0, 0, 1 }, 3 * i), { 0, 0 }, std::sqrt(Radius * Radius - 9 * i * i), 60);
  }
  const ContourSet ball = maker.Finish();
  const RefinedMargins margins(ball, InPlane(ball), false);
  EXPECT_EQ(margins.TipVertices(), 12u);
  const ConstraintSet& set = margins.Constraints();
  int upright = 0;
  for (std::size_t i = 0; i < set.Points.size(); ++i)
  {
    const double height = std::abs(set.Points[i][2]);
    if (height > 10 && set.Kind[i] != ConstraintSet::Boundary)
    {
      ++upright;
      EXPECT_NEAR(height, Radius - set.Kind[i] * set.MarginDistance, 1e-9);
      EXPECT_NEAR(set.Values[i], set.Kind[i] * set.MarginDistance, 1e-12);
    }
  }
  EXPECT_GE(upright, 12);
}

TEST(LeftOutSlices, AskForTurnedMarginsOfABallAndReachingOnesOfShoulders)
{
  Monitor monitor;
  const ContourSet ball = Ball(13);
  const LeftOutSlices ofBall(ball, ConstraintOptions(), FunctionOptions(), monitor);
  const SliceVotes turned = ofBall.Judge(MarginWay::Turned, monitor);
  EXPECT_TRUE(turned.Pass());
  EXPECT_GT(turned.All, 0u);

  const ContourSet shoulders = Shoulders();
  const LeftOutSlices ofShoulders(shoulders, ConstraintOptions(), FunctionOptions(), monitor);
  EXPECT_TRUE(ofShoulders.Judge(MarginWay::Reaching, monitor).Pass());
}

TEST(LeftOutSlices, TheFitFollowsAndSaysWhich)
{
  const ContourFit ball = FitOf(Ball(13), KeepAllPoints());
  EXPECT_FALSE(Says(ball.Constraints, "Margins stay"));
  const ContourFit shoulders = FitOf(Shoulders(), KeepAllPoints());
  Monitor monitor;
  const ContourSet set = Shoulders();
  const LeftOutSlices slices(set, KeepAllPoints(), FunctionOptions(), monitor);
  const bool turned = slices.Judge(MarginWay::Turned, monitor).Pass();
  const bool valued = !turned && slices.Judge(MarginWay::Valued, monitor).Pass();
  EXPECT_EQ(Says(shoulders.Constraints, "Margins stay"), !turned);
  EXPECT_EQ(Says(shoulders.Constraints, "how oblique"), valued);
  EXPECT_EQ(Says(shoulders.Constraints, "reach across steps"), !turned && !valued);
}

TEST(ContourFit, FewSlicesAreValuedWhereParallelAndTurnedWhereCrossing)
{
  const ContourSet few = Ball(5);
  ConstraintOptions options = KeepAllPoints();
  const ContourFit valued = FitOf(few, options);
  options.Normals = ConstraintOptions::InPlane;
  const ContourFit plain = FitOf(few, options);
  ASSERT_EQ(valued.Constraints.Points.size(), plain.Constraints.Points.size());
  EXPECT_EQ(valued.Constraints.Points, plain.Constraints.Points);
  EXPECT_NE(valued.Constraints.Values, plain.Constraints.Values);

  const ContourFit turned = FitOf(CrossingCircles(), KeepAllPoints());
  std::size_t out = 0;
  for (std::size_t i = 0; i < turned.Constraints.Points.size(); ++i)
  {
    // In the plane of its circle a point has a coordinate of 0.
    const Point3& p = turned.Constraints.Points[i];
    out += std::min({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) > 1e-9 ? 1 : 0;
  }
  EXPECT_GT(out, 0u);
}
