// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/MaterialWalker.h"

#include "Base/Predicates.h"
#include "Planar/TurnOrder.h"

#include <algorithm>
#include <map>
#include <set>

namespace recon
{
namespace
{
/// One side of an edge, walked with the material to the left.
struct HalfEdge
{
  int From = 0;
  int To = 0;
  bool Used = false;
};

/// The half-edges of one material, and how to walk on from one to the next.
class HalfEdges
{
public:
  void Add(int from, int to)
  {
    this->Outgoing[from].push_back(static_cast<int>(this->All.size()));
    ++this->Balance[from];
    --this->Balance[to];
    this->All.push_back({ from, to, false });
  }

  /// Where a walk that never closes has to begin: more edges leave than arrive.
  std::vector<int> OpenStarts() const
  {
    std::vector<int> starts;
    for (const auto& [vertex, balance] : this->Balance)
    {
      starts.insert(starts.end(), static_cast<std::size_t>(std::max(balance, 0)), vertex);
    }
    return starts;
  }

  /// Clockwise from where one came from: the next edge there bounds the same corner of the
  /// material.
  int NextAfter(int from, int at, const std::vector<Point2>& points) const
  {
    const auto found = this->Outgoing.find(at);
    int best = -1;
    for (const int candidate : found == this->Outgoing.end() ? std::vector<int>() : found->second)
    {
      const HalfEdge& half = this->All[static_cast<std::size_t>(candidate)];
      if (half.Used)
      {
        continue;
      }
      // Where a walk begins, any will do.
      if (best < 0 ||
        (from >= 0 &&
          ComesFirstClockwise(points[static_cast<std::size_t>(at)],
            points[static_cast<std::size_t>(from)], points[static_cast<std::size_t>(half.To)],
            points[static_cast<std::size_t>(this->All[static_cast<std::size_t>(best)].To)])))
      {
        best = candidate;
      }
    }
    return best;
  }

  std::vector<HalfEdge> All;

private:
  std::map<int, std::vector<int>> Outgoing;
  std::map<int, int> Balance;
};
}

MaterialWalker::MaterialWalker(
  const Vector3& normal, const std::vector<Point3>& vertices, const std::vector<NetworkEdge>& edges)
  : Edges(edges)
{
  const PlanarFrame frame = PlanarFrame::About(normal);
  for (const Point3& vertex : vertices)
  {
    this->Planar.push_back(frame.ToPlane(vertex));
  }
}

bool MaterialWalker::SwapSidesWhereZeroIsInside()
{
  int extreme = -1;
  for (const NetworkEdge& edge : this->Edges)
  {
    for (const int end : { edge.From, edge.To })
    {
      if (extreme < 0 ||
        this->Planar[static_cast<std::size_t>(end)] >
          this->Planar[static_cast<std::size_t>(extreme)])
      {
        extreme = end;
      }
    }
  }
  // All edges at the extreme vertex run to its left or straight down; counterclockwise from straight
  // to the right, the first of them has the open wedge on its right-hand side.
  const NetworkEdge* first = nullptr;
  const auto other = [extreme](const NetworkEdge& edge)
  { return static_cast<std::size_t>(edge.From == extreme ? edge.To : edge.From); };
  for (const NetworkEdge& edge : this->Edges)
  {
    if (edge.From != extreme && edge.To != extreme)
    {
      continue;
    }
    if (!first ||
      Orientation2(this->Planar[static_cast<std::size_t>(extreme)], this->Planar[other(edge)],
        this->Planar[other(*first)]) > 0)
    {
      first = &edge;
    }
  }
  if (!first)
  {
    return false;
  }
  const bool leaves = first->From == extreme;
  const int outside = leaves ? first->Right : first->Left;
  const int inside = leaves ? first->Left : first->Right;
  if (outside == 0 || inside != 0)
  {
    return false;
  }
  for (NetworkEdge& edge : this->Edges)
  {
    std::swap(edge.Left, edge.Right);
  }
  return true;
}

std::vector<int> MaterialWalker::GetMaterials() const
{
  std::set<int> materials;
  for (const NetworkEdge& edge : this->Edges)
  {
    materials.insert({ edge.Left, edge.Right });
  }
  materials.erase(0);
  return std::vector<int>(materials.begin(), materials.end());
}

std::vector<MaterialWalk> MaterialWalker::Walk(int material) const
{
  HalfEdges halves;
  for (const NetworkEdge& edge : this->Edges)
  {
    if (edge.Left == material)
    {
      halves.Add(edge.From, edge.To);
    }
    else if (edge.Right == material)
    {
      halves.Add(edge.To, edge.From);
    }
  }
  std::vector<MaterialWalk> walks;
  const auto walkFrom = [&](int half, bool isOpen)
  {
    MaterialWalk walk;
    const int start = halves.All[static_cast<std::size_t>(half)].From;
    int from = start;
    while (half >= 0)
    {
      HalfEdge& current = halves.All[static_cast<std::size_t>(half)];
      current.Used = true;
      walk.Vertices.push_back(current.From);
      from = current.From;
      const int at = current.To;
      half = !isOpen && at == start ? -1 : halves.NextAfter(from, at, this->Planar);
      if (half < 0)
      {
        walk.Closed = at == start;
        if (!walk.Closed)
        {
          walk.Vertices.push_back(at);
        }
      }
    }
    walks.push_back(std::move(walk));
  };
  for (const int vertex : halves.OpenStarts())
  {
    const int half = halves.NextAfter(-1, vertex, this->Planar);
    if (half >= 0)
    {
      walkFrom(half, true);
    }
  }
  for (std::size_t i = 0; i < halves.All.size(); ++i)
  {
    if (!halves.All[i].Used)
    {
      walkFrom(static_cast<int>(i), false);
    }
  }
  return walks;
}
}
