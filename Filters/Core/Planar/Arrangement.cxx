// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/Arrangement.h"

#include "Base/Monitor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
// Rounding a crossing moves edges by an ulp or so; more passes than a few are seen only where
// edges lie about a tolerance apart, so that each snap brings the next.
constexpr int PassesWithinTolerance = 20;
constexpr int Growths = 4;
constexpr double Growth = 10;
// Outlines cross in a few places an edge. Every edge with every other, as scribbles do, is allowed
// up to the first figure.
constexpr std::size_t FewEdges = 100000;
constexpr std::size_t EdgesEach = 40;
}

std::size_t MostPiecesOf(std::size_t edges)
{
  return FewEdges + EdgesEach * edges;
}

Arrangement::Arrangement(std::vector<Point2>& points, std::vector<PlanarEdge> edges,
  std::vector<double> tolerances, SumType sum)
  : Points(points),
    All(std::move(edges)),
    Tolerances(std::move(tolerances)),
    Sum(sum),
    MostEdges(MostPiecesOf(this->All.size())),
    Sets(this->Tolerances.size()),
    InConflict(this->Tolerances.size(), false),
    Found(this->Tolerances.size())
{
}

void Arrangement::Resolve()
{
  for (int growth = 0; growth <= Growths; ++growth)
  {
    if (this->ResolveWithin(PassesWithinTolerance))
    {
      return;
    }
    for (double& tolerance : this->Tolerances)
    {
      tolerance *= Growth;
    }
    this->Unsettle();
  }
  throw Error("Contours cross in more places than double precision can tell apart.");
}

void Arrangement::Unsettle()
{
  for (PlanarEdge& e : this->All)
  {
    e.IsSettled = false;
  }
}

bool Arrangement::ResolveWithin(int passes)
{
  for (int pass = 0; pass < passes; ++pass)
  {
    this->SumEqual();
    if (this->All.size() > this->MostEdges)
    {
      throw Error("Contours cross one another in so many places that their edges fall into more "
                  "than " +
        std::to_string(this->MostEdges) + " pieces, which is no outline of anything.");
    }
    EdgeConflicts conflicts =
      FindEdgeConflicts(this->Points, this->All, this->Tolerances, this->MostEdges);
    if (conflicts.Empty())
    {
      return true;
    }
    // Points that become one may undo what else was found.
    if (conflicts.SamePlace.empty())
    {
      this->Split(conflicts);
    }
    else
    {
      this->Merge(std::move(conflicts.SamePlace));
      this->Unsettle();
    }
  }
  return false;
}

void Arrangement::Keep(const std::vector<bool>& kept)
{
  std::vector<PlanarEdge> left;
  for (std::size_t e = 0; e < this->All.size(); ++e)
  {
    if (kept[e])
    {
      left.push_back(this->All[e]);
    }
  }
  this->All = std::move(left);
}

void Arrangement::Join(int tag, int other)
{
  this->InConflict[tag] = this->InConflict[other] = true;
  this->Sets.Join(tag, other);
}

Arrangement::Findings& Arrangement::FoundAt(int edge)
{
  return this->Found[this->All[edge].Tag];
}

void Arrangement::SumEqual()
{
  const auto key = [](const PlanarEdge& e) { return std::minmax(e.A, e.B); };
  std::vector<int> order(this->All.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int e, int f) { return key(this->All[e]) < key(this->All[f]); });
  std::vector<bool> keep(this->All.size(), true);
  for (std::size_t i = 0; i < order.size();)
  {
    std::size_t end = i + 1;
    PlanarEdge& first = this->All[order[i]];
    while (end < order.size() && key(this->All[order[end]]) == key(first))
    {
      const PlanarEdge& next = this->All[order[end]];
      this->Join(first.Tag, next.Tag);
      first.Weight += next.A == first.A ? next.Weight : -next.Weight;
      keep[order[end]] = false;
      ++end;
    }
    const bool none = this->Sum == SumType::Weight ? first.Weight == 0 : (end - i) % 2 == 0;
    keep[order[i]] = !none;
    this->FoundAt(order[i]).Cancelled += end - i > 1 ? 1 : 0;
    i = end;
  }
  this->Keep(keep);
}

