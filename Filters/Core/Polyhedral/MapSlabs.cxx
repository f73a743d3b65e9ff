// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/MapSlabs.h"

#include "Base/Text.h"
#include "Contours/LevelGaps.h"
#include "Polyhedral/TopologyContract.h"

namespace recon
{
namespace
{
std::string GapLine(
  const ContourSet& contours, const LevelGaps& gaps, std::size_t i, double maximumGap)
{
  return "The levels at offsets " + Text(contours.Levels[i].Offset) + " and " +
    Text(contours.Levels[i + 1].Offset) + " are " + Text(gaps.Thickness[i] / gaps.Usual[i]) +
    " times as far apart as those beside them and are not joined; MaximumGap is " +
    Text(maximumGap) + ", and 0 joins all.";
}

void UseJoin(const ContourMapping& mapping, const ContourJoin& join, std::vector<SlabState>& slabs)
{
  if (join.LowerRegion < 0 || join.UpperRegion < 0)
  {
    return;
  }
  const auto& lower = mapping.Regions[join.LowerRegion];
  const auto& upper = mapping.Regions[join.UpperRegion];
  SlabJoins& joins = slabs[join.Slab].Joins;
  const bool isParted =
    join.Rule == ContourJoin::Forbidden || (join.Rule == ContourJoin::ByContract && !join.Joined);
  const bool exception = joins.AllByDefault ? isParted : join.Joined;
  if (lower.Solid && upper.Solid && exception)
  {
    joins.Exceptions.insert({ lower.Wall, upper.Wall });
  }
}

void UseDecision(const ContractDecision& decision, SlabJoins& joins)
{
  switch (decision.Kind)
  {
    case ContractDecision::Join:
      joins.Spanned.insert({ decision.Lower, decision.Upper });
      break;
    case ContractDecision::Tunnel:
      joins.Tunnels.insert({ decision.Lower, decision.Upper });
      break;
    case ContractDecision::Part: // what is joined is told by the mapping
    case ContractDecision::Cut:  // SectionCuts.h does it
    case ContractDecision::Fill:
      break;
  }
}
}

ContourMappingOptions MappingOptionsOf(const PolyhedralOptions& options)
{
  ContourMappingOptions mapping;
  mapping.OverlapThreshold = options.OverlapThreshold;
  mapping.ForcedJoins = options.ForcedJoins;
  mapping.ForbiddenJoins = options.ForbiddenJoins;
  mapping.Contract = options.Contract;
  mapping.MaximumGap = options.MaximumGap;
  mapping.Threads = options.Threads;
  return mapping;
}

ContourMapping MapSlabs(const ContourSet& contours, const PolyhedralOptions& options,
  std::vector<SlabState>& slabs, std::vector<std::string>& report, Monitor& monitor,
  const KnownOverlaps& known)
{
  const bool overlap = options.Mapping == PolyhedralOptions::Overlap;
  const LevelGaps gaps = FindLevelGaps(contours, options.MaximumGap);
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    slabs[i].Joins.IsGap = gaps.IsGap[i] != 0;
    slabs[i].Joins.AllByDefault = !overlap && gaps.IsGap[i] == 0;
    if (gaps.IsGap[i] != 0)
    {
      report.push_back(GapLine(contours, gaps, i, options.MaximumGap));
    }
  }
  for (const ContractDecision& decision : options.Contract)
  {
    UseDecision(decision, slabs[decision.Slab].Joins);
  }
  if (!overlap && options.ForbiddenJoins.empty() && options.ForcedJoins.empty() &&
    !AsksForTopology(options))
  {
    return {};
  }
  ContourMapping mapping = BuildContourMapping(contours, MappingOptionsOf(options), monitor, known);
  report.insert(report.end(), mapping.Report.begin(), mapping.Report.end());
  for (const ContourJoin& join : mapping.Joins)
  {
    UseJoin(mapping, join, slabs);
  }
  return mapping;
}
}
