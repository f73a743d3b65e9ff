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
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

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
  int Start(int e) const
  {
    return this->Direction[Index(e)] > 0 ? this->Edges[Index(e)].A : this->Edges[Index(e)].B;
  }
  int End(int e) const
  {
    return this->Direction[Index(e)] > 0 ? this->Edges[Index(e)].B : this->Edges[Index(e)].A;
  }
  int Other(int e, int p) const
  {
    return this->Edges[Index(e)].A == p ? this->Edges[Index(e)].B : this->Edges[Index(e)].A;
  }

  /// The edges around every point, counterclockwise.
  void BuildFans()
  {
    this->First.assign(this->Points.size() + 1, 0);
    for (const PlanarEdge& e : this->Edges)
    {
      ++this->First[Index(e.A) + 1];
      ++this->First[Index(e.B) + 1];
    }
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      this->First[p + 1] += this->First[p];
    }
    std::vector<int> fill(this->First.begin(), this->First.end() - 1);
    this->Fan.resize(2 * this->Edges.size());
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      this->Fan[Index(fill[Index(this->Edges[i].A)]++)] = static_cast<int>(i);
      this->Fan[Index(fill[Index(this->Edges[i].B)]++)] = static_cast<int>(i);
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
      return ComesFirstFromBelow(this->Points[Index(p)], this->Points[Index(this->Other(e, p))],
        this->Points[Index(this->Other(f, p))]);
    };
    std::sort(this->Fan.begin() + this->First[Index(p)],
      this->Fan.begin() + this->First[Index(p) + 1], before);
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
      [this](int p, int q) { return this->Points[Index(p)] < this->Points[Index(q)]; });
    // The first point of a connected piece has the outside on its left: the lowest edge goes out.
    for (int p : order)
    {
      if (this->First[Index(p)] == this->First[Index(p) + 1])
      {
        continue;
      }
      const int lowest = this->LowestAt(p);
      if (this->Direction[Index(lowest)] == 0)
      {
        this->Direction[Index(lowest)] = this->Edges[Index(lowest)].A == p ? 1 : -1;
        this->Spread(p);
      }
    }
  }

  int LowestAt(int p) const
  {
    const int e = this->Fan[Index(this->First[Index(p)])];
    const int f = this->Fan[Index(this->First[Index(p)]) + 1];
    const bool two = this->First[Index(p) + 1] - this->First[Index(p)] == 2;
    const bool swap = two &&
      Orientation2(this->Points[Index(p)], this->Points[Index(this->Other(e, p))],
        this->Points[Index(this->Other(f, p))]) < 0;
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
      const int begin = this->First[Index(p)];
      const int degree = this->First[Index(p) + 1] - begin;
      int known = 0;
      while (this->Direction[Index(this->Fan[Index(begin + known)])] == 0)
      {
        ++known;
      }
      const bool knownOut = this->Start(this->Fan[Index(begin + known)]) == p;
      for (int k = 0; k < degree; ++k)
      {
        const int e = this->Fan[Index(begin + k)];
        const bool out = knownOut == ((k - known) % 2 == 0);
        if (this->Direction[Index(e)] == 0)
        {
          this->Direction[Index(e)] = (this->Edges[Index(e)].A == p) == out ? 1 : -1;
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
    const int begin = this->First[Index(p)];
    const int degree = this->First[Index(p) + 1] - begin;
    int k = 0;
    while (this->Fan[Index(begin + k)] != e)
    {
      ++k;
    }
    return this->Fan[Index(begin + (k + degree - 1) % degree)];
  }

  /// Follows one boundary of the inside; a loop is cut off wherever it comes back to a point.
  void TraceFrom(int e, std::vector<bool>& used, std::vector<int>& position,
    std::vector<TracedLoop>& loops) const
  {
    std::vector<int> path;
    position[Index(this->Start(e))] = 0;
    do
    {
      used[Index(e)] = true;
      path.push_back(e);
      int& at = position[Index(this->End(e))];
      if (at < 0)
      {
        at = static_cast<int>(path.size());
      }
      else
      {
        loops.push_back(this->CutLoop(path, Index(at), position));
      }
      e = this->Next(e);
    } while (!used[Index(e)]);
    position[Index(this->Start(e))] = -1;
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
        position[Index(this->Start(path[i]))] = -1;
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
