// SPDX-License-Identifier: GPL-3.0-or-later
#include "JoinTable.h"

#include "Base/Text.h"
#include "FieldArrays.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
namespace
{
/// A whole number, or none for an empty cell.
std::optional<int> IntOf(vtkTable* table, vtkIdType row, const char* column)
{
  const vtkVariant value = table->GetValueByName(row, column);
  if (!value.IsValid() || value.ToString().find_first_not_of(" \t") == std::string::npos)
  {
    return {};
  }
  bool valid = false;
  const double number = value.ToDouble(&valid);
  if (!valid || std::floor(number) != number || std::abs(number) > std::numeric_limits<int>::max())
  {
    throw Error("Row " + std::to_string(row) + " of the table of overrides has '" +
      std::string(value.ToString()) + "' in column " + column + ", which is no whole number.");
  }
  return static_cast<int>(number);
}

std::string ContoursOf(const ContourMapping& mapping, int region)
{
  if (region < 0)
  {
    return {};
  }
  const ContourRegion& r = mapping.Regions[static_cast<std::size_t>(region)];
  std::string text = std::to_string(r.Wall);
  for (int hole : r.Holes)
  {
    text += " " + std::to_string(hole);
  }
  return text;
}

std::string RuleOf(const ContourJoin& join)
{
  switch (join.Rule)
  {
    case ContourJoin::ByOverlap:
      return "Overlap";
    case ContourJoin::Forced:
      return "Forced";
    case ContourJoin::Forbidden:
      return "Forbidden";
    case ContourJoin::GapTooWide:
      return "Gap too wide";
    case ContourJoin::ByDistance:
      return "Distance";
    case ContourJoin::NoPartner:
      return "No partner";
    case ContourJoin::InternalWall:
      return "Internal wall " + std::to_string(join.InternalWallRule);
  }
  return {};
}

/// Which contour of the set each contour of the input has become.
std::map<int, int> ContoursByInputId(vtkDataArray* ids, const ContourSet& contours)
{
  std::map<int, int> contourOf;
  for (std::size_t c = 0; c < contours.Contours.size(); ++c)
  {
    const int source = contours.Contours[c].Source;
    if (source >= 0 && source < ids->GetNumberOfTuples())
    {
      contourOf.emplace(static_cast<int>(ids->GetTuple1(source)), static_cast<int>(c));
    }
  }
  return contourOf;
}

std::set<std::pair<int, int>> NamedPairs(const ContourMappingOptions& options)
{
  std::set<std::pair<int, int>> pairs;
  for (const auto* list : { &options.ForcedJoins, &options.ForbiddenJoins })
  {
    for (const std::pair<int, int>& pair : *list)
    {
      pairs.insert(std::minmax(pair.first, pair.second));
    }
  }
  return pairs;
}
}

void ReadJoinOverrides(vtkTable* table, ContourMappingOptions& options)
{
  const char* decision = table->GetColumnByName("Join") ? "Join" : "Joined";
  for (const char* name : { "LowerContour", "UpperContour", decision })
  {
    if (!table->GetColumnByName(name))
    {
      throw Error(std::string("The table of overrides has no column ") +
        (name == decision ? "Join or Joined" : name) +
        ": give LowerContour, UpperContour and Join (1 force, 0 forbid).");
    }
  }
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::optional<int> lower = IntOf(table, row, "LowerContour");
    const std::optional<int> upper = IntOf(table, row, "UpperContour");
    const std::optional<int> join = IntOf(table, row, decision);
    if (!lower || !upper || !join || *lower < 0 || *upper < 0)
    {
      continue;
    }
    if (*join != 0 && *join != 1)
    {
      throw Error("Row " + std::to_string(row) + " of the table of overrides has " +
        std::to_string(*join) + " in column " + decision + ": give 1 to force and 0 to forbid.");
    }
    (*join == 1 ? options.ForcedJoins : options.ForbiddenJoins).emplace_back(*lower, *upper);
  }
}

