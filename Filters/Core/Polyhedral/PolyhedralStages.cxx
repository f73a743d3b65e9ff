// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PolyhedralStages.h"

#include "Polyhedral/BoundaryVoronoi.h"
#include "Polyhedral/Elimination.h"
#include "Polyhedral/EndShapes.h"
#include "Polyhedral/LeftOut.h"
#include "Polyhedral/Lifting.h"
#include "Polyhedral/LiftTargets.h"
#include "Polyhedral/MapSlabs.h"
#include "Polyhedral/NeedleContours.h"
#include "Polyhedral/NeighbourPlaces.h"
#include "Polyhedral/PartialEnds.h"
#include "Polyhedral/StageRunner.h"
#include "Polyhedral/VoronoiSkeleton.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// Cover points change their level and the two slabs at it, which can lay others bare; after two
/// rounds of them what is left are acute tips, which no point can cover.
constexpr int Rounds = 3;

/// The progress when it is known what is joined to what.
constexpr double MappedAt = 0.15;

/// Drawn contours have at most a few T12 a triangle; with more than this it is quicker, and takes
/// far less memory, to make those at the boundary only.
constexpr std::size_t MostT12ATriangle = 8;

/// By slab the points of the lower and of the upper level at which a part of it ends in the slab.
using EndsOfSlabs = std::vector<std::array<std::vector<Point2>, 2>>;

/// The stages of the method in their order; every one is timed and takes its share of the progress
/// bar.
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
    this->Levels.resize(contours.Levels.size());
    this->Units.resize(contours.Levels.size());
    for (std::size_t i = 0; i < this->Levels.size(); ++i)
    {
      this->Levels[i].Offset = contours.Levels[i].Offset;
    }
    this->Slabs.resize(this->Levels.size() - 1);
    for (std::size_t i = 0; i < this->Slabs.size(); ++i)
    {
      this->Slabs[i].Thickness = this->Levels[i + 1].Offset - this->Levels[i].Offset;
    }
    this->Out.Earlier.Levels.resize(this->Levels.size());
    this->Out.Earlier.Slabs.resize(this->Slabs.size());
  }

  PolyhedralStages Build()
  {
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
          this->ShapesOf.resize(this->Levels.size());
        }
      });
    this->BuildLevelsAndSlabs();
    AddReports(this->Contours, this->Options, this->Out);
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
    this->BuildLevelsAndSlabs();
    return std::move(this->Out);
  }

