// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that users may look at are those that the surface is made of.
#include "BoundaryOracle.h"
#include "Polyhedral/PolyhedralStages.h"
#include "Polyhedral/SolidBoundary.h"
#include "Polyhedral/StagesMemory.h"
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

using namespace recon;
using namespace recon::testing;

namespace
{
using Corner = std::pair<int, int>; ///< level, number in its triangulation
/// Oriented triangles as a chain: how often each is there more one way round than the other.
using Chain = std::map<std::array<Corner, 3>, int>;

void Add(Chain& chain, std::array<Corner, 3> corners)
{
  int sign = 1;
  for (const auto& [i, j] : { std::pair{ 0, 1 }, std::pair{ 1, 2 }, std::pair{ 0, 1 } })
  {
    if (corners[j] < corners[i])
    {
      std::swap(corners[i], corners[j]);
      sign = -sign;
    }
  }
  if (corners[0] != corners[1] && corners[1] != corners[2] && (chain[corners] += sign) == 0)
  {
    chain.erase(corners);
  }
}

Chain BoundaryOfKeptTetrahedra(const PolyhedralStages& stages)
{
  constexpr int outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  Chain chain;
  for (std::size_t s = 0; s < stages.Slabs.size(); ++s)
  {
    for (const auto& t : stages.Slabs[s].Diagram.Tetrahedra)
    {
      for (int k = 0; k < 4 && t.Reason == SlabTetrahedra::Kept; ++k)
      {
        std::array<Corner, 3> face;
        for (int j = 0; j < 3; ++j)
        {
          const int corner = outward[k][j];
          const int level = static_cast<int>(s) + (SlabTetrahedra::OnLevel2(t, corner) ? 1 : 0);
          face[j] = { level, t.Corners[corner] };
        }
        Add(chain, face);
      }
    }
  }
  return chain;
}

/// With lifted points put back into their planes, which flattens what was filled in for lifting and
/// ends, and with the middles of halved edges put back to one of their ends.
Chain SurfaceBeforeLifting(const PolyhedralStages& stages, bool& hasPyramids)
{
  const SolidComplex solid = BuildSolidComplex(stages.Levels, stages.Slabs);
  const SolidBoundary boundary = ExtractSolidBoundary(solid);
  Chain chain;
  for (const auto& face : boundary.Faces)
  {
    std::array<Corner, 3> corners;
    for (int j = 0; j < 3; ++j)
    {
      const auto& vertex = solid.Vertices[boundary.Points[face.Points[j]].Vertex];
      corners[j] = { vertex.Level, vertex.Local };
      hasPyramids = hasPyramids || vertex.Local < 0;
    }
    Add(chain, corners);
  }
  return chain;
}
}

TEST(PolyhedralStages, KeptTetrahedraAreBoundedByTheSurfaceBeforeLiftingAndEnds)
{
  int compared = 0;
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ContourSet contours = BuildStack(RandomStack(seed));
    if (contours.Levels.size() < 2)
    {
      continue;
    }
    PolyhedralOptions options; // those that users meet
    options.Mapping = PolyhedralOptions::Overlap;
    options.EndCaps = static_cast<PolyhedralOptions::EndCapsType>(seed % 3);
    options.IsolatedContours = PolyhedralOptions::Extrude;
    Monitor monitor;
    const PolyhedralStages stages = BuildPolyhedralStages(contours, options, monitor);
    bool hasPyramids = false;
    const Chain surface = SurfaceBeforeLifting(stages, hasPyramids);
    if (!hasPyramids)
    {
      EXPECT_TRUE(surface == BoundaryOfKeptTetrahedra(stages));
      compared += surface.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 10);
}

TEST(PolyhedralStages, ReportIsPartOfTheSurfaces)
{
  const ContourSet contours = BuildStack(RandomStack(3));
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  Monitor monitor;
  const auto stages = BuildPolyhedralStages(contours, options, monitor);
  const auto surface = BuildSurface(contours, options);
  ASSERT_LE(stages.Report.size(), surface.Report.size());
  EXPECT_TRUE(std::equal(stages.Report.begin(), stages.Report.end(), surface.Report.begin()));
}

