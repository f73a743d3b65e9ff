// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/Lifting.h"

#include "Base/StopSignal.h"
#include "Polyhedral/VoronoiSections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace recon
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A tetrahedron may be flattened to this share of its volume, so that rounding of the result in a
/// tilted frame cannot turn it over either.
constexpr double LeastVolume = 0.05;

/// Points go up one at a time; after some rounds nothing much moves any more.
constexpr int Sweeps = 10;

/// Share of the remaining way below which a further step is not worth a try.
constexpr double SmallestStep = 1.0 / 16;

/// The same of the first step. It is worth much more: a point that stays in its plane between
/// others that go up is a hole through the ridge, and a step short enough never turns a tetrahedron
/// over.
constexpr double SmallestFirstStep = 1e-4;

class SlabLifting
{
public:
  SlabLifting(const LevelState& level1, const LevelState& level2, const SlabTetrahedra& slab,
    const std::vector<double>& targets1, const std::vector<double>& targets2)
    : Levels{ { &level1, &level2 } },
      Slab(slab),
      Targets{ { targets1, targets2 } }
  {
    for (int side : { 0, 1 })
    {
      const std::size_t count = this->Levels[side]->Triangulation.Points.size();
      this->Heights[side].assign(count, this->Levels[side]->Offset);
      this->Stars[side].resize(count);
    }
  }

  void Run()
  {
    if (!this->CollectStars())
    {
      return;
    }
    this->FindSmallestVolumes();
    for (int sweep = 0; sweep < Sweeps && this->Sweep(); ++sweep)
    {
      // A point that its neighbours held back may rise further now that they have risen.
    }
  }

  std::vector<double> LiftedHeightsOf(int side) const
  {
    std::vector<double> heights = this->Heights[side];
    for (double& height : heights)
    {
      height =
        height == this->Levels[side]->Offset ? std::numeric_limits<double>::quiet_NaN() : height;
    }
    return heights;
  }

private:
  bool IsToBeLifted(int side, int point) const { return !std::isnan(this->Targets[side][point]); }

  bool CollectStars()
  {
    for (const auto& t : this->Slab.Tetrahedra)
    {
      if (t.Node != SlabTetrahedra::T12 || !this->Slab.HasGaps)
      {
        this->CollectStar(t);
      }
    }
    const auto isAny = [](const std::vector<double>& targets)
    {
      return std::any_of(
        targets.begin(), targets.end(), [](double target) { return !std::isnan(target); });
    };
    if (this->Slab.HasGaps && (isAny(this->Targets[0]) || isAny(this->Targets[1])))
    {
      this->CollectMissingStars();
    }
    return !this->Tetrahedra.empty();
  }

  void CollectStar(const SlabTetrahedra::Tetrahedron& t)
  {
    bool any = false;
    Corners corners{};
    for (int k = 0; k < 4; ++k)
    {
      const int side = SlabTetrahedra::OnLevel2(t, k) ? 1 : 0;
      corners[k] = { side, t.Corners[k] };
      if (this->IsToBeLifted(side, t.Corners[k]))
      {
        this->Stars[side][t.Corners[k]].push_back(static_cast<int>(this->Tetrahedra.size()));
        any = true;
      }
    }
    if (any)
    {
      this->Tetrahedra.push_back(corners);
    }
  }

  /// All T12 at the points to be lifted, as those of the slab are not all there.
  void CollectMissingStars()
  {
    const JointCells cells(this->Levels[0]->Triangulation, this->Levels[1]->Triangulation);
    const VoronoiSections sections(cells);
    std::vector<JointCrossing> crossings;
    for (const int side : { 0, 1 })
    {
      const LevelTriangulation& level = cells.LevelAt(side);
      for (int edge = 0; edge < static_cast<int>(3 * level.Triangles.size()); ++edge)
      {
        if (!this->IsEdgeToBeLifted(level, side, edge))
        {
          continue;
        }
        crossings.clear();
        sections.Find(side, edge, true, crossings);
        for (const JointCrossing& crossing : crossings)
        {
          // What has a point of either level was found from the first.
          if (side == 0 || !this->IsEdgeToBeLifted(cells.LevelAt(0), 0, crossing.Edges[0]))
          {
            this->CollectStar(
              { crossing.Corners, {}, crossing.Edges, SlabTetrahedra::T12, SlabTetrahedra::Kept });
          }
        }
      }
    }
  }

