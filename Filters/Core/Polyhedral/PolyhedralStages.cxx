// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PolyhedralStages.h"

#include "Polyhedral/EndShapes.h"
#include "Polyhedral/LeftOut.h"
#include "Polyhedral/Lifting.h"
#include "Polyhedral/LiftTargets.h"
#include "Polyhedral/MapSlabs.h"
#include "Polyhedral/NeighbourPlaces.h"
#include "Polyhedral/PartialEnds.h"
#include "Polyhedral/SlabDiagram.h"
#include "Polyhedral/StageFront.h"
#include "Polyhedral/StageRunner.h"
#include "Polyhedral/StagesMemory.h"
#include "Polyhedral/VoronoiSkeleton.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// Cover points change their level and the two slabs at it, which can lay others bare; after two
/// rounds of them what is left are acute tips, which no point can cover.
constexpr std::size_t Rounds = 3;

/// The progress when it is known what is joined to what.
constexpr double MappedAt = 0.15;

/// How far the stack is taken on at a time: levels with so many contour points, and so many at least. What
/// is at work at once is that, and the dozen levels by which later stages come after earlier ones.
constexpr std::size_t PointsAtATime = 16384;
constexpr std::size_t LeastLevelsAtATime = 16;

/// Shares of the progress after the mapping, which add up to one; those of a round are of one round of three.
constexpr double TriangulatingShare = 0.175;
constexpr double SkeletonShare = 0.06;
constexpr double InsertingShare = 0.175;
constexpr double JoiningShare = 0.157;
constexpr double LiftingShare = 0.039;

/// What is known of a level only as long as those next to it are made.
struct PassingLevel
{
  std::vector<Point2> ExternalSkeleton;
  double Unit = 0;                              ///< of the last decimal of its contours
  std::vector<int> SkeletonTriangles;           ///< that hold the points of its InternalSkeleton
  std::array<EndShapesOfLevel, 2> ShapesOfEnds; ///< below and above, where they are extrapolated
};

/**
 * The stages of the method; every one is timed and takes its share of the progress bar.
 *
 * They go along the stack one behind the other, as far as each may by what it needs of the levels
 * above, and what is finished is handed on: so there is no need for all of the stack at once.
 */
class Builder
{
public:
  Builder(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor,
    double progressEnd, TetrahedraWanted wanted, bool keepsEarlier)
    : Contours(contours),
      Options(options),
      Wanted(wanted),
      KeepsEarlier(keepsEarlier),
      Runner(options.Threads, monitor, progressEnd),
      Spacing(contours.Spacing())
  {
    const std::size_t levels = contours.Levels.size();
    this->Levels.resize(levels);
    this->Passing.resize(levels);
    for (std::size_t i = 0; i < levels; ++i)
    {
      this->Levels[i].Offset = contours.Levels[i].Offset;
    }
    this->Slabs.resize(levels - 1);
    for (std::size_t i = 0; i < this->Slabs.size(); ++i)
    {
      this->Slabs[i].Thickness = this->Levels[i + 1].Offset - this->Levels[i].Offset;
    }
    this->InternalPlaces.resize(levels);
    this->SkeletonPlaces.resize(levels);
    this->Ends.resize(this->Slabs.size());
    this->Out.Earlier.Levels.resize(levels);
    this->Out.Earlier.Slabs.resize(this->Slabs.size());
    const StageFront ofLevels{ levels, 0 };
    const StageFront ofSlabs{ this->Slabs.size(), 0 };
    this->Triangulated = this->SkeletonsFound = this->Inserted = this->Finished = ofLevels;
    this->Fronts.fill(
      { ofSlabs, ofLevels, ofLevels, ofLevels, ofSlabs, ofLevels, ofSlabs, ofLevels });
  }

