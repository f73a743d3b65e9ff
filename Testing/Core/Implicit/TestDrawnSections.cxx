// SPDX-License-Identifier: GPL-3.0-or-later
// A drawn slice counts also where nothing is drawn on it: ends do not come back, holes do not close
// between slices, edges are known along their length; and what agrees stays as it is.
#include "Implicit/Constraints/ContourFit.h"
#include "Implicit/Constraints/DrawnSections.h"
#include "Implicit/ImplicitSurface.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "ImplicitShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;

namespace
{
constexpr double Pi = handmade::Pi;

/// Two legs of radius 8 side by side on eight slices, of which one ends after four.
ContourSet Legs()
{
  handmade::Maker maker;
  for (int i = 0; i < 8; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 2.0 * i);
    maker.AddCircle(level, { -11, 0 }, 8, 32);
    if (i < 4)
    {
      maker.AddCircle(level, { 11, 0 }, 8, 32);
    }
  }
  return maker.Finish();
}

/// A ring on four slices that are much farther apart than its hole is wide.
ContourSet Ring()
{
  handmade::Maker maker;
  const double outer[] = { 10, 23, 23, 10 };
  const double inner[] = { 5, 7.7, 7.7, 5 };
  for (int i = 0; i < 4; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 18.0 * i);
    maker.AddCircle(level, { 0, 0 }, outer[i], 48);
    maker.AddCircle(level, { 0, 0 }, inner[i], 48);
  }
  return maker.Finish();
}

ContourFit Fit(const ContourSet& contours, const ConstraintOptions& options = {})
{
  Monitor monitor;
  return FitContours(contours, options, FunctionOptions(), monitor);
}

/// Areas of the contours on a plane, the outer one positive.
std::vector<double> AreasAt(const ContourSet& drawn, const ContourFit& fit, double z)
{
  TracerOptions options;
  options.Box = ChooseBoundsOf(drawn);
  options.CellSize = 0.5;
  Monitor monitor;
  const ContourSet traced = TraceContours(
    fit.Function, SeedsOf(fit.Contours), { { drawn.Levels[0].Frame, z } }, options, monitor);
  std::vector<double> areas;
  for (const Contour& contour : traced.Contours)
  {
    areas.push_back(contour.SignedArea);
  }
  return areas;
}

bool Says(const ContourFit& fit, const std::string& words)
{
  const std::vector<std::string>& report = fit.Constraints.Report;
  return std::any_of(report.begin(), report.end(),
    [&](const std::string& line) { return line.find(words) != std::string::npos; });
}
}

TEST(DrawnSections, FindNothingWhereAllAgrees)
{
  const ContourSet ball = handmade::SphereSlices({ 0, 0, 0 }, 10, 9, 36);
  ConstraintOptions plain;
  plain.FollowDrawnPlanes = false;
  const ContourFit without = Fit(ball, plain);
  const ContourFit with = Fit(ball);
  EXPECT_FALSE(Says(with, "constraints were added"));
  EXPECT_TRUE(with.Function.Weights == without.Function.Weights) << "to the last bit";
}

TEST(DrawnSections, AnEndedBranchDoesNotComeBack)
{
  const ContourSet legs = Legs();
  ConstraintOptions plain;
  plain.FollowDrawnPlanes = false;
  EXPECT_EQ(AreasAt(legs, Fit(legs, plain), 8).size(), 2u) << "which is what there is to mend";
  const ContourFit fit = Fit(legs);
  EXPECT_TRUE(Says(fit, "constraints were added"));
  EXPECT_FALSE(Says(fit, "still differs"));
  const double circle = 16 * 8 * 8 * std::sin(Pi / 16);
  for (const double z : { 8.0, 10.0, 14.0 })
  {
    const std::vector<double> areas = AreasAt(legs, fit, z);
    ASSERT_EQ(areas.size(), 1u) << z;
    EXPECT_NEAR(areas.front(), circle, 0.02 * circle) << z;
  }
  EXPECT_EQ(AreasAt(legs, fit, 6).size(), 2u);
}

TEST(DrawnSections, AHoleDoesNotCloseBetweenItsSlices)
{
  const ContourSet ring = Ring();
  const ContourFit fit = Fit(ring);
  EXPECT_TRUE(Says(fit, "constraints were added"));
  for (const double z : { 3.0, 6.0, 9.0, 12.0 })
  {
    const std::vector<double> areas = AreasAt(ring, fit, z);
    ASSERT_EQ(areas.size(), 2u) << z;
    const double hole = -*std::min_element(areas.begin(), areas.end());
    const double straight = Pi * std::pow(5 + 2.7 * z / 18, 2);
    EXPECT_NEAR(hole, straight, 0.2 * straight) << z;
  }
}

TEST(DrawnSections, AnEmptyPlaneEndsTheSolid)
{
  handmade::Maker maker;
  for (int i = 0; i < 4; ++i)
  {
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 3.0 * i), { 0, 0 }, 12, 40);
  }
  const ContourSet column = maker.Finish();
  ConstraintOptions options;
  options.EmptyPlanes = { { { 0, 0, 1 }, 12 }, { { 0, 0, -1 }, 3 }, { { 1, 0, 0 }, 0 } };
  const ContourFit fit = Fit(column, options);
  EXPECT_LT(fit.Function.Value({ 0, 0, 12 }), 0);
  EXPECT_LT(fit.Function.Value({ 0, 0, -3 }), 0);
  EXPECT_GT(fit.Function.Value({ 0, 0, 4.5 }), 0) << "a plane across the stack is not used";
}

