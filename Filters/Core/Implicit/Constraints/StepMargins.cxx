// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/StepMargins.h"

#include "Contours/ContourMeasures.h"
#include "Planar/PlanarEdges.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// How far margins reach across a step, in parts of the distance to the level that makes it; the
/// first that has room counts.
constexpr double StepReaches[] = { 1, 0.7 };
/// A reaching margin keeps this part of its reach from all contours of its level.
constexpr double StepRoom = 0.8;
/// Contours of the other level count up to this many times the distance between the levels.
constexpr double StepHorizon = 10;

/// The levels with their edges, by height.
class StepMargins
{
public:
  explicit StepMargins(const ContourSet& contours) : Contours(contours)
  {
    for (int level = 0; level < static_cast<int>(contours.Levels.size()); ++level)
    {
      this->Edges.emplace_back(contours, level);
      this->Order.push_back(level);
    }
    std::sort(this->Order.begin(), this->Order.end(),
      [this](int a, int b) { return this->HeightOf(a) < this->HeightOf(b); });
    this->Rank.resize(this->Order.size());
    for (std::size_t r = 0; r < this->Order.size(); ++r)
    {
      this->Rank[this->Order[r]] = r;
    }
  }

  void Reach(int vertex, VertexMargins& m) const
  {
    this->Reach(vertex, m, PlanarEdges::Inside, m.Inner, m.InnerDistance, m.InnerValue);
    this->Reach(vertex, m, PlanarEdges::Outside, m.Outer, m.OuterDistance, m.OuterValue);
  }

private:
  double HeightOf(int level) const
  {
    return recon::HeightOf(
      this->Contours.Levels[level], this->Contours.Levels.front().Frame.Normal);
  }

  std::vector<int> NeighboursOf(int level) const
  {
    std::vector<int> neighbours;
    const std::size_t rank = this->Rank[level];
    if (rank > 0)
    {
      neighbours.push_back(this->Order[rank - 1]);
    }
    if (rank + 1 < this->Order.size())
    {
      neighbours.push_back(this->Order[rank + 1]);
    }
    return neighbours;
  }

  void Reach(int vertex, const VertexMargins& m, PlanarEdges::SideType side, Point3& place,
    double& distance, double& value) const
  {
    if (!(distance > 0))
    {
      return;
    }
    const Vector3 direction = (1 / Norm(place - m.Vertex)) * (place - m.Vertex);
    for (const double part : StepReaches)
    {
      for (const int next : this->NeighboursOf(m.Level))
      {
        const double reach = part * std::abs(this->HeightOf(next) - this->HeightOf(m.Level));
        const Point3 there = m.Vertex + reach * direction;
        const double room = this->RoomAt(vertex, m.Level, there, side);
        if (!(reach > distance && room >= StepRoom * reach))
        {
          continue;
        }
        const double away = this->SurfaceAwayFrom(m.Level, there, side, room);
        if (away > 0)
        {
          place = there;
          distance = room;
          value = room * away / std::hypot(room, away);
          return;
        }
      }
    }
  }

  /// Distance to the contours of the level, 0 on the wrong side of one.
  double RoomAt(int vertex, int level, const Point3& there, PlanarEdges::SideType side) const
  {
    const PlanarEdges& edges = this->Edges[level];
    const PlanarFrame& frame = this->Contours.Levels[level].Frame;
    const Point2 at = frame.ToPlane(there);
    const Point2& from = this->Contours.Planar[vertex];
    if (edges.SideOf(at) != side || edges.CrossesOthers(vertex, from, at))
    {
      return 0;
    }
    return edges.DistanceToOthers(vertex, at, edges.DistanceToOwn(vertex, at));
  }

  /// How far above or below the surface lies by shape-based interpolation (the ratio of the
  /// distances to the contours of both levels); 0 where no neighbour says otherwise of the place.
  double SurfaceAwayFrom(
    int level, const Point3& there, PlanarEdges::SideType side, double room) const
  {
    double least = 0;
    for (const int next : this->NeighboursOf(level))
    {
      const PlanarEdges& edges = this->Edges[next];
      const Point2 at = this->Contours.Levels[next].Frame.ToPlane(there);
      const PlanarEdges::SideType other = edges.SideOf(at);
      if (other == side || other == PlanarEdges::On)
      {
        continue;
      }
      const double gap = std::abs(this->HeightOf(next) - this->HeightOf(level));
      const double horizon = StepHorizon * gap;
      const double far = std::min(edges.DistanceToOthers(-1, at, horizon), horizon);
      const double away = room / (room + far) * gap;
      least = least > 0 ? std::min(least, away) : away;
    }
    return least;
  }

  const ContourSet& Contours;
  std::vector<PlanarEdges> Edges;
  std::vector<int> Order; ///< of the levels, by height
  std::vector<std::size_t> Rank;
};
}

void ReachAcrossSteps(
  const ContourSet& contours, std::vector<VertexMargins>& margins, Monitor& monitor)
{
  const StepMargins steps(contours);
  std::size_t i = 0;
  for (const Level& level : contours.Levels)
  {
    monitor.Update(static_cast<double>(i) / margins.size(), "telling inside from outside");
    for (const int c : level.Contours)
    {
      for (const int vertex : contours.Contours[c].Points)
      {
        steps.Reach(vertex, margins[i++]);
      }
    }
  }
}
}
