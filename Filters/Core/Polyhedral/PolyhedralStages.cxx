// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PolyhedralStages.h"

#include "Base/Parallel.h"
#include "Planar/PlanarContourDistance.h"
#include "Polyhedral/Lifting.h"
#include "Polyhedral/LiftTargets.h"
#include "Polyhedral/PartialEnds.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <sstream>

namespace recon
{
namespace
{
/// Cover points change their level and the two slabs at it, which can lay others bare; after two
/// rounds of them what is left are acute tips, which no point can cover.
constexpr int Rounds = 3;

/// The stages of the method in their order; every one is timed and takes its share of the progress
/// bar.
class Builder
{
public:
  Builder(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor,
    double progressEnd)
    : Contours(contours),
      Options(options),
      Observer(monitor),
      ProgressEnd(progressEnd),
      LevelCount(static_cast<int>(contours.Levels.size()))
  {
  }

  PolyhedralStages Build()
  {
    this->MapContours();
    this->TriangulateLevels();
    this->Timed("insert internal points", [&] { this->InsertInternalPoints(); });
    for (int i = 0; i < this->LevelCount; ++i)
    {
      this->Out.Levels.push_back({ &this->Out.Triangulations[i], this->Contours.Levels[i].Offset });
    }
    this->BuildSlabs();
    this->ReportJoinsNotMade();
    this->ReportContoursLeftOut();
    return std::move(this->Out);
  }

private:
  template <typename Work>
  void Timed(const char* stage, Work work)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    for (auto& known : this->Out.StageSeconds)
    {
      if (known.first == stage)
      {
        known.second += elapsed.count();
        return;
      }
    }
    this->Out.StageSeconds.emplace_back(stage, elapsed.count());
  }

  /// body(i) for every level or slab on the threads that the user allows.
  template <typename Body>
  void ForAll(int count, double from, double to, const char* stage, Body body)
  {
    ParallelFor(count, this->Options.Threads, body, this->Observer,
      { from * this->ProgressEnd, to * this->ProgressEnd, stage });
  }

  void MapContours()
  {
    this->Out.Joins.resize(this->LevelCount - 1);
    const bool overlap = this->Options.Mapping == PolyhedralOptions::Overlap;
    const std::vector<unsigned char> gaps = FindGaps(this->Contours, this->Options.MaximumGap);
    for (int i = 0; i + 1 < this->LevelCount; ++i)
    {
      this->Out.Joins[i].IsGap = gaps[i] != 0;
      this->Out.Joins[i].AllByDefault = !overlap && gaps[i] == 0;
      if (gaps[i] != 0)
      {
        this->ReportGap(i);
      }
    }
    if (!overlap && this->Options.ForbiddenJoins.empty() && this->Options.ForcedJoins.empty())
    {
      return;
    }
    ContourMappingOptions options;
    options.OverlapThreshold = this->Options.OverlapThreshold;
    options.ForcedJoins = this->Options.ForcedJoins;
    options.ForbiddenJoins = this->Options.ForbiddenJoins;
    options.MaximumGap = this->Options.MaximumGap;
    options.Threads = this->Options.Threads;
    this->Timed("map contours",
      [&] { this->Out.Mapping = BuildContourMapping(this->Contours, options, this->Observer); });
    const auto& report = this->Out.Mapping.Report;
    this->Out.Report.insert(this->Out.Report.end(), report.begin(), report.end());
    for (const ContourJoin& join : this->Out.Mapping.Joins)
    {
      this->UseJoin(join);
    }
  }

  void ReportGap(int slab)
  {
    std::ostringstream line;
    line << "The levels at offsets " << this->Contours.Levels[slab].Offset << " and "
         << this->Contours.Levels[slab + 1].Offset << " are "
         << this->Thickness(slab) / this->MedianThickness()
         << " times the usual spacing apart and are not joined; MaximumGap is "
         << this->Options.MaximumGap << ", and 0 joins all.";
    this->Out.Report.push_back(line.str());
  }

