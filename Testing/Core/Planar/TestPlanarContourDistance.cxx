// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to the contours of a triangulated level.
#include "Planar/PlanarContourDistance.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;

namespace
{
TEST(PlanarContourDistance, GoesByContourEdgesOnly)
{
  // A square cut by its diagonal, which is no contour edge.
  LevelTriangulation level;
  level.Points = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  level.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  level.EdgeContour = { { 0, -1, 0 }, { 0, 0, -1 } };
  level.Inside = { true, true };
  const PlanarContourDistance distance(level);
  EXPECT_DOUBLE_EQ(distance({ 2, 2 }), 2);
  EXPECT_DOUBLE_EQ(distance({ 3, 2 }), 1);
  EXPECT_DOUBLE_EQ(distance({ 7, 8 }), 5);
  EXPECT_DOUBLE_EQ(distance({ 4, 1 }), 0);
}
}
