// SPDX-License-Identifier: GPL-3.0-or-later
// Areas in one of two regions only, in closed form.
#include "Core/Contours/SoupMaker.h"
#include "Planar/PlanarDifference.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
void Add(const std::vector<Point2>& loop, PlanarRegions::LayerType layer, PlanarRegions& regions)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    regions.Segments.push_back({ loop[i], loop[(i + 1) % loop.size()], layer });
  }
}

TEST(PlanarDifference, OfSquares)
{
  PlanarRegions regions;
  Add(Rectangle(0, 0, 4, 4), PlanarRegions::Below, regions);
  Add(Rectangle(1, 1, 2, 2), PlanarRegions::Below, regions);
  Add(Rectangle(2, 2, 6, 6), PlanarRegions::Contour, regions);
  const PlanarDifference measured = MeasurePlanarDifference(regions);
  EXPECT_NEAR(measured.SurfaceArea, 15, 1e-12);
  EXPECT_NEAR(measured.ContourArea, 16, 1e-12);
  EXPECT_NEAR(measured.SymmetricDifference, 15 + 16 - 2 * 4, 1e-12);
  EXPECT_TRUE(measured.SurfaceIsClosed);
}

TEST(PlanarDifference, NothingOfEqualRegions)
{
  PlanarRegions regions;
  Add(Circle(1e6, 2, 3, 77), PlanarRegions::Above, regions);
  Add(Circle(1e6, 2, 3, 77), PlanarRegions::Contour, regions);
  EXPECT_EQ(MeasurePlanarDifference(regions).SymmetricDifference, 0);
}

TEST(PlanarDifference, OpenBordersAreSaid)
{
  PlanarRegions regions;
  regions.Segments.push_back({ { { 0, 0 }, { 1, 1 } }, PlanarRegions::Below });
  EXPECT_FALSE(MeasurePlanarDifference(regions).SurfaceIsClosed);
}
}
