// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourMapping.h"

#include "Base/Parallel.h"
#include "Contours/ContourNotes.h"
#include "Contours/JoinExplanation.h"
#include "Contours/JoinOverrides.h"
#include "Contours/LevelGaps.h"
#include "Contours/MappingGroups.h"
#include "Planar/NearestRegion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace recon
{
namespace
{
/// Overlaps below this part of the smaller region are rounding of a common border.
constexpr double Negligible = 1e-12;

void Validate(const ContourSet& contours, const ContourMappingOptions& options)
{
  if (!contours.Parallel)
  {
    throw Error("The contours lie in planes that are not parallel, so no level is above another: "
                "give contours of parallel planes.");
  }
  if (!(options.OverlapThreshold >= 0 && options.OverlapThreshold <= 1))
  {
    throw Error("The overlap threshold is a share of an area: give a number from 0 to 1 instead "
                "of " +
      Text(options.OverlapThreshold) + ".");
  }
  if (!(options.MaximumGap >= 0 && std::isfinite(options.MaximumGap)))
  {
    throw Error("The maximum gap is a multiple of the slice spacing: give 0 (no limit) or a "
                "positive number instead of " +
      Text(options.MaximumGap) + ".");
  }
}

/// SR and NSR (3.1): region i is the one inside contour i.
std::vector<ContourRegion> MakeRegions(const ContourSet& contours)
{
  std::vector<ContourRegion> regions(contours.Contours.size());
  for (std::size_t c = 0; c < regions.size(); ++c)
  {
    const Contour& contour = contours.Contours[c];
    ContourRegion& region = regions[c];
    region.Level = contour.Level;
    region.Wall = static_cast<int>(c);
    region.Solid = contour.Depth % 2 == 0;
    region.Area += std::abs(contour.SignedArea);
    if (contour.Parent >= 0)
    {
      ContourRegion& around = regions[contour.Parent];
      around.Holes.push_back(static_cast<int>(c));
      around.Area -= std::abs(contour.SignedArea);
    }
  }
  return regions;
}

/// All decisions of one slab.
class SlabMapper
{
public:
  SlabMapper(const ContourSet& contours, const ContourMappingOptions& options,
    const ContourMapping& mapping, const LevelGaps& gaps, const JoinOverrides& overrides, int slab)
    : Contours(contours),
      Mapping(mapping),
      Overrides(overrides.OfSlab[slab]),
      Slab(slab)
  {
    for (const ContractDecision& decision : options.Contract)
    {
      if (decision.Slab == slab && decision.Kind != ContractDecision::Cut &&
        decision.Kind != ContractDecision::Fill)
      {
        this->Contract.push_back(decision);
      }
    }
    this->Context.Threshold = options.OverlapThreshold;
    this->Context.Gap = gaps.Thickness[slab];
    this->Context.Spacing = gaps.Usual[slab];
    this->Context.MaximumGap = options.MaximumGap;
    this->Context.TooWide = mapping.IsGap[slab] != 0;
  }

  /// known: of the slab, null where they are to be found.
  void MapOverlaps(const std::vector<RegionOverlap>* known)
  {
    this->Overlaps = known
      ? *known
      : MeasureRegionOverlaps(
          this->Contours, this->Contours.Levels[this->Slab], this->Contours.Levels[this->Slab + 1]);
    this->SortOverlaps();
    // Holes come second, because rule 1 asks whether the walls around them are joined.
    this->DecidePairs(true);
    this->DecidePairs(false);
  }

  void MapRestToPhi()
  {
    this->MapRestToPhi(this->Slab);
    this->MapRestToPhi(this->Slab + 1);
  }

  bool HasPairOf(int region) const { return this->InPairs.count(region) > 0; }
  bool IsTooWide() const { return this->Context.TooWide; }
  double Thickness() const { return this->Context.Gap; }

  void JoinByDistance(int lower, int upper, double distance)
  {
    ContourJoin join;
    join.Slab = this->Slab;
    join.LowerRegion = lower;
    join.UpperRegion = upper;
    join.Rule = ContourJoin::ByDistance;
    join.Distance = distance;
    join.Joined = true;
    join.Words = DescribeJoin(this->Contours, this->Mapping, join, this->Context);
    this->Joined[lower] = this->Joined[upper] = true;
    // Before the pairs of holes.
    const auto firstHole = std::find_if(this->Joins.begin(), this->Joins.end(),
      [this](const ContourJoin& j) { return !this->RegionAt(j.LowerRegion).Solid; });
    this->Joins.insert(firstHole, std::move(join));
  }

  std::vector<ContourJoin> Joins;
  std::vector<std::string> Report;
  std::vector<RegionOverlap> Overlaps;

private:
  using Pair = std::pair<int, int>;

  const ContourRegion& RegionAt(int r) const { return this->Mapping.Regions[r]; }

  /// Pairs that overlap or are overridden, and how much of every hole faces solid.
  void SortOverlaps()
  {
    for (const RegionOverlap& overlap : this->Overlaps)
    {
      const ContourRegion& below = this->RegionAt(overlap.LowerContour);
      const ContourRegion& above = this->RegionAt(overlap.UpperContour);
      if (overlap.Area <= Negligible * std::min(below.Area, above.Area))
      {
        continue;
      }
      if (below.Solid == above.Solid)
      {
        this->InPairs.insert(overlap.LowerContour);
        this->InPairs.insert(overlap.UpperContour);
        this->Areas[{ overlap.LowerContour, overlap.UpperContour }] = overlap.Area;
      }
      else
      {
        const int hole = below.Solid ? overlap.UpperContour : overlap.LowerContour;
        this->FacingSolid[hole] += overlap.Area;
      }
    }
    for (const auto& entry : this->Overrides)
    {
      this->AddPair(entry.first);
    }
    for (const ContractDecision& decision : this->Contract)
    {
      const Pair pair{ decision.Lower, decision.Upper };
      if (this->RegionAt(pair.first).Solid == this->RegionAt(pair.second).Solid)
      {
        this->Areas.emplace(pair, 0.0);
      }
      // What is parted is not joined by distance, either; what is joined may have other partners.
      if (decision.Kind == ContractDecision::Part)
      {
        this->AddPair(pair);
      }
    }
  }

  void AddPair(const Pair& pair)
  {
    this->Areas.emplace(pair, 0.0);
    this->InPairs.insert(pair.first);
    this->InPairs.insert(pair.second);
  }

  void DecidePairs(bool solid)
  {
    for (const auto& [pair, area] : this->Areas)
    {
      if (this->RegionAt(pair.first).Solid == solid)
      {
        this->DecidePair(pair, area);
      }
    }
  }

  void DecidePair(const Pair& pair, double area)
  {
    ContourJoin join;
    join.Slab = this->Slab;
    join.LowerRegion = pair.first;
    join.UpperRegion = pair.second;
    join.OverlapArea = area;
    join.LowerRatio = RatioOf(area, this->RegionAt(pair.first));
    join.UpperRatio = RatioOf(area, this->RegionAt(pair.second));
    this->Decide(join);
    join.Words = DescribeJoin(this->Contours, this->Mapping, join, this->Context);
    if (join.Rule == ContourJoin::InternalWall && this->Overrides.count(pair) > 0)
    {
      this->Report.push_back("The forced join of contours " + std::to_string(pair.first) + " and " +
        std::to_string(pair.second) +
        " was left aside: they are holes, and the walls around them are not joined; force that "
        "join, too.");
    }
    if (join.Joined)
    {
      this->Joined[pair.first] = this->Joined[pair.second] = true;
      this->JoinedPairs[pair] = true;
    }
    this->Joins.push_back(std::move(join));
  }

  /// Where the areas are equal but for rounding, a share is 1 and not a bit more.
  static double RatioOf(double area, const ContourRegion& region)
  {
    return region.Area > 0 ? std::min(1.0, area / region.Area) : 0;
  }

  void Decide(ContourJoin& join) const
  {
    const auto wanted = this->Overrides.find({ join.LowerRegion, join.UpperRegion });
    if (wanted != this->Overrides.end())
    {
      join.Rule = wanted->second ? ContourJoin::Forced : ContourJoin::Forbidden;
      join.Joined = wanted->second;
    }
    else if (this->Context.TooWide)
    {
      join.Rule = ContourJoin::GapTooWide;
    }
    else
    {
      join.Joined = std::max(join.LowerRatio, join.UpperRatio) > this->Context.Threshold;
      this->FollowContract(join);
    }
    if (join.Joined && join.Rule != ContourJoin::ByContract && !this->AreWallsAroundJoined(join))
    {
      join.Joined = false;
      join.Rule = ContourJoin::InternalWall;
      join.InternalWallRule = 1;
    }
  }

  void FollowContract(ContourJoin& join) const
  {
    for (const ContractDecision& decision : this->Contract)
    {
      if (decision.Lower != join.LowerRegion || decision.Upper != join.UpperRegion)
      {
        continue;
      }
      join.Rule = ContourJoin::ByContract;
      join.Joined = decision.Kind != ContractDecision::Part;
    }
  }

  /// The contour at the other end of a tunnel from a hole to what is no hole, or -1.
  int TunnelOf(int hole) const
  {
    for (const ContractDecision& decision : this->Contract)
    {
      if (decision.Kind == ContractDecision::Tunnel &&
        (decision.Lower == hole || decision.Upper == hole))
      {
        return decision.Lower == hole ? decision.Upper : decision.Lower;
      }
    }
    return -1;
  }

  /// Rule 1 of 3.3.1; a solid region asks for nothing.
  bool AreWallsAroundJoined(const ContourJoin& join) const
  {
    if (this->RegionAt(join.LowerRegion).Solid)
    {
      return true;
    }
    const Pair around{ this->Contours.Contours[join.LowerRegion].Parent,
      this->Contours.Contours[join.UpperRegion].Parent };
    return this->JoinedPairs.count(around) > 0;
  }

  void MapRestToPhi(int level)
  {
    for (int region : this->Contours.Levels[level].Contours)
    {
      if (this->Joined.count(region) > 0)
      {
        continue;
      }
      ContourJoin join;
      join.Slab = this->Slab;
      (level == this->Slab ? join.LowerRegion : join.UpperRegion) = region;
      join.Rule = ContourJoin::NoPartner;
      JoinContext context = this->Context;
      if (!this->RegionAt(region).Solid && !context.TooWide)
      {
        this->ApplyRulesTwoAndThree(region, join, context);
        join.TunnelTo = this->TunnelOf(region);
        if (join.TunnelTo >= 0)
        {
          join.Rule = ContourJoin::ByContract;
        }
      }
      join.Words = DescribeJoin(this->Contours, this->Mapping, join, context);
      this->Joins.push_back(std::move(join));
    }
  }

  /**
   * Rules 2 and 3 of 3.3.1, for the hole itself (without islands in it) against all solid of the
   * other level: its outer walls cannot each cover the hole, and what is inside their own holes
   * covers nothing.
   */
  void ApplyRulesTwoAndThree(int hole, ContourJoin& join, JoinContext& context) const
  {
    const auto facing = this->FacingSolid.find(hole);
    const double area = facing == this->FacingSolid.end() ? 0.0 : facing->second;
    context.FacingSolid = RatioOf(area, this->RegionAt(hole));
    // With a threshold of a half and more both rules could apply; facing solid is the stronger.
    if (context.FacingSolid >= 1 - context.Threshold)
    {
      join.InternalWallRule = 2;
    }
    else if (context.FacingSolid <= context.Threshold)
    {
      join.InternalWallRule = 3;
    }
    join.Rule = join.InternalWallRule > 0 ? ContourJoin::InternalWall : ContourJoin::NoPartner;
  }

  const ContourSet& Contours;
  const ContourMapping& Mapping;
  const JoinOverrides::Pairs& Overrides;
  std::vector<ContractDecision> Contract; ///< of this slab
  int Slab;
  JoinContext Context;
  std::map<Pair, double> Areas;
  std::map<int, double> FacingSolid; ///< of holes
  std::set<int> InPairs;             ///< regions that overlap one of their kind or are overridden
  std::map<int, bool> Joined;
  std::map<Pair, bool> JoinedPairs;
};

/// Solid regions that overlap none above or below, each to the nearest that is near enough.
void JoinLonelyRegions(
  const ContourSet& contours, const ContourMapping& mapping, std::vector<SlabMapper>& mappers)
{
  struct Join
  {
    int Slab, Lower, Upper;
    double Distance;
  };
  std::vector<Join> joins; // all are found before any is made, so that their order does not matter
  for (const ContourRegion& region : mapping.Regions)
  {
    const bool hasBelow = region.Level > 0;
    const bool hasAbove = region.Level < static_cast<int>(mappers.size());
    if (!region.Solid || (hasBelow && mappers[region.Level - 1].HasPairOf(region.Wall)) ||
      (hasAbove && mappers[region.Level].HasPairOf(region.Wall)))
    {
      continue;
    }
    std::optional<Join> best;
    for (const bool above : { false, true })
    {
      if (!(above ? hasAbove : hasBelow))
      {
        continue;
      }
      const int slab = region.Level - (above ? 0 : 1);
      const Level& level = contours.Levels[above ? slab + 1 : slab];
      const auto nearest = mappers[slab].IsTooWide()
        ? std::nullopt
        : FindNearestRegion(
            contours, region, mapping.Regions, level, TouchingShare * mappers[slab].Thickness());
      // Relative to the slab: what counts is how steep the surface is.
      if (nearest &&
        (!best ||
          nearest->Distance * mappers[best->Slab].Thickness() <
            best->Distance * mappers[slab].Thickness()))
      {
        best = above ? Join{ slab, region.Wall, nearest->Wall, nearest->Distance }
                     : Join{ slab, nearest->Wall, region.Wall, nearest->Distance };
      }
    }
    if (best &&
      std::none_of(joins.begin(), joins.end(),
        [&](const Join& j) { return j.Lower == best->Lower && j.Upper == best->Upper; }))
    {
      joins.push_back(*best);
    }
  }
  for (const Join& join : joins)
  {
    mappers[join.Slab].JoinByDistance(join.Lower, join.Upper, join.Distance);
  }
}
}

ContourMapping BuildContourMapping(const ContourSet& contours, const ContourMappingOptions& options,
  Monitor& monitor, const KnownOverlaps& known)
{
  Validate(contours, options);
  ContourMapping mapping;
  mapping.Regions = MakeRegions(contours);
  mapping.RegionInside.resize(contours.Contours.size());
  std::iota(mapping.RegionInside.begin(), mapping.RegionInside.end(), 0);
  JoinOverrides overrides = ResolveOverrides(contours, options);
  mapping.Report = std::move(overrides.Report);

  const LevelGaps gaps = FindLevelGaps(contours, options.MaximumGap);
  mapping.IsGap = gaps.IsGap;
  std::vector<SlabMapper> mappers;
  for (std::size_t slab = 0; slab < overrides.OfSlab.size(); ++slab)
  {
    mappers.emplace_back(contours, options, mapping, gaps, overrides, static_cast<int>(slab));
  }
  ParallelFor(static_cast<int>(mappers.size()), options.Threads,
    [&](int slab)
    { mappers[slab].MapOverlaps(known.empty() || !known[slab] ? nullptr : &*known[slab]); },
    monitor, { 0.0, 0.9, "choosing what is joined" });
  JoinLonelyRegions(contours, mapping, mappers);
  for (SlabMapper& mapper : mappers)
  {
    mapper.MapRestToPhi();
  }
  for (SlabMapper& mapper : mappers)
  {
    std::move(mapper.Joins.begin(), mapper.Joins.end(), std::back_inserter(mapping.Joins));
    std::move(mapper.Report.begin(), mapper.Report.end(), std::back_inserter(mapping.Report));
    mapping.Overlaps.push_back(std::move(mapper.Overlaps));
  }
  monitor.Update(0.95, "grouping contours");
  mapping.Groups = FilterRedundantGroups(
    FilterInternalWalls(FormMappingGroups(mapping, contours), mapping), contours);
  monitor.Update(1, "grouping contours");
  return mapping;
}
}
