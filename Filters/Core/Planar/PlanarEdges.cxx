// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarEdges.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

Exact::Point_2 ToExact(const Point2& p)
{
  return { p[0], p[1] };
}

double DistanceToEdge(const PlanarEdges::Edge& e, const Point2& p)
{
  const double ux = e.B[0] - e.A[0];
  const double uy = e.B[1] - e.A[1];
  const double length2 = ux * ux + uy * uy;
  const double along = ((p[0] - e.A[0]) * ux + (p[1] - e.A[1]) * uy) / length2;
  const double t = std::min(1.0, std::max(0.0, along));
  return std::hypot(p[0] - (e.A[0] + t * ux), p[1] - (e.A[1] + t * uy));
}

bool Meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  return CGAL::do_intersect(
    Exact::Segment_2(ToExact(a), ToExact(b)), Exact::Segment_2(ToExact(c), ToExact(d)));
}

/// Edges that share a vertex meet only there, unless they run back over one another.
bool Overlap(const PlanarEdges::Edge& e, const PlanarEdges::Edge& f)
{
  const bool fromShared = e.From == f.From || e.From == f.To;
  const Point2& shared = fromShared ? e.A : e.B;
  const Point2& p = fromShared ? e.B : e.A;
  const bool fFrom = fromShared ? e.From == f.From : e.To == f.From;
  const Point2& q = fFrom ? f.B : f.A;
  return CGAL::orientation(ToExact(shared), ToExact(p), ToExact(q)) == CGAL::COLLINEAR &&
    !CGAL::collinear_are_strictly_ordered_along_line(ToExact(p), ToExact(shared), ToExact(q));
}
}

PlanarEdges::PlanarEdges(const ContourSet& contours, int level)
{
  int lastVertex = -1;
  this->FirstVertex = std::numeric_limits<int>::max();
  double top = -std::numeric_limits<double>::infinity();
  this->Bottom = std::numeric_limits<double>::infinity();
  for (const int c : contours.Levels[level].Contours)
  {
    const std::vector<int>& points = contours.Contours[c].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const int from = points[i];
      const int to = points[(i + 1) % points.size()];
      this->All.push_back({ from, to, contours.Planar[from], contours.Planar[to] });
      this->FirstVertex = std::min(this->FirstVertex, from);
      lastVertex = std::max(lastVertex, from);
      this->Bottom = std::min(this->Bottom, contours.Planar[from][1]);
      top = std::max(top, contours.Planar[from][1]);
    }
  }
  if (this->All.empty())
  {
    this->FirstVertex = 0;
    this->Bottom = 0;
    this->Strips.resize(1);
    return;
  }
  this->AtVertex.resize(lastVertex - this->FirstVertex + 1);
  const int strips = std::max<int>(1, static_cast<int>(this->All.size() / 4));
  this->Strips.resize(strips);
  this->StripHeight = std::max((top - this->Bottom) / strips, 1e-300);
  for (int e = 0; e < static_cast<int>(this->All.size()); ++e)
  {
    const Edge& edge = this->All[e];
    this->AtVertex[edge.From - this->FirstVertex].push_back(e);
    this->AtVertex[edge.To - this->FirstVertex].push_back(e);
    const int last = this->StripOf(std::max(edge.A[1], edge.B[1]));
    for (int s = this->StripOf(std::min(edge.A[1], edge.B[1])); s <= last; ++s)
    {
      this->Strips[s].push_back(e);
    }
  }
}

int PlanarEdges::StripOf(double y) const
{
  const double s = std::floor((y - this->Bottom) / this->StripHeight);
  return static_cast<int>(std::min(std::max(s, 0.0), static_cast<double>(this->Strips.size() - 1)));
}

template <typename Visit>
void PlanarEdges::ForStrips(double low, double high, const Visit& visit) const
{
  const int last = this->StripOf(high);
  for (int s = this->StripOf(low); s <= last; ++s)
  {
    for (const int e : this->Strips[s])
    {
      visit(e);
    }
  }
}

PlanarEdges::SideType PlanarEdges::SideOf(const Point2& p) const
{
  bool inside = false;
  for (const int e : this->Strips[this->StripOf(p[1])])
  {
    const Point2& a = this->All[e].A;
    const Point2& b = this->All[e].B;
    if (std::min(a[1], b[1]) > p[1] || std::max(a[1], b[1]) < p[1])
    {
      continue;
    }
    const CGAL::Orientation turn = CGAL::orientation(ToExact(a), ToExact(b), ToExact(p));
    if (turn == CGAL::COLLINEAR && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]))
    {
      return On;
    }
    const bool upward = a[1] <= p[1] && p[1] < b[1];
    const bool downward = b[1] <= p[1] && p[1] < a[1];
    if ((upward && turn == CGAL::LEFT_TURN) || (downward && turn == CGAL::RIGHT_TURN))
    {
      inside = !inside;
    }
  }
  return inside ? Inside : Outside;
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
    least = std::min(least, DistanceToEdge(this->All[e], p));
  }
  return least;
}

double PlanarEdges::DistanceToOthers(int vertex, const Point2& p, double limit) const
{
  double least = std::numeric_limits<double>::infinity();
  this->ForStrips(p[1] - limit, p[1] + limit,
    [&](int e)
    {
      const Edge& edge = this->All[e];
      if (edge.From != vertex && edge.To != vertex)
      {
        least = std::min(least, DistanceToEdge(edge, p));
      }
    });
  return least;
}

bool PlanarEdges::CrossesOthers(int vertex, const Point2& from, const Point2& p) const
{
  bool crosses = false;
  this->ForStrips(std::min(from[1], p[1]), std::max(from[1], p[1]),
    [&](int e)
    {
      const Edge& edge = this->All[e];
      if (!crosses && edge.From != vertex && edge.To != vertex)
      {
        crosses = Meet(from, p, edge.A, edge.B);
      }
    });
  return crosses;
}

bool PlanarEdges::SelfCrossing() const
{
  for (const auto& strip : this->Strips)
  {
    for (std::size_t i = 0; i < strip.size(); ++i)
    {
      for (std::size_t j = i + 1; j < strip.size(); ++j)
      {
        const Edge& e = this->All[strip[i]];
        const Edge& f = this->All[strip[j]];
        const bool share = e.From == f.From || e.From == f.To || e.To == f.From || e.To == f.To;
        if (share ? Overlap(e, f) : Meet(e.A, e.B, f.A, f.B))
        {
          return true;
        }
      }
    }
  }
  return false;
}
}
