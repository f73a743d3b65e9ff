// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/LoopTracing.h"

#include "Base/Monitor.h"
#include "Base/Predicates.h"
#include "Planar/TurnOrder.h"

#include <algorithm>
#include <cstddef>

namespace recon
{
namespace
{
class Tracer
{
public:
  Tracer(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
    : Points(points),
      Edges(edges),
      Direction(edges.size(), 0)
  {
    this->BuildFans();
  }

  std::vector<TracedLoop> Trace()
  {
    this->DirectEdges();
    std::vector<TracedLoop> loops;
    std::vector<bool> used(this->Edges.size(), false);
    std::vector<int> position(this->Points.size(), -1);
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      if (!used[i])
      {
        this->TraceFrom(static_cast<int>(i), used, position, loops);
      }
    }
    return loops;
  }

private:
  int Start(int e) const { return this->Direction[e] > 0 ? this->Edges[e].A : this->Edges[e].B; }
  int End(int e) const { return this->Direction[e] > 0 ? this->Edges[e].B : this->Edges[e].A; }
  int Other(int e, int p) const
  {
    return this->Edges[e].A == p ? this->Edges[e].B : this->Edges[e].A;
  }

  /// The edges around every point, counterclockwise.
  void BuildFans()
  {
    this->First.assign(this->Points.size() + 1, 0);
    for (const PlanarEdge& e : this->Edges)
    {
      ++this->First[e.A + 1];
      ++this->First[e.B + 1];
    }
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      this->First[p + 1] += this->First[p];
    }
    std::vector<int> fill(this->First.begin(), this->First.end() - 1);
    this->Fan.resize(2 * this->Edges.size());
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      this->Fan[fill[this->Edges[i].A]++] = static_cast<int>(i);
      this->Fan[fill[this->Edges[i].B]++] = static_cast<int>(i);
    }
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      const int degree = this->First[p + 1] - this->First[p];
      if (degree % 2 != 0)
      {
        throw Error(
          "Contours do not close after crossings were resolved; please report this input.");
      }
      if (degree > 2)
      {
        this->SortFan(static_cast<int>(p));
      }
    }
  }

  /// Exact order by angle, starting at the direction straight down (exclusive).
  void SortFan(int p)
  {
    const auto before = [&](int e, int f)
    {
      return ComesFirstFromBelow(
        this->Points[p], this->Points[this->Other(e, p)], this->Points[this->Other(f, p)]);
    };
    std::sort(this->Fan.begin() + this->First[p], this->Fan.begin() + this->First[p + 1], before);
  }

  /// Gives every edge the direction that has the inside on its left.
  void DirectEdges()
  {
    std::vector<int> order(this->Points.size());
    for (std::size_t p = 0; p < order.size(); ++p)
    {
      order[p] = static_cast<int>(p);
    }
    std::sort(order.begin(), order.end(),
      [this](int p, int q) { return this->Points[p] < this->Points[q]; });
    // The first point of a connected piece has the outside on its left: the lowest edge goes out.
    for (int p : order)
    {
      if (this->First[p] == this->First[p + 1])
      {
        continue;
      }
      const int lowest = this->LowestAt(p);
      if (this->Direction[lowest] == 0)
      {
        this->Direction[lowest] = this->Edges[lowest].A == p ? 1 : -1;
        this->Spread(p);
      }
    }
  }

  int LowestAt(int p) const
  {
    const int e = this->Fan[this->First[p]];
    const int f = this->Fan[this->First[p] + 1];
    const bool two = this->First[p + 1] - this->First[p] == 2;
    const bool swap = two &&
      Orientation2(
        this->Points[p], this->Points[this->Other(e, p)], this->Points[this->Other(f, p)]) < 0;
    return swap ? f : e;
  }

  /// Around a point, directions alternate out and in.
  void Spread(int first)
  {
    std::vector<int> stack{ first };
    while (!stack.empty())
    {
      const int p = stack.back();
      stack.pop_back();
      const int begin = this->First[p];
      const int degree = this->First[p + 1] - begin;
      int known = 0;
      while (this->Direction[this->Fan[begin + known]] == 0)
      {
        ++known;
      }
      const bool knownOut = this->Start(this->Fan[begin + known]) == p;
      for (int k = 0; k < degree; ++k)
      {
        const int e = this->Fan[begin + k];
        const bool out = knownOut == ((k - known) % 2 == 0);
        if (this->Direction[e] == 0)
        {
          this->Direction[e] = (this->Edges[e].A == p) == out ? 1 : -1;
          stack.push_back(this->Other(e, p));
        }
        else if ((this->Start(e) == p) != out)
        {
          throw Error("Contours cannot be told inside from outside by the even-odd rule; please "
                      "report this input.");
        }
      }
    }
  }

  /// The edge that goes on along the same bit of inside: the next one clockwise.
  int Next(int e) const
  {
    const int p = this->End(e);
    const int begin = this->First[p];
    const int degree = this->First[p + 1] - begin;
    int k = 0;
    while (this->Fan[begin + k] != e)
    {
      ++k;
    }
    return this->Fan[begin + (k + degree - 1) % degree];
  }

  /// Follows one boundary of the inside; a loop is cut off wherever it comes back to a point.
  void TraceFrom(int e, std::vector<bool>& used, std::vector<int>& position,
    std::vector<TracedLoop>& loops) const
  {
    std::vector<int> path;
    position[this->Start(e)] = 0;
    do
    {
      used[e] = true;
      path.push_back(e);
      int& at = position[this->End(e)];
      if (at < 0)
      {
        at = static_cast<int>(path.size());
      }
      else
      {
        loops.push_back(this->CutLoop(path, at, position));
      }
      e = this->Next(e);
    } while (!used[e]);
    position[this->Start(e)] = -1;
  }

  TracedLoop CutLoop(std::vector<int>& path, std::size_t from, std::vector<int>& position) const
  {
    TracedLoop loop;
    for (std::size_t i = from; i < path.size(); ++i)
    {
      loop.Points.push_back(this->Start(path[i]));
      loop.Edges.push_back(path[i]);
      if (i > from)
      {
        position[this->Start(path[i])] = -1;
      }
    }
    path.resize(from);
    return loop;
  }

  const std::vector<Point2>& Points;
  const std::vector<PlanarEdge>& Edges;
  std::vector<signed char> Direction; ///< +1 A to B, -1 B to A, 0 not known yet
  std::vector<int> First;             ///< where a point's fan begins in Fan
  std::vector<int> Fan;
};
}

std::vector<TracedLoop> TraceLoops(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  return Tracer(points, edges).Trace();
}
}