  PolyhedralStages Build(
    LevelAlignment alignment, std::unique_ptr<ContourSet> shifted, const StagesSink& sink)
  {
    this->Out.Report = alignment.Report;
    this->Out.Alignment = std::move(alignment);
    this->Out.Shifted = std::move(shifted);
    this->Runner.Timed("map contours",
      [&]
      {
        SubMonitor mapping = this->Runner.MonitorOf(0, MappedAt);
        this->Out.Mapping =
          MapSlabs(this->Contours, this->Options, this->Slabs, this->Out.Report, mapping);
        if (this->Extrapolates())
        {
          SubMonitor sections = this->Runner.MonitorOf(MappedAt, MappedAt);
          this->Shapes.emplace(this->Contours, this->Out.Mapping, this->Options, sections);
        }
      });
    this->Said.emplace(this->Contours, this->Options, this->Out.Mapping);
    this->BuildLevelsAndSlabs(sink);
    this->Said->Write(this->Out.Report);
    return std::move(this->Out);
  }

  PolyhedralStages BuildPart(const JoinsOfPart& joins)
  {
    this->Spacing = joins.Spacing;
    this->KnownDiagram = joins.KnownDiagram;
    for (std::size_t i = 0; i < this->Slabs.size(); ++i)
    {
      this->Slabs[i].Joins = joins.Joins[i];
    }
    this->BuildLevelsAndSlabs({});
    return std::move(this->Out);
  }

private:
  void BuildLevelsAndSlabs(const StagesSink& sink)
  {
    while (this->Finished.Done < this->Levels.size())
    {
      this->TriangulateLevels(this->NextEnd());
      this->InsertInternalPoints();
      for (std::size_t round = 0; round < Rounds; ++round)
      {
        const StageFront& before = round == 0 ? this->Inserted : this->Fronts[round - 1].Added;
        this->JoinDiagrams(round, before);
        this->LiftPoints(round, before);
        if (round + 1 < Rounds)
        {
          this->AddPointsWhereNeeded(round);
        }
      }
      this->FinishLevels();
      if (sink)
      {
        ForgetBelow(sink(this->Out, this->Finished.Done), this->Out);
      }
    }
    this->Out.Rounds = 1 + static_cast<int>(this->LastRoundAdded);
    this->Out.StageSeconds = this->Runner.GetSeconds();
  }

  /// Up to where levels are triangulated next.
  std::size_t NextEnd() const
  {
    std::size_t points = 0;
    std::size_t end = this->Triangulated.Done;
    for (std::size_t count = 0;
         end < this->Levels.size() && (count < LeastLevelsAtATime || points < PointsAtATime);
         ++count, ++end)
    {
      for (const int c : this->Contours.Levels[end].Contours)
      {
        points += this->Contours.Contours[c].Points.size();
      }
    }
    return end;
  }

  /// Takes a stage on, up to level or slab `end`. @param share of the progress, for all of the stack @param timed
  /// the name under which it is timed
  template <typename Body>
  void Advance(const char* timed, StageFront& front, std::size_t end, double share,
    const char* stage, const Body& body)
  {
    if (end <= front.Done)
    {
      return;
    }
    const std::size_t from = front.Done;
    const double before = this->Progress;
    this->Progress = std::min(1.0,
      before +
        (1 - MappedAt) * share * static_cast<double>(end - from) /
          static_cast<double>(front.Count));
    const auto run = [&](int i) { body(from + static_cast<std::size_t>(i)); };
    this->Runner.Timed(
      timed, [&] { this->Runner.ForAll(end - from, before, this->Progress, stage, run); });
    front.Done = end;
  }

  void TriangulateLevels(std::size_t end)
  {
    this->Advance("triangulate levels", this->Triangulated, end, TriangulatingShare,
      "triangulating slices",
      [&](std::size_t i)
      {
        const int level = static_cast<int>(i);
        this->Levels[i].Triangulator = std::make_unique<LevelTriangulator>(this->Contours, level);
        this->Passing[i].Unit = UnitOfLevel(this->Contours, level);
      });
  }

  bool RoundsOffPartialEnds() const
  {
    return this->Options.InternalPoints && this->Options.LiftInternalPoints &&
      PolyhedralOptions::IsRounded(this->Options.EndCaps);
  }

