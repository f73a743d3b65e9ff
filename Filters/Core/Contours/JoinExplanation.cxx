// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/JoinExplanation.h"

#include "Contours/ContourNotes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace recon
{
namespace
{
/// "83%"; what is small but not nothing does not read as 0, nor what is nearly all as 100.
std::string Percent(double share)
{
  const double percent = 100 * share;
  if (percent > 0 && percent < 1)
  {
    return "less than 1%";
  }
  const double rounded = std::round(percent);
  return std::to_string(static_cast<int>(rounded >= 100 && percent < 100 - 1e-9 ? 99.0 : rounded)) +
    "%";
}

class Describer
{
public:
  Describer(const ContourSet& contours, const ContourMapping& mapping, const ContourJoin& join,
    const JoinContext& context)
    : Contours(contours),
      Mapping(mapping),
      Join(join),
      Context(context)
  {
  }

  std::string Describe() const
  {
    return this->Join.LowerRegion >= 0 && this->Join.UpperRegion >= 0 ? this->DescribePair()
                                                                      : this->DescribeEnd();
  }

private:
  const ContourRegion& RegionAt(int region) const { return this->Mapping.Regions[region]; }

  std::string NameOf(int region) const
  {
    const ContourRegion& r = this->RegionAt(region);
    return (r.Solid ? "contour " : "hole ") + std::to_string(r.Wall);
  }

  std::string PlaceOfLevel(int level) const { return PlaceOf(this->Contours.Levels[level]); }

  std::string NameAndPlace(int region) const
  {
    return this->NameOf(region) + " (" + this->PlaceOfLevel(this->RegionAt(region).Level) + ")";
  }

  static std::string Capital(std::string text)
  {
    text[0] = text[0] == 'c' ? 'C' : 'H';
    return text;
  }

  double Shared() const { return std::max(this->Join.LowerRatio, this->Join.UpperRatio); }

  std::string SharedWords() const
  {
    return this->Join.OverlapArea > 0
      ? "they share " + Percent(this->Shared()) + " of the smaller one's area"
      : "they do not overlap";
  }

  std::string DescribePair() const
  {
    return Capital(this->NameAndPlace(this->Join.LowerRegion)) +
      (this->Join.Joined ? " is joined to " : " is not joined to ") +
      this->NameAndPlace(this->Join.UpperRegion) + this->ReasonOfPair();
  }

  std::string ReasonOfPair() const
  {
    switch (this->Join.Rule)
    {
      case ContourJoin::Forced:
        return " because the join is forced; " + this->SharedWords() + ".";
      case ContourJoin::Forbidden:
        return " because the join is forbidden; " + this->SharedWords() + ".";
      case ContourJoin::GapTooWide:
        return ": the levels are " + Text(this->Context.Gap) + " apart, more than " +
          Text(this->Context.MaximumGap) + " times the " + Text(this->Context.Spacing) +
          " between the levels beside them.";
      case ContourJoin::InternalWall:
        return this->ReasonOfRuleOne();
      case ContourJoin::ByDistance:
        return ": one of them overlaps nothing above or below, and they are " +
          Text(this->Join.Distance) + " apart, next to nothing beside the " +
          Text(this->Context.Gap) + " between their levels.";
      case ContourJoin::ByContract:
        return " because the expected pieces and handles ask for it; " + this->SharedWords() + ".";
      case ContourJoin::ByOverlap:
      case ContourJoin::NoPartner:
        break;
    }
    if (this->Join.Joined)
    {
      return ": " + this->SharedWords() + ".";
    }
    return ": " + this->SharedWords() + ", and more than " + Percent(this->Context.Threshold) +
      " is asked for.";
  }

  std::string ReasonOfRuleOne() const
  {
    const auto wallAround = [this](int region)
    {
      const int wall = this->RegionAt(region).Wall;
      return std::to_string(this->Contours.Contours[wall].Parent);
    };
    return ", although " + this->SharedWords() + ": the walls around them, contours " +
      wallAround(this->Join.LowerRegion) + " and " + wallAround(this->Join.UpperRegion) +
      ", are not joined.";
  }

  std::string DescribeEnd() const
  {
    const bool up = this->Join.LowerRegion >= 0;
    const int region = up ? this->Join.LowerRegion : this->Join.UpperRegion;
    const int other = up ? this->Join.Slab + 1 : this->Join.Slab;
    const std::string subject = Capital(this->NameAndPlace(region));
    const std::string there = this->PlaceOfLevel(other);
    if (this->Context.TooWide)
    {
      return subject + " ends towards " + there + ": the levels are too far apart to be joined.";
    }
    if (this->RegionAt(region).Solid)
    {
      return subject + " ends towards " + there + ": nothing there is joined to it.";
    }
    return subject + this->DescribeEndOfHole(there);
  }

  std::string DescribeEndOfHole(const std::string& there) const
  {
    if (this->Join.TunnelTo >= 0)
    {
      return " is opened to contour " + std::to_string(this->Join.TunnelTo) + " (" + there +
        ") because the expected pieces and handles ask for it.";
    }
    const std::string share = Percent(this->Context.FacingSolid);
    switch (this->Join.InternalWallRule)
    {
      case 2:
        return " is closed towards " + there + ": " + share + " of it faces solid there.";
      case 3:
        return " stays open towards " + there + ": " +
          (this->Context.FacingSolid > 0 ? "only " + share : std::string("nothing")) +
          " of it faces solid there.";
      default:
        return " ends towards " + there + ": it is closed where it faces solid there, which is " +
          share + " of it, and open elsewhere.";
    }
  }

  const ContourSet& Contours;
  const ContourMapping& Mapping;
  const ContourJoin& Join;
  const JoinContext& Context;
};
}

std::string PlaceOf(const Level& level)
{
  static const char* const names[3] = { "x", "y", "z" };
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (level.Frame.Normal[k] == 1)
    {
      return names[k] + (" = " + Text(level.Offset));
    }
  }
  return "offset = " + Text(level.Offset);
}

std::string DescribeJoin(const ContourSet& contours, const ContourMapping& mapping,
  const ContourJoin& join, const JoinContext& context)
{
  return Describer(contours, mapping, join, context).Describe();
}

std::string RuleName(const ContourJoin& join)
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
    case ContourJoin::ByContract:
      return "Contract";
    case ContourJoin::NoPartner:
      return "No partner";
    case ContourJoin::InternalWall:
      return "Internal wall " + std::to_string(join.InternalWallRule);
  }
  return {};
}

std::string RegionContours(const ContourMapping& mapping, int region)
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
}
