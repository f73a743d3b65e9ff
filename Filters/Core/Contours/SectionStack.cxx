// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/SectionStack.h"

#include "Base/Angles.h"
#include "Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace recon
{
namespace
{
/// Half the second derivative of a ball's section along the stack.
constexpr double HalfBendOfBall = -Pi;
}

double SectionParabola::Integral(double t) const
{
  return t * (this->Area + t * (this->Slope / 2 + t * this->HalfBend / 3));
}

double SectionParabola::PlaceOf(double area) const
{
  const double none = std::numeric_limits<double>::infinity();
  const double above = this->Area - area;
  const double square = this->Slope * this->Slope - 4 * this->HalfBend * above;
  if (square < 0)
  {
    return none;
  }
  // 2 c / (-b +- sqrt), which holds for no bend, too; the least positive has the larger divisor.
  const double divisor = std::sqrt(square) - this->Slope;
  return divisor > 0 ? 2 * above / divisor : none;
}

double BendOf(const std::array<double, 3>& areas, double near, double far)
{
  const double first = (areas[0] - areas[1]) / near;
  const double second = (areas[1] - areas[2]) / far;
  return 2 * (first - second) / (near + far);
}

SectionStack::SectionStack(
  const ContourSet& contours, const ContourMapping& mapping, const LevelGaps& gaps)
  : Contours(contours),
    Mapping(mapping),
    Gaps(gaps)
{
  const std::size_t regions = mapping.Regions.size();
  const std::size_t slabs = gaps.Thickness.size();
  this->Parts.resize(slabs);
  for (auto& parts : this->PartOf)
  {
    parts.assign(regions, -1);
  }
  std::vector<std::vector<const ContourJoin*>> joins(slabs);
  for (const ContourJoin& join : mapping.Joins)
  {
    if (join.Joined && join.LowerRegion >= 0 && join.UpperRegion >= 0 &&
      mapping.Regions[join.LowerRegion].Solid)
    {
      joins[join.Slab].push_back(&join);
    }
  }
  DisjointSets linked(2 * regions); // as of the slab above, and of that below
  for (std::size_t slab = 0; slab < slabs; ++slab)
  {
    for (const ContourJoin* join : joins[slab])
    {
      linked.Join(2 * join->LowerRegion + 1, 2 * join->UpperRegion);
    }
    std::map<int, int> partOfSet;
    for (const ContourJoin* join : joins[slab])
    {
      const int set = linked.Find(2 * join->LowerRegion + 1);
      const auto [found, isNew] = partOfSet.emplace(set, this->Parts[slab].size());
      if (isNew)
      {
        this->Parts[slab].emplace_back();
      }
      this->Take(join->LowerRegion, 0, found->second, this->Parts[slab][found->second]);
      this->Take(join->UpperRegion, 1, found->second, this->Parts[slab][found->second]);
    }
  }
}

void SectionStack::Take(int region, int side, int number, SlabPart& part)
{
  int& known = this->PartOf[side][region];
  if (known < 0)
  {
    known = number;
    std::vector<int>& regions = part.Regions[side];
    regions.insert(std::upper_bound(regions.begin(), regions.end(), region), region);
    part.Area[side] += this->Mapping.Regions[region].Area;
  }
}

const SlabPart* SectionStack::WholePartAt(const std::vector<int>& regions, int step) const
{
  const int side = step > 0 ? 0 : 1;
  const int number = this->PartOf[side][regions.front()];
  if (number < 0)
  {
    return nullptr;
  }
  const int level = this->Mapping.Regions[regions.front()].Level;
  const SlabPart& part = this->Parts[SlabAt(level, step)][number];
  return part.Regions[side] == regions ? &part : nullptr;
}

double SectionStack::ReachOf(int level, int step) const
{
  for (const int slab : { SlabAt(level, step), SlabAt(level, -step) })
  {
    if (this->IsBridged(slab))
    {
      return this->Gaps.Thickness[slab];
    }
  }
  return this->Contours.Spacing();
}

std::optional<SectionParabola> SectionStack::ParabolaAtEnd(int region, int step) const
{
  const SlabPart* behind = this->WholePartAt({ region }, -step);
  if (!behind)
  {
    return std::nullopt;
  }
  const int far = step > 0 ? 0 : 1;
  const int level = this->Mapping.Regions[region].Level;
  const double near = this->Gaps.Thickness[SlabAt(level, -step)];
  const double area = this->Mapping.Regions[region].Area;
  double halfBend = HalfBendOfBall;
  if (const SlabPart* next = this->WholePartAt(behind->Regions[far], -step))
  {
    const double beyond = this->Gaps.Thickness[SlabAt(level - step, -step)];
    halfBend = BendOf({ area, behind->Area[far], next->Area[far] }, near, beyond) / 2;
  }
  return SectionParabola{ area, (area - behind->Area[far]) / near + halfBend * near, halfBend };
}
}
