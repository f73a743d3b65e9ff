// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourSetBuilder.h"

#include "Base/BoundingBox.h"
#include "Contours/ContourChaining.h"
#include "Contours/ContourNotes.h"
#include "Contours/ContourPlanes.h"
#include "Contours/HoleExplanation.h"
#include "Contours/OpenLines.h"
#include "Contours/PlanarRings.h"
#include "Contours/TipSections.h"
#include "Planar/HoleRule.h"
#include "Planar/LoopTwins.h"
#include "Planar/NestingForest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace recon
{
namespace
{
// Loose ends nearer to each other than this part of the diagonal are one.
constexpr double EndShare = 1e-5;
// Points of a tilted plane that are farther off it than this part of the distance to the next level
// are put on it; those of planes across a coordinate axis in any case.
constexpr double LooseShare = 1e-3;
// Outlines of one region cross so often, all slices together, and once more a point. Each crossing costs a
// millisecond until the surface is there, and scribbles cross in the square of their points.
constexpr std::size_t FewCrossings = 5000;

/// The box around all finite points that chains use.
Box3 BoundsOf(const LoopSoup& soup)
{
  Box3 box;
  for (const LoopSoup::Chain& chain : soup.Chains)
  {
    for (int p : chain.Points)
    {
      if (p >= 0 && p < static_cast<int>(soup.Points.size()) && std::isfinite(Norm(soup.Points[p])))
      {
        box.Add(soup.Points[p]);
      }
    }
  }
  return box;
}

/// What was the matter with loops that had to be resolved, in brackets.
std::string Findings(const EvenOddCluster& cluster)
{
  std::string text;
  const auto add = [&text](std::size_t count, const char* noun, const char* what)
  {
    if (count > 0)
    {
      text += (text.empty() ? " (" : ", ") + Counted(count, noun) + what;
    }
  };
  add(cluster.Crossings, "crossing", "");
  add(cluster.OnEdge, "point", " on an edge");
  add(cluster.Cancelled, "edge", " walked more than once");
  add(cluster.Shared, "point", " passed again");
  const std::string apart = Text(cluster.Moved);
  add(cluster.Merged, "point", (" merged with another, at most " + apart + " apart").c_str());
  return text.empty() ? text : text + ")";
}

class Builder
{
public:
  Builder(const LoopSoup& soup, const ContourSetOptions& options, Monitor& monitor)
    : Soup(soup),
      Options(options),
      Progress(monitor),
      Notes(soup)
  {
    for (const LoopSoup::Chain& chain : soup.Chains)
    {
      if (chain.ExclusiveOr)
      {
        this->ExclusiveOrSources.insert(chain.Source);
      }
    }
  }

  ContourSet Build()
  {
    if (!(this->Options.PlaneTolerance >= 0 && std::isfinite(this->Options.PlaneTolerance)))
    {
      throw Error(
        "The plane tolerance is a distance in the unit of the contours: give 0 (found from "
        "the contours) or a positive number instead of " +
        Text(this->Options.PlaneTolerance) + ".");
    }
    if (!(this->Options.SnapTolerance >= 0 && std::isfinite(this->Options.SnapTolerance)))
    {
      throw Error("The snap tolerance is a distance in the units of the contours: give 0 for an "
                  "automatic one, or a positive number, instead of " +
        Text(this->Options.SnapTolerance) + ".");
    }
    const double size = BoundsOf(this->Soup).Diagonal();
    this->ChainAndClose(size);
    this->FindLargestCoordinate();
    PlaneOptions planes;
    planes.OnlyParallel = this->Options.Parallel;
    planes.Tolerance = this->Options.PlaneTolerance;
    planes.Size = size;
    const PlaneGrouping grouping =
      GroupByPlane(this->Soup, this->Rings, planes, this->Notes, this->Progress);
    this->AddWarning(grouping.Warning);
    this->Set.Parallel = grouping.Parallel;
    const auto count = static_cast<double>(grouping.Planes.size());
    for (std::size_t i = 0; i < grouping.Planes.size(); ++i)
    {
      this->Progress.Update(0.3 + 0.7 * static_cast<double>(i) / count, "cleaning contours");
      this->AddLevel(grouping.Planes[i]);
    }
    std::optional<PlanarFrame> common;
    if (grouping.Parallel && !grouping.Planes.empty())
    {
      common = grouping.Planes[0].Frame;
    }
    if (grouping.Parallel)
    {
      this->PutOnPlanes();
    }
    this->Set.Report = this->Notes.Sentences(common, this->Set.Contours.size());
    if (!this->Set.Warning.empty())
    {
      this->Set.Report.insert(this->Set.Report.begin(), this->Set.Warning);
    }
    this->ThrowWhereEmpty();
    this->Progress.Update(1, "cleaning contours");
    return std::move(this->Set);
  }

private:
  /// Distance of a level to its nearest neighbour; infinite where there is none.
  double RoomAt(std::size_t level) const
  {
    double room = std::numeric_limits<double>::infinity();
    for (const std::size_t other : { level - 1, level + 1 })
    {
      if (other < this->Set.Levels.size())
      {
        room =
          std::min(room, std::abs(this->Set.Levels[other].Offset - this->Set.Levels[level].Offset));
      }
    }
    return room;
  }

  /// Points that are visibly off their plane go onto it: what is decided is decided there, and
  /// sheets that touch in the plane would cross by what their points are off it.
  void PutOnPlanes()
  {
    std::size_t moved = 0;
    double farthest = 0;
    for (std::size_t l = 0; l < this->Set.Levels.size(); ++l)
    {
      const Level& level = this->Set.Levels[l];
      // In a tilted frame all points are off their plane by rounding.
      const double loose = level.Grid > 0 ? LooseShare * this->RoomAt(l) : 0;
      if (!(level.Thickness > loose))
      {
        continue;
      }
      ++moved;
      farthest = std::max(farthest, level.Thickness);
      for (int c : level.Contours)
      {
        for (int p : this->Set.Contours[c].Points)
        {
          this->Set.Points[p] = level.Frame.ToSpace(this->Set.Planar[p], level.Offset);
        }
      }
    }
    if (moved > 0)
    {
      this->Notes.ContinueGeneral("Points of " + Counted(moved, "slice") + ", up to " +
        Text(farthest) +
        " off its plane, were put on it, so that the surface cannot cross itself there.");
    }
  }

  void ChainAndClose(double size)
  {
    ChainedRings chained =
      ChainRings(this->Soup, EndShare * size, this->Notes, this->Progress, true);
    this->Rings = std::move(chained.Rings);
    std::size_t left = 0;
    for (OpenLine& line : chained.Open)
    {
      const bool closes = this->Options.OpenLines == OpenLineRule::Chord && line.Points.size() >= 3;
      this->Notes.Add(line.Source, line.Points.size(), line.Points[0],
        "is open, its ends are " + Text(GapOf(this->Soup, line)) + " apart; " +
          (closes ? "closed by a straight line, as OpenLines asks" : "left out"));
      if (closes)
      {
        this->Rings.push_back({ std::move(line.Points), line.Source, -1 });
      }
      left += closes ? 0 : 1;
    }
    if (left > this->Rings.size() && !this->Rings.empty())
    {
      this->AddWarning(std::to_string(left) + " of " +
        Counted(left + this->Rings.size(), "contour") + (left == 1 ? " is" : " are") +
        " open and left out, so that the result is only a part of what was drawn: OpenLines closes "
        "them by a straight line (Chord) or along the border of the data (Border).");
    }
    this->HasOpenLinesOnly = left > 0 && this->Rings.empty() && this->IsNoChainClosed();
  }

  /// Lines and points, and nothing that was meant to be a contour?
  bool IsNoChainClosed() const
  {
    const auto isUsable = [this](int p)
    {
      return p >= 0 && p < static_cast<int>(this->Soup.Points.size()) &&
        std::isfinite(Norm(this->Soup.Points[p]));
    };
    return std::all_of(this->Soup.Chains.begin(), this->Soup.Chains.end(),
      [&](const LoopSoup::Chain& chain)
      {
        return chain.Points.size() < 2 ||
          (!chain.Closed && std::all_of(chain.Points.begin(), chain.Points.end(), isUsable));
      });
  }

  void AddWarning(const std::string& sentence)
  {
    this->Set.Warning += (this->Set.Warning.empty() || sentence.empty() ? "" : " ") + sentence;
  }

  void ThrowWhereEmpty() const
  {
    if (!this->Set.Contours.empty())
    {
      return;
    }
    if (this->Soup.Chains.empty())
    {
      throw Error("There are no contours: give closed polylines, polygons or loose segments.");
    }
    const std::size_t more = this->Set.Report.size() - 1;
    const std::string sentences = this->Set.Report.front() +
      (more > 0 ? " (And " + Counted(more, "more sentence") + " like this.)" : "");
    if (this->HasOpenLinesOnly)
    {
      throw NothingToDo("There are open lines only, which enclose nothing: nothing to do. " +
        sentences + " (OpenLines closes such lines.)");
    }
    throw Error("No usable contour is left. " + sentences);
  }

  void AddLevel(const PlaneOfRings& plane)
  {
    const double grid = PlanarGridOf(plane.Frame, this->Largest);
    PlanarRings rings = FlattenLevel(this->Soup, this->Rings, plane, grid, this->Notes);
    HoleFindings found;
    found.ExclusiveOr = this->IsExclusiveOr(rings);
    this->LeaveOutTwins(rings, !found.ExclusiveOr);
    const HoleRule rule = found.ExclusiveOr ? HoleRule::EvenOdd : this->Options.Holes;
    EvenOddResult result;
    try
    {
      result = ApplyHoleRule(rings.Points, rings.Loops, rule, this->Options.SnapTolerance);
      this->CountCrossings(result);
    }
    catch (const Error& error)
    {
      // One level that cannot be resolved must not take the others down.
      std::vector<int> all(rings.Loops.size());
      std::iota(all.begin(), all.end(), 0);
      const std::string why = error.what();
      this->NoteLoops(
        rings, all, "cannot be resolved: " + why.substr(0, why.find_last_not_of('.') + 1));
      return;
    }
    for (const EvenOddCluster& cluster : result.Clusters)
    {
      this->NoteCluster(rings, cluster);
    }
    if (rule != this->Options.Holes && this->Options.Holes != HoleRule::Automatic)
    {
      this->NoteLoops(rings, { 0 },
        std::string("shares its plane with CLOSEDPLANAR_XOR contours, which go by even-odd and not "
                    "by the ") +
          NameOf(this->Options.Holes) + " rule that was asked for");
    }
    for (int l : result.Swallowed)
    {
      this->NoteLoops(
        rings, { l }, std::string("lies within solid by the ") + NameOf(rule) + " rule; left out");
    }
    found.Swallowed = result.Swallowed.size();
    this->LeaveOutThinRings(rings, result);
    this->AddContours(plane, rings, result, rule, found);
  }

  /// @throws Error where those of all slices so far come to more than outlines have
  void CountCrossings(const EvenOddResult& result)
  {
    std::size_t crossings = this->Crossings;
    for (const EvenOddCluster& cluster : result.Clusters)
    {
      crossings += cluster.Crossings;
    }
    const std::size_t most = FewCrossings + this->Soup.Points.size();
    if (crossings > most)
    {
      throw Error("Contours cross in more than " + std::to_string(most) +
        " places, all slices together, which is no outline of anything.");
    }
    this->Crossings = crossings;
  }

  void LeaveOutTwins(PlanarRings& rings, bool tracedAgain)
  {
    const std::vector<LoopTwin> twins =
      FindLoopTwins(rings.Points, rings.Loops, this->UnitsOf(rings), tracedAgain);
    for (const LoopTwin& twin : twins)
    {
      const Ring& of = this->Rings[rings.Rings[twin.Of]];
      this->NoteLoops(rings, { twin.Loop },
        "is the same as that of cell " + std::to_string(of.Source) +
          (twin.WithinRounding ? " within rounding" : " traced again") + " (at most " +
          Text(twin.Apart) + " apart); left out");
    }
    // From the last, so that the numbers of the others stay.
    for (auto twin = twins.rbegin(); twin != twins.rend(); ++twin)
    {
      rings.Loops.erase(rings.Loops.begin() + twin->Loop);
      rings.Rings.erase(rings.Rings.begin() + twin->Loop);
    }
  }

  /// A contour that goes around several times, hardly beside itself, is rings by even-odd; what was
  /// meant is what it goes around.
  void LeaveOutThinRings(const PlanarRings& rings, EvenOddResult& result)
  {
    std::vector<std::vector<int>> loops;
    for (const EvenOddResult::Loop& loop : result.Loops)
    {
      loops.push_back(loop.Points);
    }
    const std::vector<double> units(loops.size(), 0);
    const std::vector<LoopTwin> twins = FindLoopTwins(rings.Points, loops, units, false);
    for (auto twin = twins.rbegin(); twin != twins.rend(); ++twin)
    {
      this->NoteLoops(rings, { result.Loops[twin->Loop].Origin },
        "goes around once more within " + Text(twin->Apart) + " of another; left out");
      result.Loops.erase(result.Loops.begin() + twin->Loop);
    }
  }

  /// Of every loop, that of the last decimal of its coordinates as they were given. One that all
  /// its points share is that of the plane, which may have decimals of its own.
  std::vector<double> UnitsOf(const PlanarRings& rings) const
  {
    std::vector<double> units;
    for (int r : rings.Rings)
    {
      std::vector<double> numbers;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::vector<double> column = this->CoordinatesOf(this->Rings[r], k);
        if (std::any_of(column.begin(), column.end(), [&](double x) { return x != column[0]; }))
        {
          numbers.insert(numbers.end(), column.begin(), column.end());
        }
      }
      units.push_back(UnitOf(numbers));
    }
    return units;
  }

  std::vector<double> CoordinatesOf(const Ring& ring, std::size_t axis) const
  {
    std::vector<double> coordinates;
    for (int p : ring.Points)
    {
      coordinates.push_back(this->Soup.Points[p][axis]);
    }
    return coordinates;
  }

  void FindLargestCoordinate()
  {
    for (const Ring& ring : this->Rings)
    {
      for (int p : ring.Points)
      {
        for (double x : this->Soup.Points[p])
        {
          this->Largest = std::max(this->Largest, std::abs(x));
        }
      }
    }
  }

  bool IsExclusiveOr(const PlanarRings& rings) const
  {
    return std::any_of(rings.Rings.begin(), rings.Rings.end(),
      [this](int r) { return this->ExclusiveOrSources.count(this->Rings[r].Source) > 0; });
  }

  /// How the holes among loops were drawn.
  static void CountHoles(const PlanarRings& rings, const std::vector<int>& origins,
    const NestingForest& forest, HoleFindings& found)
  {
    const auto isPositive = [&](int origin)
    { return SignedAreaOf(rings.Points, rings.Loops[origin]) > 0; };
    for (std::size_t l = 0; l < origins.size(); ++l)
    {
      if (forest.Depth[l] % 2 == 0)
      {
        continue;
      }
      const int around = origins[forest.Parent[l]];
      if (around == origins[l])
      {
        ++found.Keyholes;
      }
      else
      {
        ++(isPositive(around) == isPositive(origins[l]) ? found.Same : found.Opposite);
      }
    }
  }

  void NoteLoops(const PlanarRings& rings, const std::vector<int>& loops, const std::string& what)
  {
    std::vector<int> sources;
    std::size_t points = 0;
    for (int l : loops)
    {
      const Ring& ring = this->Rings[rings.Rings[l]];
      points += ring.Points.size();
      if (std::find(sources.begin(), sources.end(), ring.Source) == sources.end())
      {
        sources.push_back(ring.Source);
      }
    }
    const Ring& first = this->Rings[rings.Rings[loops[0]]];
    this->Notes.Add(std::move(sources), points, first.Points[0], what);
  }

  /// Of a loop by itself of which nothing is left.
  static std::string WhyNothing(const PlanarRings& rings, const EvenOddCluster& cluster)
  {
    if (cluster.Cancelled + cluster.Merged == 0)
    {
      return std::string("lies within solid by the ") + cluster.Rule + " rule";
    }
    const bool flat = SignedAreaOf(rings.Points, rings.Loops[cluster.Loops[0]]) == 0;
    return flat ? "encloses no area"
                : "is narrower than the snap tolerance of " + Text(cluster.Tolerance);
  }

  void NoteCluster(const PlanarRings& rings, const EvenOddCluster& cluster)
  {
    if (!cluster.Changed)
    {
      return;
    }
    const bool alone = cluster.Loops.size() == 1;
    if (cluster.Results == 0)
    {
      this->NoteLoops(rings, cluster.Loops,
        (alone ? this->WhyNothing(rings, cluster)
               : std::string("cancel one another under the ") + cluster.Rule + " rule") +
          Findings(cluster) + "; left out");
      return;
    }
    this->NoteLoops(rings, cluster.Loops,
      (alone ? "touches or crosses itself" : "touch or cross one another") + Findings(cluster) +
        "; resolved by the " + cluster.Rule + " rule into " + Counted(cluster.Results, "contour"));
    for (int l : cluster.Vanished)
    {
      this->NoteLoops(
        rings, { l }, std::string("vanishes under the ") + cluster.Rule + " rule; left out");
    }
  }

  /// Turns the loops the way their depth asks for and appends them as a level.
  void AddContours(const PlaneOfRings& plane, const PlanarRings& rings, EvenOddResult& result,
    HoleRule rule, HoleFindings& found)
  {
    std::vector<std::vector<int>> loops;
    std::vector<double> areas;
    std::vector<int> sources;
    std::vector<int> origins;
    for (EvenOddResult::Loop& loop : result.Loops)
    {
      const double area = SignedAreaOf(rings.Points, loop.Points);
      if (!std::isnormal(area))
      {
        this->NoteLoops(
          rings, { loop.Origin }, "encloses an area too small for a number; left out");
        continue;
      }
      if (area < 0)
      {
        std::reverse(loop.Points.begin() + 1, loop.Points.end());
      }
      areas.push_back(std::abs(area));
      loops.push_back(std::move(loop.Points));
      origins.push_back(loop.Origin);
      sources.push_back(this->Rings[rings.Rings[loop.Origin]].Source);
    }
    if (loops.empty())
    {
      return;
    }
    const NestingForest forest = BuildNestingForest(rings.Points, loops);
    const int firstContour = static_cast<int>(this->Set.Contours.size());
    Level level;
    level.Frame = plane.Frame;
    level.Offset = plane.Offset;
    level.Thickness = plane.Thickness;
    level.Grid = PlanarGridOf(plane.Frame, this->Largest);
    CountHoles(rings, origins, forest, found);
    level.HoleNote = DescribeHoles(rule, found);
    std::vector<int> pointMap(rings.Points.size(), -1);
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      Contour contour;
      contour.Level = static_cast<int>(this->Set.Levels.size());
      contour.Depth = forest.Depth[l];
      contour.Parent = forest.Parent[l] < 0 ? -1 : firstContour + forest.Parent[l];
      contour.Source = sources[l];
      const bool hole = contour.Depth % 2 == 1;
      contour.SignedArea = hole ? -areas[l] : areas[l];
      if (hole)
      {
        std::reverse(loops[l].begin() + 1, loops[l].end());
      }
      for (int p : loops[l])
      {
        contour.Points.push_back(this->PointOf(p, level, rings, pointMap));
      }
      level.Contours.push_back(firstContour + static_cast<int>(l));
      this->Set.Contours.push_back(std::move(contour));
    }
    this->Set.Levels.push_back(std::move(level));
  }

  int PointOf(int p, const Level& level, const PlanarRings& rings, std::vector<int>& pointMap)
  {
    int& mapped = pointMap[p];
    if (mapped < 0)
    {
      mapped = static_cast<int>(this->Set.Points.size());
      const Point2& planar = rings.Points[p];
      const bool given = p < static_cast<int>(rings.InputPoint.size());
      this->Set.Planar.push_back(planar);
      this->Set.Points.push_back(
        given ? this->Soup.Points[rings.InputPoint[p]] : level.Frame.ToSpace(planar, level.Offset));
    }
    return mapped;
  }

  const LoopSoup& Soup;
  const ContourSetOptions& Options;
  Monitor& Progress;
  ContourNotes Notes;
  bool HasOpenLinesOnly = false;
  std::set<int> ExclusiveOrSources;
  std::vector<Ring> Rings;
  std::size_t Crossings = 0; ///< of the slices so far
  double Largest = 0;        ///< coordinate of all planes, so that they have one grid
  ContourSet Set;
};
}

ContourSet BuildContourSet(const LoopSoup& soup, const ContourSetOptions& options, Monitor& monitor)
{
  const double size = BoundsOf(soup).Diagonal();
  TipSections drawn = options.Parallel ? DrawTips(soup, size) : TipSections{ soup, {} };
  if (options.OpenLines == OpenLineRule::Border)
  {
    LinesAlongBorder closed = CloseAlongBorder(drawn.Soup, EndShare * size, monitor);
    drawn.Soup = std::move(closed.Soup);
    drawn.Report.insert(drawn.Report.end(), closed.Report.begin(), closed.Report.end());
  }
  ContourSet set = Builder(drawn.Soup, options, monitor).Build();
  set.Report.insert(set.Report.end(), drawn.Report.begin(), drawn.Report.end());
  return set;
}
}