  void UseJoin(const ContourJoin& join)
  {
    if (join.LowerRegion < 0 || join.UpperRegion < 0)
    {
      return;
    }
    const auto& lower = this->Out.Mapping.Regions[join.LowerRegion];
    const auto& upper = this->Out.Mapping.Regions[join.UpperRegion];
    SlabJoins& joins = this->Out.Joins[join.Slab];
    const bool exception = joins.AllByDefault ? join.Rule == ContourJoin::Forbidden : join.Joined;
    if (lower.Solid && upper.Solid && exception)
    {
      joins.Exceptions.insert({ lower.Wall, upper.Wall });
    }
  }

  void TriangulateLevels()
  {
    this->Triangulators.resize(this->LevelCount);
    this->Out.Triangulations.resize(this->LevelCount);
    this->Timed("triangulate levels",
      [&]
      {
        this->ForAll(this->LevelCount, 0, 0.3, "triangulating levels",
          [&](int i)
          { this->Triangulators[i] = std::make_unique<LevelTriangulator>(this->Contours, i); });
      });
  }

  void InsertInternalPoints()
  {
    std::vector<std::vector<Point2>> skeletons(this->LevelCount);
    this->InternalSkeletons.resize(this->LevelCount);
    if (this->Options.InternalPoints)
    {
      this->ForAll(this->LevelCount, 0.3, 0.35, "tracing Voronoi skeletons",
        [&](int i)
        {
          skeletons[i] = this->Triangulators[i]->ExternalVoronoiVertices();
          if (this->RoundsOffPartialEnds())
          {
            this->InternalSkeletons[i] = this->Triangulators[i]->InternalVoronoiVertices();
          }
        });
    }
    this->ForAll(this->LevelCount, 0.35, 0.5, "inserting internal points",
      [&](int i)
      {
        auto& triangulator = *this->Triangulators[i];
        if (i > 0)
        {
          triangulator.AddInternalPoints(skeletons[i - 1], LevelTriangulation::LevelBelow);
        }
        if (i + 1 < this->LevelCount)
        {
          triangulator.AddInternalPoints(skeletons[i + 1], LevelTriangulation::LevelAbove);
        }
        this->Out.Triangulations[i] = triangulator.Finish();
      });
  }

  /// Tetrahedra and heights of all slabs, once more where points were added for ends and bare
  /// parts.
  void BuildSlabs()
  {
    this->Out.Slabs.resize(this->LevelCount - 1);
    this->Out.Coverages.resize(this->LevelCount);
    this->Out.Lifted.resize(this->LevelCount);
    std::vector<unsigned char> changed(this->LevelCount, 1);
    for (int round = 0; round < Rounds; ++round)
    {
      const double from = 0.5 + 0.5 * round / Rounds;
      const double middle = from + 0.4 / Rounds;
      const double to = from + 0.5 / Rounds;
      this->Timed("join Voronoi diagrams",
        [&]
        {
          this->ForAll(this->LevelCount - 1, from, middle, "joining Voronoi diagrams",
            [&](int i) { this->BuildSlab(i, changed[i] || changed[i + 1]); });
        });
      this->Timed("lift internal points", [&] { this->LiftPoints(middle, to, changed); });
      if (round + 1 == Rounds || !this->AddPointsWhereNeeded(round, changed))
      {
        return;
      }
    }
  }

  void BuildSlab(int i, bool changed)
  {
    if (changed)
    {
      const auto& level1 = this->Out.Triangulations[i];
      const auto& level2 = this->Out.Triangulations[i + 1];
      this->Out.Slabs[i] = BuildJointVoronoi(level1, level2);
      EliminateTetrahedra(level1, level2, this->Out.Joins[i], this->Out.Slabs[i]);
    }
  }

