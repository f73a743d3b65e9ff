// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionDiscs.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;
using namespace recon::testing;

namespace
{
const PlanarFrame Upright = PlanarFrame::About({ 0, 0, 1 });
}

TEST(SectionDiscs, OfABoxAreItsSection)
{
  const auto discs = FindSectionDiscs(MakeBox({ 0, 0, 0 }, { 2, 3, 4 }), Upright, { 0, 4 });
  ASSERT_FALSE(discs.empty());
  for (const SectionDisc& disc : discs)
  {
    EXPECT_TRUE(disc.Solid);
    EXPECT_NEAR(disc.Area, 6, 1e-12);
    EXPECT_EQ(disc.Edges.size(), disc.Triangles.size());
    EXPECT_LT(disc.Low, disc.High);
  }
}

TEST(SectionDiscs, ARingHasTheDiscOfItsHoleOnly)
{
  const auto discs = FindSectionDiscs(MakeRingChain(1), Upright, { 0, 1 });
  ASSERT_FALSE(discs.empty());
  for (const SectionDisc& disc : discs)
  {
    EXPECT_FALSE(disc.Solid);
    EXPECT_NEAR(disc.Area, 1, 1e-12);
  }
}

TEST(SectionDiscs, NoPointLiesBetweenTheTwoHeights)
{
  const TriangleMesh torus = MakeTorus(2, 0.7);
  for (const SectionDisc& disc : FindSectionDiscs(torus, Upright, { -0.7, 0, 0.7 }))
  {
    EXPECT_TRUE(std::none_of(torus.Points.begin(), torus.Points.end(),
      [&](const Point3& p) { return p[2] >= disc.Low && p[2] <= disc.High; }));
  }
}

TEST(SectionDiscs, ThereAreNoneBeyondTheLevels)
{
  EXPECT_TRUE(FindSectionDiscs(MakeCube(), Upright, { 2, 3 }).empty());
  EXPECT_TRUE(FindSectionDiscs(MakeCube(), Upright, { 0 }).empty());
}