  /// Of a Delaunay edge under its canonical number, whether one of its ends is.
  bool IsEdgeToBeLifted(const LevelTriangulation& level, int side, int edge) const
  {
    const auto& corners = level.Triangles[edge / 3];
    return (this->IsToBeLifted(side, corners[(edge + 1) % 3]) ||
             this->IsToBeLifted(side, corners[(edge + 2) % 3])) &&
      CanonicalEdge(level, edge / 3, edge % 3) == edge;
  }

  void FindSmallestVolumes()
  {
    this->SmallestVolume.resize(this->Tetrahedra.size());
    for (std::size_t t = 0; t < this->SmallestVolume.size(); ++t)
    {
      this->SmallestVolume[t] = LeastVolume * this->Volume(static_cast<int>(t));
    }
  }

  /// One try for every point that has not reached its target; returns whether any moved.
  bool Sweep()
  {
    bool moved = false;
    for (int side : { 0, 1 })
    {
      for (std::size_t p = 0; p < this->Stars[side].size(); ++p)
      {
        moved = this->Raise(side, static_cast<int>(p)) || moved;
      }
    }
    return moved;
  }

  bool Raise(int side, int point)
  {
    const double from = this->Heights[side][point];
    if (this->Stars[side][point].empty() || from == this->Targets[side][point])
    {
      return false;
    }
    const double way = this->Targets[side][point] - from;
    double& height = this->Heights[side][point];
    const bool first = from == this->Levels[side]->Offset;
    const double smallest = first ? SmallestFirstStep : SmallestStep;
    for (double fraction = 1; fraction >= smallest; fraction /= 2)
    {
      height = from + fraction * way;
      if (height != from && this->IsSafe(side, point))
      {
        return true;
      }
    }
    height = from;
    return false;
  }

  bool IsSafe(int side, int point) const
  {
    ThrowIfStopped();
    const auto& star = this->Stars[side][point];
    return std::all_of(star.begin(), star.end(),
      [&](int t) { return this->Volume(t) >= this->SmallestVolume[t] && this->IsPositive(t); });
  }

  std::array<Kernel::Point_3, 4> CornersOf(int tetrahedron) const
  {
    std::array<Kernel::Point_3, 4> corners;
    for (int k = 0; k < 4; ++k)
    {
      const auto& [side, point] = this->Tetrahedra[tetrahedron][k];
      const Point2& p = this->Levels[side]->Triangulation.Points[point];
      corners[k] = { p[0], p[1], this->Heights[side][point] };
    }
    return corners;
  }

  double Volume(int tetrahedron) const
  {
    const auto p = this->CornersOf(tetrahedron);
    return CGAL::volume(p[0], p[1], p[2], p[3]);
  }

  bool IsPositive(int tetrahedron) const
  {
    const auto p = this->CornersOf(tetrahedron);
    return CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE;
  }

  /// Of a tetrahedron: level and point.
  using Corners = std::array<std::array<int, 2>, 4>;

  std::array<const LevelState*, 2> Levels;
  const SlabTetrahedra& Slab;
  std::array<std::vector<double>, 2> Heights;
  std::array<std::vector<double>, 2> Targets;
  std::vector<Corners> Tetrahedra;                    ///< those with a point to be lifted
  std::vector<double> SmallestVolume;                 ///< that a tetrahedron must keep
  std::array<std::vector<std::vector<int>>, 2> Stars; ///< tetrahedra at every point to be lifted
};
}

void LiftInternalPoints(LevelState& level1, LevelState& level2, const SlabTetrahedra& slab,
  const std::vector<double>& targets1, const std::vector<double>& targets2)
{
  SlabLifting lifting(level1, level2, slab, targets1, targets2);
  lifting.Run();
  level1.Lifted.Above = lifting.LiftedHeightsOf(0);
  level2.Lifted.Below = lifting.LiftedHeightsOf(1);
}
}