  bool RoundsOffPartialEnds() const
  {
    return this->Options.InternalPoints && this->Options.LiftInternalPoints &&
      this->Options.EndCaps == PolyhedralOptions::Tapered;
  }

  const SlabTetrahedra* SlabOrNull(int i) const
  {
    return i >= 0 && i + 1 < this->LevelCount ? &this->Out.Slabs[i] : nullptr;
  }

  const PlanarContourDistance* DistanceOrNull(int i) const
  {
    return i >= 0 && i < this->LevelCount ? this->Distances[i].get() : nullptr;
  }

  /// Of points of every level the triangles of the levels next to it that hold them, or -1.
  struct Places
  {
    std::vector<std::vector<int>> Below, Above;
  };

  Places LocateInNeighbours(const std::vector<std::vector<Point2>>& points)
  {
    Places places;
    places.Below.resize(this->LevelCount);
    places.Above.resize(this->LevelCount);
    // By the level that is asked: no two threads may ask one triangulation.
    this->ForAll(this->LevelCount, this->Reached, this->Reached, "lifting internal points",
      [&](int i)
      {
        if (i > 0)
        {
          places.Above[i - 1] = this->Triangulators[i]->Locate(points[i - 1]);
        }
        if (i + 1 < this->LevelCount)
        {
          places.Below[i + 1] = this->Triangulators[i]->Locate(points[i + 1]);
        }
      });
    return places;
  }

  static std::vector<int> InternalPointsOf(const LevelTriangulation& level)
  {
    std::vector<int> internal;
    for (std::size_t p = 0; p < level.Points.size(); ++p)
    {
      if (level.Kind[p] == PolyhedralSurface::Internal)
      {
        internal.push_back(static_cast<int>(p));
      }
    }
    return internal;
  }

  void FindPointsOutsideNeighbours()
  {
    std::vector<std::vector<Point2>> points(this->LevelCount);
    for (int i = 0; i < this->LevelCount; ++i)
    {
      const auto& level = this->Out.Triangulations[i];
      for (int p : InternalPointsOf(level))
      {
        points[i].push_back(level.Points[p]);
      }
    }
    const Places places = this->LocateInNeighbours(points);
    this->OutsideBelow.resize(this->LevelCount);
    this->OutsideAbove.resize(this->LevelCount);
    for (int i = 0; i < this->LevelCount; ++i)
    {
      this->OutsideBelow[i] = this->OutsideOf(i, i - 1, places.Below[i]);
      this->OutsideAbove[i] = this->OutsideOf(i, i + 1, places.Above[i]);
    }
  }

  /// Of every point of a level whether it is internal and lies outside the neighbour's contours.
  std::vector<unsigned char> OutsideOf(
    int level, int neighbour, const std::vector<int>& triangles) const
  {
    std::vector<unsigned char> outside(this->Out.Triangulations[level].Points.size(), 0);
    if (neighbour < 0 || neighbour >= this->LevelCount)
    {
      return outside;
    }
    const auto& other = this->Out.Triangulations[neighbour];
    const std::vector<int> internal = InternalPointsOf(this->Out.Triangulations[level]);
    for (std::size_t i = 0; i < internal.size(); ++i)
    {
      outside[internal[i]] = triangles[i] < 0 || !other.Inside[triangles[i]] ? 1 : 0;
    }
    return outside;
  }

