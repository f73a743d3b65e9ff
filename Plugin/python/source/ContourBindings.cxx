// SPDX-License-Identifier: GPL-3.0-or-later
// Contour Hierarchy and Contour Mapping for Python.
#include "Base/SubMonitor.h"
#include "Contours/JoinExplanation.h"
#include "GivenData.h"
#include "Polyhedral/ContractMapping.h"
#include "PythonMonitor.h"

#include <algorithm>

namespace recon
{
namespace
{
template <typename Getter>
nb::list TextsOf(const ContourMapping& mapping, const Getter& textOf)
{
  std::vector<std::string> texts;
  for (const ContourJoin& join : mapping.Joins)
  {
    texts.push_back(textOf(join));
  }
  return ToList(texts);
}

/// The table of joins, column by column; region i is the one inside contour i.
nb::dict JoinsOf(const ContourMapping& mapping)
{
  const auto& joins = mapping.Joins;
  const auto isSolid = [&](const ContourJoin& join)
  { return mapping.Regions[std::max(join.LowerRegion, join.UpperRegion)].Solid ? 1 : 0; };
  nb::dict table;
  table["Slab"] = ArrayOf(joins, [](const ContourJoin& j) { return j.Slab; });
  table["LowerContour"] = ArrayOf(joins, [](const ContourJoin& j) { return j.LowerRegion; });
  table["UpperContour"] = ArrayOf(joins, [](const ContourJoin& j) { return j.UpperRegion; });
  table["LowerContours"] =
    TextsOf(mapping, [&](const ContourJoin& j) { return RegionContours(mapping, j.LowerRegion); });
  table["UpperContours"] =
    TextsOf(mapping, [&](const ContourJoin& j) { return RegionContours(mapping, j.UpperRegion); });
  table["OverlapArea"] = ArrayOf(joins, [](const ContourJoin& j) { return j.OverlapArea; });
  table["LowerRatio"] = ArrayOf(joins, [](const ContourJoin& j) { return j.LowerRatio; });
  table["UpperRatio"] = ArrayOf(joins, [](const ContourJoin& j) { return j.UpperRatio; });
  table["Solid"] = ArrayOf(joins, isSolid);
  table["Rule"] = TextsOf(mapping, RuleName);
  table["Joined"] = ArrayOf(joins, [](const ContourJoin& j) { return j.Joined ? 1 : 0; });
  table["Words"] = TextsOf(mapping, [](const ContourJoin& j) { return j.Words; });
  return table;
}

/// Of every contour its group in the slab below it, or above; -1 where there is none.
nb::object GroupsOf(const ContourMapping& mapping, std::size_t contours, bool below)
{
  std::vector<int> groups(contours, -1);
  int number = 0;
  for (const MappingGroup& group : mapping.Groups)
  {
    for (const int c : below ? group.UpperContours : group.LowerContours)
    {
      groups[c] = number;
    }
    ++number;
  }
  return ToNumpy(std::move(groups));
}

/// The decisions about pairs, so that they are not forgotten by what comes next.
void AddDecisions(const ContourMapping& mapping, nb::dict field)
{
  std::vector<ContourJoin> pairs;
  std::copy_if(mapping.Joins.begin(), mapping.Joins.end(), std::back_inserter(pairs),
    [](const ContourJoin& j) { return j.LowerRegion >= 0 && j.UpperRegion >= 0; });
  field["JoinLower"] = ArrayOf(pairs, [](const ContourJoin& j) { return j.LowerRegion; });
  field["JoinUpper"] = ArrayOf(pairs, [](const ContourJoin& j) { return j.UpperRegion; });
  field["JoinJoined"] = ArrayOf(pairs, [](const ContourJoin& j) { return j.Joined ? 1 : 0; });
}

nb::dict Hierarchy(const nb::dict& loops, const nb::dict& properties, nb::handle progress)
{
  const LoopSoup soup = SoupOf(loops);
  const ContourSetOptions options =
    ContourSetOptionsOf(properties, ValueOf<bool>(properties, "ParallelPlanesOnly"));
  const ContourSet contours = RunWithoutLock(
    progress, [&](Monitor& monitor) { return BuildContourSet(soup, options, monitor); });
  nb::dict result = FromContours(contours);
  result["report"] = ToList(contours.Report);
  result["warning"] = contours.Warning;
  return result;
}

struct MappedContours
{
  ContourSet Contours;
  ContractMapping Mapped;
};

MappedContours Map(const LoopSoup& soup, const ContourSetOptions& reading, LevelAlignmentMode align,
  const ContourMappingOptions& options, const TopologyAsked& asked, Monitor& monitor)
{
  SubMonitor cleaning(monitor, 0.0, 0.3);
  SubMonitor mapping(monitor, 0.3, 1.0);
  MappedContours mapped;
  mapped.Contours = BuildContourSet(soup, reading, cleaning);
  mapped.Mapped = MapByContract(mapped.Contours, options, align, asked, mapping);
  return mapped;
}

nb::dict Mapping(const nb::dict& loops, const nb::dict& properties, nb::handle progress)
{
  const LoopSoup soup = SoupOf(loops);
  const ContourSetOptions reading = ContourSetOptionsOf(properties, true);
  const auto align = ChoiceOf<LevelAlignmentMode>(properties, "AlignLevels");
  ContourMappingOptions options;
  options.OverlapThreshold = ValueOf<double>(properties, "OverlapThreshold");
  options.MaximumGap = ValueOf<double>(properties, "MaximumGap");
  options.ForcedJoins = PairsOf(properties, "ForcedJoins");
  options.ForbiddenJoins = PairsOf(properties, "ForbiddenJoins");
  options.Threads = ValueOf<int>(properties, "Threads");
  const TopologyAsked asked{ ValueOf<int>(properties, "ExpectedPieces"),
    ValueOf<int>(properties, "ExpectedHandles") };
  const MappedContours mapped = RunWithoutLock(
    progress, [&](Monitor& monitor) { return Map(soup, reading, align, options, asked, monitor); });

  const std::size_t count = mapped.Contours.Contours.size();
  nb::dict result = FromContours(mapped.Contours);
  result["cell_data"]["MappingGroupBelow"] = GroupsOf(mapped.Mapped.Mapping, count, true);
  result["cell_data"]["MappingGroupAbove"] = GroupsOf(mapped.Mapped.Mapping, count, false);
  AddDecisions(mapped.Mapped.Mapping, nb::cast<nb::dict>(result["field_data"]));
  std::vector<std::string> report = mapped.Contours.Report;
  report.insert(
    report.end(), mapped.Mapped.Mapping.Report.begin(), mapped.Mapped.Mapping.Report.end());
  result["report"] = ToList(report);
  result["warning"] = mapped.Contours.Warning;
  result["joins"] = JoinsOf(mapped.Mapped.WithCuts);
  return result;
}
}

void BindContours(nb::module_& module)
{
  module.def("contour_hierarchy", &Hierarchy, nb::arg("loops"), nb::arg("properties"),
    nb::arg("progress").none());
  module.def("contour_mapping", &Mapping, nb::arg("loops"), nb::arg("properties"),
    nb::arg("progress").none());
}
}
