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
/// Even planes of a slab: one in each such part of it, so that handles near the levels are seen, too.
constexpr int EvenPlanes = 8;

/// Critical planes of a slab at most, those with most room; a cortex has some hundred.
constexpr std::size_t MostCriticalPlanes = 2000;

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

/// A plane may lie anywhere between the two.
using Gap = std::pair<double, double>;

double WidthOf(const Gap& gap)
{
  return gap.second - gap.first;
}

class DiscFinder
{
public:
  DiscFinder(const TriangleMesh& mesh, const SectionPlanes& planes, const Vector3& normal,
    const std::vector<double>& offsets)
    : Mesh(mesh),
      Planes(planes),
      Offsets(offsets)
  {
    for (const Point3& p : mesh.Points)
    {
      this->Heights.push_back(Dot(planes.Frame.Normal, p));
      this->LevelHeights.push_back(Dot(normal, p));
    }
  }

  std::vector<SectionDisc> Find(Monitor& monitor)
  {
    if (this->Planes.Spacing == SectionPlanes::Critical)
    {
      this->FindCriticalPoints();
    }
    const std::vector<std::vector<int>> triangles = this->TrianglesBySlab();
    for (std::size_t slab = 0; slab + 1 < this->Offsets.size(); ++slab)
    {
      monitor.Update(
        static_cast<double>(slab) / static_cast<double>(this->Offsets.size()), "cutting handles");
      const std::vector<Gap> gaps = this->Planes.Spacing == SectionPlanes::Even
        ? this->EvenGaps(slab)
        : this->CriticalGaps(slab, triangles[slab]);
      for (const Gap& gap : gaps)
      {
        const double third = WidthOf(gap) / 3;
        if (third > LeastGap * this->ThicknessOf(slab))
        {
          this->AddDiscs(slab, gap.first + third, gap.second - third, triangles[slab]);
        }
      }
    }
    return std::move(this->Discs);
  }

private:
  double ThicknessOf(std::size_t slab) const
  {
    return this->Offsets[slab + 1] - this->Offsets[slab];
  }

  /// Up to rounding.
  bool IsAtLevel(int point, std::size_t slab) const
  {
    const double margin = LeastGap * this->ThicknessOf(slab);
    return std::min(std::abs(this->LevelHeights[point] - this->Offsets[slab]),
             std::abs(this->LevelHeights[point] - this->Offsets[slab + 1])) < margin;
  }

  bool IsWithinSlab(int point, std::size_t slab) const
  {
    return (this->LevelHeights[point] > this->Offsets[slab] &&
             this->LevelHeights[point] < this->Offsets[slab + 1]) ||
      this->IsAtLevel(point, slab);
  }

