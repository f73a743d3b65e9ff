// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/EvenOddRule.h"

#include "Planar/Arrangement.h"
#include "Planar/LoopOrder.h"
#include "Planar/LoopTracing.h"
#include "Planar/SnapTolerance.h"
#include "Planar/WindingBorder.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace recon
{
namespace
{
class EvenOdd
{
public:
  EvenOdd(std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, bool winding,
    double snapTolerance)
    : Points(points),
      Loops(loops),
      Winding(winding),
      Plane(points, EdgesOf(loops), SnapTolerances(points, loops, snapTolerance),
        winding ? Arrangement::SumType::Weight : Arrangement::SumType::Parity),
      Shared(loops.size(), 0)
  {
  }

  EvenOddResult Apply()
  {
    this->FindSharedPoints();
    this->Plane.Resolve();
    if (this->Winding)
    {
      // Edges with solid on both sides, or on none, go.
      this->Plane.Keep(FindWindingBorder(this->Points, this->Plane.Edges()));
    }
    return this->Collect();
  }

private:
  static std::vector<PlanarEdge> EdgesOf(const std::vector<std::vector<int>>& loops)
  {
    std::vector<PlanarEdge> edges;
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      AddLoopEdges(loops[l], static_cast<int>(l), edges);
    }
    return edges;
  }

  void FindSharedPoints()
  {
    std::vector<int> visitor(this->Points.size(), -1);
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      for (int p : this->Loops[l])
      {
        int& first = visitor[p];
        if (first >= 0)
        {
          this->Plane.Join(first, static_cast<int>(l));
          ++this->Shared[l];
        }
        else
        {
          first = static_cast<int>(l);
        }
      }
    }
  }

  EvenOddResult Collect()
  {
    std::vector<PlanarEdge> inConflict;
    std::vector<bool> left(this->Loops.size(), false);
    for (const PlanarEdge& e : this->Plane.Edges())
    {
      left[e.Tag] = true;
      if (this->Plane.HasConflict(e.Tag))
      {
        inConflict.push_back(e);
      }
    }
    EvenOddResult result;
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      const bool troubled = this->Plane.HasConflict(static_cast<int>(l));
      if (!troubled && !left[l])
      {
        result.Swallowed.push_back(static_cast<int>(l));
      }
      else if (!troubled)
      {
        result.Loops.push_back({ this->Loops[l], static_cast<int>(l) });
      }
    }
    std::vector<EvenOddResult::Loop> traced;
    for (TracedLoop& loop : TraceLoops(this->Points, inConflict))
    {
      int origin = inConflict[loop.Edges[0]].Tag;
      for (int e : loop.Edges)
      {
        origin = std::min(origin, inConflict[e].Tag);
      }
      traced.push_back({ std::move(loop.Points), origin });
    }
    this->CollectClusters(traced, left, result);
    std::move(traced.begin(), traced.end(), std::back_inserter(result.Loops));
    std::stable_sort(result.Loops.begin(), result.Loops.end(),
      [](const auto& x, const auto& y) { return x.Origin < y.Origin; });
    return result;
  }

  void CollectClusters(const std::vector<EvenOddResult::Loop>& traced,
    const std::vector<bool>& left, EvenOddResult& result)
  {
    std::map<int, EvenOddCluster> clusters;
    std::map<int, std::multiset<std::vector<int>>> before;
    std::map<int, std::multiset<std::vector<int>>> after;
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      const int loop = static_cast<int>(l);
      if (!this->Plane.HasConflict(loop))
      {
        continue;
      }
      const int root = this->Plane.SetOf(loop);
      EvenOddCluster& cluster = clusters[root];
      cluster.Loops.push_back(loop);
      if (!left[l])
      {
        cluster.Vanished.push_back(loop);
      }
      const Arrangement::Findings& found = this->Plane.FindingsOf(loop);
      cluster.Crossings += found.Crossings;
      cluster.OnEdge += found.OnEdge;
      cluster.Cancelled += found.Cancelled;
      cluster.Shared += this->Shared[l];
      cluster.Merged += found.Merged;
      cluster.Moved = std::max(cluster.Moved, found.Moved);
      cluster.Tolerance = std::max(cluster.Tolerance, this->Plane.ToleranceOf(loop));
      before[root].insert(CanonicalLoop(this->Loops[l]));
    }
    for (const EvenOddResult::Loop& loop : traced)
    {
      const int root = this->Plane.SetOf(loop.Origin);
      ++clusters[root].Results;
      after[root].insert(CanonicalLoop(loop.Points));
    }
    for (auto& [root, cluster] : clusters)
    {
      cluster.Changed = before[root] != after[root];
      cluster.Rule = this->Winding ? "winding" : "even-odd";
      result.Clusters.push_back(std::move(cluster));
    }
  }

  std::vector<Point2>& Points;
  const std::vector<std::vector<int>>& Loops;
  bool Winding;
  Arrangement Plane;
  std::vector<std::size_t> Shared; ///< a loop: its points that were passed before
};
}

EvenOddResult ApplyEvenOddRule(
  std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, double snapTolerance)
{
  return EvenOdd(points, loops, false, snapTolerance).Apply();
}

EvenOddResult ApplyWindingRule(
  std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, double snapTolerance)
{
  return EvenOdd(points, loops, true, snapTolerance).Apply();
}
}
