// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/EvenOddRule.h"

#include "Base/DisjointSets.h"
#include "Planar/EdgeConflicts.h"
#include "Planar/LoopOrder.h"
#include "Planar/LoopTracing.h"
#include "Planar/WindingBorder.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace recon
{
namespace
{
// Rounding a crossing moves edges by an ulp or so; more rounds than a few are not seen.
constexpr int MaximumRounds = 50;

std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

class EvenOdd
{
public:
  EvenOdd(std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, bool winding)
    : Points(points),
      Loops(loops),
      Winding(winding),
      Sets(loops.size()),
      Counts(loops.size()),
      Trouble(loops.size(), false)
  {
  }

  EvenOddResult Apply()
  {
    this->CollectEdges();
    this->FindSharedPoints();
    this->SplitUntilClean();
    if (this->Winding)
    {
      this->KeepBorder();
    }
    return this->Collect();
  }

private:
  void CollectEdges()
  {
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      const std::vector<int>& p = this->Loops[l];
      for (std::size_t i = 0; i < p.size(); ++i)
      {
        this->Edges.push_back({ p[i], p[(i + 1) % p.size()], static_cast<int>(l) });
      }
    }
  }

  void Mark(int x, int y)
  {
    this->Trouble[Index(x)] = this->Trouble[Index(y)] = true;
    this->Sets.Join(x, y);
  }

  void FindSharedPoints()
  {
    std::vector<int> visitor(this->Points.size(), -1);
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      for (int p : this->Loops[l])
      {
        int& first = visitor[Index(p)];
        if (first >= 0)
        {
          this->Mark(first, static_cast<int>(l));
          ++this->Counts[l].Shared;
        }
        else
        {
          first = static_cast<int>(l);
        }
      }
    }
  }

  void SplitUntilClean()
  {
    for (int round = 0; round < MaximumRounds; ++round)
    {
      this->CancelPairs();
      const EdgeConflicts conflicts = FindEdgeConflicts(this->Points, this->Edges);
      if (conflicts.Empty())
      {
        return;
      }
      // Points that become one may undo what else was found.
      if (conflicts.SamePlace.empty())
      {
        this->Split(conflicts);
      }
      else
      {
        this->Merge(conflicts.SamePlace);
      }
    }
    throw Error("Contours cross in more places than double precision can tell apart.");
  }

  /// Edges with solid on both sides, or on none, go.
  void KeepBorder()
  {
    const std::vector<bool> onBorder = FindWindingBorder(this->Points, this->Edges);
    std::vector<PlanarEdge> kept;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (onBorder[e])
      {
        kept.push_back(this->Edges[e]);
      }
    }
    this->Edges = std::move(kept);
  }

  /// Of edges with the same two ends an odd number leaves one, an even number none; under the
  /// winding rule their sum counts.
  void CancelPairs()
  {
    const auto key = [](const PlanarEdge& e) { return std::minmax(e.A, e.B); };
    std::vector<int> order(this->Edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [&](int e, int f) { return key(this->Edges[Index(e)]) < key(this->Edges[Index(f)]); });
    std::vector<bool> keep(this->Edges.size(), true);
    for (std::size_t i = 0; i < order.size();)
    {
      std::size_t end = i + 1;
      PlanarEdge& first = this->Edges[Index(order[i])];
      while (end < order.size() && key(this->Edges[Index(order[end])]) == key(first))
      {
        const PlanarEdge& next = this->Edges[Index(order[end])];
        this->Mark(first.Loop, next.Loop);
        first.Weight += next.A == first.A ? next.Weight : -next.Weight;
        keep[Index(order[end])] = false;
        ++end;
      }
      if (this->Winding ? first.Weight == 0 : (end - i) % 2 == 0)
      {
        keep[Index(order[i])] = false;
      }
      this->Counts[Index(first.Loop)].Cancelled += end - i > 1 ? 1 : 0;
      i = end;
    }
    std::vector<PlanarEdge> kept;
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      if (keep[i])
      {
        kept.push_back(this->Edges[i]);
      }
    }
    this->Edges = std::move(kept);
  }

  int PointAt(const Point2& p)
  {
    if (this->Known.empty())
    {
      for (std::size_t i = 0; i < this->Points.size(); ++i)
      {
        this->Known.emplace(this->Points[i], static_cast<int>(i));
      }
    }
    const auto [at, isNew] = this->Known.emplace(p, static_cast<int>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(p);
    }
    return at->second;
  }

  /// The point that came first stands for its twins.
  void Merge(const std::vector<EdgeConflicts::Twins>& twins)
  {
    DisjointSets places(this->Points.size());
    for (const EdgeConflicts::Twins& t : twins)
    {
      const int loop = this->Edges[Index(t.FirstEdge)].Loop;
      this->Mark(loop, this->Edges[Index(t.OtherEdge)].Loop);
      this->Counts[Index(loop)].Merged += places.Find(t.First) != places.Find(t.Second) ? 1 : 0;
      places.Join(t.First, t.Second);
    }
    std::vector<PlanarEdge> moved;
    for (PlanarEdge e : this->Edges)
    {
      e.A = places.Find(e.A);
      e.B = places.Find(e.B);
      if (e.A != e.B)
      {
        moved.push_back(e);
      }
    }
    this->Edges = std::move(moved);
  }

  void Split(const EdgeConflicts& conflicts)
  {
    std::vector<std::vector<int>> inner(this->Edges.size());
    for (const EdgeConflicts::Touch& t : conflicts.Touches)
    {
      const int loop = this->Edges[Index(t.Edge)].Loop;
      this->Mark(loop, this->Edges[Index(t.Other)].Loop);
      std::vector<int>& onEdge = inner[Index(t.Edge)];
      // Several edges may end in the point; touches are sorted, so it is the last one that was
      // added.
      if (onEdge.empty() || onEdge.back() != t.Vertex)
      {
        onEdge.push_back(t.Vertex);
        ++this->Counts[Index(loop)].OnEdge;
      }
    }
    for (const EdgeConflicts::Crossing& c : conflicts.Crossings)
    {
      const PlanarEdge e = this->Edges[Index(c.First)];
      const PlanarEdge f = this->Edges[Index(c.Second)];
      const int p = this->PointAt(CrossingPoint(this->Points[Index(e.A)], this->Points[Index(e.B)],
        this->Points[Index(f.A)], this->Points[Index(f.B)]));
      inner[Index(c.First)].push_back(p);
      inner[Index(c.Second)].push_back(p);
      this->Mark(e.Loop, f.Loop);
      ++this->Counts[Index(e.Loop)].Crossings;
    }
    std::vector<PlanarEdge> split;
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      this->SplitEdge(this->Edges[i], inner[i], split);
    }
    this->Edges = std::move(split);
  }

  void SplitEdge(const PlanarEdge& e, std::vector<int>& inner, std::vector<PlanarEdge>& out) const
  {
    // Rounded crossings need not lie on the edge: they are ordered along its longer direction.
    const Point2& a = this->Points[Index(e.A)];
    const Point2& b = this->Points[Index(e.B)];
    const std::size_t k = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1;
    const double sign = b[k] < a[k] ? -1 : 1;
    std::sort(inner.begin(), inner.end(),
      [&](int p, int q)
      {
        const Point2& x = this->Points[Index(p)];
        const Point2& y = this->Points[Index(q)];
        return x[k] != y[k] ? sign * x[k] < sign * y[k] : x[1 - k] < y[1 - k];
      });
    int from = e.A;
    inner.push_back(e.B);
    for (int p : inner)
    {
      if (p != from)
      {
        out.push_back({ from, p, e.Loop, e.Weight });
        from = p;
      }
    }
  }

  EvenOddResult Collect()
  {
    std::vector<PlanarEdge> troubled;
    std::vector<bool> left(this->Loops.size(), false);
    for (const PlanarEdge& e : this->Edges)
    {
      left[Index(e.Loop)] = true;
      if (this->Trouble[Index(e.Loop)])
      {
        troubled.push_back(e);
      }
    }
    EvenOddResult result;
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      if (!this->Trouble[l] && !left[l])
      {
        result.Swallowed.push_back(static_cast<int>(l));
      }
      else if (!this->Trouble[l])
      {
        result.Loops.push_back({ this->Loops[l], static_cast<int>(l) });
      }
    }
    std::vector<EvenOddResult::Loop> traced;
    for (TracedLoop& loop : TraceLoops(this->Points, troubled))
    {
      int origin = troubled[Index(loop.Edges[0])].Loop;
      for (int e : loop.Edges)
      {
        origin = std::min(origin, troubled[Index(e)].Loop);
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
      if (!this->Trouble[l])
      {
        continue;
      }
      const int root = this->Sets.Find(static_cast<int>(l));
      EvenOddCluster& cluster = clusters[root];
      cluster.Loops.push_back(static_cast<int>(l));
      if (!left[l])
      {
        cluster.Vanished.push_back(static_cast<int>(l));
      }
      cluster.Crossings += this->Counts[l].Crossings;
      cluster.OnEdge += this->Counts[l].OnEdge;
      cluster.Cancelled += this->Counts[l].Cancelled;
      cluster.Shared += this->Counts[l].Shared;
      cluster.Merged += this->Counts[l].Merged;
      before[root].insert(CanonicalLoop(this->Loops[l]));
    }
    for (const EvenOddResult::Loop& loop : traced)
    {
      const int root = this->Sets.Find(loop.Origin);
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

  struct Count
  {
    std::size_t Crossings = 0;
    std::size_t OnEdge = 0;
    std::size_t Cancelled = 0;
    std::size_t Shared = 0;
    std::size_t Merged = 0;
  };

  std::vector<Point2>& Points;
  const std::vector<std::vector<int>>& Loops;
  bool Winding;
  DisjointSets Sets; ///< loops that have something to do with one another
  std::vector<Count> Counts;
  std::vector<bool> Trouble;
  std::vector<PlanarEdge> Edges;
  std::map<Point2, int> Known;
};
}

EvenOddResult ApplyEvenOddRule(
  std::vector<Point2>& points, const std::vector<std::vector<int>>& loops)
{
  return EvenOdd(points, loops, false).Apply();
}

EvenOddResult ApplyWindingRule(
  std::vector<Point2>& points, const std::vector<std::vector<int>>& loops)
{
  return EvenOdd(points, loops, true).Apply();
}
}