namespace
{
/// The same four levels again and again: a branching, and a region that ends.
ContourSet PeriodicStack(int levels)
{
  const RingStack period{ { Blob(150, 0) }, { Blob(70, 1, { -1.6, 0 }), Blob(80, 2, { 1.6, 0 }) },
    { Blob(150, 3) }, { Blob(120, 4), Blob(30, 5, { 4, 0 }) } };
  RingStack stack;
  for (int l = 0; l < levels; ++l)
  {
    stack.push_back(period[l % period.size()]);
  }
  return BuildStack(stack);
}

PolyhedralOptions UsersOptions()
{
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.EndCaps = PolyhedralOptions::Tapered;
  return options;
}
}

// However far the stack is taken on at a time, what a level becomes follows from those near it alone.
TEST(PolyhedralStages, RepeatWhereLevelsRepeat)
{
  const int levels = 240; // more than twice what is taken on at a time
  const int period = 4;
  const int reach = 7; // KeptStages.h
  const ContourSet contours = PeriodicStack(levels);
  Monitor monitor;
  const PolyhedralStages stages = BuildPolyhedralStages(contours, UsersOptions(), monitor);
  EXPECT_EQ(stages.Forgotten, 0u);
  for (int i = reach; i + 1 + period + reach < levels; ++i)
  {
    const LevelState& level = stages.Levels[i];
    const LevelState& like = stages.Levels[i + period];
    ASSERT_EQ(level.Triangulation.Points, like.Triangulation.Points) << "level " << i;
    ASSERT_EQ(level.Triangulation.Triangles, like.Triangulation.Triangles) << "level " << i;
    ASSERT_EQ(level.Covered.Covered, like.Covered.Covered) << "level " << i;
    ASSERT_EQ(level.OutsideAbove, like.OutsideAbove) << "level " << i;
    ASSERT_EQ(level.OutsideBelow, like.OutsideBelow) << "level " << i;
    const auto& tetrahedra = stages.Slabs[i].Diagram.Tetrahedra;
    const auto& same = stages.Slabs[i + period].Diagram.Tetrahedra;
    ASSERT_EQ(tetrahedra.size(), same.size()) << "slab " << i;
    for (std::size_t t = 0; t < same.size(); ++t)
    {
      ASSERT_EQ(tetrahedra[t].Corners, same[t].Corners) << "slab " << i;
      ASSERT_EQ(tetrahedra[t].Reason, same[t].Reason) << "slab " << i;
    }
  }
}

TEST(PolyhedralStages, AreHandedOnAndForgottenAsTheyAreFinished)
{
  std::size_t longest = 0;
  for (const int levels : { 240, 360 })
  {
    const ContourSet contours = PeriodicStack(levels);
    Monitor monitor;
    std::size_t finished = 0;
    std::size_t most = 0;
    const StagesSink sink = [&](const PolyhedralStages& stages, std::size_t first)
    {
      EXPECT_GE(first, finished);
      EXPECT_EQ(stages.Forgotten, finished);
      finished = first;
      std::size_t bytes = 0;
      for (std::size_t i = 0; i < stages.Levels.size(); ++i)
      {
        bytes += BytesOfLevel(stages, i) > sizeof(LevelState) + sizeof(SlabState)
          ? BytesOfLevel(stages, i)
          : 0;
        const bool isThere = i >= stages.Forgotten && i < first;
        EXPECT_TRUE(!isThere || !stages.Levels[i].Triangulation.Triangles.empty());
      }
      most = std::max(most, bytes);
      return first;
    };
    const PolyhedralStages stages = BuildPolyhedralStages(
      contours, UsersOptions(), monitor, 1, TetrahedraWanted::ForSurface, false, sink);
    EXPECT_EQ(finished, static_cast<std::size_t>(levels));
    EXPECT_GT(most, 0u);
    if (longest > 0)
    {
      EXPECT_LE(most, longest + longest / 20) << "what is there at once grows with the stack";
    }
    longest = most;
  }
}
