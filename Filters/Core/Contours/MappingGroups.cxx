// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/MappingGroups.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
/// Regions of one slab that joins link, directly or through others.
class Links
{
public:
  void Join(int a, int b)
  {
    const int rootA = this->RootOf(a);
    const int rootB = this->RootOf(b);
    // The smaller number leads, so that the result does not depend on the order of the joins.
    this->Leaders[std::max(rootA, rootB)] = std::min(rootA, rootB);
  }

  /// Regions by the smallest of those that they are linked with.
  std::map<int, std::vector<int>> Clusters()
  {
    std::vector<int> regions;
    for (const auto& entry : this->Leaders)
    {
      regions.push_back(entry.first);
    }
    std::map<int, std::vector<int>> clusters;
    for (int region : regions)
    {
      clusters[this->RootOf(region)].push_back(region);
    }
    return clusters;
  }

private:
  int RootOf(int region)
  {
    int root = this->Leaders.emplace(region, region).first->second;
    while (this->Leaders[root] != root)
    {
      root = this->Leaders[root];
    }
    while (region != root)
    {
      region = std::exchange(this->Leaders[region], root);
    }
    return root;
  }

  std::map<int, int> Leaders;
};

bool IsPhi(const ContourJoin& join)
{
  return join.LowerRegion < 0 || join.UpperRegion < 0;
}

void SortUnique(std::vector<int>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

MappingGroup GroupOf(const std::vector<int>& regions, int slab, const ContourMapping& mapping)
{
  MappingGroup group;
  group.Slab = slab;
  for (int r : regions)
  {
    const ContourRegion& region = mapping.Regions[r];
    std::vector<int>& side = region.Level == slab ? group.LowerContours : group.UpperContours;
    side.push_back(region.Wall);
    side.insert(side.end(), region.Holes.begin(), region.Holes.end());
  }
  SortUnique(group.LowerContours);
  SortUnique(group.UpperContours);
  return group;
}

MappingGroup GroupOfPhi(const ContourJoin& join, const ContourMapping& mapping)
{
  const int region = std::max(join.LowerRegion, join.UpperRegion);
  if (mapping.Regions[region].Solid)
  {
    return GroupOf({ region }, join.Slab, mapping);
  }
  MappingGroup group;
  group.Slab = join.Slab;
  (join.LowerRegion >= 0 ? group.LowerContours : group.UpperContours)
    .push_back(mapping.Regions[region].Wall);
  return group;
}

/// level(mg): the lowest depth of a contour in it.
int LevelOf(const MappingGroup& group, const ContourSet& contours)
{
  int level = std::numeric_limits<int>::max();
  for (const auto* side : { &group.LowerContours, &group.UpperContours })
  {
    for (int c : *side)
    {
      level = std::min(level, contours.Contours[c].Depth);
    }
  }
  return level;
}

void Remove(std::vector<int>& contours, const std::set<std::pair<int, int>>& taken, int slab)
{
  contours.erase(std::remove_if(contours.begin(), contours.end(),
                   [&](int c) {
                     return taken.count({ slab, c }) > 0;
                   }),
    contours.end());
}
}

std::vector<MappingGroup> FormMappingGroups(
  const ContourMapping& mapping, const ContourSet& contours)
{
  std::vector<Links> links(contours.Levels.size());
  std::vector<std::vector<MappingGroup>> ofPhi(contours.Levels.size());
  for (const ContourJoin& join : mapping.Joins)
  {
    if (IsPhi(join))
    {
      ofPhi[join.Slab].push_back(GroupOfPhi(join, mapping));
    }
    else if (join.Joined)
    {
      links[join.Slab].Join(join.LowerRegion, join.UpperRegion);
    }
  }
  std::vector<MappingGroup> groups;
  for (std::size_t slab = 0; slab < links.size(); ++slab)
  {
    for (const auto& cluster : links[slab].Clusters())
    {
      groups.push_back(GroupOf(cluster.second, static_cast<int>(slab), mapping));
    }
    groups.insert(groups.end(), ofPhi[slab].begin(), ofPhi[slab].end());
  }
  return groups;
}

std::vector<MappingGroup> FilterInternalWalls(
  const std::vector<MappingGroup>& groups, const ContourMapping& mapping)
{
  std::set<std::pair<int, int>> ignored;
  for (const ContourJoin& join : mapping.Joins)
  {
    if (IsPhi(join) && join.InternalWallRule == 3)
    {
      const int region = std::max(join.LowerRegion, join.UpperRegion);
      ignored.insert({ join.Slab, mapping.Regions[region].Wall });
    }
  }
  std::vector<MappingGroup> kept;
  for (const MappingGroup& group : groups)
  {
    const bool alone = group.LowerContours.size() + group.UpperContours.size() == 1;
    const int contour =
      group.LowerContours.empty() ? group.UpperContours.front() : group.LowerContours.front();
    if (!alone || ignored.count({ group.Slab, contour }) == 0)
    {
      kept.push_back(group);
    }
  }
  return kept;
}

std::vector<MappingGroup> FilterRedundantGroups(
  const std::vector<MappingGroup>& groups, const ContourSet& contours)
{
  // Slab, level and number of a group; the lowest comes first.
  using Entry = std::tuple<int, int, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    waiting.emplace(groups[g].Slab, LevelOf(groups[g], contours), g);
  }
  std::vector<MappingGroup> rest = groups;
  std::set<std::pair<int, int>> taken;
  std::vector<MappingGroup> kept;
  while (!waiting.empty())
  {
    const auto [slab, level, g] = waiting.top();
    waiting.pop();
    MappingGroup& group = rest[g];
    Remove(group.LowerContours, taken, slab);
    Remove(group.UpperContours, taken, slab);
    if (group.LowerContours.empty() && group.UpperContours.empty())
    {
      continue;
    }
    if (const int now = LevelOf(group, contours); now > level)
    {
      waiting.emplace(slab, now, g); // what made it low has gone to another group
      continue;
    }
    for (const auto* side : { &group.LowerContours, &group.UpperContours })
    {
      for (int c : *side)
      {
        taken.insert({ slab, c });
      }
    }
    kept.push_back(group);
  }
  return kept;
}
}
