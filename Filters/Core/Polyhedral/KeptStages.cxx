// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/KeptStages.h"

#include "Base/SubMonitor.h"
#include "Polyhedral/LeftOut.h"
#include "Polyhedral/MapSlabs.h"
#include "Polyhedral/StagesMemory.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

namespace recon
{
namespace
{
/// Stages that take more bytes are not kept.
constexpr std::size_t MostBytes = 128 << 20;

/// The progress when it is known what is joined to what, as in BuildPolyhedralStages.
constexpr double MappedAt = 0.15;

/// See KeptStages.h.
int ReachOf(int rounds)
{
  return 2 * rounds + 1;
}

int FirstContourOf(const ContourSet& contours, int level)
{
  return contours.Levels[level].Contours.front();
}

/// Points of a level have neighbouring numbers.
int FirstPointOf(const ContourSet& contours, int level)
{
  int first = std::numeric_limits<int>::max();
  for (int c : contours.Levels[level].Contours)
  {
    const auto& points = contours.Contours[c].Points;
    first = std::min(first, *std::min_element(points.begin(), points.end()));
  }
  return first;
}

/// But for the numbers of the first contour and of the first point.
bool IsSameLevel(const ContourSet& before, const ContourSet& after, int level)
{
  const auto& ofBefore = before.Levels[level].Contours;
  const auto& ofAfter = after.Levels[level].Contours;
  if (ofBefore.size() != ofAfter.size())
  {
    return false;
  }
  const int pointBefore = FirstPointOf(before, level);
  const int pointAfter = FirstPointOf(after, level);
  for (std::size_t i = 0; i < ofBefore.size(); ++i)
  {
    const Contour& b = before.Contours[ofBefore[i]];
    const Contour& a = after.Contours[ofAfter[i]];
    const auto isSamePoint = [&](int p, int q)
    {
      return p - pointBefore == q - pointAfter && before.Planar[p] == after.Planar[q] &&
        before.Points[p] == after.Points[q];
    };
    const bool isSame = b.Depth == a.Depth && (b.Parent < 0) == (a.Parent < 0) &&
      (b.Parent < 0 || b.Parent - ofBefore.front() == a.Parent - ofAfter.front()) &&
      std::equal(b.Points.begin(), b.Points.end(), a.Points.begin(), a.Points.end(), isSamePoint);
    if (!isSame)
    {
      return false;
    }
  }
  return true;
}

bool IsSamePlane(const Level& a, const Level& b)
{
  return a.Offset == b.Offset && a.Grid == b.Grid && a.Frame.U == b.Frame.U &&
    a.Frame.V == b.Frame.V && a.Frame.Normal == b.Frame.Normal;
}

/// All that the stages depend on.
bool AreSame(const PolyhedralOptions& a, const PolyhedralOptions& b)
{
  return a.InternalPoints == b.InternalPoints && a.LiftInternalPoints == b.LiftInternalPoints &&
    a.Mapping == b.Mapping && a.OverlapThreshold == b.OverlapThreshold &&
    a.ForcedJoins == b.ForcedJoins && a.ForbiddenJoins == b.ForbiddenJoins &&
    a.MaximumGap == b.MaximumGap && a.AlignLevels == b.AlignLevels && a.EndCaps == b.EndCaps &&
    a.IsolatedContours == b.IsolatedContours;
}

std::size_t BytesOfLevels(const PolyhedralStages& stages)
{
  std::size_t bytes = 0;
  for (std::size_t level = 0; level < stages.Levels.size(); ++level)
  {
    bytes += BytesOfLevel(stages, level);
  }
  return bytes;
}

using Pairs = std::set<std::pair<int, int>>;

/// Pairs of contours of two levels with other numbers.
Pairs Shifted(const Pairs& pairs, int byLower, int byUpper)
{
  Pairs shifted;
  for (const auto& pair : pairs)
  {
    shifted.insert({ pair.first + byLower, pair.second + byUpper });
  }
  return shifted;
}

void Shift(std::vector<int>& numbers, int by)
{
  for (int& number : numbers)
  {
    number += number >= 0 ? by : 0;
  }
}

void ShiftContours(LevelTriangulation& level, int by)
{
  Shift(level.Region, by);
  for (auto& contours : level.EdgeContour)
  {
    for (int& contour : contours)
    {
      contour += contour >= 0 ? by : 0;
    }
  }
}

template <typename T>
bool AreSameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Numbers of contours that are the same but for that; -1 is none.
bool AreShifted(const std::vector<int>& before, const std::vector<int>& after, int by)
{
  return std::equal(before.begin(), before.end(), after.begin(), after.end(),
    [by](int b, int a) { return a == (b < 0 ? b : b + by); });
}

/// For what is made between two levels, which asks for no contour points: `by` is added to numbers of
/// contours.
bool IsSameTriangulation(const LevelTriangulation& before, const LevelTriangulation& after, int by)
{
  const auto areShifted = [by](const std::array<int, 3>& b, const std::array<int, 3>& a)
  {
    return std::equal(b.begin(), b.end(), a.begin(),
      [by](int known, int now) { return now == (known < 0 ? known : known + by); });
  };
  return before.IsGabriel == after.IsGabriel && AreSameBytes(before.Points, after.Points) &&
    AreSameBytes(before.Kind, after.Kind) && AreSameBytes(before.AskedBy, after.AskedBy) &&
    AreSameBytes(before.Triangles, after.Triangles) &&
    AreSameBytes(before.Neighbours, after.Neighbours) &&
    AreSameBytes(before.Inside, after.Inside) &&
    AreSameBytes(before.StarTriangle, after.StarTriangle) &&
    AreShifted(before.Region, after.Region, by) &&
    std::equal(before.EdgeContour.begin(), before.EdgeContour.end(), after.EdgeContour.begin(),
      after.EdgeContour.end(), areShifted);
}

void ShiftContours(LevelState& level, std::vector<LevelTriangulation>& earlier, int by)
{
  Shift(level.Needles, by);
  ShiftContours(level.Triangulation, by);
  for (LevelTriangulation& before : earlier)
  {
    ShiftContours(before, by);
  }
}

void ShiftContours(
  SlabState& slab, std::vector<EarlierRounds::Slab>& earlier, int byLower, int byUpper)
{
  slab.Diagram.GapRegions = Shifted(slab.Diagram.GapRegions, byLower, byUpper);
  for (EarlierRounds::Slab& before : earlier)
  {
    before.Diagram.GapRegions = Shifted(before.Diagram.GapRegions, byLower, byUpper);
  }
}

/// Neighbouring levels as a stack of their own; points keep their numbers.
ContourSet PartOf(const ContourSet& contours, int firstLevel, int endLevel)
{
  ContourSet part;
  part.Parallel = true;
  part.Points = contours.Points;
  part.Planar = contours.Planar;
  const int firstContour = FirstContourOf(contours, firstLevel);
  for (int l = firstLevel; l < endLevel; ++l)
  {
    part.Levels.push_back(contours.Levels[l]);
    Shift(part.Levels.back().Contours, -firstContour);
    for (int c : contours.Levels[l].Contours)
    {
      Contour contour = contours.Contours[c];
      contour.Level -= firstLevel;
      contour.Parent -= contour.Parent < 0 ? 0 : firstContour;
      part.Contours.push_back(std::move(contour));
    }
  }
  return part;
}

/// Lines on what became of contours, for stages that have all else.
void AddReports(
  const ContourSet& contours, const PolyhedralOptions& options, PolyhedralStages& stages)
{
  StageReport said(contours, options, stages.Mapping);
  for (std::size_t i = 0; i < stages.Levels.size(); ++i)
  {
    said.AddLevel(stages.Levels[i]);
    if (i > 0)
    {
      said.AddSlab(static_cast<int>(i - 1), stages.Levels[i - 1], stages.Levels[i],
        stages.Slabs[i - 1].Diagram);
    }
  }
  said.Write(stages.Report);
}
}

KeptStages::Range KeptStages::Range::Grown(int by, int levels) const
{
  return { std::max(0, this->First - by), std::min(levels, this->End + by) };
}

void KeptStages::Range::Include(int level)
{
  this->First = std::min(this->First, level);
  this->End = std::max(this->End, level + 1);
}

const PolyhedralStages& KeptStages::Update(const ContourSet& contours,
  const PolyhedralOptions& options, Monitor& monitor, double progressEnd, TetrahedraWanted wanted,
  const StagesSink& sink)
{
  if (this->IsOfUse(contours, options, wanted) &&
    this->UpdatePart(contours, options, monitor, progressEnd, wanted))
  {
    this->HasStages = BytesOfLevels(this->Stages) <= MostBytes;
    const std::size_t levels = this->Stages.Levels.size();
    const std::size_t needed = sink ? sink(this->Stages, levels) : 0;
    ForgetBelow(this->HasStages ? 0 : needed, this->Stages);
    return this->Stages;
  }
  this->HasStages = false;
  this->Stages = PolyhedralStages(); // not both at once
  std::size_t bytes = 0;
  std::size_t counted = 0;
  const StagesSink keep = [&](const PolyhedralStages& stages, std::size_t levels)
  {
    const std::size_t needed = sink ? sink(stages, levels) : 0;
    for (; counted < levels; ++counted)
    {
      bytes += BytesOfLevel(stages, counted);
    }
    return sink && bytes > MostBytes ? needed : 0;
  };
  this->Stages = BuildPolyhedralStages(contours, options, monitor, progressEnd, wanted, true, keep);
  this->Options = options;
  this->Wanted = wanted;
  this->Made = contours.Levels.size();
  this->HasStages = bytes <= MostBytes;
  this->Contours = this->HasStages ? contours : ContourSet();
  return this->Stages;
}

/// Levels that were shifted, and ends that go on as the sections before them tell, depend on the whole stack.
bool KeptStages::IsOfUse(
  const ContourSet& contours, const PolyhedralOptions& options, TetrahedraWanted wanted) const
{
  return this->HasStages && contours.Parallel && this->Wanted == wanted &&
    options.Contract.empty() && AreSame(this->Options, options) &&
    this->Stages.Alignment.IsEmpty() && options.EndCaps != PolyhedralOptions::Extrapolated &&
    std::equal(contours.Levels.begin(), contours.Levels.end(), this->Contours.Levels.begin(),
      this->Contours.Levels.end(), IsSamePlane);
}

KnownOverlaps KeptStages::OverlapsWithout(const Range& changed, const ContourSet& contours) const
{
  const std::vector<std::vector<RegionOverlap>>& before = this->Stages.Mapping.Overlaps;
  KnownOverlaps known(before.size());
  for (int slab = 0; slab < static_cast<int>(before.size()); ++slab)
  {
    if (slab + 1 >= changed.First && slab < changed.End)
    {
      continue;
    }
    const int lower = FirstContourOf(contours, slab) - FirstContourOf(this->Contours, slab);
    const int upper = FirstContourOf(contours, slab + 1) - FirstContourOf(this->Contours, slab + 1);
    known[slab] = before[slab];
    for (RegionOverlap& overlap : *known[slab])
    {
      overlap.LowerContour += lower;
      overlap.UpperContour += upper;
    }
  }
  return known;
}

bool KeptStages::UpdatePart(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, double progressEnd, TetrahedraWanted wanted)
{
  const auto start = std::chrono::steady_clock::now();
  LevelAlignment alignment = FindLevelAlignment(contours, options.AlignLevels, options.ForcedJoins);
  if (!alignment.IsEmpty())
  {
    return false;
  }
  const int levels = static_cast<int>(contours.Levels.size());
  Range changed{ levels, 0 };
  for (int l = 0; l < levels; ++l)
  {
    if (!IsSameLevel(this->Contours, contours, l))
    {
      changed.Include(l);
    }
  }
  std::vector<SlabState> slabs(this->Stages.Slabs.size());
  std::vector<std::string> report = alignment.Report;
  SubMonitor mappingMonitor(monitor, 0, MappedAt * progressEnd);
  ContourMapping mapping = MapSlabs(
    contours, options, slabs, report, mappingMonitor, this->OverlapsWithout(changed, contours));
  std::vector<char> isJoinedAnew(slabs.size(), 0);
  for (int i = 0; i + 1 < levels; ++i)
  {
    const SlabJoins& before = this->Stages.Slabs[i].Joins;
    const int lower = FirstContourOf(contours, i) - FirstContourOf(this->Contours, i);
    const int upper = FirstContourOf(contours, i + 1) - FirstContourOf(this->Contours, i + 1);
    if (before.IsGap != slabs[i].Joins.IsGap ||
      before.AllByDefault != slabs[i].Joins.AllByDefault ||
      Shifted(before.Exceptions, lower, upper) != slabs[i].Joins.Exceptions)
    {
      isJoinedAnew[i] = 1;
      changed.Include(i);
      changed.Include(i + 1);
    }
  }
  const std::chrono::duration<double> mapped = std::chrono::steady_clock::now() - start;

  PolyhedralStages part;
  part.Rounds = this->Stages.Rounds;
  Range window = changed;
  int rounds = 0;
  this->Made = 0;
  // What takes more rounds than before reaches farther, and there are only so many.
  while (changed.First < changed.End && rounds < part.Rounds)
  {
    rounds = std::max(rounds, part.Rounds);
    window = changed.Grown(2 * ReachOf(rounds), levels);
    if (window.End - window.First == levels)
    {
      return false;
    }
    const ContourSet contoursOfPart = PartOf(contours, window.First, window.End);
    const int firstContour = FirstContourOf(contours, window.First);
    JoinsOfPart joins;
    joins.Spacing = contours.Spacing();
    for (int i = window.First; i + 1 < window.End; ++i)
    {
      joins.Joins.push_back(slabs[i].Joins);
      joins.Joins.back().Exceptions =
        Shifted(slabs[i].Joins.Exceptions, -firstContour, -firstContour);
    }
    joins.KnownDiagram = [&](int slab, const LevelTriangulation& lower,
                           const LevelTriangulation& upper) -> std::optional<SlabTetrahedra>
    {
      const int i = window.First + slab;
      return isJoinedAnew[i] ? std::nullopt
                             : this->KnownDiagram(i, contours, firstContour, lower, upper);
    };
    SubMonitor making(monitor, MappedAt * progressEnd, progressEnd);
    try
    {
      part = BuildStagesOfPart(contoursOfPart, joins, options, making, 1, wanted);
    }
    catch (const Error&)
    {
      return false; // the whole stack has the sentence
    }
  }

  this->Renumber(contours);
  if (changed.First < changed.End)
  {
    this->Made = static_cast<std::size_t>(window.End - window.First);
    this->TakeOver(
      part, window, changed.Grown(ReachOf(rounds), levels), FirstContourOf(contours, window.First));
  }
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    this->Stages.Slabs[i].Joins = std::move(slabs[i].Joins);
  }
  this->Contours = contours;
  this->Stages.Alignment = std::move(alignment);
  this->Stages.Rounds = std::max(this->Stages.Rounds, rounds);
  this->Stages.Mapping = std::move(mapping);
  this->Stages.Report = std::move(report);
  AddReports(contours, options, this->Stages);
  for (auto& [stage, seconds] : this->Stages.StageSeconds)
  {
    const std::string& name = stage;
    const auto again = std::find_if(part.StageSeconds.begin(), part.StageSeconds.end(),
      [&](const auto& known) { return known.first == name; });
    seconds = again != part.StageSeconds.end() ? again->second : 0;
  }
  this->Stages.StageSeconds.front().second = mapped.count();
  return true;
}

