// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/LevelAlignment.h"

#include "Base/BoundingBox.h"
#include "Base/Text.h"
#include "Planar/RegionOverlaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace recon
{
namespace
{
/// Sections that share more than this part of the smaller one face each other well enough.
constexpr double EnoughOverlap = 0.5;
/// Tangent of the angle between the normal and the line through two centroids up to which they are
/// taken for one shape unasked: 45 degrees. Beyond, two shapes side by side are as likely.
constexpr double SteepestLean = 1;
/// Of sections one of which is smaller than this part of the other, the smaller is the end of a
/// shape, where it lies is its own matter, and Contour Mapping deals with it.
constexpr double ComparableAreas = 0.25;
/// A shift by less than this part of the mean width of a section changes little, so the overlap,
/// which takes time, is not even measured.
constexpr double WorthAShift = 0.25;
/// Places named in a sentence.
constexpr std::size_t NamedPlaces = 3;

/// Area centroid, or the mean of the points where there is as good as no area.
Point2 CentroidOf(const ContourSet& contours, const Contour& contour)
{
  const Point2& o = contours.Planar[contour.Points.front()];
  Point2 weighted{ 0, 0 };
  Point2 mean{ 0, 0 };
  double twiceArea = 0;
  double terms = 0;
  for (std::size_t i = 0; i < contour.Points.size(); ++i)
  {
    const Point2& a = contours.Planar[contour.Points[i]];
    const Point2& b = contours.Planar[contour.Points[(i + 1) % contour.Points.size()]];
    const double cross = (a[0] - o[0]) * (b[1] - o[1]) - (b[0] - o[0]) * (a[1] - o[1]);
    twiceArea += cross;
    terms += std::abs(cross);
    for (std::size_t k = 0; k < 2; ++k)
    {
      weighted[k] += cross * ((a[k] - o[k]) + (b[k] - o[k])) / 3;
      mean[k] += (a[k] - o[k]) / static_cast<double>(contour.Points.size());
    }
  }
  const bool flat = std::abs(twiceArea) <= 1e-6 * terms;
  return { o[0] + (flat ? mean[0] : weighted[0] / twiceArea),
    o[1] + (flat ? mean[1] : weighted[1] / twiceArea) };
}

/// The only outer contour of a level, or none.
std::optional<int> OnlyOuterContour(const ContourSet& contours, const Level& level)
{
  std::optional<int> only;
  for (int c : level.Contours)
  {
    if (contours.Contours[c].Depth % 2 == 0)
    {
      if (only)
      {
        return std::nullopt;
      }
      only = c;
    }
  }
  return only;
}

class Finder
{
public:
  Finder(const ContourSet& contours, LevelAlignmentMode mode,
    const std::vector<std::pair<int, int>>& forcedJoins)
    : Contours(contours),
      Mode(mode),
      ForcedJoins(forcedJoins)
  {
  }

  LevelAlignment Find()
  {
    std::vector<Finding> slabs;
    for (std::size_t slab = 0; slab + 1 < this->Contours.Levels.size(); ++slab)
    {
      slabs.push_back(this->Examine(slab));
    }
    this->ShiftWholeRuns(slabs);
    LevelAlignment found;
    found.Report = this->Sentences(slabs);
    this->Accumulate(slabs, found);
    return found;
  }

private:
  enum class What
  {
    Several, ///< outer contours on one of the levels
    Facing,  ///< the sections share enough, or a shift would change little
    Oblique, ///< they do not, and lean little
    Steep,   ///< they do not, and lean much
    Forced   ///< joined on request without any overlap
  };

  /// Of a slab.
  struct Finding
  {
    What Is = What::Several;
    Point2 Step{ 0, 0 }; ///< how far the upper level goes to lie on the lower one
    bool Shifts = false;
  };

  Finding Examine(std::size_t slab) const
  {
    const auto a = OnlyOuterContour(this->Contours, this->Contours.Levels[slab]);
    const auto b = OnlyOuterContour(this->Contours, this->Contours.Levels[slab + 1]);
    if (!a || !b)
    {
      return {}; // what suits one pair would part the others
    }
    if (this->IsForced(*a, *b) && this->OverlapOf(slab, *a, *b) == 0)
    {
      return { What::Forced, this->Between(*a, *b), true };
    }
    Finding finding{ What::Facing, this->Between(*a, *b), this->Mode == LevelAlignmentMode::On };
    const double length = std::hypot(finding.Step[0], finding.Step[1]);
    const double width = std::min(this->MeanWidthOf(*a), this->MeanWidthOf(*b));
    if (finding.Shifts || !this->AreComparable(*a, *b) || length < WorthAShift * width ||
      this->OverlapOf(slab, *a, *b) >= EnoughOverlap)
    {
      return finding;
    }
    const double thickness =
      this->Contours.Levels[slab + 1].Offset - this->Contours.Levels[slab].Offset;
    finding.Is = length > SteepestLean * thickness ? What::Steep : What::Oblique;
    finding.Shifts = this->Mode == LevelAlignmentMode::Automatic && finding.Is == What::Oblique;
    return finding;
  }

  /// A shape that is oblique somewhere is so as a whole: its other slabs shift as well, as far as
  /// both levels have one outer contour.
  static void ShiftWholeRuns(std::vector<Finding>& slabs)
  {
    const auto spread = [](auto begin, auto end)
    {
      for (auto previous = begin++; begin < end; previous = begin++)
      {
        begin->Shifts = begin->Shifts ||
          (begin->Is == What::Facing && previous->Is != What::Forced && previous->Shifts);
      }
    };
    if (!slabs.empty())
    {
      spread(slabs.begin(), slabs.end());
      spread(slabs.rbegin(), slabs.rend());
    }
  }

  void Accumulate(const std::vector<Finding>& slabs, LevelAlignment& found) const
  {
    std::vector<Point2> shift(1, { 0, 0 });
    bool any = false;
    for (const Finding& slab : slabs)
    {
      const Point2 step = slab.Shifts ? slab.Step : Point2{ 0, 0 };
      any = any || step != Point2{ 0, 0 };
      shift.push_back(this->OnGrid({ shift.back()[0] + step[0], shift.back()[1] + step[1] }));
    }
    if (any)
    {
      found.Shift = std::move(shift);
      for (const Level& level : this->Contours.Levels)
      {
        found.Offset.push_back(level.Offset);
      }
    }
  }

  bool IsForced(int lower, int upper) const
  {
    return std::any_of(this->ForcedJoins.begin(), this->ForcedJoins.end(),
      [&](const std::pair<int, int>& join)
      { return std::minmax(join.first, join.second) == std::minmax(lower, upper); });
  }

  /// Share of the smaller region.
  double OverlapOf(std::size_t slab, int lower, int upper) const
  {
    const auto overlaps = MeasureRegionOverlaps(
      this->Contours, this->Contours.Levels[slab], this->Contours.Levels[slab + 1]);
    const double smaller = std::min(std::abs(this->Contours.Contours[lower].SignedArea),
      std::abs(this->Contours.Contours[upper].SignedArea));
    double shared = 0;
    for (const RegionOverlap& overlap : overlaps)
    {
      // Of outlines, holes included: what lies in a hole of one and in the other faces it.
      shared +=
        this->IsWithin(overlap.LowerContour, lower) && this->IsWithin(overlap.UpperContour, upper)
        ? overlap.Area
        : 0;
    }
    return shared / smaller;
  }

  bool AreComparable(int a, int b) const
  {
    const double one = std::abs(this->Contours.Contours[a].SignedArea);
    const double other = std::abs(this->Contours.Contours[b].SignedArea);
    return std::min(one, other) >= ComparableAreas * std::max(one, other);
  }

  /// Area by longest extent.
  double MeanWidthOf(int contour) const
  {
    Box2 box;
    for (int p : this->Contours.Contours[contour].Points)
    {
      box.Add(this->Contours.Planar[p]);
    }
    return std::abs(this->Contours.Contours[contour].SignedArea) / box.LongestExtent();
  }

  bool IsWithin(int contour, int outline) const
  {
    while (contour >= 0 && contour != outline)
    {
      contour = this->Contours.Contours[contour].Parent;
    }
    return contour == outline;
  }

  Point2 Between(int lower, int upper) const
  {
    const Point2 a = CentroidOf(this->Contours, this->Contours.Contours[lower]);
    const Point2 b = CentroidOf(this->Contours, this->Contours.Contours[upper]);
    return { a[0] - b[0], a[1] - b[1] };
  }

  /// Whole multiples of the grid of the planes, or few enough bits that a sum loses next to none.
  Point2 OnGrid(const Point2& shift) const
  {
    double grid = this->Contours.Levels.front().Grid;
    if (grid == 0)
    {
      const double largest = std::max({ std::abs(shift[0]), std::abs(shift[1]), 1e-300 });
      grid = std::ldexp(1.0, std::ilogb(largest) - 20);
    }
    return { std::round(shift[0] / grid) * grid, std::round(shift[1] / grid) * grid };
  }

  std::string PlaceOf(std::size_t slab) const
  {
    return Text(this->Contours.Levels[slab].Offset) + " to " +
      Text(this->Contours.Levels[slab + 1].Offset);
  }

  std::vector<std::string> Sentences(const std::vector<Finding>& slabs) const
  {
    std::vector<std::string> forced, shifted, leftAlone;
    for (std::size_t i = 0; i < slabs.size(); ++i)
    {
      const bool hardly = slabs[i].Is == What::Oblique || slabs[i].Is == What::Steep;
      if (slabs[i].Is == What::Forced)
      {
        forced.push_back(this->PlaceOf(i));
      }
      else if (slabs[i].Shifts)
      {
        shifted.push_back(this->PlaceOf(i));
      }
      else if (hardly && this->Mode != LevelAlignmentMode::Off)
      {
        leftAlone.push_back(this->PlaceOf(i));
      }
    }
    std::vector<std::string> report;
    if (!forced.empty())
    {
      report.push_back(
        "Levels were shifted onto one another for joins that were asked for and have "
        "no overlap, at offsets " +
        Listed(forced, NamedPlaces) + ".");
    }
    if (!shifted.empty())
    {
      report.push_back("Sections of one oblique shape that hardly overlap were shifted onto one "
                       "another and back, at offsets " +
        Listed(shifted, NamedPlaces) + "; Align Levels = Off leaves them as they lie.");
    }
    if (!leftAlone.empty())
    {
      report.push_back(
        "Neighbouring sections share less than half of the smaller one, at offsets " +
        Listed(leftAlone, NamedPlaces) +
        "; if they are of one oblique shape, set Align Levels to On, or force the joins.");
    }
    return report;
  }

  const ContourSet& Contours;
  LevelAlignmentMode Mode;
  const std::vector<std::pair<int, int>>& ForcedJoins;
};
}

Point2 LevelAlignment::Undo(const Point2& p, double height) const
{
  if (this->IsEmpty())
  {
    return p;
  }
  const auto above = std::upper_bound(this->Offset.begin(), this->Offset.end(), height);
  const auto upper = static_cast<std::size_t>(above - this->Offset.begin());
  if (upper == 0 || upper == this->Offset.size())
  {
    const Point2& shift = upper == 0 ? this->Shift.front() : this->Shift.back();
    return { p[0] - shift[0], p[1] - shift[1] };
  }
  const std::size_t lower = upper - 1;
  const double t = (height - this->Offset[lower]) / (this->Offset[upper] - this->Offset[lower]);
  const Point2& a = this->Shift[lower];
  const Point2& b = this->Shift[upper];
  return { p[0] - ((1 - t) * a[0] + t * b[0]), p[1] - ((1 - t) * a[1] + t * b[1]) };
}

LevelAlignment FindLevelAlignment(const ContourSet& contours, LevelAlignmentMode mode,
  const std::vector<std::pair<int, int>>& forcedJoins)
{
  return Finder(contours, mode, forcedJoins).Find();
}

ContourSet Aligned(const ContourSet& contours, const LevelAlignment& alignment)
{
  ContourSet shifted = contours;
  for (std::size_t i = 0; i < contours.Levels.size() && !alignment.IsEmpty(); ++i)
  {
    std::vector<int> points;
    for (int c : contours.Levels[i].Contours)
    {
      points.insert(
        points.end(), contours.Contours[c].Points.begin(), contours.Contours[c].Points.end());
    }
    // Contours of a level may share a point.
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (int p : points)
    {
      shifted.Planar[p][0] += alignment.Shift[i][0];
      shifted.Planar[p][1] += alignment.Shift[i][1];
    }
  }
  return shifted;
}
}