/// The first point stands for those near it; never for those that are near these only, as else a
/// finely sampled line would shrink to a point.
void Arrangement::Merge(std::vector<EdgeConflicts::Twins> twins)
{
  std::sort(twins.begin(), twins.end(),
    [](const EdgeConflicts::Twins& x, const EdgeConflicts::Twins& y)
    {
      return std::tie(x.Second, x.First, x.FirstEdge, x.OtherEdge) <
        std::tie(y.Second, y.First, y.FirstEdge, y.OtherEdge);
    });
  std::vector<int> standIn(this->Points.size());
  std::iota(standIn.begin(), standIn.end(), 0);
  for (const EdgeConflicts::Twins& t : twins)
  {
    this->Join(this->All[t.FirstEdge].Tag, this->All[t.OtherEdge].Tag);
    if (standIn[t.Second] != t.Second || standIn[t.First] != t.First)
    {
      continue;
    }
    standIn[t.Second] = t.First;
    Findings& found = this->FoundAt(t.FirstEdge);
    ++found.Merged;
    found.Moved = std::max(found.Moved, Distance(this->At(t.First), this->At(t.Second)));
  }
  this->MoveEnds(standIn);
}

void Arrangement::MoveEnds(const std::vector<int>& standIn)
{
  std::vector<PlanarEdge> moved;
  for (PlanarEdge e : this->All)
  {
    e.A = standIn[e.A];
    e.B = standIn[e.B];
    if (e.A != e.B)
    {
      moved.push_back(e);
    }
  }
  this->All = std::move(moved);
}

void Arrangement::Split(const EdgeConflicts& conflicts)
{
  std::vector<std::vector<int>> inner(this->All.size());
  this->AddTouches(conflicts, inner);
  this->AddCrossings(conflicts, inner);
  std::vector<PlanarEdge> split;
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    this->SplitEdge(this->All[i], inner[i], split);
  }
  this->All = std::move(split);
}

void Arrangement::AddTouches(const EdgeConflicts& conflicts, std::vector<std::vector<int>>& inner)
{
  for (const EdgeConflicts::Touch& t : conflicts.Touches)
  {
    this->Join(this->All[t.Edge].Tag, this->All[t.Other].Tag);
    std::vector<int>& onEdge = inner[t.Edge];
    // Several edges may end in the point; touches are sorted, so it is the last one that was added.
    if (onEdge.empty() || onEdge.back() != t.Vertex)
    {
      onEdge.push_back(t.Vertex);
      ++this->FoundAt(t.Edge).OnEdge;
    }
  }
}

void Arrangement::AddCrossings(const EdgeConflicts& conflicts, std::vector<std::vector<int>>& inner)
{
  for (const EdgeConflicts::Crossing& c : conflicts.Crossings)
  {
    const PlanarEdge& e = this->All[c.First];
    const PlanarEdge& f = this->All[c.Second];
    const int p =
      this->PointAt(CrossingPoint(this->At(e.A), this->At(e.B), this->At(f.A), this->At(f.B)));
    inner[c.First].push_back(p);
    inner[c.Second].push_back(p);
    this->Join(e.Tag, f.Tag);
    ++this->FoundAt(c.First).Crossings;
  }
}

void Arrangement::SplitEdge(
  const PlanarEdge& e, std::vector<int>& inner, std::vector<PlanarEdge>& out) const
{
  // Rounded crossings need not lie on the edge: they are ordered along its longer direction.
  const Point2& a = this->At(e.A);
  const Point2& b = this->At(e.B);
  const std::size_t k = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1;
  const double sign = b[k] < a[k] ? -1 : 1;
  std::sort(inner.begin(), inner.end(),
    [&](int p, int q)
    {
      const Point2& x = this->At(p);
      const Point2& y = this->At(q);
      return x[k] != y[k] ? sign * x[k] < sign * y[k] : x[1 - k] < y[1 - k];
    });
  int from = e.A;
  const bool isWhole = inner.empty();
  inner.push_back(e.B);
  for (int p : inner)
  {
    if (p != from)
    {
      out.push_back({ from, p, e.Tag, e.Weight, isWhole });
      from = p;
    }
  }
}

int Arrangement::PointAt(const Point2& p)
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
}