  bool Extrapolates() const { return this->Options.EndCaps == PolyhedralOptions::Extrapolated; }

  void InsertInternalPoints()
  {
    const std::size_t levels = this->Levels.size();
    const char* const timed = "insert internal points";
    this->Advance(timed, this->SkeletonsFound, this->Triangulated.Allows(levels, 0), SkeletonShare,
      "finding the middle of gaps", [&](std::size_t i) { this->FindSkeletons(i); });
    this->Advance(timed, this->Inserted, this->SkeletonsFound.Allows(levels, 1), InsertingShare,
      "adding points where branches meet", [&](std::size_t i) { this->InsertSkeletons(i); });
  }

  void FindSkeletons(std::size_t i)
  {
    if (!this->Options.InternalPoints)
    {
      return;
    }
    LevelState& level = this->Levels[i];
    const LevelTriangulation drawn = level.Triangulator->Finish();
    this->Passing[i].ExternalSkeleton = ExternalSkeletonVertices(drawn, this->Passing[i].Unit);
    if (this->RoundsOffPartialEnds())
    {
      level.InternalSkeleton = InternalSkeletonVertices(drawn, this->Passing[i].Unit);
    }
  }

  void InsertSkeletons(std::size_t i)
  {
    auto& triangulator = *this->Levels[i].Triangulator;
    if (i > 0)
    {
      triangulator.AddInternalPoints(
        this->Passing[i - 1].ExternalSkeleton, LevelTriangulation::LevelBelow);
    }
    if (i + 1 < this->Levels.size())
    {
      triangulator.AddInternalPoints(
        this->Passing[i + 1].ExternalSkeleton, LevelTriangulation::LevelAbove);
    }
    this->Levels[i].Triangulation = triangulator.Finish();
  }

  /// Tetrahedra of slabs, once more where points were added for ends and bare parts.
  void JoinDiagrams(std::size_t round, const StageFront& before)
  {
    StageFront& joined = this->Fronts[round].Joined;
    this->Advance("join Voronoi diagrams", joined, before.Allows(joined.Count, 1), JoiningShare,
      "filling the space between slices",
      [&](std::size_t i)
      {
        const LevelState& lower = this->Levels[i];
        const LevelState& upper = this->Levels[i + 1];
        if (lower.Changed || upper.Changed)
        {
          this->JoinDiagram(static_cast<int>(i), lower.Triangulation, upper.Triangulation);
        }
      });
  }

  void JoinDiagram(int index, const LevelTriangulation& lower, const LevelTriangulation& upper)
  {
    SlabState& slab = this->Slabs[index];
    this->KeepEarlier(index);
    if (std::optional<SlabTetrahedra> known =
          this->KnownDiagram ? this->KnownDiagram(index, lower, upper) : std::nullopt)
    {
      slab.Diagram = std::move(*known);
      return;
    }
    slab.Diagram = BuildSlabDiagram(lower, upper, slab.Joins, this->Wanted);
  }

  /// What the slab was before its levels changed.
  void KeepEarlier(int slab)
  {
    SlabTetrahedra& diagram = this->Slabs[slab].Diagram;
    if (!this->KeepsEarlier || diagram.Tetrahedra.empty())
    {
      return;
    }
    const auto before = [this](int level)
    { return this->Out.Earlier.Levels[level].size() - (this->Levels[level].Changed ? 1 : 0); };
    this->Out.Earlier.Slabs[slab].push_back({ before(slab), before(slab + 1), std::move(diagram) });
  }

  const SlabTetrahedra* DiagramOrNull(int slab) const
  {
    const bool exists = slab >= 0 && slab < static_cast<int>(this->Slabs.size());
    return exists ? &this->Slabs[slab].Diagram : nullptr;
  }

  const LevelState* LevelOrNull(int i) const
  {
    return i >= 0 && i < static_cast<int>(this->Levels.size()) ? &this->Levels[i] : nullptr;
  }

