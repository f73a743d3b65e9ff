// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/VolumeInterval.h"

#include "Base/SubMonitor.h"
#include "Contours/ContourSetBuilder.h"
#include "Contours/LevelGaps.h"
#include "Contours/SectionStack.h"
#include "Planar/RegionOverlaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace recon
{
namespace
{
/// Between two levels: the bounds' distance from the estimate, as a part of what the parabola
/// differs from a straight line.
constexpr double PartOfBend = 0.5;
/// Where a section has less than this part of the one on the next level, the shape is ending between them.
constexpr double EndingSection = 0.25;
/// Then its integral differs from a straight line by this part of the difference: that of a cone's
/// tip, a square, has a third of it, that of a cylinder across the slices, a root, two thirds.
constexpr double PartOfEnding = 1.0 / 6;
/// How far a region goes on that does not get smaller, as a part of the distance to the next slice.
constexpr double StraightEnd = 0.5;
class VolumeEstimator
{
public:
  VolumeEstimator(const ContourSet& contours, const ContourMapping& mapping, const LevelGaps& gaps)
    : Contours(contours),
      Mapping(mapping),
      Gaps(gaps),
      Stack(contours, mapping, gaps)
  {
  }

  VolumeInterval Estimate(Monitor& monitor)
  {
    const int slabs = static_cast<int>(this->Gaps.Thickness.size());
    for (int slab = 0; slab < slabs; ++slab)
    {
      monitor.Update(static_cast<double>(slab) / slabs, "estimating the volume");
      for (const SlabPart& part : this->Stack.PartsOf(slab))
      {
        this->AddPart(part, slab);
      }
      this->AddHoleEnds(slab);
    }
    for (int region = 0; region < static_cast<int>(this->Mapping.Regions.size()); ++region)
    {
      for (const int step : { -1, 1 })
      {
        if (this->Mapping.Regions[region].Solid && this->Stack.Ends(region, step))
        {
          this->AddEnd(region, step);
        }
      }
    }
    this->Result.Lowest = std::max(0.0, this->Result.Lowest);
    for (const auto& [offset, width] : this->Widths)
    {
      this->Result.Doubts.push_back({ offset, width });
    }
    std::stable_sort(this->Result.Doubts.begin(), this->Result.Doubts.end(),
      [](const VolumeDoubt& a, const VolumeDoubt& b) { return a.Width > b.Width; });
    return this->Result;
  }

private:
  double OffsetOf(int level) const { return this->Contours.Levels[level].Offset; }

  void Add(double estimate, double lowest, double highest, double offset)
  {
    this->Result.Estimate += estimate;
    this->Result.Lowest += lowest;
    this->Result.Highest += highest;
    this->Widths[offset] += highest - lowest;
  }

  double MiddleOf(int slab) const
  {
    return 0.5 * (this->OffsetOf(slab) + this->OffsetOf(slab + 1));
  }

  void AddPart(const SlabPart& part, int slab)
  {
    const double h = this->Gaps.Thickness[slab];
    const auto& [lower, upper] = part.Area;
    const double straight = h * (lower + upper) / 2;
    std::vector<double> bends;
    for (const int side : { 0, 1 })
    {
      const int step = side == 0 ? -1 : 1;
      if (const SlabPart* next = this->Stack.WholePartAt(part.Regions[side], step))
      {
        bends.push_back(BendOf({ part.Area[1 - side], part.Area[side], next->Area[side] }, h,
          this->Gaps.Thickness[slab + step]));
      }
    }
    // Without a third level: a frustum, as of a cone.
    double bent = straight - h * (lower + upper + std::sqrt(lower * upper)) / 3;
    double most = bent;
    if (!bends.empty())
    {
      const double share = h * h * h / 12;
      bent = share * (bends.front() + bends.back()) / 2;
      most = share * std::max(std::abs(bends.front()), std::abs(bends.back()));
    }
    const double estimate = std::max(0.0, straight - bent);
    double lowest = estimate - PartOfBend * most;
    double highest = estimate + PartOfBend * most;
    if (std::min(lower, upper) < EndingSection * std::max(lower, upper))
    {
      const double ending = PartOfEnding * h * std::abs(upper - lower);
      lowest = std::min(lowest, straight - ending);
      highest = std::max(highest, straight + ending);
    }
    this->Add(estimate, lowest, highest, this->MiddleOf(slab));
  }

  /// A hole that ends within the solid, not by opening: half of it counts as solid, and all or
  /// nothing may be.
  void AddHoleEnds(int slab)
  {
    std::map<int, double> closed; // by the wall
    for (const ContourJoin& join : this->Mapping.Joins)
    {
      const int region = std::max(join.LowerRegion, join.UpperRegion);
      if (join.Slab == slab && std::min(join.LowerRegion, join.UpperRegion) < 0 && region >= 0 &&
        !this->Mapping.Regions[region].Solid && !this->Gaps.IsGap[slab])
      {
        closed[this->Mapping.Regions[region].Wall] = 0;
      }
    }
    if (closed.empty())
    {
      return;
    }
    const auto isOuter = [&](int contour)
    { return this->Contours.Contours[contour].Depth % 2 == 0; };
    for (const RegionOverlap& overlap : MeasureRegionOverlaps(
           this->Contours, this->Contours.Levels[slab], this->Contours.Levels[slab + 1]))
    {
      for (const auto& [hole, solid] : { std::pair(overlap.LowerContour, overlap.UpperContour),
             std::pair(overlap.UpperContour, overlap.LowerContour) })
      {
        const auto found = closed.find(hole);
        if (found != closed.end() && isOuter(solid))
        {
          found->second += overlap.Area;
        }
      }
    }
    for (const auto& [wall, area] : closed)
    {
      const double half = area * this->Gaps.Thickness[slab] / 2;
      this->Add(0, -half, half, this->MiddleOf(slab));
    }
  }

  void AddEnd(int region, int step)
  {
    const int level = this->Mapping.Regions[region].Level;
    const int slab = SectionStack::SlabAt(level, step);
    const double reach = this->Stack.ReachOf(level, step);
    const double box = this->Mapping.Regions[region].Area * reach;
    double estimate = StraightEnd * box;
    double highest = box;
    if (const std::optional<SectionParabola> parabola = this->Stack.ParabolaAtEnd(region, step))
    {
      const double end = parabola->PlaceOf(0);
      estimate = parabola->Integral(
        end <= reach ? end : reach * (StraightEnd + (1 - StraightEnd) * reach / end));
      const SectionParabola widening{ parabola->Area, std::max(0.0, parabola->Slope),
        parabola->Slope > 0 ? std::max(0.0, parabola->HalfBend) : 0 };
      highest = std::max(widening.Integral(reach), estimate);
    }
    const bool isBetween = this->Stack.IsBridged(slab);
    this->Add(estimate, 0, highest,
      isBetween ? this->MiddleOf(slab) : this->OffsetOf(level) + step * reach / 2);
  }

  const ContourSet& Contours;
  const ContourMapping& Mapping;
  const LevelGaps& Gaps;
  const SectionStack Stack;
  VolumeInterval Result;
  std::map<double, double> Widths; ///< by offset
};
}

std::optional<VolumeInterval> EstimateVolume(
  const ContourSet& contours, const ContourMappingOptions& options, Monitor& monitor)
{
  if (!contours.Parallel || contours.Levels.size() < 2)
  {
    return std::nullopt;
  }
  constexpr double MappingShare = 0.8; // of the time
  SubMonitor mappingMonitor(monitor, 0, MappingShare);
  const ContourMapping mapping = BuildContourMapping(contours, options, mappingMonitor);
  const LevelGaps gaps = FindLevelGaps(contours, options.MaximumGap);
  SubMonitor estimating(monitor, MappingShare, 1);
  return VolumeEstimator(contours, mapping, gaps).Estimate(estimating);
}

std::optional<VolumeInterval> EstimateVolume(const LoopSoup& soup, const ContourSet& asRead,
  const std::optional<CarriedMapping>& carried, Monitor& monitor)
{
  const auto isParallel = [&](const Level& level)
  {
    return AreParallel(
      level.Frame.Normal, asRead.Levels.front().Frame.Normal, Parallelism::UpToDrawing);
  };
  if (!std::all_of(asRead.Levels.begin(), asRead.Levels.end(), isParallel))
  {
    return std::nullopt;
  }
  constexpr double ReadingShare = 0.2; // of the time
  SubMonitor reading(monitor, 0, ReadingShare);
  SubMonitor estimating(monitor, ReadingShare, 1);
  try
  {
    const ContourSet contours = BuildContourSet(soup, ContourSetOptions(), reading);
    ContourMappingOptions options;
    if (carried)
    {
      static_cast<void>(FollowMapping(*carried, contours, options)); // which was reported before
    }
    return EstimateVolume(contours, options, estimating);
  }
  catch (const Error&)
  {
    return std::nullopt; // nothing is known of it; what else there is to say of a surface is
  }
}
}
