// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/NestingForest.h"

#include "Base/Predicates.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace recon
{
namespace
{
/// An edge from its smaller to its larger end, in the order of points.
struct SweepEdge
{
  int Left = -1;
  int Right = -1;
  int Loop = -1;
  bool InsideAbove = false; ///< the inside of its own loop
};

class Sweep
{
public:
  Sweep(const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops)
    : Points(points),
      Status(Below{ this })
  {
    this->Forest.Parent.assign(loops.size(), -1);
    this->Forest.Depth.assign(loops.size(), -1);
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      this->AddLoop(loops[l], static_cast<int>(l));
    }
  }

  NestingForest Run()
  {
    // Sorted by left end; at one left end from low to high, so that a loop's neighbour below is
    // known.
    std::vector<int> starts(this->Edges.size());
    for (std::size_t i = 0; i < starts.size(); ++i)
    {
      starts[i] = static_cast<int>(i);
    }
    std::vector<int> ends = starts;
    std::sort(
      starts.begin(), starts.end(), [this](int e, int f) { return this->StartsBefore(e, f); });
    std::sort(ends.begin(), ends.end(),
      [this](int e, int f)
      {
        const SweepEdge& x = this->Edges[e];
        const SweepEdge& y = this->Edges[f];
        return x.Right != y.Right ? this->At(x.Right) < this->At(y.Right) : e < f;
      });
    this->Where.assign(this->Edges.size(), this->Status.end());
    std::size_t ended = 0;
    for (int e : starts)
    {
      const Point2& now = this->At(this->Edges[e].Left);
      for (; ended < ends.size() && !(now < this->At(this->Edges[ends[ended]].Right)); ++ended)
      {
        this->Status.erase(this->Where[ends[ended]]);
      }
      const auto place = this->Status.insert(e).first;
      this->Where[e] = place;
      this->PlaceLoop(e, place);
    }
    return std::move(this->Forest);
  }

private:
  struct Below
  {
    const Sweep* Owner;
    bool operator()(int e, int f) const { return this->Owner->IsBelow(e, f); }
  };
  using StatusType = std::set<int, Below>;

  const Point2& At(int p) const { return this->Points[p]; }

  void AddLoop(const std::vector<int>& loop, int number)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      const bool forward = this->At(a) < this->At(b);
      // Counterclockwise: the inside is left of the walk, above an edge that is walked to the
      // right.
      this->Edges.push_back({ forward ? a : b, forward ? b : a, number, forward });
    }
  }

  bool StartsBefore(int e, int f) const
  {
    const SweepEdge& x = this->Edges[e];
    const SweepEdge& y = this->Edges[f];
    if (x.Left != y.Left)
    {
      return this->At(x.Left) < this->At(y.Left);
    }
    if (x.Right == y.Right)
    {
      return e < f;
    }
    return Orientation2(this->At(x.Left), this->At(x.Right), this->At(y.Right)) > 0;
  }

  /// Order of two edges that the sweep line meets at once; they do not cross.
  bool IsBelow(int e, int f) const
  {
    if (e == f)
    {
      return false;
    }
    const SweepEdge& x = this->Edges[e];
    const SweepEdge& y = this->Edges[f];
    if (x.Left == y.Left)
    {
      return this->StartsBefore(e, f);
    }
    if (this->At(x.Left) < this->At(y.Left))
    {
      return Orientation2(this->At(x.Left), this->At(x.Right), this->At(y.Left)) > 0;
    }
    return Orientation2(this->At(y.Left), this->At(y.Right), this->At(x.Left)) < 0;
  }

  /// The first edge of a loop that comes in is the lower one at its leftmost point.
  void PlaceLoop(int e, StatusType::iterator place)
  {
    const int loop = this->Edges[e].Loop;
    if (this->Forest.Depth[loop] >= 0)
    {
      return;
    }
    int parent = -1;
    if (place != this->Status.begin())
    {
      const SweepEdge& below = this->Edges[*std::prev(place)];
      parent = below.InsideAbove ? below.Loop : this->Forest.Parent[below.Loop];
    }
    this->Forest.Parent[loop] = parent;
    this->Forest.Depth[loop] = parent < 0 ? 0 : this->Forest.Depth[parent] + 1;
  }

  const std::vector<Point2>& Points;
  std::vector<SweepEdge> Edges;
  StatusType Status;
  std::vector<StatusType::iterator> Where;
  NestingForest Forest;
};

/// The turn at the smallest point: the exact sense of a simple loop.
int SenseOf(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  const auto smallest = std::min_element(
    loop.begin(), loop.end(), [&points](int p, int q) { return points[p] < points[q]; });
  const auto i = static_cast<std::size_t>(smallest - loop.begin());
  const std::size_t n = loop.size();
  return Orientation2(points[loop[(i + n - 1) % n]], points[loop[i]], points[loop[(i + 1) % n]]);
}

double ExactArea(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  using Rational = CGAL::Exact_rational;
  Rational twice(0);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = points[loop[i]];
    const Point2& b = points[loop[(i + 1) % loop.size()]];
    twice += Rational(a[0]) * Rational(b[1]) - Rational(b[0]) * Rational(a[1]);
  }
  return CGAL::to_double(Rational(twice / 2));
}
}

double SignedAreaOf(const std::vector<Point2>& points, const std::vector<int>& loop)
{
  const Point2& o = points[loop[0]];
  double area = 0;
  double size = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    const Point2& a = points[loop[i]];
    const Point2& b = points[loop[i + 1]];
    const double left = 0.5 * (a[0] - o[0]) * (b[1] - o[1]);
    const double right = 0.5 * (b[0] - o[0]) * (a[1] - o[1]);
    area += left - right;
    size += std::abs(left) + std::abs(right);
  }
  // Slivers, whose terms cancel, are summed exactly.
  const int sense = SenseOf(points, loop);
  return area * sense > 1e-4 * size ? area : ExactArea(points, loop);
}

NestingForest BuildNestingForest(
  const std::vector<Point2>& points, const std::vector<std::vector<int>>& loops)
{
  return Sweep(points, loops).Run();
}
}