TEST(DrawnSections, HolesThatNobodyDrewAndLostContoursCountHoweverSmall)
{
  // Tolerances that let everything else pass.
  SectionTolerances only;
  only.Depth = 100;
  only.Area = 10;
  only.WaistArea = 10;
  const ContourSet ball = handmade::SphereSlices({ 0, 0, 0 }, 10, 9, 36);
  const ContourFit fit = Fit(ball);
  Monitor monitor;
  EXPECT_TRUE(DrawnSections(ball, {}, 1, only).Compare(fit.Function, 1, monitor).Sections.empty());

  std::vector<Point3> places = fit.Constraints.Points;
  std::vector<double> values = fit.Constraints.Values;
  places.push_back({ 3, 0, ball.Levels[4].Offset });
  values.push_back(-2);
  const ImplicitFunction holed = FitImplicitFunction(places, values, FunctionOptions(), monitor);
  const auto found = DrawnSections(ball, {}, 1, only).Compare(holed, 1, monitor);
  EXPECT_EQ(std::count(found.Sections.begin(), found.Sections.end(), 8), 1) << "the fifth plane";
  EXPECT_FALSE(found.Places.empty());

  handmade::Maker maker;
  for (int i = 0; i < 9; ++i)
  {
    const double z = ball.Levels[i].Offset;
    const int level = maker.AddLevel({ 0, 0, 1 }, z);
    maker.AddCircle(level, { 0, 0 }, std::sqrt(100 - z * z), 36);
    if (i == 4)
    {
      maker.AddCircle(level, { 12, 0 }, 0.8, 16);
    }
  }
  const ContourSet more = maker.Finish();
  const auto lost = DrawnSections(more, {}, 1, only).Compare(fit.Function, 1, monitor);
  EXPECT_EQ(lost.Sections, std::vector<int>{ 8 });
}

TEST(DrawnSections, ContoursOfFewCornersAreFollowedThoughTheyNeedManyPlaces)
{
  // A marker drawn with eight pixels' edges, on slices farther apart than it is wide.
  handmade::Maker maker;
  for (int i = 0; i < 4; ++i)
  {
    const double z = 40.0 * i;
    maker.AddContour(maker.AddLevel({ 0, 0, 1 }, z),
      { { -6, -13, z }, { 6, -13, z }, { 13, -6, z }, { 13, 6, z }, { 6, 13, z }, { -6, 13, z },
        { -13, 6, z }, { -13, -6, z } });
  }
  const ContourSet marker = maker.Finish();
  const ContourFit fit = Fit(marker);
  EXPECT_FALSE(Says(fit, "still differs"));
  for (int i = 0; i < 4; ++i)
  {
    const std::vector<double> areas = AreasAt(marker, fit, 40.0 * i);
    ASSERT_EQ(areas.size(), 1u);
    EXPECT_NEAR(areas.front(), 578, 0.01 * 578) << i;
  }
}

TEST(DrawnSections, TheResultDoesNotDependOnThreads)
{
  const ContourSet legs = Legs();
  Monitor monitor;
  FunctionOptions one;
  one.Threads = 1;
  FunctionOptions many;
  many.Threads = 4;
  const ContourFit a = FitContours(legs, ConstraintOptions(), one, monitor);
  const ContourFit b = FitContours(legs, ConstraintOptions(), many, monitor);
  EXPECT_TRUE(a.Constraints.Points == b.Constraints.Points);
}

TEST(DrawnSections, LongEdgesGetPoints)
{
  handmade::Maker maker;
  for (int i = 0; i < 6; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 2.0 * i);
    maker.AddContour(
      level, { { -5, -5, 2.0 * i }, { 5, -5, 2.0 * i }, { 5, 5, 2.0 * i }, { -5, 5, 2.0 * i } });
  }
  const ContourSet box = maker.Finish();
  const ContourFit fit = Fit(box);
  EXPECT_TRUE(Says(fit, "contour edges longer than 4"));
  // The middle of an edge and a corner, both on the surface.
  for (const Point3& p : { Point3{ 5, 0, 4 }, Point3{ 5, 5, 4 }, Point3{ 0, -5, 6 } })
  {
    EXPECT_LT(std::abs(fit.Function.Value(p)) / Norm(fit.Function.Gradient(p)), 0.05);
  }
  ConstraintOptions corners;
  corners.FillLongEdges = false;
  corners.FollowDrawnPlanes = false;
  const ContourFit bare = Fit(box, corners);
  EXPECT_EQ(bare.Contours.Points.size(), 24u);
  EXPECT_GT(std::abs(bare.Function.Value({ 5, 0, 4 })), 0.5) << "which is what there is to mend";
}

TEST(DrawnSections, SheetsThatAreMissedAreCounted)
{
  handmade::Maker maker;
  for (int i = 0; i < 3; ++i)
  {
    const int level = maker.AddLevel({ 0, 0, 1 }, 0.5 * i);
    for (int k = 0; k < 20; ++k)
    {
      const double x = 0.1 * k;
      const double z = 0.5 * i;
      maker.AddContour(level, { { x, 0, z }, { x + 0.02, 0, z }, { x + 0.02, 2, z }, { x, 2, z } });
    }
  }
  ImplicitSurfaceOptions options;
  options.Constraints.FillLongEdges = false;
  options.Constraints.FollowDrawnPlanes = false;
  options.Polygonizer.CellSize = 0.1;
  Monitor monitor;
  const ImplicitSurface surface = BuildImplicitSurface(maker.Finish(), options, monitor);
  EXPECT_GT(surface.Mesh.FarContourPoints, 0u);
  EXPECT_TRUE(std::any_of(surface.Report.begin(), surface.Report.end(),
    [](const std::string& line) { return line.find("more than a cell of") != std::string::npos; }));
}
