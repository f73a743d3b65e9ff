// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of the function on planes (thesis 9.3.1).
#include "Implicit/Constraints/ContourFit.h"
#include "Implicit/ImplicitSurface.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "ImplicitShapes.h"

#include <gtest/gtest.h>

#include <set>

using namespace recon;

namespace
{
const ContourFit& Ball()
{
  static const ContourFit fit = []
  {
    Monitor monitor;
    return FitContours(handmade::SphereSlices({ 30, -20, 500 }, 10, 9, 36), ConstraintOptions(),
      FunctionOptions(), monitor);
  }();
  return fit;
}

ContourSet Trace(const ContourFit& fit, const std::vector<TracePlane>& planes)
{
  Monitor monitor;
  return TraceContours(fit.Function, SeedsOf(fit.Contours), planes, TracerOptions(), monitor);
}
}

TEST(ContourTracer, CirclesOfASphereOnParallelPlanes)
{
  const ContourSet set = Trace(Ball(), ParallelPlanes({ 0, 0, 2 }, 492, 508, 0.48));
  EXPECT_TRUE(set.Parallel);
  EXPECT_EQ(set.Levels.size(), 34u);
  for (const Contour& contour : set.Contours)
  {
    const double z = set.Levels[static_cast<std::size_t>(contour.Level)].Offset - 500;
    const double area = handmade::Pi * (100 - z * z);
    EXPECT_NEAR(contour.SignedArea, area, 0.02 * 314);
    EXPECT_EQ(contour.Depth, 0);
  }
  // Its own planes give its own contours back, as points on the surface.
  const ContourSet own = Trace(Ball(), PlanesOf(Ball().Contours));
  ASSERT_EQ(own.Contours.size(), 9u);
  for (std::size_t c = 0; c < 9; ++c)
  {
    EXPECT_NEAR(own.Contours[c].SignedArea, Ball().Contours.Contours[c].SignedArea,
      0.02 * own.Contours[c].SignedArea);
  }
}

TEST(ContourTracer, ContoursOfAFewCellsKeepTheirArea)
{
  // A circle of radius 1.4 in cells of 1, whose chords alone would lose a tenth of it.
  TracerOptions options;
  options.CellSize = 1;
  const double z = 10 - 0.1;
  Monitor monitor;
  const ContourSet set = TraceContours(Ball().Function, SeedsOf(Ball().Contours),
    ParallelPlanes({ 0, 0, 1 }, 500 + z, 500 + z, 1), options, monitor);
  TracerOptions fine;
  fine.CellSize = 0.1;
  const ContourSet truth = TraceContours(Ball().Function, SeedsOf(Ball().Contours),
    ParallelPlanes({ 0, 0, 1 }, 500 + z, 500 + z, 1), fine, monitor);
  ASSERT_EQ(set.Contours.size(), 1u);
  ASSERT_EQ(truth.Contours.size(), 1u);
  const double area = truth.Contours.front().SignedArea;
  EXPECT_NEAR(set.Contours.front().SignedArea, area, 0.03 * area);
}

TEST(ContourTracer, WhatIsSmallerThanACellIsTracedWhereItHasSeeds)
{
  handmade::Maker maker;
  for (int i = 0; i < 4; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 0.8 * i);
    maker.AddCircle(level, { 0, 0 }, 8, 48);
    maker.AddCircle(level, { 9.3, 0.37 }, 0.3, 12);
  }
  Monitor monitor;
  ConstraintOptions all;
  all.ThinOut = false;
  const ContourFit fit = FitContours(maker.Finish(), all, FunctionOptions(), monitor);
  TracerOptions options;
  options.CellSize = 2;
  const ContourSet traced =
    TraceContours(fit.Function, SeedsOf(fit.Contours), PlanesOf(fit.Contours), options, monitor);
  EXPECT_EQ(traced.Contours.size(), 8u);
  for (const Contour& contour : traced.Contours)
  {
    const double area = handmade::Pi * (contour.SignedArea > 10 ? 64 : 0.09);
    EXPECT_NEAR(contour.SignedArea, area, 0.15 * area);
  }
}

