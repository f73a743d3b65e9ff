// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/VertexMargins.h"

#include "Base/Angles.h"
#include "Planar/PlanarEdges.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// A margin that had to shrink below this part of d says nothing but noise, and is left out.
constexpr double LeastMargin = 1e-6;
/// What is left of d after a step that found no room.
constexpr double ShrinkStep = 0.7;

/// Finds room for the two margins of every vertex of one level.
class LevelMargins
{
public:
  LevelMargins(const ContourSet& contours, int level, double distance)
    : Contours(contours),
      Frame(contours.Levels[level].Frame),
      Edges(contours, level),
      Level(level),
      Distance(distance)
  {
  }

  VertexMargins At(int contour, std::size_t position) const
  {
    const std::vector<int>& points = this->Contours.Contours[contour].Points;
    const int v = points[position];
    const int next = points[(position + 1) % points.size()];
    VertexMargins margins;
    margins.Vertex = this->Contours.Points[v];
    margins.Contour = contour;
    margins.Level = this->Level;
    const double along = this->AngleTo(v, next);
    // The solid is on the left of every contour (ContourSet.h).
    const double left = along + 0.5 * this->SectorFrom(v, along, next, +1);
    const double right = along - 0.5 * this->SectorFrom(v, along, next, -1);
    margins.InnerDistance = this->Place(v, left, PlanarEdges::Inside, margins.Inner);
    margins.OuterDistance = this->Place(v, right, PlanarEdges::Outside, margins.Outer);
    margins.InnerValue = margins.InnerDistance;
    margins.OuterValue = margins.OuterDistance;
    return margins;
  }

private:
  double AngleTo(int from, int to) const
  {
    const Point2& a = this->Contours.Planar[from];
    const Point2& b = this->Contours.Planar[to];
    return std::atan2(b[1] - a[1], b[0] - a[0]);
  }

  /// The angle, turning by sign from the edge to `next`, to the first other edge at v (of any
  /// contour).
  double SectorFrom(int v, double along, int next, int sign) const
  {
    double least = 2 * Pi;
    for (const int e : this->Edges.EdgesAt(v))
    {
      const PlanarEdges::Edge& edge = this->Edges.Edges()[e];
      const int other = edge.From == v ? edge.To : edge.From;
      if (other == next)
      {
        continue;
      }
      double turn = std::fmod(sign * (this->AngleTo(v, other) - along), 2 * Pi);
      turn = turn < 0 ? turn + 2 * Pi : turn;
      least = std::min(least, turn);
    }
    return least;
  }

  /// Moves from v in the direction of an angle as far as there is room; returns the distance to the
  /// contour.
  double Place(int v, double angle, PlanarEdges::SideType side, Point3& place) const
  {
    const Point2& from = this->Contours.Planar[v];
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    for (double t = this->Distance; t >= LeastMargin * this->Distance; t *= ShrinkStep)
    {
      place = this->Contours.Points[v] + t * (x * this->Frame.U + y * this->Frame.V);
      // The margin is judged where it will be, after rounding.
      const Point2 at = this->Frame.ToPlane(place);
      const double own = this->Edges.DistanceToOwn(v, at);
      const double beyond = std::nextafter(own, HUGE_VAL);
      if (this->Edges.DistanceToOthers(v, at, beyond) > own && this->Edges.SideOf(at) == side &&
        !this->Edges.CrossesOthers(v, from, at))
      {
        return own;
      }
    }
    return 0;
  }

  const ContourSet& Contours;
  const PlanarFrame Frame;
  const PlanarEdges Edges;
  const int Level;
  const double Distance;
};

}

std::vector<VertexMargins> PlaceMargins(
  const ContourSet& contours, double distance, Monitor& monitor)
{
  std::vector<VertexMargins> all;
  const int levels = static_cast<int>(contours.Levels.size());
  for (int level = 0; level < levels; ++level)
  {
    monitor.Update(static_cast<double>(level) / levels, "telling inside from outside");
    const LevelMargins margins(contours, level, distance);
    for (const int c : contours.Levels[level].Contours)
    {
      for (std::size_t i = 0; i < contours.Contours[c].Points.size(); ++i)
      {
        all.push_back(margins.At(c, i));
      }
    }
  }
  return all;
}
}
