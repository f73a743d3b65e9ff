// SPDX-License-Identifier: GPL-3.0-or-later
// What bears on the boundary is found from either level, and all crossings are where all are asked for.
#include "BoundaryOracle.h"

#include "Polyhedral/JointVoronoi.h"
#include "Polyhedral/VoronoiSections.h"

#include <gtest/gtest.h>

#include <map>

using namespace recon;
using namespace recon::testing;

namespace
{
using CornersByEdges = std::map<std::array<int, 2>, std::array<int, 4>>;

CornersByEdges Found(const JointCells& cells, const std::vector<int>& levels, bool all)
{
  const VoronoiSections sections(cells);
  std::vector<JointCrossing> crossings;
  for (const int own : levels)
  {
    const LevelTriangulation& level = cells.LevelAt(own);
    for (int edge = 0; edge < static_cast<int>(3 * level.Triangles.size()); ++edge)
    {
      if (CanonicalEdge(level, edge / 3, edge % 3) == edge)
      {
        sections.Find(own, edge, all, crossings);
      }
    }
  }
  CornersByEdges found;
  for (const JointCrossing& crossing : crossings)
  {
    found[crossing.Edges] = crossing.Corners;
  }
  return found;
}

/// As far as contours alone tell.
bool IsSolid(const JointCells& cells, const SlabTetrahedra::Tetrahedron& t)
{
  if (t.Node != SlabTetrahedra::T12)
  {
    return cells.LevelAt(t.Node == SlabTetrahedra::T1 ? 0 : 1).Inside[t.Origin[0]] != 0;
  }
  const auto inside = SidesOf(cells, { t.Origin, t.Corners });
  return KindOf(cells.LevelAt(0), t.Origin[0]) != EdgeKind::External &&
    KindOf(cells.LevelAt(1), t.Origin[1]) != EdgeKind::External && (inside[0] || inside[1]);
}

void ExpectSections(const LevelTriangulation& lower, const LevelTriangulation& upper)
{
  const JointCells cells(lower, upper);
  const SlabTetrahedra slab = BuildJointVoronoi(lower, upper);
  CornersByEdges all;
  for (const auto& t : slab.Tetrahedra)
  {
    if (t.Node == SlabTetrahedra::T12)
    {
      all[t.Origin] = t.Corners;
    }
  }
  EXPECT_EQ(Found(cells, { 0 }, true), all);
  EXPECT_EQ(Found(cells, { 1 }, true), all);
  const CornersByEdges few = Found(cells, { 0, 1 }, false);
  for (const auto& crossing : few)
  {
    ASSERT_EQ(all.count(crossing.first), 1u);
    EXPECT_EQ(all.at(crossing.first), crossing.second);
  }
  for (const auto& t : slab.Tetrahedra)
  {
    for (const int neighbour : t.Neighbours)
    {
      const bool isBorder = t.Node == SlabTetrahedra::T12 && neighbour >= 0 && IsSolid(cells, t) &&
        !IsSolid(cells, slab.Tetrahedra[neighbour]);
      EXPECT_TRUE(!isBorder || few.count(t.Origin) == 1)
        << t.Origin[0] << " and " << t.Origin[1] << " cross where solid ends";
    }
  }
}
}

TEST(VoronoiSections, HoldWhereSolidBeginsAndEnds)
{
  const auto blobs = TriangulateLevels(BlobStack(300, 2), true);
  ExpectSections(blobs[0], blobs[1]);
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto levels = TriangulateLevels(BuildStack(RandomStack(seed)), true);
    for (std::size_t l = 0; l + 1 < levels.size(); ++l)
    {
      ExpectSections(levels[l], levels[l + 1]);
    }
  }
}

TEST(VoronoiSections, HoldWhereEverythingIsATie)
{
  const Ring disc = PixelDisc(5, 1);
  const auto levels = TriangulateLevels(BuildStack({ { disc }, { PixelDisc(3, 1) } }), true);
  ExpectSections(levels[0], levels[1]);
}