TEST(ContourTracer, AnyPlaneAndExactOffsets)
{
  const TracePlane tilted{ FrameAbout({ 1, 2, -0.5 }),
    Dot(FrameAbout({ 1, 2, -0.5 }).Normal, { 30, -20, 500 }) };
  const ContourSet set = Trace(Ball(), { tilted });
  ASSERT_EQ(set.Contours.size(), 1u);
  EXPECT_NEAR(set.Contours[0].SignedArea, handmade::Pi * 100, 3);
  for (const Point3& p : set.Points)
  {
    EXPECT_NEAR(Dot(tilted.Frame.Normal, p), tilted.Offset, 1e-9);
    EXPECT_NEAR(Ball().Function.Value(p), 0, 1e-4);
  }
  EXPECT_EQ(FrameAbout({ 3, 0, 0 }).U, (Vector3{ 0, 1, 0 }));
  EXPECT_EQ(FrameAbout({ 0, 0, 1 }).V, (Vector3{ 0, 1, 0 }));
}

TEST(ContourTracer, HolesAreNestedAndTurned)
{
  Monitor monitor;
  const ContourFit torus = FitContours(
    handmade::TorusSlices(10, 4, 15, 24), ConstraintOptions(), FunctionOptions(), monitor);
  const ContourSet set = Trace(torus, { { FrameAbout({ 0, 1, 0 }), 0 } });
  ASSERT_EQ(set.Contours.size(), 2u);
  const bool firstOuter = set.Contours[0].Depth == 0;
  const Contour& outer = set.Contours[firstOuter ? 0 : 1];
  const Contour& hole = set.Contours[firstOuter ? 1 : 0];
  EXPECT_EQ(hole.Depth, 1);
  EXPECT_EQ(hole.Parent, firstOuter ? 0 : 1);
  EXPECT_NEAR(outer.SignedArea, handmade::Pi * 14 * 14, 20);
  EXPECT_NEAR(hole.SignedArea, -handmade::Pi * 6 * 6, 10);
}

TEST(ContourTracerInvalid, EachBadInputHasItsSentence)
{
  EXPECT_THROW(Trace(Ball(), {}), Error);
  EXPECT_THROW(Trace(Ball(), ParallelPlanes({ 0, 0, 1 }, 0, 1, 0.5)), Error);
  EXPECT_THROW(ParallelPlanes({ 0, 0, 0 }, 0, 1, 0.5), Error);
  EXPECT_THROW(ParallelPlanes({ 0, 0, 1 }, 0, 1, 0), Error);
  EXPECT_THROW(ParallelPlanes({ 0, 0, 1 }, 2, 1, 0.5), Error);
  EXPECT_THROW(ParallelPlanes({ 0, 0, 1 }, 0, 1e9, 1e-9), Error);
  EXPECT_THROW(ParallelPlanes({ 0, 0, std::nan("") }, 0, 1, 1), Error);
  EXPECT_THROW(Trace(Ball(), { { FrameAbout({ 0, 0, 1 }), std::nan("") } }), Error);
}

TEST(ContourTracer, PlanesBeyondTheOutermostPointsAreNotWithin)
{
  const std::vector<Point3> points = { { 0, 0, 1 }, { 5, 0, 4 } };
  const auto planes = ParallelPlanes({ 0, 0, 1 }, 0, 5, 1);
  const auto within = PlanesWithin(planes, points, 0);
  ASSERT_EQ(within.size(), 4u);
  EXPECT_EQ(within.front().Offset, 1);
  EXPECT_EQ(within.back().Offset, 4);
  EXPECT_EQ(PlanesWithin(planes, points, 1).size(), 6u);
  EXPECT_TRUE(PlanesWithin(planes, {}, 1).empty());
  // Seen along another normal the same points reach from 0 to 5.
  EXPECT_EQ(PlanesWithin(ParallelPlanes({ 1, 0, 0 }, -2, 9, 1), points, 0).size(), 6u);
}

TEST(ContourTracer, SpecksAreLeftOutAndCounted)
{
  TracerOptions options;
  options.SmallestArea = 10;
  Monitor monitor;
  const auto planes = ParallelPlanes({ 0, 0, 1 }, 500, 509, 9);
  const ContourSet set =
    TraceContours(Ball().Function, SeedsOf(Ball().Contours), planes, options, monitor);
  // Of radius 10 at the equator, and of less than 5 near the pole.
  ASSERT_EQ(set.Contours.size(), 2u);
  EXPECT_NEAR(set.Contours.front().SignedArea, 314, 10);
  const std::size_t told = set.Report.size();
  options.SmallestArea = 100;
  const ContourSet fewer =
    TraceContours(Ball().Function, SeedsOf(Ball().Contours), planes, options, monitor);
  ASSERT_EQ(fewer.Contours.size(), 1u);
  ASSERT_EQ(fewer.Report.size(), told + 1);
  EXPECT_EQ(fewer.Report.back(),
    "1 computed contour of less than 100 square units left out, as nobody drew one so small.");
}