  void LiftPoints(std::size_t round, const StageFront& before)
  {
    RoundFronts& fronts = this->Fronts[round];
    const std::size_t levels = this->Levels.size();
    const char* const stage = "shaping branches and ends";
    const char* const timed = "lift internal points";
    this->Advance(timed, fronts.Covered, fronts.Joined.Allows(levels, 0), 0, stage,
      [&](std::size_t i) { this->FindCovered(i); });
    this->Advance(timed, fronts.Located, before.Allows(levels, 2), 0, stage,
      [&](std::size_t i)
      {
        if (this->AnyChanged(i, 2, 2))
        {
          LocateInternalPoints(this->Levels, i, this->InternalPlaces);
        }
      });
    this->Advance(timed, fronts.Outside, fronts.Located.Allows(levels, 1), 0, stage,
      [&](std::size_t i)
      {
        if (this->AnyChanged(i, 1, 1))
        {
          FindPointsOutsideNeighbours(this->Levels, i, this->InternalPlaces[i]);
        }
        this->InternalPlaces[i] = {};
      });
    const std::size_t end = std::min(
      fronts.Covered.Allows(this->Slabs.size(), 2), fronts.Outside.Allows(this->Slabs.size(), 1));
    this->Advance(timed, fronts.Lifted, end, LiftingShare, stage,
      [&](std::size_t i) { this->LiftSlab(static_cast<int>(i)); });
  }

  void FindCovered(std::size_t i)
  {
    if (!this->AnyChanged(i, 1, 1))
    {
      return;
    }
    LevelState& level = this->Levels[i];
    if (!level.Distance)
    {
      // Added points cut contour edges but do not move them.
      level.Distance = std::make_unique<PlanarContourDistance>(level.Triangulation);
    }
    const int index = static_cast<int>(i);
    level.Covered = FindCoverage(level.Triangulation, this->DiagramOrNull(index - 1),
      this->DiagramOrNull(index), this->Options.IsolatedContours == PolyhedralOptions::Extrude);
    for (const int towards : { -1, 1 })
    {
      if (this->Shapes)
      {
        this->Passing[i].ShapesOfEnds[towards > 0 ? 1 : 0] =
          this->Shapes->Find(level, index, towards);
      }
    }
  }

  void LiftSlab(int i)
  {
    // What is covered on a level follows from both slabs at it, and so from their levels.
    if (!this->AnyChanged(static_cast<std::size_t>(i), 1, 2))
    {
      return;
    }
    LiftInternalPoints(this->Levels[i], this->Levels[i + 1], this->Slabs[i].Diagram,
      this->TargetsOf(i, 1), this->TargetsOf(i + 1, -1));
    // Beyond the first and the last level nothing is in the way.
    if (i == 0)
    {
      this->Levels.front().Lifted.Below = this->TargetsOf(0, -1);
    }
    if (i + 1 == static_cast<int>(this->Slabs.size()))
    {
      this->Levels.back().Lifted.Above = this->TargetsOf(i + 1, 1);
    }
  }

  /// Whether points were added in the last round to this level or one of so many below or above it.
  bool AnyChanged(std::size_t level, std::size_t below, std::size_t above) const
  {
    const auto end = this->Levels.begin() +
      static_cast<std::ptrdiff_t>(std::min(this->Levels.size(), level + above + 1));
    const auto begin =
      this->Levels.begin() + static_cast<std::ptrdiff_t>(level - std::min(level, below));
    return std::any_of(begin, end, [](const LevelState& other) { return other.Changed; });
  }

  /// towards: 1 above, -1 below.
  std::vector<double> TargetsOf(int level, int towards) const
  {
    const LiftSide side{ &this->Levels[level], this->LevelOrNull(level + towards),
      this->LevelOrNull(level - towards), towards, this->ThicknessForCaps(level, towards),
      this->Shapes ? &this->Passing[level].ShapesOfEnds[towards > 0 ? 1 : 0] : nullptr };
    return FindLiftTargets(side, this->Options);
  }

