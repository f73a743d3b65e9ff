// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/EdgeSweep.h"

#include "Base/Predicates.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>

namespace recon
{
namespace
{
class Sweep
{
public:
  Sweep(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
    : Points(points),
      Status(Below{ this })
  {
    for (const PlanarEdge& e : edges)
    {
      const bool right = RunsRight(points, e);
      this->Edges.push_back({ right ? e.A : e.B, right ? e.B : e.A });
    }
  }

  std::vector<SweptEdge> Run()
  {
    std::vector<int> starts(this->Edges.size());
    std::iota(starts.begin(), starts.end(), 0);
    std::vector<int> ends = starts;
    std::sort(
      starts.begin(), starts.end(), [this](int e, int f) { return this->StartsBefore(e, f); });
    std::sort(ends.begin(), ends.end(),
      [this](int e, int f)
      {
        const int x = this->Edges[e].Right;
        const int y = this->Edges[f].Right;
        return x != y ? this->At(x) < this->At(y) : e < f;
      });
    std::vector<StatusType::iterator> where(this->Edges.size(), this->Status.end());
    std::vector<SweptEdge> swept;
    std::size_t ended = 0;
    for (int e : starts)
    {
      const Point2& now = this->At(this->Edges[e].Left);
      for (; ended < ends.size() && !(now < this->At(this->Edges[ends[ended]].Right)); ++ended)
      {
        this->Status.erase(where[ends[ended]]);
      }
      const auto place = where[e] = this->Status.insert(e).first;
      swept.push_back({ e, place == this->Status.begin() ? -1 : *std::prev(place) });
    }
    return swept;
  }

private:
  /// From the smaller to the larger end, in the order of points.
  struct Ends
  {
    int Left;
    int Right;
  };
  struct Below
  {
    const Sweep* Owner;
    bool operator()(int e, int f) const { return this->Owner->IsBelow(e, f); }
  };
  using StatusType = std::set<int, Below>;

  const Point2& At(int p) const { return this->Points[p]; }

  bool StartsBefore(int e, int f) const
  {
    const Ends& x = this->Edges[e];
    const Ends& y = this->Edges[f];
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
    const Ends& x = this->Edges[e];
    const Ends& y = this->Edges[f];
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

  const std::vector<Point2>& Points;
  std::vector<Ends> Edges;
  StatusType Status;
};
}

std::vector<SweptEdge> SweepEdges(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  return Sweep(points, edges).Run();
}
}
