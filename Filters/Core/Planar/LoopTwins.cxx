// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/LoopTwins.h"

#include "Base/BoundingBox.h"
#include "Planar/Arrangement.h"
#include "Planar/EdgeConflicts.h"
#include "Planar/EdgeTree.h"
#include "Planar/PlanarDifference.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
// Decimals that were cut, not rounded, move a point by a whole unit along either axis.
const double CutDecimals = std::sqrt(2.0);
// Both cut or rounded to the same decimals: a point is off by no more, if that is little beside the
// loop; a wall of that thickness is never drawn.
constexpr double SameDecimals = 1.5;
constexpr double LittleBesideLoop = 1e-3;
// As above where there are no decimals to go by.
constexpr double NothingBesideLoop = 1e-5;
// A loop of hardly more than the unit has no shape that could be recognised.
constexpr double SmallestInRoundings = 2.5;

/// How much two outlines of one shape may differ.
struct Likeness
{
  double Area;     ///< in one of them only, of the smaller area
  double Distance; ///< the farthest that a point of one is from the other, of the diagonal
};
// Traced by hand twice: 1 to 3 percent of the diameter are usual.
constexpr Likeness TracedTwice{ 0.1, 0.05 };
// With points left out, chords cut off what was between.
constexpr Likeness WithFewerPoints{ 0.3, 0.15 };
// Of its length, a loop traced again has at least this much on either side of the first.
constexpr double OnEitherSide = 0.1;
// Of its points, a loop with points left out has at least this many on the first.
constexpr double PointsOnOther = 0.9;

constexpr int MostDecimals = 8; ///< more are not told from coordinates that nobody rounded

class TwinFinder
{
public:
  TwinFinder(const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops,
    const std::vector<double>& units, bool tracedAgain)
    : Points(points),
      Loops(loops),
      Units(units),
      TracedAgain(tracedAgain)
  {
    for (const std::vector<int>& loop : loops)
    {
      Box2 box;
      for (int p : loop)
      {
        box.Add(points[p]);
      }
      this->Boxes.push_back(box);
    }
  }

  std::vector<LoopTwin> Find()
  {
    std::vector<std::pair<int, int>> pairs = this->Candidates();
    // The one that stays first, and those that stay in the order of their fineness.
    for (auto& [first, second] : pairs)
    {
      if (this->Fineness(second) < this->Fineness(first))
      {
        std::swap(first, second);
      }
    }
    std::sort(pairs.begin(), pairs.end(),
      [this](const auto& x, const auto& y)
      {
        return std::make_pair(this->Fineness(x.first), this->Fineness(x.second)) <
          std::make_pair(this->Fineness(y.first), this->Fineness(y.second));
      });
    std::map<int, LoopTwin> leftOut;
    for (const auto& [first, second] : pairs)
    {
      if (leftOut.count(first) > 0 || leftOut.count(second) > 0)
      {
        continue;
      }
      LoopTwin twin{ second, first };
      if (this->AreTwins(twin))
      {
        leftOut.emplace(second, twin);
      }
    }
    std::vector<LoopTwin> twins;
    for (const auto& [loop, twin] : leftOut)
    {
      twins.push_back(twin);
    }
    return twins;
  }

private:
  /// Smaller for finer decimals, then for more points, then for the first.
  std::tuple<double, std::ptrdiff_t, int> Fineness(int loop) const
  {
    const auto points = static_cast<std::ptrdiff_t>(this->Loops[loop].size());
    return { this->Units[loop], -points, loop };
  }

  double ReachOf(int loop) const
  {
    return std::max(WithFewerPoints.Distance * this->Boxes[loop].Diagonal(), 2 * this->Units[loop]);
  }

  /// Pairs with boxes whose corners are no farther apart than twins' can be.
  std::vector<std::pair<int, int>> Candidates() const
  {
    using CornerBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;
    std::vector<CornerBox> corners;
    for (std::size_t l = 0; l < this->Boxes.size(); ++l)
    {
      const double half = this->ReachOf(static_cast<int>(l));
      const Point2& low = this->Boxes[l].Low;
      corners.emplace_back(CGAL::Bbox_2(low[0] - half, low[1] - half, low[0] + half, low[1] + half),
        static_cast<int>(l));
    }
    std::vector<std::pair<int, int>> pairs;
    CGAL::box_self_intersection_d(corners.begin(), corners.end(),
      [&](const CornerBox& x, const CornerBox& y)
      {
        const Point2& a = this->Boxes[x.info()].High;
        const Point2& b = this->Boxes[y.info()].High;
        const double reach = this->ReachOf(x.info()) + this->ReachOf(y.info());
        if (std::abs(a[0] - b[0]) <= reach && std::abs(a[1] - b[1]) <= reach)
        {
          pairs.push_back(std::minmax(x.info(), y.info()));
        }
      });
    return pairs;
  }

