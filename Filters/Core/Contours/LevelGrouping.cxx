// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/LevelGrouping.h"

#include "Base/Median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace recon
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
// Offsets that differ by less than this part of the largest one are equal but for rounding.
constexpr double OffsetRounding = 1e-12;
// An offset along a tilted normal is a sum of coordinates, and rounds like the largest of them.
constexpr double CoordinateRounding = 1e-14;
// Distances within a level are at most this part of the one to the next level.
constexpr double MostInnerShare = 0.25;
// Below this part of the spacing a distance is no slice distance, whatever the contours look like.
constexpr double SurelyOneLevel = 0.005;
// Contours whose boxes have more than this in common could be slices of one thing.
constexpr double SameOutline = 0.5;
// So many levels must be left where more than half of the distances are merged.
constexpr int FewestRegularLevels = 3;

double LargestOf(const LevelCandidate& candidate)
{
  return std::max({ std::abs(candidate.Low[0]), std::abs(candidate.Low[1]),
    std::abs(candidate.High[0]), std::abs(candidate.High[1]) });
}

/// Distances of consecutive contours; rounding counts as nothing.
class Distances
{
public:
  explicit Distances(const std::vector<LevelCandidate>& candidates) : Candidates(candidates)
  {
    this->Order.resize(candidates.size());
    std::iota(this->Order.begin(), this->Order.end(), 0);
    std::stable_sort(this->Order.begin(), this->Order.end(),
      [&](int a, int b) { return candidates[a].Offset < candidates[b].Offset; });
    for (std::size_t i = 1; i < this->Order.size(); ++i)
    {
      const LevelCandidate& a = this->At(i - 1);
      const LevelCandidate& b = this->At(i);
      const double rounding = OffsetRounding * std::max(std::abs(a.Offset), std::abs(b.Offset)) +
        CoordinateRounding * std::max(LargestOf(a), LargestOf(b)) + a.Noise + b.Noise;
      const double distance = b.Offset - a.Offset;
      this->Values.push_back(distance > rounding ? distance : 0);
    }
    this->Sorted = this->Values;
    std::sort(this->Sorted.begin(), this->Sorted.end());
    this->Zeros = static_cast<std::size_t>(
      std::upper_bound(this->Sorted.begin(), this->Sorted.end(), 0.0) - this->Sorted.begin());
  }

  const LevelCandidate& At(std::size_t i) const { return this->Candidates[this->Order[i]]; }

  /// Lower median of the distances that are left where the smallest `count` are merged.
  double MedianBeyond(std::size_t count) const
  {
    const std::size_t left = this->Sorted.size() - count;
    return left == 0 ? 0 : this->Sorted[count + (left - 1) / 2];
  }

  const std::vector<LevelCandidate>& Candidates;
  std::vector<int> Order;
  std::vector<double> Values; ///< between Order[i] and Order[i + 1]
  std::vector<double> Sorted;
  std::size_t Zeros = 0;
};

/// Share that two boxes have of the area of both together.
double CommonShare(const LevelCandidate& a, const LevelCandidate& b)
{
  double common = 1;
  double areaA = 1;
  double areaB = 1;
  for (std::size_t k = 0; k < 2; ++k)
  {
    common *= std::max(0.0, std::min(a.High[k], b.High[k]) - std::max(a.Low[k], b.Low[k]));
    areaA *= a.High[k] - a.Low[k];
    areaB *= b.High[k] - b.Low[k];
  }
  const double both = areaA + areaB - common;
  return both > 0 ? common / both : 0;
}

class Grouper
{
public:
  Grouper(const std::vector<LevelCandidate>& candidates, double most) : Gaps(candidates), Most(most)
  {
  }

  double FindTolerance() const
  {
    const std::size_t count = this->Gaps.Sorted.size();
    std::size_t first = this->Gaps.Zeros;
    while (first < count && this->Gaps.Sorted[first] <= this->ToleranceBeyond(first))
    {
      ++first;
    }
    // From here on each merge has to raise the median of the rest far enough for itself.
    for (std::size_t merged = count; merged-- > first + 1;)
    {
      if (this->Gaps.Sorted[merged - 1] <= this->ToleranceBeyond(merged) &&
        (std::isfinite(this->Most) || this->AreRegularLevels(merged)))
      {
        return this->ToleranceBeyond(merged);
      }
    }
    return this->ToleranceBeyond(first);
  }

  LevelGrouping Group(double tolerance, bool found) const
  {
    std::vector<bool> splits(this->Gaps.Values.size());
    for (std::size_t i = 0; i < splits.size(); ++i)
    {
      splits[i] = this->Gaps.Values[i] > tolerance;
    }
    if (found)
    {
      this->SplitWhatIsNoLevel(splits);
    }
    return this->Describe(splits, tolerance);
  }

private:
  double ToleranceBeyond(std::size_t merged) const
  {
    return std::min(this->Most, LevelShare * this->Gaps.MedianBeyond(merged));
  }

