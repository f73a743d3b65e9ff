// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionDiscs.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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
    EXPECT_EQ(disc.Loop.Edges.size(), disc.Loop.Triangles.size());
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

namespace
{
std::vector<SectionDisc> Find(const TriangleMesh& mesh, const Vector3& normal, bool withRings,
  const std::vector<double>& offsets)
{
  Monitor monitor;
  const PlanarFrame frame = PlanarFrame::About((1 / Norm(normal)) * normal);
  return FindSectionDiscs(
    mesh, { frame, SectionPlanes::Critical, withRings }, Upright.Normal, offsets, monitor);
}
}

TEST(SectionDiscs, CriticalPlanesSeeWhatIsLow)
{
  // A pin a hundredth as high as the slab, beside a block.
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleMesh pin = MakeBox({ 2, 0, 0.5 }, { 3, 1, 0.51 });
  const int first = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), pin.Points.begin(), pin.Points.end());
  for (const auto& t : pin.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  const auto discs = Find(mesh, Upright.Normal, false, { 0, 1 });
  EXPECT_EQ(std::count_if(discs.begin(), discs.end(),
              [](const SectionDisc& d) { return d.Low > 0.5 && d.High < 0.51; }),
    2);
}

TEST(SectionDiscs, RingsComeWithWhatIsInside)
{
  const TriangleMesh ring = MakeRingChain(1);
  for (const SectionDisc& disc : Find(ring, Upright.Normal, false, { 0, 1 }))
  {
    EXPECT_TRUE(disc.Inside.empty());
  }
  const auto discs = Find(ring, Upright.Normal, true, { 0, 1 });
  const auto isRing = [](const SectionDisc& disc) { return !disc.Inside.empty(); };
  const auto found = std::find_if(discs.begin(), discs.end(), isRing);
  ASSERT_NE(found, discs.end());
  EXPECT_TRUE(found->Solid);
  EXPECT_EQ(found->Inside.size(), 1U);
  EXPECT_NEAR(found->Area, 9, 1e-12);
}

TEST(SectionDiscs, OfTiltedPlanesNoneLeavesItsSlabOrCutsWhatIsDrawn)
{
  const TriangleMesh box = MakeBox({ 0, 0, 0 }, { 2, 3, 4 });
  const auto discs = Find(box, { 0.05, 0.02, 1 }, false, { 0, 4 });
  ASSERT_FALSE(discs.empty());
  for (const SectionDisc& disc : discs)
  {
    for (const auto& edge : disc.Loop.Edges)
    {
      EXPECT_NE(box.Points[edge[0]][2], box.Points[edge[1]][2]);
    }
  }
  EXPECT_TRUE(Find(box, { 3, 0, 1 }, false, { 0, 4 }).empty());
}