/// Where levels are those of the last run, contours of a part by its own numbers.
std::optional<SlabTetrahedra> KeptStages::KnownDiagram(int slab, const ContourSet& contours,
  int firstContour, const LevelTriangulation& lower, const LevelTriangulation& upper) const
{
  const auto by = [&](int level) {
    return FirstContourOf(contours, level) - firstContour - FirstContourOf(this->Contours, level);
  };
  const EarlierRounds& earlier = this->Stages.Earlier;
  const auto isLike = [&](int level, std::size_t round, const LevelTriangulation& now)
  {
    const auto& before = earlier.Levels[level];
    return IsSameTriangulation(
      round < before.size() ? before[round] : this->Stages.Levels[level].Triangulation, now,
      by(level));
  };
  const SlabTetrahedra* found = nullptr;
  for (const EarlierRounds::Slab& before : earlier.Slabs[slab])
  {
    if (!found && isLike(slab, before.Lower, lower) && isLike(slab + 1, before.Upper, upper))
    {
      found = &before.Diagram;
    }
  }
  if (!found && isLike(slab, earlier.Levels[slab].size(), lower) &&
    isLike(slab + 1, earlier.Levels[slab + 1].size(), upper))
  {
    found = &this->Stages.Slabs[slab].Diagram;
  }
  if (!found)
  {
    return std::nullopt;
  }
  SlabTetrahedra known = *found;
  known.GapRegions = Shifted(known.GapRegions, by(slab), by(slab + 1));
  return known;
}