  /// May the smallest `merged` distances, more than half of all, lie within levels?
  bool AreRegularLevels(std::size_t merged) const
  {
    const double widest = this->Gaps.Sorted[merged - 1];
    const bool tiny = widest <= SurelyOneLevel * this->Gaps.MedianBeyond(merged);
    const std::size_t levels = this->Gaps.Sorted.size() - merged + 1;
    return levels >= static_cast<std::size_t>(FewestRegularLevels) &&
      (tiny || !this->HasSlicesOfOneThing(widest));
  }

  /// Do two contours look like slices of one thing in a group that a tolerance makes?
  bool HasSlicesOfOneThing(double tolerance) const
  {
    std::size_t first = 0;
    for (std::size_t i = 1; i < this->Gaps.Order.size(); ++i)
    {
      first = this->Gaps.Values[i - 1] > tolerance ? i : first;
      if (this->LooksLikeOneOf(first, i))
      {
        return true;
      }
    }
    return false;
  }

  /// Does contour `i` look like one of those from `first` to it that lie beside it?
  bool LooksLikeOneOf(std::size_t first, std::size_t i) const
  {
    const LevelCandidate& b = this->Gaps.At(i);
    for (std::size_t j = first; j < i; ++j)
    {
      const LevelCandidate& a = this->Gaps.At(j);
      if (b.Offset - a.Offset > a.Noise + b.Noise && CommonShare(a, b) > SameOutline)
      {
        return true;
      }
    }
    return false;
  }

  /// Are the contours from `from` to `to` three slices of one thing or more? In millimetres it is
  /// known what is too near for that.
  bool AreSlices(std::size_t from, std::size_t to, double widest) const
  {
    if (std::isfinite(this->Most) ||
      widest <= SurelyOneLevel * this->Gaps.MedianBeyond(this->Gaps.Zeros))
    {
      return false;
    }
    int slices = 1;
    for (std::size_t i = from + 1; i <= to; ++i)
    {
      slices += this->Gaps.Values[i - 1] > 0 && this->LooksLikeOneOf(from, i) ? 1 : 0;
    }
    return slices > 2;
  }

  /// Takes groups apart whose inner distances are not small beside those to their neighbours.
  void SplitWhatIsNoLevel(std::vector<bool>& splits) const
  {
    const std::vector<bool> before = splits;
    for (std::size_t from = 0; from < before.size();)
    {
      std::size_t to = from;
      double widest = 0;
      for (; to < before.size() && !before[to]; ++to)
      {
        widest = std::max(widest, this->Gaps.Values[to]);
      }
      const double below = from > 0 ? this->Gaps.Values[from - 1] : Infinity;
      const double above = to < before.size() ? this->Gaps.Values[to] : Infinity;
      if (widest > MostInnerShare * std::min(below, above) || this->AreSlices(from, to, widest))
      {
        for (std::size_t i = from; i < to; ++i)
        {
          splits[i] = this->Gaps.Values[i] > 0;
        }
      }
      from = to + 1;
    }
  }

  LevelGrouping Describe(const std::vector<bool>& splits, double tolerance) const
  {
    LevelGrouping grouping;
    grouping.Tolerance = tolerance;
    grouping.LevelOf.assign(this->Gaps.Order.size(), 0);
    std::vector<double> spacings;
    int level = 0;
    for (std::size_t i = 0; i < this->Gaps.Order.size(); ++i)
    {
      const double gap = i > 0 ? this->Gaps.Values[i - 1] : 0;
      if (i > 0 && splits[i - 1])
      {
        ++level;
        spacings.push_back(gap);
      }
      else if (gap > 0)
      {
        grouping.WidestMerge = std::max(grouping.WidestMerge, gap);
        if (grouping.Merged.empty() || grouping.Merged.back() != level)
        {
          grouping.Merged.push_back(level);
        }
      }
      grouping.LevelOf[this->Gaps.Order[i]] = level;
    }
    grouping.Count = this->Gaps.Order.empty() ? 0 : level + 1;
    grouping.Room.assign(grouping.Count, Infinity);
    for (std::size_t s = 0; s < spacings.size(); ++s)
    {
      grouping.Room[s] = std::min(grouping.Room[s], spacings[s]);
      grouping.Room[s + 1] = spacings[s];
    }
    grouping.Spacing = Median(spacings);
    return grouping;
  }

  Distances Gaps;
  double Most;
};
}

LevelGrouping GroupLevels(
  const std::vector<LevelCandidate>& candidates, double tolerance, bool millimetres)
{
  const Grouper grouper(candidates, millimetres ? MostLevelTolerance : Infinity);
  return tolerance > 0 ? grouper.Group(tolerance, false)
                       : grouper.Group(grouper.FindTolerance(), true);
}
}
