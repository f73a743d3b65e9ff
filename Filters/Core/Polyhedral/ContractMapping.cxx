// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/ContractMapping.h"

#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Contours/JoinExplanation.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "Polyhedral/TopologyContract.h"

#include <string>
#include <utility>

namespace recon
{
namespace
{
PolyhedralOptions OptionsOf(
  const ContourMappingOptions& options, LevelAlignmentMode align, const TopologyAsked& asked)
{
  PolyhedralOptions surface;
  surface.Mapping = PolyhedralOptions::Overlap;
  surface.EndCaps = PolyhedralOptions::Tapered;
  surface.IsolatedContours = PolyhedralOptions::Extrude;
  surface.OverlapThreshold = options.OverlapThreshold;
  surface.ForcedJoins = options.ForcedJoins;
  surface.ForbiddenJoins = options.ForbiddenJoins;
  surface.MaximumGap = options.MaximumGap;
  surface.AlignLevels = align;
  surface.ExpectedPieces = asked.Pieces;
  surface.ExpectedHandles = asked.Handles;
  surface.Threads = options.Threads;
  return surface;
}

ContourJoin RowOf(const ContourSet& contours, const ContractDecision& decision)
{
  const auto named = [&](int contour)
  {
    return std::to_string(contour) + " (" +
      PlaceOf(contours.Levels[contours.Contours[contour].Level]) + ")";
  };
  ContourJoin row;
  row.Slab = decision.Slab;
  row.LowerRegion = decision.Lower;
  row.UpperRegion = decision.Upper;
  row.Rule = ContourJoin::ByContract;
  row.Words = "Between contours " + named(decision.Lower) + " and " + named(decision.Upper) +
    (decision.Kind == ContractDecision::Cut ? " the solid is parted" : " a hole is filled") +
    " between the two levels, at a place of area " + Text(decision.Cost) +
    ", because the expected handles ask for it.";
  return row;
}
}

ContractMapping MapByContract(const ContourSet& contours, const ContourMappingOptions& options,
  LevelAlignmentMode align, const TopologyAsked& asked, Monitor& monitor)
{
  ContourMappingOptions followed = options;
  std::vector<std::string> report;
  const PolyhedralOptions surfaceOptions = OptionsOf(options, align, asked);
  const bool asks = AsksForTopology(surfaceOptions);
  if (asks)
  {
    SubMonitor searching(monitor, 0, 0.9);
    PolyhedralSurface surface = BuildPolyhedralSurface(contours, surfaceOptions, searching);
    followed.Contract = std::move(surface.Contract);
    report.push_back(surface.Report.back());
  }
  SubMonitor mapping(monitor, asks ? 0.9 : 0, 1);
  const LevelAlignment alignment = FindLevelAlignment(contours, align, options.ForcedJoins);
  ContractMapping result;
  result.Mapping = BuildContourMapping(Aligned(contours, alignment), followed, mapping);
  std::vector<std::string>& lines = result.Mapping.Report;
  lines.insert(lines.begin(), alignment.Report.begin(), alignment.Report.end());
  lines.insert(lines.end(), report.begin(), report.end());
  result.WithCuts = result.Mapping;
  for (const ContractDecision& decision : followed.Contract)
  {
    const bool isPlace =
      decision.Kind == ContractDecision::Cut || decision.Kind == ContractDecision::Fill;
    if (isPlace && decision.Lower >= 0 && decision.Upper >= 0)
    {
      result.WithCuts.Joins.push_back(RowOf(contours, decision));
    }
  }
  return result;
}
}