  /// Of the slab on that side, or of the last one; of one that is a gap the median one, as half of
  /// it would be out of proportion.
  double ThicknessForCaps(int level, int towards) const
  {
    const int last = static_cast<int>(this->Slabs.size()) - 1;
    const SlabState& slab = this->Slabs[std::clamp(towards > 0 ? level : level - 1, 0, last)];
    return slab.Joins.IsGap ? this->Spacing : slab.Thickness;
  }

  void FindEndsOfSlab(int i)
  {
    const auto side = [&](int level, int towards)
    {
      const NeighbourPlaces& places = this->SkeletonPlaces[level];
      return SkeletonSide{ &this->Levels[level], this->LevelOrNull(level - towards),
        &this->Passing[level].SkeletonTriangles, towards > 0 ? &places.Above : &places.Below,
        towards > 0 ? &places.Below : &places.Above };
    };
    this->Ends[i] = FindPartialEnds(this->Slabs[i].Diagram, side(i, 1), side(i + 1, -1));
  }

  /// In the first round points for ends, too, and not only for what is bare.
  void AddPointsWhereNeeded(std::size_t round)
  {
    RoundFronts& fronts = this->Fronts[round];
    const std::size_t levels = this->Levels.size();
    const bool partialEnds = round == 0 && this->RoundsOffPartialEnds();
    const char* const timed = "cap ends and cover bare parts";
    std::size_t end = std::min(fronts.Lifted.Allows(levels, 1), fronts.Outside.Allows(levels, 1));
    if (partialEnds)
    {
      const char* const stage = "rounding off ends";
      this->Advance(timed, fronts.SkeletonLocated, fronts.Located.Allows(levels, 0), 0, stage,
        [&](std::size_t i)
        {
          this->Passing[i].SkeletonTriangles =
            this->Levels[i].Triangulator->Locate(this->Levels[i].InternalSkeleton);
          LocateInternalSkeletons(this->Levels, i, this->SkeletonPlaces);
        });
      const std::size_t slabs = std::min(fronts.SkeletonLocated.Allows(this->Slabs.size(), 2),
        fronts.Covered.Allows(this->Slabs.size(), 2));
      this->Advance(timed, fronts.Ended, slabs, 0, stage,
        [&](std::size_t i) { this->FindEndsOfSlab(static_cast<int>(i)); });
      end = std::min(end, fronts.Ended.Allows(levels, 1));
    }
    const std::size_t from = fronts.Added.Done;
    this->Advance(timed, fronts.Added, end, 0, "covering what is bare",
      [&](std::size_t i)
      {
        const bool anyEnds = partialEnds &&
          AddPartialEnds(*this->Levels[i].Triangulator, i > 0 ? &this->Ends[i - 1] : nullptr,
            i < this->Ends.size() ? &this->Ends[i] : nullptr);
        this->AddCapAndCoverPoints(i, round == 0, anyEnds);
      });
    for (std::size_t i = from; i < end; ++i)
    {
      this->LastRoundAdded =
        this->Levels[i].Changed ? std::max(this->LastRoundAdded, round + 1) : this->LastRoundAdded;
    }
  }

  /// anyEnds: the triangulator was changed already.
  void AddCapAndCoverPoints(std::size_t index, bool first, bool anyEnds)
  {
    LevelState& level = this->Levels[index];
    const bool round = first && PolyhedralOptions::IsRounded(this->Options.EndCaps);
    const std::vector<Point2> bare =
      FindCoverPoints(level.Triangulation, level.Covered, level.Lifted);
    const std::vector<Point2> caps = round ? FindEndCapPoints(level.Triangulation, level.Covered,
                                               this->Passing[index].Unit, this->Extrapolates())
                                           : std::vector<Point2>();
    level.Changed = anyEnds || !bare.empty() || !caps.empty();
    if (!level.Changed)
    {
      return;
    }
    level.Triangulator->AddInternalPoints(caps, LevelTriangulation::EndCap);
    if (!bare.empty())
    {
      level.Triangulator->AddCoverPoints(bare);
    }
    if (this->KeepsEarlier)
    {
      this->Out.Earlier.Levels[index].push_back(std::move(level.Triangulation));
    }
    level.Triangulation = level.Triangulator->Finish();
  }

