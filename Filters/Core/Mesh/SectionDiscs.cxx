// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionDiscs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// Planes of a slab: one in each such part of it, so that handles near the levels are seen, too.
constexpr int Planes = 8;

/// Of the slab: a gap between the heights of points must be wider, so that a cut has room in it and
/// rounding none.
constexpr double LeastGap = 1e-6;

using Edge = std::array<int, 2>;
using Polygon = std::vector<Point2>;

double SignedAreaOf(const Polygon& polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

bool IsWithin(const Point2& p, const Polygon& polygon)
{
  bool within = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    within ^=
      (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]);
  }
  return within;
}

class DiscFinder
{
public:
  DiscFinder(const TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets)
    : Mesh(mesh),
      Frame(frame),
      Offsets(offsets)
  {
  }

  std::vector<SectionDisc> Find()
  {
    const std::size_t slabs = this->Offsets.size() - 1;
    std::vector<std::vector<double>> heights(slabs);
    std::vector<std::vector<int>> triangles(slabs);
    for (const Point3& p : this->Mesh.Points)
    {
      this->Heights.push_back(Dot(this->Frame.Normal, p));
      if (const int slab = this->SlabAt(this->Heights.back()); slab >= 0)
      {
        heights[slab].push_back(this->Heights.back());
      }
    }
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      double middle = 0;
      for (const int p : this->Mesh.Triangles[t])
      {
        middle += this->Heights[p] / 3;
      }
      if (const int slab = this->SlabAt(middle); slab >= 0)
      {
        triangles[slab].push_back(static_cast<int>(t));
      }
    }
    for (std::size_t slab = 0; slab < slabs; ++slab)
    {
      std::sort(heights[slab].begin(), heights[slab].end());
      for (int plane = 0; plane < Planes; ++plane)
      {
        if (const auto gap = this->WidestGap(slab, heights[slab], plane))
        {
          this->AddDiscs(static_cast<int>(slab), gap->first, gap->second, triangles[slab]);
        }
      }
    }
    return std::move(this->Discs);
  }

private:
  int SlabAt(double height) const
  {
    const auto above = std::upper_bound(this->Offsets.begin(), this->Offsets.end(), height);
    return above == this->Offsets.begin() || above == this->Offsets.end()
      ? -1
      : static_cast<int>(above - this->Offsets.begin()) - 1;
  }

  /// Between heights of points, as far as it lies in that part of the slab.
  std::optional<std::pair<double, double>> WidestGap(
    std::size_t slab, const std::vector<double>& heights, int plane) const
  {
    const double thickness = this->Offsets[slab + 1] - this->Offsets[slab];
    const double from = this->Offsets[slab] + plane * thickness / Planes;
    const double to = this->Offsets[slab] + (plane + 1) * thickness / Planes;
    double low = from;
    std::pair<double, double> widest{ from, from };
    const auto close = [&](double high)
    {
      if (high - low > widest.second - widest.first)
      {
        widest = { low, high };
      }
      low = high;
    };
    for (auto h = std::upper_bound(heights.begin(), heights.end(), from);
         h != heights.end() && *h < to; ++h)
    {
      close(*h);
    }
    close(to);
    const double third = (widest.second - widest.first) / 3;
    return third > LeastGap * thickness
      ? std::make_optional(std::make_pair(widest.first + third, widest.second - third))
      : std::nullopt;
  }

  Edge Ordered(int a, int b) const
  {
    return this->Heights[a] < this->Heights[b] ? Edge{ { a, b } } : Edge{ { b, a } };
  }

  bool Crosses(int a, int b, double height) const
  {
    return (this->Heights[a] < height) != (this->Heights[b] < height);
  }

  /// Where the part of a triangle below the plane leaves and enters it: its rim runs from the edge that
  /// goes up to the one that comes down.
  std::optional<std::pair<Edge, Edge>> RimOf(int triangle, double height) const
  {
    const auto& corners = this->Mesh.Triangles[triangle];
    std::pair<Edge, Edge> rim;
    bool crosses = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int a = corners[k];
      const int b = corners[(k + 1) % 3];
      if (this->Crosses(a, b, height))
      {
        crosses = true;
        (this->Heights[a] < this->Heights[b] ? rim.first : rim.second) = this->Ordered(a, b);
      }
    }
    return crosses ? std::make_optional(rim) : std::nullopt;
  }

  struct Loop
  {
    std::vector<Edge> Edges;
    std::vector<int> Triangles;
    Polygon Corners;
  };

  std::vector<Loop> LoopsAt(double height, const std::vector<int>& triangles) const
  {
    struct Step
    {
      Edge To;
      int Triangle;
    };
    std::map<Edge, Step> next;
    std::vector<Edge> starts;
    for (const int t : triangles)
    {
      if (const auto rim = this->RimOf(t, height))
      {
        next[rim->first] = { rim->second, t };
        starts.push_back(rim->first);
      }
    }
    std::vector<Loop> loops;
    for (const Edge& start : starts)
    {
      Loop loop;
      Edge end = start;
      for (auto step = next.find(start); step != next.end() && step->second.Triangle >= 0;
           step = next.find(end))
      {
        end = step->second.To;
        loop.Edges.push_back(step->first);
        loop.Triangles.push_back(step->second.Triangle);
        loop.Corners.push_back(CrossingAt(this->Mesh, this->Frame, step->first, height));
        step->second.Triangle = -1;
      }
      if (loop.Edges.empty())
      {
        continue; // been here
      }
      if (end != start)
      {
        return {}; // a triangle reaches beyond the level, so nesting could not be told
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  void AddDiscs(int slab, double low, double high, const std::vector<int>& triangles)
  {
    const std::vector<Loop> loops = this->LoopsAt((low + high) / 2, triangles);
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      int around = 0;
      int inside = 0;
      for (std::size_t j = 0; j < loops.size(); ++j)
      {
        around += i != j && IsWithin(loops[i].Corners[0], loops[j].Corners) ? 1 : 0;
        inside += i != j && IsWithin(loops[j].Corners[0], loops[i].Corners) ? 1 : 0;
      }
      if (inside == 0)
      {
        this->Discs.push_back({ slab, low, high, std::abs(SignedAreaOf(loops[i].Corners)),
          around % 2 == 0, loops[i].Edges, loops[i].Triangles });
      }
    }
  }

  const TriangleMesh& Mesh;
  const PlanarFrame& Frame;
  const std::vector<double>& Offsets;
  std::vector<double> Heights; ///< of the points
  std::vector<SectionDisc> Discs;
};
}

std::vector<SectionDisc> FindSectionDiscs(
  const TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets)
{
  return offsets.size() < 2 ? std::vector<SectionDisc>() : DiscFinder(mesh, frame, offsets).Find();
}

Point2 CrossingAt(
  const TriangleMesh& mesh, const PlanarFrame& frame, const std::array<int, 2>& edge, double height)
{
  const Point3& a = mesh.Points[edge[0]];
  const Point3& b = mesh.Points[edge[1]];
  const double from = Dot(frame.Normal, a);
  const double to = Dot(frame.Normal, b);
  const double share = (height - from) / (to - from);
  const Point2 p = frame.ToPlane(a);
  const Point2 q = frame.ToPlane(b);
  return { p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]) };
}
}