  /// changed: levels whose triangulation is new in this round.
  void LiftPoints(double from, double to, const std::vector<unsigned char>& changed)
  {
    this->Reached = from;
    this->Distances.resize(this->LevelCount);
    this->ForAll(this->LevelCount, from, from, "lifting internal points",
      [&](int i)
      {
        const auto& level = this->Out.Triangulations[i];
        if (!this->Distances[i])
        {
          // Added points cut contour edges but do not move them.
          this->Distances[i] = std::make_unique<PlanarContourDistance>(level);
        }
        this->Out.Coverages[i] = FindCoverage(level, this->SlabOrNull(i - 1), this->SlabOrNull(i),
          this->Options.IsolatedContours == PolyhedralOptions::Extrude);
      });
    this->FindPointsOutsideNeighbours();
    const auto targets = [&](int level, int neighbour)
    {
      const int other = std::clamp(neighbour, 0, this->LevelCount - 1);
      return FindLiftTargets(
        this->SideOf(level, neighbour, *this->Distances[level], *this->Distances[other]),
        this->Options);
    };
    this->ForAll(this->LevelCount - 1, from, to, "lifting internal points",
      [&](int i)
      {
        // What is covered on a level follows from both slabs at it, and so from their levels.
        const auto first = changed.begin() + std::max(0, i - 1);
        const auto last = changed.begin() + std::min(this->LevelCount, i + 3);
        if (std::find(first, last, 1) != last)
        {
          LiftInternalPoints(this->Out.Levels[i], this->Out.Levels[i + 1], this->Out.Slabs[i],
            targets(i, i + 1), targets(i + 1, i), this->Out.Lifted[i], this->Out.Lifted[i + 1]);
        }
      });
    // Beyond the first and the last level nothing is in the way.
    this->Out.Lifted.front().Below = targets(0, -1);
    this->Out.Lifted.back().Above = targets(this->LevelCount - 1, this->LevelCount);
  }

  LiftSide SideOf(int level, int neighbour, const PlanarContourDistance& distance,
    const PlanarContourDistance& otherDistance) const
  {
    const int sign = neighbour > level ? 1 : -1;
    const bool exists = neighbour >= 0 && neighbour < this->LevelCount;
    LiftSide side;
    side.Level = &this->Out.Levels[level];
    side.Distance = &distance;
    side.Covered = &this->Out.Coverages[level];
    side.Towards = sign > 0 ? LevelTriangulation::LevelAbove : LevelTriangulation::LevelBelow;
    side.OtherDistance = exists ? &otherDistance : nullptr;
    side.BehindDistance = this->DistanceOrNull(level - sign);
    side.OutsideOther = sign > 0 ? &this->OutsideAbove[level] : &this->OutsideBelow[level];
    side.Slab = exists ? this->Contours.Levels[neighbour].Offset - side.Level->Offset : 0;
    side.EndSlab = sign *
      this->ThicknessForCaps(exists ? std::min(level, neighbour) : (sign > 0 ? level - 1 : level));
    return side;
  }

  /// Of the slab itself; of one that is a gap the median one, as half of it would be out of
  /// proportion.
  double ThicknessForCaps(int slab) const
  {
    return this->Out.Joins[slab].IsGap ? this->MedianThickness() : this->Thickness(slab);
  }

  /// The lower median, so that one gap between two slices counts.
  double MedianThickness() const
  {
    std::vector<double> all;
    for (int i = 0; i + 1 < this->LevelCount; ++i)
    {
      all.push_back(this->Thickness(i));
    }
    const auto median = all.begin() + (all.size() - 1) / 2;
    std::nth_element(all.begin(), median, all.end());
    return *median;
  }

  double Thickness(int slab) const
  {
    return this->Contours.Levels[slab + 1].Offset - this->Contours.Levels[slab].Offset;
  }

  /// By slab the points of the lower and of the upper level.
  std::vector<std::array<std::vector<Point2>, 2>> FindPartialEndsOfSlabs()
  {
    std::vector<std::vector<int>> own(this->LevelCount);
    this->ForAll(this->LevelCount, this->Reached, this->Reached, "rounding off ends",
      [&](int i) { own[i] = this->Triangulators[i]->Locate(this->InternalSkeletons[i]); });
    const Places places = this->LocateInNeighbours(this->InternalSkeletons);
    const auto side = [&](int i, int towards)
    {
      const int behind = i - towards;
      const bool hasBehind = behind >= 0 && behind < this->LevelCount;
      const auto& other = towards > 0 ? places.Above[i] : places.Below[i];
      const auto& back = towards > 0 ? places.Below[i] : places.Above[i];
      return SkeletonSide{ &this->Out.Triangulations[i], this->Distances[i].get(),
        this->DistanceOrNull(behind), &this->InternalSkeletons[i], &own[i], &other,
        hasBehind ? &this->Out.Triangulations[behind] : nullptr, &back };
    };
    std::vector<std::array<std::vector<Point2>, 2>> ends(this->LevelCount - 1);
    this->ForAll(this->LevelCount - 1, this->Reached, this->Reached, "rounding off ends",
      [&](int i) { ends[i] = FindPartialEnds(this->Out.Slabs[i], side(i, 1), side(i + 1, -1)); });
    return ends;
  }

