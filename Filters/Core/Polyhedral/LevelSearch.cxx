// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/LevelSearch.h"

#include "Polyhedral/VertexStars.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
constexpr double Never = std::numeric_limits<double>::infinity();

std::vector<std::array<int, 2>> ContourEdgesOf(const LevelTriangulation& level)
{
  std::vector<std::array<int, 2>> edges;
  for (int t = 0; t < static_cast<int>(level.Triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (level.EdgeContour[t][k] >= 0 && CanonicalEdge(level, t, k) == 3 * t + k)
      {
        edges.push_back({ { level.Triangles[t][(k + 1) % 3], level.Triangles[t][(k + 2) % 3] } });
      }
    }
  }
  return edges;
}

std::vector<Box2> BoxesOf(const LevelTriangulation& level)
{
  std::vector<Box2> boxes;
  for (const Point2& p : level.Points)
  {
    boxes.emplace_back(p, p);
  }
  return boxes;
}

std::vector<Box2> BoxesOf(
  const LevelTriangulation& level, const std::vector<std::array<int, 2>>& edges)
{
  std::vector<Box2> boxes;
  for (const auto& edge : edges)
  {
    boxes.push_back(
      Box2::Around(std::array<Point2, 2>{ { level.Points[edge[0]], level.Points[edge[1]] } }));
  }
  return boxes;
}

/// A point as the line sees it: how far along, in its own unit, and how far beside it, in length.
struct Seen
{
  double Along;
  double Beside;
};

Seen See(const PlanarLine& line, const Point2& p)
{
  const double dx = line.Direction[0], dy = line.Direction[1];
  const double px = p[0] - line.Origin[0], py = p[1] - line.Origin[1];
  const double squared = dx * dx + dy * dy;
  return { (dx * px + dy * py) / squared, (dx * py - dy * px) / std::sqrt(squared) };
}

/// No contour edge in the box comes near the line before that.
double EarliestIn(const Box2& box, const PlanarLine& line, double tolerance)
{
  const double dx = std::abs(line.Direction[0]), dy = std::abs(line.Direction[1]);
  const double squared = dx * dx + dy * dy;
  const double length = std::sqrt(squared);
  const Seen middle = See(line, box.Middle());
  const double halfX = 0.5 * box.Extent(0), halfY = 0.5 * box.Extent(1);
  const double along = (dx * halfX + dy * halfY) / squared + 2 * tolerance / length;
  const bool beside = std::abs(middle.Beside) > (dy * halfX + dx * halfY) / length + 2 * tolerance;
  const bool apart = middle.Along + along < line.From || middle.Along - along > line.To;
  return beside || apart ? Never : middle.Along - along;
}
}

VertexSearch::VertexSearch(const LevelTriangulation& level) : Level(level), Vertices(BoxesOf(level))
{
}

LevelSearch::LevelSearch(const LevelTriangulation& level)
  : VertexSearch(level),
    Edges(ContourEdgesOf(level)),
    Contours(BoxesOf(level, Edges))
{
}

int VertexSearch::NearestVertex(const Point2& p) const
{
  return this->Vertices
    .Least([&](const Box2& box) { return box.SquaredDistanceTo(p); },
      [&](int v)
      {
        const double dx = this->Level.Points[v][0] - p[0], dy = this->Level.Points[v][1] - p[1];
        return dx * dx + dy * dy;
      })
    .Number;
}

std::optional<LineInterval> LevelSearch::FirstContour(
  const PlanarLine& line, double tolerance) const
{
  const auto found =
    this->Contours.Least([&](const Box2& box) { return EarliestIn(box, line, tolerance); },
      [&](int edge)
      {
        const auto near = this->Near(edge, line, tolerance);
        return near ? near->From : Never;
      });
  return found.Number < 0 ? std::nullopt : this->Near(found.Number, line, tolerance);
}

std::optional<LineInterval> LevelSearch::Near(
  int edge, const PlanarLine& line, double tolerance) const
{
  const Seen p = See(line, this->Level.Points[this->Edges[edge][0]]);
  const Seen q = See(line, this->Level.Points[this->Edges[edge][1]]);
  if (std::min(p.Beside, q.Beside) > tolerance || std::max(p.Beside, q.Beside) < -tolerance)
  {
    return std::nullopt;
  }
  // The part of the edge from p to q within the tolerance of the line.
  const double rise = q.Beside - p.Beside;
  double from = 0, to = 1;
  if (std::abs(rise) > tolerance)
  {
    const double first = (-tolerance - p.Beside) / rise, second = (tolerance - p.Beside) / rise;
    from = std::clamp(std::min(first, second), 0.0, 1.0);
    to = std::clamp(std::max(first, second), 0.0, 1.0);
  }
  const double margin = tolerance / std::hypot(line.Direction[0], line.Direction[1]);
  const double s = p.Along + from * (q.Along - p.Along), t = p.Along + to * (q.Along - p.Along);
  const LineInterval near{ std::min(s, t) - margin, std::max(s, t) + margin };
  return near.To < line.From || near.From > line.To ? std::nullopt : std::make_optional(near);
}
}
