// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/TracedRaster.h"

#include "Core/Polyhedral/PolyhedralShapes.h"
#include "TracedShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
TracedRaster Find(const std::vector<Point2>& ring)
{
  return FindTracedRaster(BuildStack({ { ring }, { ring } }));
}
}

TEST(TracedRaster, FindsThePitch)
{
  EXPECT_NEAR(Find(Traced(20.3, 1, 0)).Pitch, 1, 0.02);
  EXPECT_NEAR(Find(Traced(50.1, 2.15, 0)).Pitch, 2.15, 0.04);
}

TEST(TracedRaster, DrawnContoursHaveNone)
{
  EXPECT_EQ(Find(RegularPolygon(200, 20)).Pitch, 0);
  EXPECT_EQ(Find(RegularPolygon(23, 20)).Pitch, 0);
  EXPECT_EQ(Find({ { 0, 0 }, { 7, 0 }, { 7, 4 }, { 3, 5 }, { 0, 4 } }).Pitch, 0);
}

TEST(TracedRaster, SaysHowUnsteadyTheyAre)
{
  EXPECT_LT(Find(Traced(20.3, 1, 0)).Unsteadiness, 0.01);
  const double little = Find(Traced(50.1, 1, 0.05)).Unsteadiness;
  const double much = Find(Traced(50.1, 1, 0.15)).Unsteadiness;
  EXPECT_GT(little, 0.01);
  EXPECT_LT(little, 0.05);
  EXPECT_NEAR(much, 3 * little, little);
}
