// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/Lifting.h"

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
  bool CollectStars()
  {
    bool any = false;
    for (std::size_t i = 0; i < this->Slab.Tetrahedra.size(); ++i)
    {
      const auto& t = this->Slab.Tetrahedra[i];
      for (int k = 0; k < 4; ++k)
      {
        const int side = SlabTetrahedra::OnLevel2(t, k) ? 1 : 0;
        if (!std::isnan(this->Targets[side][t.Corners[k]]))
        {
          this->Stars[side][t.Corners[k]].push_back(static_cast<int>(i));
          any = true;
        }
      }
    }
    return any;
  }

  void FindSmallestVolumes()
  {
    this->SmallestVolume.resize(this->Slab.Tetrahedra.size());
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
    const auto& star = this->Stars[side][point];
    return std::all_of(star.begin(), star.end(),
      [&](int t) { return this->Volume(t) >= this->SmallestVolume[t] && this->IsPositive(t); });
  }

  std::array<Kernel::Point_3, 4> CornersOf(int tetrahedron) const
  {
    const auto& t = this->Slab.Tetrahedra[tetrahedron];
    std::array<Kernel::Point_3, 4> corners;
    for (int k = 0; k < 4; ++k)
    {
      const int side = SlabTetrahedra::OnLevel2(t, k) ? 1 : 0;
      const Point2& p = this->Levels[side]->Triangulation.Points[t.Corners[k]];
      corners[k] = { p[0], p[1], this->Heights[side][t.Corners[k]] };
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

  std::array<const LevelState*, 2> Levels;
  const SlabTetrahedra& Slab;
  std::array<std::vector<double>, 2> Heights;
  std::array<std::vector<double>, 2> Targets;
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
