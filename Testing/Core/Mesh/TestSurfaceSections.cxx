// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/RingPlane.h"
#include "Mesh/SurfaceSections.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace recon;
using namespace recon::testing;

namespace
{
LoopSoup Section(const TriangleMesh& mesh, const PlanarFrame& frame, double offset)
{
  LoopSoup soup;
  AppendSection(mesh, frame, offset, soup);
  return soup;
}

const PlanarFrame Upright = PlanarFrame::About({ 0, 0, 1 });
}

TEST(SurfaceSections, OfABoxAreItsRectangles)
{
  const TriangleMesh box = MakeBox({ 0, 0, 0 }, { 2, 3, 4 });
  for (const double z : { 0.5, 1.0, 3.999 })
  {
    const LoopSoup soup = Section(box, Upright, z);
    ASSERT_EQ(soup.Chains.size(), 1u);
    EXPECT_TRUE(soup.Chains.front().Closed);
    // Counterclockwise, seen from above: the solid is on the left.
    EXPECT_NEAR(NewellArea(soup, soup.Chains.front().Points)[2], 6, 1e-12);
    for (const int p : soup.Chains.front().Points)
    {
      EXPECT_NEAR(soup.Points[p][2], z, 1e-12);
    }
  }
}

TEST(SurfaceSections, InTheEndsOfABoxAreThoseOfAHairBelow)
{
  const TriangleMesh box = MakeBox({ 0, 0, 0 }, { 2, 3, 4 });
  const LoopSoup top = Section(box, Upright, 4);
  ASSERT_EQ(top.Chains.size(), 1u);
  EXPECT_EQ(NewellArea(top, top.Chains.front().Points)[2], 6);
  EXPECT_TRUE(Section(box, Upright, 0).Chains.empty());
  EXPECT_TRUE(Section(box, Upright, 5).Chains.empty());
}

TEST(SurfaceSections, OfTwoBoxesInATiltedPlane)
{
  TriangleMesh boxes = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleMesh other = MakeBox({ 5, 0, 0 }, { 6, 1, 1 });
  const int first = static_cast<int>(boxes.Points.size());
  boxes.Points.insert(boxes.Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& t : other.Triangles)
  {
    boxes.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  const PlanarFrame tilted = PlanarFrame::About({ 0, 0.6, 0.8 });
  const LoopSoup soup = Section(boxes, tilted, 0.7);
  ASSERT_EQ(soup.Chains.size(), 2u);
  for (const auto& chain : soup.Chains)
  {
    // A unit box at half its height: the plane is as wide as its slope makes it.
    EXPECT_NEAR(Norm(NewellArea(soup, chain.Points)), 1 / 0.8, 1e-12);
    for (const int p : chain.Points)
    {
      EXPECT_NEAR(tilted.OffsetOf(soup.Points[p]), 0.7, 1e-12);
    }
  }
}

TEST(SurfaceSections, OfAnOpenSurfaceAreNoLoops)
{
  TriangleMesh box = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  box.Triangles.erase(
    std::remove_if(box.Triangles.begin(), box.Triangles.end(),
      [&](const auto& t)
      { return box.Points[t[0]][0] == 1 && box.Points[t[1]][0] == 1 && box.Points[t[2]][0] == 1; }),
    box.Triangles.end());
  EXPECT_TRUE(Section(box, Upright, 0.5).Chains.empty());
}