void WriteJoins(const ContourMapping& mapping, vtkTable* table)
{
  const auto add = [&](const char* name, const auto& valueOf)
  {
    std::vector<decltype(valueOf(mapping.Joins.front()))> values;
    for (const ContourJoin& join : mapping.Joins)
    {
      values.push_back(valueOf(join));
    }
    AddArray(table->GetRowData(), name, values);
  };
  const auto isSolid = [&](const ContourJoin& join)
  {
    const int region = std::max(join.LowerRegion, join.UpperRegion);
    return mapping.Regions[static_cast<std::size_t>(region)].Solid ? 1 : 0;
  };
  add("Slab", [](const ContourJoin& join) { return join.Slab; });
  // Region i is the one inside contour i.
  add("LowerContour", [](const ContourJoin& join) { return join.LowerRegion; });
  add("UpperContour", [](const ContourJoin& join) { return join.UpperRegion; });
  add("LowerContours",
    [&](const ContourJoin& join) { return ContoursOf(mapping, join.LowerRegion); });
  add("UpperContours",
    [&](const ContourJoin& join) { return ContoursOf(mapping, join.UpperRegion); });
  add("OverlapArea", [](const ContourJoin& join) { return join.OverlapArea; });
  add("LowerRatio", [](const ContourJoin& join) { return join.LowerRatio; });
  add("UpperRatio", [](const ContourJoin& join) { return join.UpperRatio; });
  add("Solid", isSolid);
  add("Rule", [](const ContourJoin& join) { return RuleOf(join); });
  add("Joined", [](const ContourJoin& join) { return join.Joined ? 1 : 0; });
  add("Words", [](const ContourJoin& join) { return join.Words; });
  // A spreadsheet shows columns by name: the sentence under a name that comes first.
  add("Decision", [](const ContourJoin& join) { return join.Words; });
}

void WriteMapping(const ContourMapping& mapping, vtkDataObject* output)
{
  std::vector<int> lower;
  std::vector<int> upper;
  std::vector<int> joined;
  for (const ContourJoin& join : mapping.Joins)
  {
    if (join.LowerRegion >= 0 && join.UpperRegion >= 0)
    {
      lower.push_back(join.LowerRegion); // region i is the one inside contour i
      upper.push_back(join.UpperRegion);
      joined.push_back(join.Joined ? 1 : 0);
    }
  }
  AddArray(output->GetFieldData(), "JoinLower", lower);
  AddArray(output->GetFieldData(), "JoinUpper", upper);
  AddArray(output->GetFieldData(), "JoinJoined", joined);
}

std::string ReadMapping(
  vtkPolyData* input, const ContourSet& contours, ContourMappingOptions& options)
{
  vtkFieldData* data = input->GetFieldData();
  vtkDataArray* lower = data->GetArray("JoinLower");
  vtkDataArray* upper = data->GetArray("JoinUpper");
  vtkDataArray* joined = data->GetArray("JoinJoined");
  vtkDataArray* ids = input->GetCellData()->GetArray("ContourId");
  if (!lower || !upper || !joined)
  {
    return {};
  }
  const vtkIdType count = lower->GetNumberOfTuples();
  if (!ids || upper->GetNumberOfTuples() != count || joined->GetNumberOfTuples() != count)
  {
    return "The mapping that came with the contours is not followed: their ContourId is missing.";
  }
  const std::map<int, int> contourOf = ContoursByInputId(ids, contours);
  const std::set<std::pair<int, int>> own = NamedPairs(options);
  int followed = 0;
  int forbidden = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto a = contourOf.find(static_cast<int>(lower->GetTuple1(i)));
    const auto b = contourOf.find(static_cast<int>(upper->GetTuple1(i)));
    if (a == contourOf.end() || b == contourOf.end() ||
      own.count(std::minmax(a->second, b->second)) > 0)
    {
      continue;
    }
    const bool isJoined = joined->GetTuple1(i) != 0;
    (isJoined ? options.ForcedJoins : options.ForbiddenJoins).emplace_back(a->second, b->second);
    (isJoined ? followed : forbidden)++;
  }
  return "The mapping that came with the contours is followed: " + Counted(followed, "join") +
    ", and " + Counted(forbidden, "pair") + " that " + (forbidden == 1 ? "is" : "are") +
    " not joined.";
}
}
