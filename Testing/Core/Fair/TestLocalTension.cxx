// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/LocalTension.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Of a mesh that bends as much everywhere.
double TensionAt(double rest, double bend)
{
  const TriangleMesh sphere = MakeSphere(24, 12);
  const std::vector<double> tension =
    TensionByBend(sphere, std::vector<double>(sphere.Points.size(), rest),
      std::vector<double>(sphere.Points.size(), bend), 4);
  EXPECT_NEAR(*std::min_element(tension.begin(), tension.end()), tension.front(), 1e-12);
  EXPECT_NEAR(*std::max_element(tension.begin(), tension.end()), tension.front(), 1e-12);
  return tension.front();
}
}

TEST(LocalTension, IsLittleWhereSlicesShowTheShape)
{
  EXPECT_LT(TensionAt(0.5, 0.5), FirstTension);
  EXPECT_EQ(TensionAt(0.5, 0.3), TensionAt(0.5, 0.9));
}

TEST(LocalTension, RisesWhereItBendsMoreThanTheyShow)
{
  EXPECT_GT(TensionAt(0.5, 1.9), TensionAt(0.5, 1.5));
  EXPECT_GT(TensionAt(0.5, 10), 0.5);
  EXPECT_LE(TensionAt(0.5, 1e9), 1);
}

TEST(LocalTension, IsMuchWhereTheGivenSurfaceIsFlat)
{
  EXPECT_GT(TensionAt(0, 0.3), 0.5);
  EXPECT_EQ(TensionAt(0, 0.3), TensionAt(0, 10));
}

TEST(LocalTension, GoesOverFromPlaceToPlace)
{
  // A single point that bends without bound is evened out over its surroundings, and is not felt afar.
  const TriangleMesh sphere = MakeSphere(60, 30);
  const std::vector<double> rest(sphere.Points.size(), 1);
  std::vector<double> bends(sphere.Points.size(), 0.5);
  bends[900] = 500;
  const std::vector<double> tension = TensionByBend(sphere, rest, bends, 3);
  for (std::size_t p = 0; p < tension.size(); ++p)
  {
    const double far = Norm(sphere.Points[p] - sphere.Points[900]);
    EXPECT_TRUE(far < 0.6 || tension[p] < FirstTension) << far;
    EXPECT_TRUE(far > 0.12 || tension[p] > 0.5) << far;
  }
}
