// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/ContourSamples.h"

#include "Base/Angles.h"

#include "Core/Polyhedral/PolyhedralShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
ContourSet TwoSquares()
{
  return BuildStack({ { Rectangle(0, 0, 4, 2) }, { Rectangle(0, 0, 4, 2) } });
}

TriangleMesh AllPoints(const ContourSet& contours)
{
  TriangleMesh mesh;
  mesh.Points = contours.Points;
  return mesh;
}
}

TEST(ContourSamples, StandForTheWholeLength)
{
  const ContourSet contours = TwoSquares();
  for (const double distance : { 0.3, 1.0, 100.0 })
  {
    double length = 0;
    for (const ContourSample& sample : SampleContours(contours, AllPoints(contours), distance))
    {
      length += sample.Length;
    }
    EXPECT_NEAR(length, 2 * 12, 1e-12) << distance;
  }
}

TEST(ContourSamples, LieAlongLongEdges)
{
  const ContourSet contours = TwoSquares();
  const auto samples = SampleContours(contours, AllPoints(contours), 1);
  EXPECT_EQ(samples.size(), 2u * 12);
  EXPECT_EQ(std::count_if(samples.begin(), samples.end(),
              [](const ContourSample& sample) { return sample.IsVertex; }),
    8);
}

TEST(ContourSamples, PointOutOfTheSolid)
{
  const ContourSet contours = TwoSquares();
  for (const ContourSample& sample : SampleContours(contours, AllPoints(contours), 1))
  {
    EXPECT_NEAR(Norm(sample.Outward), 1, 1e-12);
    EXPECT_GT(Dot(sample.Outward, sample.Place - Point3{ 2, 1, sample.Place[2] }), 0);
  }
}

TEST(ContourSamples, PassOverWhatIsNotInTheSurface)
{
  const ContourSet contours = TwoSquares();
  EXPECT_TRUE(SampleContours(contours, TriangleMesh(), 1).empty());
}

TEST(ContourSamples, KnowHowLongTheirContourIs)
{
  const ContourSet contours = TwoSquares();
  for (const ContourSample& sample : SampleContours(contours, AllPoints(contours), 1))
  {
    EXPECT_NEAR(2 * Pi * sample.Radius, 12, 1e-12);
  }
}