  /// Returns whether there were any at that level.
  bool AddPartialEnds(int level, const std::vector<std::array<std::vector<Point2>, 2>>& endsOfSlabs)
  {
    auto& triangulator = *this->Triangulators[level];
    bool any = false;
    if (level > 0)
    {
      const auto& below = endsOfSlabs[level - 1];
      triangulator.AddInternalPoints(below[1], LevelTriangulation::LevelBelow);
      triangulator.AddExternalPoints(below[0]);
      any = !below[0].empty() || !below[1].empty();
    }
    if (level + 1 < this->LevelCount)
    {
      const auto& above = endsOfSlabs[level];
      triangulator.AddInternalPoints(above[0], LevelTriangulation::LevelAbove);
      triangulator.AddExternalPoints(above[1]);
      any = any || !above[0].empty() || !above[1].empty();
    }
    return any;
  }

  /// Returns whether any level was changed, and which.
  bool AddPointsWhereNeeded(int round, std::vector<unsigned char>& changed)
  {
    const bool taper = round == 0 && this->Options.EndCaps == PolyhedralOptions::Tapered;
    const double from = 0.5 + 0.5 * (round + 1) / Rounds;
    this->Reached = from;
    changed.assign(this->LevelCount, 0);
    this->Timed("cap ends and cover bare parts",
      [&]
      {
        const bool partialEnds = taper && this->RoundsOffPartialEnds();
        const auto ends = partialEnds ? this->FindPartialEndsOfSlabs()
                                      : std::vector<std::array<std::vector<Point2>, 2>>();
        this->ForAll(this->LevelCount, from, from, "covering bare parts",
          [&](int i)
          {
            const auto& level = this->Out.Triangulations[i];
            const auto& coverage = this->Out.Coverages[i];
            const std::vector<Point2> bare = FindCoverPoints(level, coverage, this->Out.Lifted[i]);
            const std::vector<Point2> caps =
              taper ? FindEndCapPoints(level, coverage) : std::vector<Point2>();
            const bool anyEnds = partialEnds && this->AddPartialEnds(i, ends);
            if (bare.empty() && caps.empty() && !anyEnds)
            {
              return;
            }
            this->Triangulators[i]->AddInternalPoints(caps, LevelTriangulation::EndCap);
            if (!bare.empty())
            {
              this->Triangulators[i]->AddCoverPoints(bare);
            }
            this->Out.Triangulations[i] = this->Triangulators[i]->Finish();
            changed[i] = 1;
          });
      });
    return std::count(changed.begin(), changed.end(), 1) > 0;
  }

  /// A join that was asked for and that no tetrahedron makes is reported, not ignored.
  void ReportJoinsNotMade()
  {
    for (const ContourJoin& join : this->Out.Mapping.Joins)
    {
      if (join.Rule != ContourJoin::Forced || join.LowerRegion < 0 || join.UpperRegion < 0)
      {
        continue;
      }
      const int lower = this->Out.Mapping.Regions[join.LowerRegion].Wall;
      const int upper = this->Out.Mapping.Regions[join.UpperRegion].Wall;
      if (!this->IsMade(join.Slab, lower, upper))
      {
        std::ostringstream line;
        line << "The join of contours " << lower << " and " << upper
             << " was asked for but cannot be made: other contours lie between them, so that their "
                "Voronoi regions do not meet.";
        this->Out.Report.push_back(line.str());
      }
    }
  }

