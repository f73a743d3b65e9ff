// SPDX-License-Identifier: GPL-3.0-or-later
// The contour edges of a level: its own and the others' distances, crossings, sides.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"
#include "Planar/PlanarEdges.h"

using namespace recon;
using namespace recon::testing;

namespace
{
/// A square with a square hole, above a square that is not asked for.
ContourSet Ring()
{
  return SoupMaker()
    .Loop(Rectangle(0, 0, 1, 1), -1)
    .Loop(Rectangle(0, 0, 10, 10))
    .Loop(Rectangle(4, 4, 6, 6))
    .Build();
}

int VertexAt(const ContourSet& set, int level, const Point2& place)
{
  for (int c : set.Levels[At(level)].Contours)
  {
    for (int p : set.Contours[At(c)].Points)
    {
      if (set.Planar[At(p)] == place)
      {
        return p;
      }
    }
  }
  return -1;
}

TEST(PlanarEdges, SidesAndDistances)
{
  const ContourSet set = Ring();
  const PlanarEdges edges(set, 1);
  EXPECT_EQ(edges.Edges().size(), 8u);
  EXPECT_EQ(edges.SideOf({ 1, 1 }), PlanarEdges::Inside);
  EXPECT_EQ(edges.SideOf({ 5, 5 }), PlanarEdges::Outside);
  EXPECT_EQ(edges.SideOf({ 4, 5 }), PlanarEdges::On);
  const int corner = VertexAt(set, 1, { 0, 0 });
  ASSERT_GE(corner, 0);
  EXPECT_EQ(edges.EdgesAt(corner).size(), 2u);
  EXPECT_DOUBLE_EQ(edges.DistanceToOwn(corner, { 3, 2 }), 2);
  EXPECT_DOUBLE_EQ(edges.DistanceToOthers(corner, { 3, 2 }, 100), std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(edges.DistanceToOthers(corner, { 3, 2 }, 2), 2);
  EXPECT_DOUBLE_EQ(edges.DistanceToOthers(-1, { 3, 1 }, 100), 1);
}

TEST(PlanarEdges, CrossingsOfOthers)
{
  const ContourSet set = Ring();
  const PlanarEdges edges(set, 1);
  const int corner = VertexAt(set, 1, { 0, 0 });
  EXPECT_FALSE(edges.CrossesOthers(corner, { 0, 0 }, { 3, 3 }));
  EXPECT_TRUE(edges.CrossesOthers(corner, { 0, 0 }, { 4, 4 }));
  EXPECT_TRUE(edges.CrossesOthers(corner, { 0, 0 }, { 5, 5 }));
  EXPECT_TRUE(edges.CrossesOthers(corner, { 0, 0 }, { 3, 11 }));
}

TEST(PlanarEdges, SelfCrossing)
{
  ContourSet set = Ring();
  EXPECT_FALSE(PlanarEdges(set, 1).SelfCrossing());
  set.Planar[At(VertexAt(set, 1, { 4, 4 }))] = { -1, 4 };
  EXPECT_TRUE(PlanarEdges(set, 1).SelfCrossing());
  // An edge that runs back over the one before it.
  set = Ring();
  set.Planar[At(VertexAt(set, 1, { 4, 4 }))] = { 6, 5 };
  EXPECT_TRUE(PlanarEdges(set, 1).SelfCrossing());
  // A point on another edge, and one on another point.
  set = Ring();
  set.Planar[At(VertexAt(set, 1, { 4, 4 }))] = { 0, 4 };
  EXPECT_TRUE(PlanarEdges(set, 1).SelfCrossing());
  set.Planar[At(VertexAt(set, 1, { 0, 4 }))] = { 0, 0 };
  EXPECT_TRUE(PlanarEdges(set, 1).SelfCrossing());
}

TEST(PlanarEdges, OfALevelWithoutContours)
{
  ContourSet set = Ring();
  set.Levels.push_back({});
  const PlanarEdges edges(set, 2);
  EXPECT_EQ(edges.SideOf({ 1, 1 }), PlanarEdges::Outside);
  EXPECT_EQ(edges.DistanceToOthers(-1, { 1, 1 }, 7), 7);
  EXPECT_FALSE(edges.SelfCrossing());
}
}