private:
  void BuildLevelsAndSlabs()
  {
    this->Runner.Timed("triangulate levels", [&] { this->TriangulateLevels(); });
    this->Runner.Timed("insert internal points", [&] { this->InsertInternalPoints(); });
    this->BuildSlabs();
    for (LevelState& level : this->Levels)
    {
      level.Needles = level.Triangulator->Needles();
      // These take more memory than all that is handed on.
      level.Triangulator.reset();
      level.Distance.reset();
    }
    this->Out.StageSeconds = this->Runner.GetSeconds();
  }

  void TriangulateLevels()
  {
    this->Runner.ForAll(this->Levels.size(), MappedAt, 0.3, "triangulating slices",
      [&](int i)
      {
        this->Levels[i].Triangulator = std::make_unique<LevelTriangulator>(this->Contours, i);
        this->Units[i] = UnitOfLevel(this->Contours, i);
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
    std::vector<std::vector<Point2>> skeletons(this->Levels.size());
    if (this->Options.InternalPoints)
    {
      this->Runner.ForAll(this->Levels.size(), 0.3, 0.35, "finding the middle of gaps",
        [&](int i)
        {
          LevelState& level = this->Levels[i];
          const LevelTriangulation drawn = level.Triangulator->Finish();
          skeletons[i] = ExternalSkeletonVertices(drawn, this->Units[i]);
          if (this->RoundsOffPartialEnds())
          {
            level.InternalSkeleton = InternalSkeletonVertices(drawn, this->Units[i]);
          }
        });
    }
    this->Runner.ForAll(this->Levels.size(), 0.35, 0.5, "adding points where branches meet",
      [&](std::size_t i)
      {
        auto& triangulator = *this->Levels[i].Triangulator;
        if (i > 0)
        {
          triangulator.AddInternalPoints(skeletons[i - 1], LevelTriangulation::LevelBelow);
        }
        if (i + 1 < skeletons.size())
        {
          triangulator.AddInternalPoints(skeletons[i + 1], LevelTriangulation::LevelAbove);
        }
        this->Levels[i].Triangulation = triangulator.Finish();
      });
  }

  /// Tetrahedra and heights of all slabs, once more where points were added for ends and bare
  /// parts.
  void BuildSlabs()
  {
    for (int round = 0; round < Rounds; ++round)
    {
      const double from = 0.5 + 0.5 * round / Rounds;
      const double middle = from + 0.4 / Rounds;
      const double to = from + 0.5 / Rounds;
      this->Runner.Timed("join Voronoi diagrams", [&] { this->JoinDiagrams(from, middle); });
      this->Runner.Timed("lift internal points", [&] { this->LiftPoints(middle, to); });
      ++this->Out.Rounds;
      if (round + 1 == Rounds || !this->AddPointsWhereNeeded(round == 0, to))
      {
        return;
      }
    }
  }

  void JoinDiagrams(double from, double to)
  {
    this->Runner.ForAll(this->Slabs.size(), from, to, "filling the space between slices",
      [&](int i)
      {
        const LevelState& lower = this->Levels[i];
        const LevelState& upper = this->Levels[i + 1];
        if (lower.Changed || upper.Changed)
        {
          this->JoinDiagram(i, lower.Triangulation, upper.Triangulation);
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
    const JointCells cells(lower, upper);
    const bool mayHaveGaps = this->Wanted != TetrahedraWanted::All && lower.IsGabriel &&
      upper.IsGabriel && !slab.Joins.HasContract();
    std::size_t most = std::numeric_limits<std::size_t>::max();
    if (mayHaveGaps)
    {
      most = this->Wanted == TetrahedraWanted::BoundaryOnly
        ? 0
        : MostT12ATriangle * (lower.Triangles.size() + upper.Triangles.size());
    }
    std::optional<SlabTetrahedra> all =
      most > 0 ? BuildJointVoronoi(cells, most) : std::optional<SlabTetrahedra>();
    if (!all)
    {
      slab.Diagram = BuildBoundaryVoronoi(cells, slab.Joins);
      return;
    }
    slab.Diagram = std::move(*all);
    EliminateTetrahedra(lower, upper, slab.Joins, slab.Diagram);
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

  void LiftPoints(double from, double to)
  {
    this->Runner.ForAll(this->Levels.size(), from, from, "shaping branches and ends",
      [&](int i)
      {
        LevelState& level = this->Levels[i];
        if (!level.Distance)
        {
          // Added points cut contour edges but do not move them.
          level.Distance = std::make_unique<PlanarContourDistance>(level.Triangulation);
        }
        level.Covered = FindCoverage(level.Triangulation, this->DiagramOrNull(i - 1),
          this->DiagramOrNull(i), this->Options.IsolatedContours == PolyhedralOptions::Extrude);
        for (const int towards : { -1, 1 })
        {
          if (this->Shapes)
          {
            this->ShapesOf[i][towards > 0 ? 1 : 0] = this->Shapes->Find(level, i, towards);
          }
        }
      });
    FindPointsOutsideNeighbours(this->Levels, this->Runner, from);
    this->Runner.ForAll(this->Slabs.size(), from, to, "shaping branches and ends",
      [&](int i)
      {
        if (this->MayHaveChanged(i))
        {
          LiftInternalPoints(this->Levels[i], this->Levels[i + 1], this->Slabs[i].Diagram,
            this->TargetsOf(i, 1), this->TargetsOf(i + 1, -1));
        }
      });
    // Beyond the first and the last level nothing is in the way.
    this->Levels.front().Lifted.Below = this->TargetsOf(0, -1);
    this->Levels.back().Lifted.Above = this->TargetsOf(static_cast<int>(this->Slabs.size()), 1);
  }

  /// What is covered on a level follows from both slabs at it, and so from their levels.
  bool MayHaveChanged(int slab) const
  {
    bool changed = false;
    for (int i = slab - 1; i <= slab + 2; ++i)
    {
      const LevelState* level = this->LevelOrNull(i);
      changed = changed || (level && level->Changed);
    }
    return changed;
  }

  /// towards: 1 above, -1 below.
  std::vector<double> TargetsOf(int level, int towards) const
  {
    const LiftSide side{ &this->Levels[level], this->LevelOrNull(level + towards),
      this->LevelOrNull(level - towards), towards, this->ThicknessForCaps(level, towards),
      this->Shapes ? &this->ShapesOf[level][towards > 0 ? 1 : 0] : nullptr };
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

  EndsOfSlabs FindPartialEndsOfSlabs(double progress) const
  {
    std::vector<std::vector<Point2>> skeletons;
    for (const LevelState& level : this->Levels)
    {
      skeletons.push_back(level.InternalSkeleton);
    }
    std::vector<std::vector<int>> own(this->Levels.size());
    this->Runner.ForAll(this->Levels.size(), progress, progress, "rounding off ends",
      [&](int i) { own[i] = this->Levels[i].Triangulator->Locate(skeletons[i]); });
    const auto places = LocateInNeighbours(this->Levels, skeletons, this->Runner, progress);
    const auto side = [&](int i, int towards)
    {
      const auto& other = towards > 0 ? places[i].Above : places[i].Below;
      const auto& behind = towards > 0 ? places[i].Below : places[i].Above;
      return SkeletonSide{ &this->Levels[i], this->LevelOrNull(i - towards), &own[i], &other,
        &behind };
    };
    EndsOfSlabs ends(this->Slabs.size());
    this->Runner.ForAll(ends.size(), progress, progress, "rounding off ends",
      [&](int i)
      { ends[i] = FindPartialEnds(this->Slabs[i].Diagram, side(i, 1), side(i + 1, -1)); });
    return ends;
  }

  /// Returns whether there were any at that level.
  bool AddPartialEnds(std::size_t level, const EndsOfSlabs& endsOfSlabs)
  {
    auto& triangulator = *this->Levels[level].Triangulator;
    bool any = false;
    if (level > 0)
    {
      const auto& below = endsOfSlabs[level - 1];
      triangulator.AddInternalPoints(below[1], LevelTriangulation::LevelBelow);
      triangulator.AddExternalPoints(below[0]);
      any = !below[0].empty() || !below[1].empty();
    }
    if (level < endsOfSlabs.size())
    {
      const auto& above = endsOfSlabs[level];
      triangulator.AddInternalPoints(above[0], LevelTriangulation::LevelAbove);
      triangulator.AddExternalPoints(above[1]);
      any = any || !above[0].empty() || !above[1].empty();
    }
    return any;
  }

  /// Returns whether any level was changed. first: points for ends, too, and not only for what is
  /// bare.
  bool AddPointsWhereNeeded(bool first, double progress)
  {
    this->Runner.Timed("cap ends and cover bare parts",
      [&]
      {
        const bool round = first && PolyhedralOptions::IsRounded(this->Options.EndCaps);
        const bool partialEnds = first && this->RoundsOffPartialEnds();
        const EndsOfSlabs ends =
          partialEnds ? this->FindPartialEndsOfSlabs(progress) : EndsOfSlabs();
        this->Runner.ForAll(this->Levels.size(), progress, progress, "covering what is bare",
          [&](int i)
          {
            const bool anyEnds = partialEnds && this->AddPartialEnds(i, ends);
            this->AddCapAndCoverPoints(i, round, anyEnds);
          });
      });
    return std::any_of(this->Levels.begin(), this->Levels.end(),
      [](const LevelState& level) { return level.Changed; });
  }

  /// anyEnds: the triangulator was changed already.
  void AddCapAndCoverPoints(int index, bool round, bool anyEnds)
  {
    LevelState& level = this->Levels[index];
    const std::vector<Point2> bare =
      FindCoverPoints(level.Triangulation, level.Covered, level.Lifted);
    const std::vector<Point2> caps = round ? FindEndCapPoints(level.Triangulation, level.Covered,
                                               this->Units[index], this->Extrapolates())
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

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  TetrahedraWanted Wanted;
  bool KeepsEarlier;
  StageRunner Runner;
  double Spacing; ///< of the whole stack
  decltype(JoinsOfPart::KnownDiagram) KnownDiagram;
  std::optional<EndShapes> Shapes;                       ///< where ends are extrapolated
  std::vector<std::array<EndShapesOfLevel, 2>> ShapesOf; ///< by level, below and above
  std::vector<double> Units; ///< of the last decimal of each level's contours
  PolyhedralStages Out;
  std::vector<LevelState>& Levels = Out.Levels;
  std::vector<SlabState>& Slabs = Out.Slabs;
};
}

PolyhedralStages BuildPolyhedralStages(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, double progressEnd, TetrahedraWanted wanted, bool keepsEarlier)
{
  RequireParallelLevels(contours);
  LevelAlignment alignment = FindLevelAlignment(contours, options.AlignLevels, options.ForcedJoins);
  auto shifted = alignment.IsEmpty() ? std::unique_ptr<ContourSet>()
                                     : std::make_unique<ContourSet>(Aligned(contours, alignment));
  PolyhedralStages stages =
    Builder(shifted ? *shifted : contours, options, monitor, progressEnd, wanted, keepsEarlier)
      .Build();
  stages.Report.insert(stages.Report.begin(), alignment.Report.begin(), alignment.Report.end());
  stages.Alignment = std::move(alignment);
  stages.Shifted = std::move(shifted);
  return stages;
}

PolyhedralStages BuildStagesOfPart(const ContourSet& part, const JoinsOfPart& joins,
  const PolyhedralOptions& options, Monitor& monitor, double progressEnd, TetrahedraWanted wanted)
{
  return Builder(part, options, monitor, progressEnd, wanted, true).BuildPart(joins);
}

void AddReports(
  const ContourSet& contours, const PolyhedralOptions& options, PolyhedralStages& stages)
{
  for (const LevelState& level : stages.Levels)
  {
    for (int contour : level.Needles)
    {
      stages.Report.push_back(DescribeNeedle(contours, contour));
    }
  }
  ReportLevelsWithoutCondition2(stages.Levels, stages.Report);
  ReportJoinsNotMade(stages.Mapping, stages.Levels, stages.Slabs, stages.Report);
  ReportContoursLeftOut(contours, stages.Levels, options, stages.Report);
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
