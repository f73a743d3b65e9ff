// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarEdges.h"

#include "Planar/EdgeConflicts.h"

#include <algorithm>
#include <limits>

namespace recon
{
namespace
{
std::vector<PlanarEdges::Edge> EdgesOf(const ContourSet& contours, int level)
{
  std::vector<PlanarEdges::Edge> edges;
  for (const int c : contours.Levels[level].Contours)
  {
    const std::vector<int>& points = contours.Contours[c].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const int from = points[i];
      const int to = points[(i + 1) % points.size()];
      edges.push_back({ from, to });
    }
  }
  return edges;
}

std::vector<PlanarSegment> SegmentsOf(
  const ContourSet& contours, const std::vector<PlanarEdges::Edge>& edges)
{
  std::vector<PlanarSegment> segments;
  segments.reserve(edges.size());
  for (const PlanarEdges::Edge& e : edges)
  {
    segments.push_back({ contours.Planar[e.From], contours.Planar[e.To] });
  }
  return segments;
}
}

PlanarEdges::PlanarEdges(const ContourSet& contours, int level)
  : All(EdgesOf(contours, level)),
    Tree(SegmentsOf(contours, this->All))
{
  if (this->All.empty())
  {
    return;
  }
  const auto [first, last] = std::minmax_element(this->All.begin(), this->All.end(),
    [](const Edge& e, const Edge& f) { return e.From < f.From; });
  this->FirstVertex = first->From;
  this->AtVertex.resize(last->From - first->From + 1);
  for (int e = 0; e < static_cast<int>(this->All.size()); ++e)
  {
    this->AtVertex[this->All[e].From - this->FirstVertex].push_back(e);
    this->AtVertex[this->All[e].To - this->FirstVertex].push_back(e);
  }
}

const std::vector<int>& PlanarEdges::EdgesAt(int vertex) const
{
  return this->AtVertex[vertex - this->FirstVertex];
}

double PlanarEdges::DistanceToOwn(int vertex, const Point2& p) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const int e : this->EdgesAt(vertex))
  {
    least = std::min(least, DistanceToSegment(p, this->Tree.Segments()[e]));
  }
  return least;
}

double PlanarEdges::DistanceToOthers(int vertex, const Point2& p, double limit) const
{
  return this->Tree.DistanceWithin(
    p, limit, [&](int e) { return this->All[e].From != vertex && this->All[e].To != vertex; });
}

bool PlanarEdges::CrossesOthers(int vertex, const Point2& from, const Point2& p) const
{
  bool crosses = false;
  this->Tree.ForNear({ std::min(from[0], p[0]), std::min(from[1], p[1]) },
    { std::max(from[0], p[0]), std::max(from[1], p[1]) },
    [&](int e)
    {
      const Edge& edge = this->All[e];
      crosses = crosses ||
        (edge.From != vertex && edge.To != vertex && Meet({ from, p }, this->Tree.Segments()[e]));
    });
  return crosses;
}

bool PlanarEdges::SelfCrossing() const
{
  std::vector<Point2> points;
  std::vector<PlanarEdge> edges;
  points.resize(this->AtVertex.size());
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    const Edge& e = this->All[i];
    points[e.From - this->FirstVertex] = this->Tree.Segments()[i].A;
    edges.push_back({ e.From - this->FirstVertex, e.To - this->FirstVertex, 0 });
  }
  return !FindEdgeConflicts(points, edges, { 0.0 }, std::numeric_limits<std::size_t>::max())
            .Empty();
}
}