  /// All that lie in a slab, or reach into it.
  std::vector<std::vector<int>> TrianglesBySlab() const
  {
    std::vector<std::vector<int>> triangles(this->Offsets.size() - 1);
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      const auto& c = this->Mesh.Triangles[t];
      const auto [low, high] = std::minmax(
        { this->LevelHeights[c[0]], this->LevelHeights[c[1]], this->LevelHeights[c[2]] });
      const auto above = std::upper_bound(this->Offsets.begin(), this->Offsets.end(), low);
      for (auto slab = static_cast<std::size_t>(above - this->Offsets.begin());
           slab < this->Offsets.size() && (slab == 0 || this->Offsets[slab - 1] < high); ++slab)
      {
        if (slab > 0)
        {
          triangles[slab - 1].push_back(static_cast<int>(t));
        }
      }
    }
    return triangles;
  }

  /// The widest gap between heights of points, as far as it lies in each part of the slab.
  std::vector<Gap> EvenGaps(std::size_t slab)
  {
    if (this->SortedHeights.empty())
    {
      this->SortedHeights = this->Heights;
      std::sort(this->SortedHeights.begin(), this->SortedHeights.end());
    }
    std::vector<Gap> gaps;
    for (int plane = 0; plane < EvenPlanes; ++plane)
    {
      const double from = this->Offsets[slab] + plane * this->ThicknessOf(slab) / EvenPlanes;
      const double to = this->Offsets[slab] + (plane + 1) * this->ThicknessOf(slab) / EvenPlanes;
      gaps.push_back(WidestGap(this->SortedHeights, from, to));
    }
    return gaps;
  }

  static Gap WidestGap(const std::vector<double>& heights, double from, double to)
  {
    double low = from;
    Gap widest{ from, from };
    const auto close = [&](double high)
    {
      if (high - low > WidthOf(widest))
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
    return widest;
  }

  /// A point is regular where its neighbours below are one row, and those above.
  void FindCriticalPoints()
  {
    std::vector<int> changes(this->Mesh.Points.size(), 0);
    this->IsCritical.assign(this->Mesh.Points.size(), 0);
    for (const auto& corners : this->Mesh.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double own = this->Heights[corners[k]];
        const double next = this->Heights[corners[(k + 1) % 3]];
        const double last = this->Heights[corners[(k + 2) % 3]];
        changes[corners[k]] += (next < own) != (last < own) ? 1 : 0;
        this->IsCritical[corners[k]] |= next == own || last == own ? 1 : 0;
      }
    }
    for (std::size_t p = 0; p < changes.size(); ++p)
    {
      this->IsCritical[p] |= changes[p] != 2 ? 1 : 0;
    }
  }

  /// Between every two critical heights the widest gap between heights of points.
  std::vector<Gap> CriticalGaps(std::size_t slab, const std::vector<int>& triangles) const
  {
    std::vector<double> heights;
    std::vector<double> critical;
    for (const int t : triangles)
    {
      for (const int p : this->Mesh.Triangles[t])
      {
        heights.push_back(this->Heights[p]);
        if (this->IsCritical[p] != 0 || this->IsAtLevel(p, slab))
        {
          critical.push_back(this->Heights[p]);
        }
      }
    }
    std::sort(heights.begin(), heights.end());
    std::sort(critical.begin(), critical.end());
    std::vector<Gap> gaps;
    for (std::size_t i = 1; i < critical.size(); ++i)
    {
      if (critical[i] > critical[i - 1])
      {
        gaps.push_back(WidestGap(heights, critical[i - 1], critical[i]));
      }
    }
    return WidestOf(std::move(gaps));
  }

  /// As many as may be looked at, from below.
  static std::vector<Gap> WidestOf(std::vector<Gap> gaps)
  {
    if (gaps.size() > MostCriticalPlanes)
    {
      std::stable_sort(gaps.begin(), gaps.end(),
        [](const Gap& a, const Gap& b) { return WidthOf(a) > WidthOf(b); });
      gaps.resize(MostCriticalPlanes);
      std::sort(gaps.begin(), gaps.end());
    }
    return gaps;
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

  struct Loop : SectionLoop
  {
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
        loop.Corners.push_back(CrossingAt(this->Mesh, this->Planes.Frame, step->first, height));
        step->second.Triangle = -1;
      }
      if (loop.Edges.empty())
      {
        continue; // been here
      }
      if (end == start) // else it leaves the slab, so it lies in no disc of it
      {
        loops.push_back(std::move(loop));
      }
    }
    return loops;
  }

  /// Not where it reaches beyond the slab, nor across what is drawn.
  bool IsOfSlab(const Loop& loop, std::size_t slab) const
  {
    return std::none_of(loop.Edges.begin(), loop.Edges.end(),
      [&](const Edge& edge)
      {
        return !this->IsWithinSlab(edge[0], slab) || !this->IsWithinSlab(edge[1], slab) ||
          (this->IsAtLevel(edge[0], slab) && this->IsAtLevel(edge[1], slab) &&
            std::abs(this->LevelHeights[edge[0]] - this->LevelHeights[edge[1]]) <
              this->ThicknessOf(slab) / 2);
      });
  }

  /// Numbers of the loops that lie within a loop.
  static std::vector<std::size_t> Within(const std::vector<Loop>& loops, std::size_t i)
  {
    std::vector<std::size_t> within;
    for (std::size_t j = 0; j < loops.size(); ++j)
    {
      if (j != i && IsWithin(loops[j].Corners[0], loops[i].Corners))
      {
        within.push_back(j);
      }
    }
    return within;
  }

  void AddDiscs(std::size_t slab, double low, double high, const std::vector<int>& triangles)
  {
    const std::vector<Loop> loops = this->LoopsAt((low + high) / 2, triangles);
    std::vector<std::vector<std::size_t>> within;
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      within.push_back(Within(loops, i));
    }
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      const bool isDisc = within[i].empty() ||
        (this->Planes.WithRings &&
          std::all_of(within[i].begin(), within[i].end(),
            [&](std::size_t inner) { return within[inner].empty(); }));
      if (isDisc && this->IsOfSlab(loops[i], slab))
      {
        const double area = SignedAreaOf(loops[i].Corners);
        // Parts of triangles below run clockwise around solid.
        this->Discs.push_back(
          { static_cast<int>(slab), low, high, std::abs(area), area < 0, loops[i], {} });
        for (const std::size_t inner : within[i])
        {
          this->Discs.back().Inside.push_back(loops[inner]);
        }
      }
    }
  }

  const TriangleMesh& Mesh;
  const SectionPlanes& Planes;
  const std::vector<double>& Offsets;
  std::vector<double> Heights;       ///< of the points, above the planes
  std::vector<double> LevelHeights;  ///< of the points, along the levels' normal
  std::vector<double> SortedHeights; ///< for even planes
  std::vector<char> IsCritical;      ///< a point, for critical planes
  std::vector<SectionDisc> Discs;
};
}

std::vector<SectionDisc> FindSectionDiscs(const TriangleMesh& mesh, const SectionPlanes& planes,
  const Vector3& normal, const std::vector<double>& offsets, Monitor& monitor)
{
  return offsets.size() < 2 ? std::vector<SectionDisc>()
                            : DiscFinder(mesh, planes, normal, offsets).Find(monitor);
}

std::vector<SectionDisc> FindSectionDiscs(
  const TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets)
{
  Monitor monitor;
  return FindSectionDiscs(
    mesh, { frame, SectionPlanes::Even, false }, frame.Normal, offsets, monitor);
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
