// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Monitor.h"
#include "Mesh/HalfEdges.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <set>

using namespace recon;
using namespace recon::testing;

TEST(HalfEdges, OppositesRunTheSameEdgeTheOtherWay)
{
  const TriangleMesh mesh = MakeTorus(2, 0.5);
  const HalfEdges edges(mesh);
  ASSERT_EQ(edges.Count(), static_cast<int>(3 * mesh.Triangles.size()));
  for (int h = 0; h < edges.Count(); ++h)
  {
    const int opposite = edges.Opposite(h);
    ASSERT_GE(opposite, 0);
    EXPECT_EQ(edges.Opposite(opposite), h);
    EXPECT_EQ(edges.From(opposite), edges.To(h));
    EXPECT_EQ(edges.To(opposite), edges.From(h));
    EXPECT_EQ(edges.Partner(h), opposite);
    EXPECT_EQ(HalfEdges::Next(HalfEdges::Next(HalfEdges::Next(h))), h);
  }
}

TEST(HalfEdges, EachLeavesThePointThatItIsListedAt)
{
  const TriangleMesh mesh = MakeSphere(12, 6);
  const HalfEdges edges(mesh);
  std::set<int> seen;
  for (int p = 0; p < static_cast<int>(mesh.Points.size()); ++p)
  {
    for (const int* h = edges.BeginFrom(p); h != edges.EndFrom(p); ++h)
    {
      EXPECT_EQ(edges.From(*h), p);
      EXPECT_TRUE(seen.insert(*h).second);
    }
  }
  EXPECT_EQ(static_cast<int>(seen.size()), edges.Count());
}

TEST(HalfEdges, PartnersLeadRoundABorder)
{
  TriangleMesh mesh = MakeCube();
  const std::array<int, 3> hole = mesh.Triangles.back();
  mesh.Triangles.pop_back();
  const HalfEdges edges(mesh);
  int borders = 0;
  for (int h = 0; h < edges.Count(); ++h)
  {
    if (edges.Opposite(h) >= 0)
    {
      continue;
    }
    ++borders;
    const int next = edges.Partner(h);
    EXPECT_EQ(edges.Opposite(next), -1);
    EXPECT_EQ(edges.From(next), edges.To(h));
    EXPECT_NE(std::find(hole.begin(), hole.end(), edges.From(h)), hole.end());
  }
  EXPECT_EQ(borders, 3);
}

TEST(HalfEdges, ComponentsAreNumberedByTheirFirstTriangle)
{
  TriangleMesh mesh = MakeCube();
  Append(mesh, MakeSphere(8, 4));
  const std::vector<int> components = HalfEdges(mesh).Components();
  for (std::size_t t = 0; t < components.size(); ++t)
  {
    EXPECT_EQ(components[t], t < 12 ? 0 : 1);
  }
}

TEST(HalfEdges, RefusesWhatIsNoOrientedManifold)
{
  TriangleMesh twice = MakeCube();
  twice.Triangles.push_back(twice.Triangles.front());
  EXPECT_THROW(HalfEdges edges(twice), Error);
  TriangleMesh turned = MakeCube();
  std::swap(turned.Triangles[0][0], turned.Triangles[0][1]);
  EXPECT_THROW(HalfEdges edges(turned), Error);
  TriangleMesh collapsed = MakeCube();
  collapsed.Triangles[0][1] = collapsed.Triangles[0][0];
  EXPECT_THROW(HalfEdges edges(collapsed), Error);
}