/// What was made before, by the numbers that contours and points have now.
void KeptStages::Renumber(const ContourSet& contours)
{
  const int levels = static_cast<int>(this->Stages.Levels.size());
  std::vector<int> by(levels);
  for (int l = 0; l < levels; ++l)
  {
    by[l] = FirstContourOf(contours, l) - FirstContourOf(this->Contours, l);
    Shift(this->Stages.Levels[l].Triangulation.Source,
      FirstPointOf(contours, l) - FirstPointOf(this->Contours, l));
    ShiftContours(this->Stages.Levels[l], this->Stages.Earlier.Levels[l], by[l]);
  }
  for (int i = 0; i + 1 < levels; ++i)
  {
    ShiftContours(this->Stages.Slabs[i], this->Stages.Earlier.Slabs[i], by[i], by[i + 1]);
  }
}

/// What a change has reached, of a part that is right there.
void KeptStages::TakeOver(
  PolyhedralStages& part, const Range& window, const Range& reached, int firstContour)
{
  for (int l = reached.First; l < reached.End; ++l)
  {
    LevelState& level = part.Levels[l - window.First];
    auto& earlier = part.Earlier.Levels[l - window.First];
    ShiftContours(level, earlier, firstContour);
    this->Stages.Levels[l] = std::move(level);
    this->Stages.Earlier.Levels[l] = std::move(earlier);
  }
  for (int i = reached.First; i + 1 < reached.End; ++i)
  {
    SlabState& slab = part.Slabs[i - window.First];
    auto& earlier = part.Earlier.Slabs[i - window.First];
    ShiftContours(slab, earlier, firstContour, firstContour);
    this->Stages.Slabs[i] = std::move(slab);
    this->Stages.Earlier.Slabs[i] = std::move(earlier);
  }
  // Earlier rounds of one level of these are those of the part.
  for (const int i : { reached.First - 1, reached.End - 1 })
  {
    if (i >= 0 && i < static_cast<int>(this->Stages.Slabs.size()))
    {
      this->Stages.Earlier.Slabs[i].clear();
    }
  }
}
}
