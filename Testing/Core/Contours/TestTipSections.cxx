// SPDX-License-Identifier: GPL-3.0-or-later
// End sections of one point or one line.
#include "Contours/TipSections.h"
#include "Core/Contours/SoupMaker.h"
#include "Core/Polyhedral/PolyhedralShapes.h"
#include "Core/Polyhedral/SurfaceInvariants.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
/// A square of side 10 at height 0.
SoupMaker Base()
{
  SoupMaker maker;
  maker.Loop(Rectangle(-5, -5, 5, 5), 0);
  return maker;
}

PolyhedralSurface Build(const SoupMaker& maker, ContourSet& contours)
{
  contours = maker.Build();
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  return BuildSurface(contours, options);
}

bool HasVertex(const PolyhedralSurface& surface, const Point3& p)
{
  return std::count(surface.Mesh.Points.begin(), surface.Mesh.Points.end(), p) == 1;
}

bool SaysTip(const ContourSet& contours)
{
  return std::any_of(contours.Report.begin(), contours.Report.end(),
    [](const std::string& line)
    { return line.find("taken for the end of the shape") != std::string::npos; });
}
}

TEST(TipSections, ApexOfAPyramidIsAVertexExactly)
{
  for (const Point3& apex : { Point3{ 0, 0, 10 }, Point3{ 0.1, 0.2, -10 } })
  {
    SoupMaker maker = Base();
    maker.Chain({ apex }, false);
    ContourSet contours;
    const PolyhedralSurface surface = Build(maker, contours);
    ExpectKeepsPromises(surface, contours);
    EXPECT_TRUE(HasVertex(surface, apex));
    EXPECT_NEAR(VolumeOf(surface.Mesh), 1000.0 / 3, 0.1);
    EXPECT_TRUE(SaysTip(contours));
  }
}

TEST(TipSections, RingOfEqualPointsIsAPoint)
{
  SoupMaker maker = Base();
  maker.Loop({ { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 } }, 10);
  ContourSet contours;
  const PolyhedralSurface surface = Build(maker, contours);
  ExpectKeepsPromises(surface, contours);
  EXPECT_TRUE(HasVertex(surface, { 1, 1, 10 }));
  EXPECT_NEAR(VolumeOf(surface.Mesh), 1000.0 / 3, 0.1);
}

TEST(TipSections, RidgeOfARoofIsAnEdge)
{
  // A wedge: area falls from 100 to 0 in proportion, as the ridge is as long as the square.
  for (const bool closed : { false, true })
  {
    SoupMaker maker = Base();
    std::vector<Point3> ridge{ { -5, 0, 4 }, { 0, 0, 4 }, { 5, 0, 4 } };
    if (closed)
    {
      ridge.push_back({ 0, 0, 4 });
    }
    maker.Chain(ridge, closed);
    ContourSet contours;
    const PolyhedralSurface surface = Build(maker, contours);
    ExpectKeepsPromises(surface, contours);
    EXPECT_TRUE(HasVertex(surface, { -5, 0, 4 }));
    EXPECT_TRUE(HasVertex(surface, { 5, 0, 4 }));
    EXPECT_NEAR(VolumeOf(surface.Mesh), 200, 1);
  }
}

TEST(TipSections, BothEndsOfASpindle)
{
  SoupMaker maker;
  maker.Chain({ { 0, 0, -1 } }, false);
  maker.Loop(Circle(0, 0, 1, 32), 0);
  maker.Chain({ { 0, 0, 1 } }, false);
  ContourSet contours;
  const PolyhedralSurface surface = Build(maker, contours);
  ExpectKeepsPromises(surface, contours);
  EXPECT_NEAR(VolumeOf(surface.Mesh), 2 * 16 * std::sin(FullTurn / 32) / 3, 2e-3);
  EXPECT_EQ(contours.Levels.size(), 3u);
}

TEST(TipSections, PointsElsewhereAreNoTips)
{
  const auto expectNone = [](const SoupMaker& maker)
  {
    const ContourSet contours = maker.Build();
    EXPECT_FALSE(SaysTip(contours));
    EXPECT_EQ(contours.Levels.size(), 2u);
  };
  SoupMaker beside = Base();
  beside.Loop(Rectangle(-5, -5, 5, 5), 1).Chain({ { 20, 0, 2 } }, false);
  expectNone(beside); // not above the contours
  SoupMaker far = Base();
  far.Loop(Rectangle(-5, -5, 5, 5), 1).Chain({ { 0, 0, 9 } }, false);
  expectNone(far); // eight spacings off: a marker
  SoupMaker within = Base();
  within.Loop(Rectangle(-5, -5, 5, 5), 1).Chain({ { 0, 0, 0.5 } }, false);
  expectNone(within); // between the levels
  SoupMaker several = Base();
  several.Loop(Rectangle(-5, -5, 5, 5), 1)
    .Chain({ { 0, 0, 2 } }, false)
    .Chain({ { 0, 0, 3 } }, false);
  expectNone(several); // markers one above another
}

TEST(TipSections, AHoleAboveWhichThePointLiesIsNoEnd)
{
  SoupMaker maker = Base();
  maker.Loop(Rectangle(-1, -1, 1, 1), 0)
    .Loop(Rectangle(-5, -5, 5, 5), 1)
    .Loop(Rectangle(-1, -1, 1, 1), 1)
    .Chain({ { 0, 0, 2 } }, false);
  EXPECT_FALSE(SaysTip(maker.Build()));
}

TEST(TipSections, TiltedStacksHaveTipsToo)
{
  SoupMaker maker;
  const PlanarFrame frame = PlanarFrame::About({ 0.48, 0.6, 0.64 });
  std::vector<Point3> square;
  for (const Point2& p : Rectangle(-5, -5, 5, 5))
  {
    square.push_back(frame.ToSpace(p, 0));
  }
  const Point3 apex = frame.ToSpace({ 0, 0 }, 10);
  maker.Chain(square, true).Chain({ apex }, false);
  ContourSet contours;
  const PolyhedralSurface surface = Build(maker, contours);
  ExpectClosed(surface.Mesh);
  ExpectManifold(surface.Mesh);
  EXPECT_TRUE(HasVertex(surface, apex));
  EXPECT_NEAR(VolumeOf(surface.Mesh), 1000.0 / 3, 0.1);
}
