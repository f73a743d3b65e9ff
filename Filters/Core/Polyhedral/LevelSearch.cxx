// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/LevelSearch.h"

#include "Polyhedral/DelaunayEdges.h"
#include "Polyhedral/VertexStars.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
constexpr double Never = std::numeric_limits<double>::infinity();

/// A length beyond all that coordinates have.
constexpr double Anywhere = 1e150;

/// What is searched with lies within so many diagonals of a level.
constexpr double FarOutside = 64;

/// As FilterFactor of JointVoronoiPredicates.cxx.
constexpr double FilterFactor = 32 * std::numeric_limits<double>::epsilon();

std::vector<Box2> BoxesOf(const LevelTriangulation& level)
{
  std::vector<Box2> boxes;
  for (const Point2& p : level.Points)
  {
    boxes.emplace_back(p, p);
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

double VoronoiVertexError(const LevelTriangulation& level, int triangle)
{
  const auto& t = level.Triangles[triangle];
  const Point2& a = level.Points[t[0]];
  const double bx = level.Points[t[1]][0] - a[0], by = level.Points[t[1]][1] - a[1];
  const double cx = level.Points[t[2]][0] - a[0], cy = level.Points[t[2]][1] - a[1];
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double determinant = std::abs(bx * cy - by * cx);
  const double sum = std::abs(bx * cy) + std::abs(by * cx);
  const double numerator = b2 * (std::abs(cx) + std::abs(cy)) + c2 * (std::abs(bx) + std::abs(by));
  return determinant > 2 * FilterFactor * sum
    ? FilterFactor * numerator / determinant * (1 + sum / determinant) +
      FilterFactor * (std::abs(a[0]) + std::abs(a[1]))
    : Never;
}

LevelSearch::LevelSearch(const LevelTriangulation& level)
  : VertexSearch(level),
    Edges(ContourEdgesOf(level)),
    Contours(BoxesOf(Edges)),
    Skeleton(ExternalEdgesOf(level)),
    External(BoxesOf(Skeleton))
{
}

std::vector<LevelSearch::Segment> LevelSearch::ContourEdgesOf(const LevelTriangulation& level)
{
  std::vector<Segment> edges;
  for (int t = 0; t < static_cast<int>(level.Triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (level.EdgeContour[t][k] >= 0 && CanonicalEdge(level, t, k) == 3 * t + k)
      {
        const auto& corners = level.Triangles[t];
        edges.push_back(
          { level.Points[corners[(k + 1) % 3]], level.Points[corners[(k + 2) % 3]], 0 });
      }
    }
  }
  return edges;
}

std::vector<LevelSearch::Segment> LevelSearch::ExternalEdgesOf(const LevelTriangulation& level)
{
  const Box2 box = Box2::Around(level.Points);
  std::vector<Segment> edges;
  for (int t = 0; t < static_cast<int>(level.Triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int edge = 3 * t + k;
      if (CanonicalEdge(level, t, k) != edge || KindOf(level, edge) != EdgeKind::External)
      {
        continue;
      }
      const Point2 from = level.VoronoiVertex(t);
      double error = VoronoiVertexError(level, t);
      Point2 to = from;
      const int neighbour = level.Neighbours[t][k];
      if (neighbour >= 0)
      {
        to = level.VoronoiVertex(neighbour);
        error = std::max(error, VoronoiVertexError(level, neighbour));
      }
      else
      {
        // To infinity: as far as anything may be that is searched with.
        const Point2& p = level.Points[level.Triangles[t][(k + 1) % 3]];
        const Point2& q = level.Points[level.Triangles[t][(k + 2) % 3]];
        const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
        const double far = FarOutside * box.Diagonal() +
          std::hypot(from[0] - box.Middle()[0], from[1] - box.Middle()[1]);
        to = { from[0] + far * (q[1] - p[1]) / length, from[1] - far * (q[0] - p[0]) / length };
        error += FilterFactor * far;
      }
      edges.push_back({ from, to, std::isfinite(error) ? error : Never });
    }
  }
  return edges;
}

std::vector<Box2> LevelSearch::BoxesOf(const std::vector<Segment>& segments)
{
  std::vector<Box2> boxes;
  for (const Segment& segment : segments)
  {
    Box2 box;
    for (const Point2& end : { segment.From, segment.To })
    {
      // What may be anywhere is in the way everywhere.
      const bool known = std::isfinite(end[0]) && std::isfinite(end[1]) && segment.Error < Anywhere;
      for (const double side : { -1.0, 1.0 })
      {
        box.Add(known ? Point2{ end[0] + side * segment.Error, end[1] + side * segment.Error }
                      : Point2{ side * Anywhere, side * Anywhere });
      }
    }
    boxes.push_back(box);
  }
  return boxes;
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
  return First(this->Contours, this->Edges, line, tolerance);
}

std::optional<LineInterval> LevelSearch::FirstExternal(
  const PlanarLine& line, double tolerance) const
{
  return First(this->External, this->Skeleton, line, tolerance);
}

std::optional<LineInterval> LevelSearch::First(const BoxTree& boxes,
  const std::vector<Segment>& segments, const PlanarLine& line, double tolerance)
{
  const auto found = boxes.Least([&](const Box2& box) { return EarliestIn(box, line, tolerance); },
    [&](int number)
    {
      const auto near = Near(segments[number], line, tolerance);
      return near ? near->From : Never;
    });
  return found.Number < 0 ? std::nullopt : Near(segments[found.Number], line, tolerance);
}

std::optional<LineInterval> LevelSearch::Near(
  const Segment& segment, const PlanarLine& line, double least)
{
  const double tolerance = least + segment.Error;
  if (!(tolerance < Anywhere) || !std::isfinite(segment.From[0] + segment.From[1]) ||
    !std::isfinite(segment.To[0] + segment.To[1]))
  {
    return LineInterval{ line.From, line.To }; // in the way from the beginning to the end
  }
  const Seen p = See(line, segment.From);
  const Seen q = See(line, segment.To);
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
