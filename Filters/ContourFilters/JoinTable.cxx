// SPDX-License-Identifier: GPL-3.0-or-later
#include "JoinTable.h"

#include "Contours/CarriedMapping.h"
#include "Contours/JoinExplanation.h"
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
#include <optional>
#include <string>
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

/// Whole numbers of any array; none where there is no array.
std::vector<int> NumbersOf(vtkDataArray* array)
{
  std::vector<int> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    numbers.push_back(static_cast<int>(array->GetTuple1(i)));
  }
  return numbers;
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
    [&](const ContourJoin& join) { return RegionContours(mapping, join.LowerRegion); });
  add("UpperContours",
    [&](const ContourJoin& join) { return RegionContours(mapping, join.UpperRegion); });
  add("OverlapArea", [](const ContourJoin& join) { return join.OverlapArea; });
  add("LowerRatio", [](const ContourJoin& join) { return join.LowerRatio; });
  add("UpperRatio", [](const ContourJoin& join) { return join.UpperRatio; });
  add("Solid", isSolid);
  add("Rule", [](const ContourJoin& join) { return RuleName(join); });
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

std::optional<CarriedMapping> CarriedMappingOf(vtkPolyData* input)
{
  vtkFieldData* data = input->GetFieldData();
  vtkDataArray* lower = data->GetArray("JoinLower");
  vtkDataArray* upper = data->GetArray("JoinUpper");
  vtkDataArray* joined = data->GetArray("JoinJoined");
  if (!lower || !upper || !joined)
  {
    return std::nullopt;
  }
  return CarriedMapping{ NumbersOf(lower), NumbersOf(upper), NumbersOf(joined),
    NumbersOf(input->GetCellData()->GetArray("ContourId")) };
}

std::string ReadMapping(
  vtkPolyData* input, const ContourSet& contours, ContourMappingOptions& options)
{
  const std::optional<CarriedMapping> carried = CarriedMappingOf(input);
  return carried ? FollowMapping(*carried, contours, options) : std::string();
}
}