  /// Levels that no stage changes or asks any more, and the slabs below them.
  void FinishLevels()
  {
    const std::size_t from = this->Finished.Done;
    // A slab is lifted by distances from the contours of two levels on either side.
    const std::size_t end = this->Fronts.back().Lifted.Allows(this->Levels.size(), 1);
    for (std::size_t i = from; i < end; ++i)
    {
      LevelState& level = this->Levels[i];
      level.Needles = level.Triangulator->Needles();
      // These take more memory than all that is handed on.
      level.Triangulator.reset();
      level.Distance.reset();
      level.InternalSkeleton = {};
      this->Passing[i] = {};
      this->SkeletonPlaces[i] = {};
      if (this->Said)
      {
        this->Said->AddLevel(level);
      }
      if (i > 0)
      {
        this->Ends[i - 1] = {};
        if (this->Said)
        {
          this->Said->AddSlab(
            static_cast<int>(i - 1), this->Levels[i - 1], level, this->Slabs[i - 1].Diagram);
        }
      }
    }
    this->Finished.Done = end;
  }

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  TetrahedraWanted Wanted;
  bool KeepsEarlier;
  StageRunner Runner;
  double Spacing; ///< of the whole stack
  double Progress = MappedAt;
  decltype(JoinsOfPart::KnownDiagram) KnownDiagram;
  std::optional<EndShapes> Shapes; ///< where ends are extrapolated
  std::optional<StageReport> Said; ///< of a whole stack
  std::vector<PassingLevel> Passing;
  std::vector<NeighbourPlaces> InternalPlaces; ///< of internal points, by level
  std::vector<NeighbourPlaces> SkeletonPlaces; ///< of internal skeletons, by level
  std::vector<EndsOfSlab> Ends;                ///< by slab
  StageFront Triangulated;                     ///< levels, as the next two
  StageFront SkeletonsFound;
  StageFront Inserted;
  std::array<RoundFronts, Rounds> Fronts;
  StageFront Finished;            ///< levels
  std::size_t LastRoundAdded = 0; ///< the last round in which points were added, from one; 0 = none
  PolyhedralStages Out;
  std::vector<LevelState>& Levels = Out.Levels;
  std::vector<SlabState>& Slabs = Out.Slabs;
};
}

PolyhedralStages BuildPolyhedralStages(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, double progressEnd, TetrahedraWanted wanted, bool keepsEarlier,
  const StagesSink& sink)
{
  RequireParallelLevels(contours);
  LevelAlignment alignment = FindLevelAlignment(contours, options.AlignLevels, options.ForcedJoins);
  auto shifted = alignment.IsEmpty() ? std::unique_ptr<ContourSet>()
                                     : std::make_unique<ContourSet>(Aligned(contours, alignment));
  Builder builder(
    shifted ? *shifted : contours, options, monitor, progressEnd, wanted, keepsEarlier);
  return builder.Build(std::move(alignment), std::move(shifted), sink);
}

PolyhedralStages BuildStagesOfPart(const ContourSet& part, const JoinsOfPart& joins,
  const PolyhedralOptions& options, Monitor& monitor, double progressEnd, TetrahedraWanted wanted)
{
  return Builder(part, options, monitor, progressEnd, wanted, true).BuildPart(joins);
}

void RequireParallelLevels(const ContourSet& contours)
{
  if (!contours.Parallel)
  {
    throw Error(
      "The contours lie in planes of several directions; the polyhedral surface needs parallel "
      "planes. Use Implicit Surface for these.");
  }
  if (contours.Levels.size() < 2)
  {
    throw Error(contours.Warning.empty()
        ? "The contours lie in one plane only; a solid needs at least two parallel levels."
        : contours.Warning);
  }
}
}
