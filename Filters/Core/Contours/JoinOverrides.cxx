// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/JoinOverrides.h"

#include <cstddef>

namespace recon
{
namespace
{
class Resolver
{
public:
  explicit Resolver(const ContourSet& contours) : Contours(contours)
  {
    const std::size_t levels = contours.Levels.size();
    this->Result.OfSlab.resize(levels > 0 ? levels - 1 : 0);
  }

  void Add(std::pair<int, int> pair, bool force)
  {
    const std::string trouble = this->TroubleWith(pair);
    if (!trouble.empty())
    {
      this->Result.Report.push_back(std::string("The ") + (force ? "forced" : "forbidden") +
        " join of contours " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
        " was left aside: " + trouble);
      return;
    }
    if (this->LevelOf(pair.first) > this->LevelOf(pair.second))
    {
      std::swap(pair.first, pair.second);
    }
    auto& wanted = this->Result.OfSlab[this->LevelOf(pair.first)];
    const auto [entry, isNew] = wanted.emplace(pair, force);
    if (!isNew && entry->second != force)
    {
      entry->second = false;
      this->Result.Report.push_back("The join of contours " + std::to_string(pair.first) + " and " +
        std::to_string(pair.second) + " is both forced and forbidden: it is forbidden.");
    }
  }

  JoinOverrides Take() { return std::move(this->Result); }

private:
  int LevelOf(int contour) const { return this->Contours.Contours[contour].Level; }
  bool IsHole(int contour) const { return this->Contours.Contours[contour].Depth % 2 == 1; }

  /// Why a pair cannot be followed, or nothing.
  std::string TroubleWith(const std::pair<int, int>& pair) const
  {
    const auto count = static_cast<int>(this->Contours.Contours.size());
    for (int c : { pair.first, pair.second })
    {
      if (c < 0 || c >= count)
      {
        return "there is no contour " + std::to_string(c) + "; ContourId goes from 0 to " +
          std::to_string(count - 1) + ".";
      }
    }
    const int below = this->LevelOf(pair.first);
    const int above = this->LevelOf(pair.second);
    if (below - above != 1 && above - below != 1)
    {
      return "they are on levels " + std::to_string(below) + " and " + std::to_string(above) +
        "; only contours of adjacent levels can be joined.";
    }
    if (this->IsHole(pair.first) != this->IsHole(pair.second))
    {
      const int hole = this->IsHole(pair.first) ? pair.first : pair.second;
      return "contour " + std::to_string(hole) +
        " is the wall of a hole and the other is an outer wall; name two outer walls or two holes.";
    }
    return {};
  }

  const ContourSet& Contours;
  JoinOverrides Result;
};
}

JoinOverrides ResolveOverrides(const ContourSet& contours, const ContourMappingOptions& options)
{
  Resolver resolver(contours);
  for (const auto& pair : options.ForcedJoins)
  {
    resolver.Add(pair, true);
  }
  for (const auto& pair : options.ForbiddenJoins)
  {
    resolver.Add(pair, false);
  }
  return resolver.Take();
}
}
