// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/CarriedMapping.h"

#include "Base/Text.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace recon
{
namespace
{
/// Which contour of the set each contour of the input has become.
std::map<int, int> ContoursByInputId(const std::vector<int>& ids, const ContourSet& contours)
{
  std::map<int, int> contourOf;
  for (std::size_t c = 0; c < contours.Contours.size(); ++c)
  {
    const int source = contours.Contours[c].Source;
    if (source >= 0 && source < static_cast<int>(ids.size()))
    {
      contourOf.emplace(ids[source], static_cast<int>(c));
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

std::string FollowMapping(
  const CarriedMapping& carried, const ContourSet& contours, ContourMappingOptions& options)
{
  const std::size_t count = carried.Lower.size();
  if (carried.ContourIds.empty() || carried.Upper.size() != count || carried.Joined.size() != count)
  {
    return "The mapping that came with the contours is not followed: their ContourId is missing.";
  }
  const std::map<int, int> contourOf = ContoursByInputId(carried.ContourIds, contours);
  const std::set<std::pair<int, int>> own = NamedPairs(options);
  int followed = 0;
  int forbidden = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto a = contourOf.find(carried.Lower[i]);
    const auto b = contourOf.find(carried.Upper[i]);
    if (a == contourOf.end() || b == contourOf.end() ||
      own.count(std::minmax(a->second, b->second)) > 0)
    {
      continue;
    }
    const bool isJoined = carried.Joined[i] != 0;
    (isJoined ? options.ForcedJoins : options.ForbiddenJoins).emplace_back(a->second, b->second);
    (isJoined ? followed : forbidden)++;
  }
  return "The mapping that came with the contours is followed: " + Counted(followed, "join") +
    ", and " + Counted(forbidden, "pair") + " that " + (forbidden == 1 ? "is" : "are") +
    " not joined.";
}
}