  bool IsMade(int slab, int lower, int upper) const
  {
    const auto& level1 = this->Out.Triangulations[slab];
    const auto& level2 = this->Out.Triangulations[slab + 1];
    const auto& tetrahedra = this->Out.Slabs[slab].Tetrahedra;
    return std::any_of(tetrahedra.begin(), tetrahedra.end(),
      [&](const auto& t)
      {
        return t.Reason == SlabTetrahedra::Kept && t.NodeType == SlabTetrahedra::T12 &&
          RegionAtEdge(level1, t.Origin[0]) == lower && RegionAtEdge(level2, t.Origin[1]) == upper;
      });
  }

  /**
   * Contours of isolated regions are not part of the surface and are named. A contour that touches
   * another or is touched by its holes may bound several regions, some of which are.
   */
  void ReportContoursLeftOut()
  {
    if (this->Options.IsolatedContours == PolyhedralOptions::Extrude)
    {
      return;
    }
    std::vector<unsigned char> bounds(this->Contours.Contours.size(), 0);
    for (int i = 0; i < this->LevelCount; ++i)
    {
      const auto& level = this->Out.Triangulations[i];
      for (std::size_t t = 0; t < level.Triangles.size(); ++t)
      {
        for (int contour : level.EdgeContour[t])
        {
          if (contour >= 0 && level.Inside[t])
          {
            bounds[contour] |= this->Out.Coverages[i].Isolated[t] ? Isolated : Kept;
          }
        }
      }
    }
    for (std::size_t c = 0; c < bounds.size(); ++c)
    {
      if (bounds[c] & Isolated)
      {
        this->ReportContourLeftOut(static_cast<int>(c), (bounds[c] & Kept) != 0);
      }
    }
  }

  void ReportContourLeftOut(int c, bool inPart)
  {
    const Contour& contour = this->Contours.Contours[c];
    std::ostringstream line;
    line << "Contour " << c << " (level " << contour.Level << ", offset "
         << this->Contours.Levels[contour.Level].Offset << ", " << contour.Points.size()
         << " points): left out"
         << (inPart ? " in part, as it bounds several regions that only touch and one of them is "
                      "joined to no contour of the levels next to it"
                    : ", as it is joined to no contour of the levels next to it")
         << "; set IsolatedContours to Extrude to keep it as a slice"
         << (this->Options.Mapping == PolyhedralOptions::Overlap
                ? ", or Mapping to Proximity to join it to what is near."
                : ".");
    this->Out.Report.push_back(line.str());
  }

  /// What a contour bounds, as bits.
  static constexpr unsigned char Kept = 1;
  static constexpr unsigned char Isolated = 2;

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  Monitor& Observer;
  double ProgressEnd;
  int LevelCount;
  std::vector<std::unique_ptr<LevelTriangulator>> Triangulators;
  std::vector<std::unique_ptr<PlanarContourDistance>> Distances; ///< by level
  std::vector<std::vector<Point2>> InternalSkeletons; ///< by level; empty where not wanted
  std::vector<std::vector<unsigned char>> OutsideBelow, OutsideAbove; ///< by level, of its points
  double Reached = 0; ///< progress at which a stage without a share of its own is
  PolyhedralStages Out;
};
}

PolyhedralStages BuildPolyhedralStages(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, double progressEnd)
{
  if (!contours.Parallel)
  {
    throw Error(
      "The contours lie in planes of several directions; the polyhedral surface needs parallel "
      "planes. Use Implicit Surface for these.");
  }
  if (contours.Levels.size() < 2)
  {
    throw Error("The contours lie in one plane only; a solid needs at least two parallel levels.");
  }
  return Builder(contours, options, monitor, progressEnd).Build();
}
}