  bool AreTwins(LoopTwin& twin)
  {
    const double diagonal =
      std::max(this->Boxes[twin.Loop].Diagonal(), this->Boxes[twin.Of].Diagonal());
    const double rounding = this->RoundingOf(twin, diagonal);
    const bool hasShape = diagonal >= SmallestInRoundings * rounding;
    const double reach = std::max(
      hasShape ? rounding : 0, this->TracedAgain ? WithFewerPoints.Distance * diagonal : 0);
    twin.Apart = std::max(
      this->FarthestOf(twin.Loop, twin.Of, reach), this->FarthestOf(twin.Of, twin.Loop, reach));
    twin.WithinRounding = hasShape && twin.Apart <= rounding && this->HaveOneArea(twin, rounding);
    return twin.WithinRounding ||
      (this->TracedAgain && twin.Apart <= reach && this->IsTracedAgain(twin, diagonal, rounding));
  }

  bool IsTracedAgain(const LoopTwin& twin, double diagonal, double rounding)
  {
    const auto isNear = [&](const Likeness& most)
    { return twin.Apart <= most.Distance * diagonal; };
    const bool twice = isNear(TracedTwice) && this->RunsOnBothSides(twin.Loop, twin.Of);
    const bool withFewer = isNear(WithFewerPoints) &&
      (this->LiesOn(twin.Loop, twin.Of, rounding) || this->LiesOn(twin.Of, twin.Loop, rounding));
    if ((!twice && !withFewer) || this->CrossTooOften(twin))
    {
      return false;
    }
    const double difference = this->DifferenceOf(twin);
    return (twice && difference <= TracedTwice.Area) ||
      (withFewer && difference <= WithFewerPoints.Area);
  }

  /// More often than their level may have crossings, which ends in a sentence whatever they are; their areas would take
  /// long.
  bool CrossTooOften(const LoopTwin& twin) const
  {
    std::vector<PlanarEdge> edges;
    AddLoopEdges(this->Loops[twin.Loop], 0, edges);
    AddLoopEdges(this->Loops[twin.Of], 0, edges);
    std::size_t ofLevel = 0;
    for (const std::vector<int>& loop : this->Loops)
    {
      ofLevel += loop.size();
    }
    return CrossMoreOftenThan(this->Points, edges, MostPiecesOf(ofLevel));
  }

  /// How far apart rounding alone can have put points of the two.
  double RoundingOf(const LoopTwin& twin, double diagonal) const
  {
    const double coarse = this->Units[twin.Loop];
    const double fine = this->Units[twin.Of];
    double rounding = NothingBesideLoop * diagonal;
    if (coarse != fine)
    {
      rounding = std::max(rounding, CutDecimals * (coarse + fine));
    }
    else if (SameDecimals * coarse <= LittleBesideLoop * diagonal)
    {
      rounding = std::max(rounding, SameDecimals * coarse);
    }
    return rounding;
  }

  /// Of the points of a loop, how far the farthest is from the other; infinite beyond reach.
  double FarthestOf(int loop, int other, double reach)
  {
    double farthest = 0;
    const EdgeTree& tree = this->TreeOf(other);
    for (int p : this->Loops[loop])
    {
      const double beyond = std::nextafter(reach, HUGE_VAL);
      farthest = std::max(farthest, tree.DistanceWithin(this->Points[p], beyond));
      if (farthest > reach)
      {
        return HUGE_VAL;
      }
    }
    return farthest;
  }

  /// Not so for a loop that is walked twice.
  bool HaveOneArea(const LoopTwin& twin, double apart) const
  {
    const double difference = std::abs(this->AreaOf(twin.Loop)) - std::abs(this->AreaOf(twin.Of));
    return std::abs(difference) <=
      apart * std::max(this->LengthOf(twin.Loop), this->LengthOf(twin.Of));
  }

