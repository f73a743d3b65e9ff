// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PartialEnds.h"

#include "Polyhedral/DelaunayEdges.h"
#include "Polyhedral/LiftTargets.h"

#include <set>
#include <utility>

namespace recon
{
namespace
{
using RegionPair = std::pair<int, int>; ///< on the lower and on the upper level

int RegionAt(const LevelTriangulation& level, int triangle)
{
  return triangle < 0 ? -1 : level.Region[triangle];
}

std::set<RegionPair> JoinedPairs(
  const SlabTetrahedra& slab, const LevelTriangulation& lower, const LevelTriangulation& upper)
{
  std::set<RegionPair> pairs = slab.GapRegions;
  for (const auto& t : slab.Tetrahedra)
  {
    if (t.Reason == SlabTetrahedra::Kept && t.Node == SlabTetrahedra::T12)
    {
      pairs.emplace(RegionAtEdge(lower, t.Origin[0]), RegionAtEdge(upper, t.Origin[1]));
    }
  }
  return pairs;
}

/// Whether point i has nothing on either side and the neighbour is the nearer one.
bool IsNearerThanBehind(const SkeletonSide& side, std::size_t i, double across)
{
  return !side.Behind ||
    (RegionAt(side.Behind->Triangulation, (*side.BehindTriangles)[i]) < 0 &&
      across <= (*side.Behind->Distance)(side.Level->InternalSkeleton[i]));
}

std::vector<Point2> EndsOf(
  const SkeletonSide& side, const SkeletonSide& other, const std::set<int>& spared)
{
  std::vector<Point2> ends;
  const std::vector<Point2>& skeleton = side.Level->InternalSkeleton;
  const auto* behind = side.Behind ? side.Behind->Distance.get() : nullptr;
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    const int region = RegionAt(side.Level->Triangulation, (*side.Triangles)[i]);
    if (region < 0 || RegionAt(other.Level->Triangulation, (*side.OtherTriangles)[i]) >= 0 ||
      spared.count(region) > 0)
    {
      continue;
    }
    const Point2& p = skeleton[i];
    const double own = (*side.Level->Distance)(p);
    const double across = (*other.Level->Distance)(p);
    const double cone = own / (own + across);
    if (!IsNearerThanBehind(side, i, across) && EndShare(p, own, behind, false) > cone)
    {
      ends.push_back(p);
    }
  }
  return ends;
}
}

EndsOfSlab FindPartialEnds(
  const SlabTetrahedra& slab, const SkeletonSide& lower, const SkeletonSide& upper)
{
  const LevelTriangulation& level1 = lower.Level->Triangulation;
  const LevelTriangulation& level2 = upper.Level->Triangulation;
  std::set<RegionPair> seen;
  for (std::size_t i = 0; i < lower.Triangles->size(); ++i)
  {
    seen.emplace(
      RegionAt(level1, (*lower.Triangles)[i]), RegionAt(level2, (*lower.OtherTriangles)[i]));
  }
  for (std::size_t i = 0; i < upper.Triangles->size(); ++i)
  {
    seen.emplace(
      RegionAt(level1, (*upper.OtherTriangles)[i]), RegionAt(level2, (*upper.Triangles)[i]));
  }
  std::array<std::set<int>, 2> spared;
  for (const RegionPair& pair : JoinedPairs(slab, level1, level2))
  {
    if (seen.count(pair) == 0)
    {
      spared[0].insert(pair.first);
      spared[1].insert(pair.second);
    }
  }
  return { { EndsOf(lower, upper, spared[0]), EndsOf(upper, lower, spared[1]) } };
}
bool AddPartialEnds(LevelTriangulator& level, const EndsOfSlab* below, const EndsOfSlab* above)
{
  bool any = false;
  if (below)
  {
    level.AddInternalPoints((*below)[1], LevelTriangulation::LevelBelow);
    level.AddExternalPoints((*below)[0]);
    any = !(*below)[0].empty() || !(*below)[1].empty();
  }
  if (above)
  {
    level.AddInternalPoints((*above)[0], LevelTriangulation::LevelAbove);
    level.AddExternalPoints((*above)[1]);
    any = any || !(*above)[0].empty() || !(*above)[1].empty();
  }
  return any;
}
}