  /// The area that is in one of them only, in parts of the smaller one.
  double DifferenceOf(const LoopTwin& twin) const
  {
    PlanarRegions regions;
    this->AddSegments(twin.Loop, PlanarRegions::Below, regions);
    this->AddSegments(twin.Of, PlanarRegions::Contour, regions);
    const PlanarDifference difference = MeasurePlanarDifference(regions);
    const double smaller = std::min(difference.SurfaceArea, difference.ContourArea);
    return smaller > 0 ? difference.SymmetricDifference / smaller : HUGE_VAL;
  }

  void AddSegments(int loop, PlanarRegions::LayerType layer, PlanarRegions& regions) const
  {
    for (const PlanarSegment& s : this->SegmentsOf(loop))
    {
      regions.Segments.push_back({ s.A, s.B, layer });
    }
  }

  /// By the middles of its edges.
  bool RunsOnBothSides(int loop, int other)
  {
    const EdgeTree& tree = this->TreeOf(other);
    double inside = 0;
    double outside = 0;
    for (const PlanarSegment& s : this->SegmentsOf(loop))
    {
      const double length = Distance(s.A, s.B);
      const EdgeTree::SideType side =
        tree.SideOf({ 0.5 * (s.A[0] + s.B[0]), 0.5 * (s.A[1] + s.B[1]) });
      inside += side == EdgeTree::Inside ? length : 0;
      outside += side == EdgeTree::Outside ? length : 0;
    }
    return std::min(inside, outside) >= OnEitherSide * this->LengthOf(loop);
  }

  bool LiesOn(int loop, int other, double within)
  {
    const EdgeTree& tree = this->TreeOf(other);
    const std::vector<int>& p = this->Loops[loop];
    const double beyond = std::nextafter(within, HUGE_VAL);
    const auto on = std::count_if(p.begin(), p.end(),
      [&](int q) { return tree.DistanceWithin(this->Points[q], beyond) <= within; });
    return static_cast<double>(on) >= PointsOnOther * static_cast<double>(p.size());
  }

  std::vector<PlanarSegment> SegmentsOf(int loop) const
  {
    const std::vector<int>& p = this->Loops[loop];
    std::vector<PlanarSegment> segments;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      segments.push_back({ this->Points[p[i]], this->Points[p[(i + 1) % p.size()]] });
    }
    return segments;
  }

  double LengthOf(int loop) const
  {
    double length = 0;
    for (const PlanarSegment& s : this->SegmentsOf(loop))
    {
      length += Distance(s.A, s.B);
    }
    return length;
  }

  double AreaOf(int loop) const
  {
    const Point2& o = this->Points[this->Loops[loop][0]];
    double twice = 0;
    for (const PlanarSegment& s : this->SegmentsOf(loop))
    {
      twice += (s.A[0] - o[0]) * (s.B[1] - o[1]) - (s.B[0] - o[0]) * (s.A[1] - o[1]);
    }
    return 0.5 * twice;
  }

  const EdgeTree& TreeOf(int loop)
  {
    const auto found = this->Trees.find(loop);
    return found != this->Trees.end()
      ? found->second
      : this->Trees.emplace(loop, EdgeTree(this->SegmentsOf(loop))).first->second;
  }

  const std::vector<Point2>& Points;
  const std::vector<std::vector<int>>& Loops;
  const std::vector<double>& Units;
  bool TracedAgain;
  std::vector<Box2> Boxes;
  std::map<int, EdgeTree> Trees; ///< of loops that were candidates
};
}

std::vector<LoopTwin> FindLoopTwins(const std::vector<Point2>& points,
  const std::vector<std::vector<int>>& loops, const std::vector<double>& units, bool tracedAgain)
{
  return TwinFinder(points, loops, units, tracedAgain).Find();
}

double UnitOf(const std::vector<double>& numbers)
{
  double largest = 0;
  for (double x : numbers)
  {
    largest = std::max(largest, std::abs(x));
  }
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest;
  int decimals = 0;
  double power = 1;
  for (double x : numbers)
  {
    while (decimals <= MostDecimals && std::abs(x - std::round(x * power) / power) > rounding)
    {
      ++decimals;
      power *= 10;
    }
  }
  if (decimals <= MostDecimals && rounding * power < 0.01)
  {
    return 1 / power;
  }
  const bool single = largest <= std::numeric_limits<float>::max() &&
    std::all_of(numbers.begin(), numbers.end(),
      [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
  return single ? std::numeric_limits<float>::epsilon() * largest : 0;
}
}
