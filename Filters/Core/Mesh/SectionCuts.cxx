// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionCuts.h"

#include "Base/DisjointSets.h"
#include "Mesh/SectionDiscs.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
using Edge = std::array<int, 2>;
using Triangle = std::array<int, 3>;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

/// Triangles of a simple polygon, by its corners, counterclockwise; nothing where it is not simple.
std::optional<std::vector<Triangle>> TrianglesOf(const std::vector<Point2>& polygon)
{
  std::vector<Kernel::Point_2> corners;
  for (const Point2& p : polygon)
  {
    corners.emplace_back(p[0], p[1]);
  }
  if (!CGAL::is_simple_2(corners.begin(), corners.end()))
  {
    return std::nullopt;
  }
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    vertices.push_back(triangulation.insert(corners[i]));
    vertices.back()->info() = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % corners.size()]);
  }
  // Outside is what is reached from the infinite vertex without crossing the polygon.
  std::set<Triangulation::Face_handle> outside;
  std::vector<Triangulation::Face_handle> stack{ triangulation.infinite_face() };
  while (!stack.empty())
  {
    const Triangulation::Face_handle face = stack.back();
    stack.pop_back();
    if (!outside.insert(face).second)
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      if (!face->is_constrained(k))
      {
        stack.push_back(face->neighbor(k));
      }
    }
  }
  std::vector<Triangle> triangles;
  for (const Triangulation::Face_handle face : triangulation.finite_face_handles())
  {
    if (outside.count(face) == 0)
    {
      triangles.push_back(
        { face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info() });
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

double SignedAreaOf(const std::vector<Point2>& polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice;
}

class Cutter
{
public:
  Cutter(TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets)
    : Mesh(mesh),
      Frame(frame),
      Discs(FindSectionDiscs(mesh, frame, offsets))
  {
    const auto isUseless = [&](const SectionDisc& disc)
    { return !this->CapOf(disc, disc.Low) || !this->CapOf(disc, disc.High); };
    this->Discs.erase(
      std::remove_if(this->Discs.begin(), this->Discs.end(), isUseless), this->Discs.end());
  }

  SectionCuts Cut(int handles, Monitor& monitor)
  {
    std::vector<std::size_t> chosen = this->DiscsThatPartNothing();
    chosen.resize(std::min(chosen.size(), static_cast<std::size_t>(std::max(0, handles))));
    monitor.Update(0.5, "cutting handles");
    for (const std::size_t d : chosen)
    {
      const SectionDisc& disc = this->Discs[d];
      const double height = (disc.Low + disc.High) / 2;
      this->Result.Cuts.push_back({ disc.Slab, height, disc.Area, disc.Solid,
        this->Frame.ToSpace(CrossingAt(this->Mesh, this->Frame, disc.Edges[0], height), height) });
      for (const int t : disc.Triangles)
      {
        this->DiscsOfTriangle[t].push_back(d);
      }
    }
    const TriangleMesh before = this->Mesh;
    this->Mesh.Triangles.clear();
    for (std::size_t t = 0; t < before.Triangles.size(); ++t)
    {
      this->AddParts(before, static_cast<int>(t));
    }
    for (const std::size_t d : chosen)
    {
      this->AddCap(before, this->Discs[d], false);
      this->AddCap(before, this->Discs[d], true);
    }
    return std::move(this->Result);
  }

private:
  std::vector<Point2> Corners(const SectionDisc& disc, double height) const
  {
    std::vector<Point2> corners;
    for (const Edge& edge : disc.Edges)
    {
      corners.push_back(CrossingAt(this->Mesh, this->Frame, edge, height));
    }
    return corners;
  }

  std::optional<std::vector<Triangle>> CapOf(const SectionDisc& disc, double height) const
  {
    return TrianglesOf(this->Corners(disc, height));
  }

  /**
   * All that can be cut together without parting the surface, the cheapest first.
   *
   * The surface is points and, below and above every loop, a collar. Discs taken from the largest on
   * hold together what did not hang together yet; the others may be cut.
   */
  std::vector<std::size_t> DiscsThatPartNothing() const
  {
    const std::size_t points = this->Mesh.Points.size();
    DisjointSets sets(points + 2 * this->Discs.size());
    const auto collar = [&](std::size_t disc, int above)
    { return static_cast<int>(points + 2 * disc) + above; };
    std::map<Edge, std::vector<std::size_t>> crossed; // an edge: its discs, the lowest first
    for (std::size_t d = 0; d < this->Discs.size(); ++d)
    {
      for (const Edge& edge : this->Discs[d].Edges)
      {
        crossed[edge].push_back(d);
      }
    }
    for (auto& [edge, discs] : crossed)
    {
      std::sort(discs.begin(), discs.end(),
        [&](std::size_t a, std::size_t b) { return this->Discs[a].Low < this->Discs[b].Low; });
      int below = edge[0];
      for (const std::size_t d : discs)
      {
        sets.Join(below, collar(d, 0));
        below = collar(d, 1);
      }
      sets.Join(below, edge[1]);
    }
    for (const Triangle& triangle : this->Mesh.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const int a = triangle[k];
        const int b = triangle[(k + 1) % 3];
        if (crossed.count({ { a, b } }) == 0 && crossed.count({ { b, a } }) == 0)
        {
          sets.Join(a, b);
        }
      }
    }
    std::vector<std::size_t> order(this->Discs.size());
    for (std::size_t d = 0; d < order.size(); ++d)
    {
      order[d] = d;
    }
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return this->Discs[a].Area > this->Discs[b].Area; });
    std::vector<std::size_t> free;
    for (const std::size_t d : order)
    {
      if (sets.Find(collar(d, 0)) == sets.Find(collar(d, 1)))
      {
        free.push_back(d);
      }
      sets.Join(collar(d, 0), collar(d, 1));
    }
    std::reverse(free.begin(), free.end());
    return free;
  }

  /// The point at which an edge is cut, one for all that have the edge.
  int PointAt(const TriangleMesh& before, const Edge& edge, double height)
  {
    const auto [known, isNew] = this->NewPoints.emplace(
      std::make_pair(edge, height), static_cast<int>(this->Mesh.Points.size()));
    if (isNew)
    {
      this->Mesh.Points.push_back(
        this->Frame.ToSpace(CrossingAt(before, this->Frame, edge, height), height));
    }
    return known->second;
  }

  double HeightOf(const TriangleMesh& mesh, int point) const
  {
    return Dot(this->Frame.Normal, mesh.Points[point]);
  }

  void Add(const Triangle& triangle, int partOf)
  {
    this->Mesh.Triangles.push_back(triangle);
    this->Result.PartOf.push_back(partOf);
  }

  /// A triangle without what lies between the two heights of each disc that it crosses.
  void AddParts(const TriangleMesh& before, int t)
  {
    const auto crossed = this->DiscsOfTriangle.find(t);
    if (crossed == this->DiscsOfTriangle.end())
    {
      this->Add(before.Triangles[t], t);
      return;
    }
    std::vector<double> cuts; // low and high, from below
    for (const std::size_t d : crossed->second)
    {
      cuts.push_back(this->Discs[d].Low);
      cuts.push_back(this->Discs[d].High);
    }
    std::sort(cuts.begin(), cuts.end());
    // Once around the triangle: corners, and the points at which cuts cross its edges, each with the
    // number of cuts below it; parts are those between an even and the next odd number of cuts.
    std::map<int, std::vector<int>> parts;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int a = before.Triangles[t][k];
      const int b = before.Triangles[t][(k + 1) % 3];
      const double from = this->HeightOf(before, a);
      const double to = this->HeightOf(before, b);
      const auto below =
        static_cast<int>(std::lower_bound(cuts.begin(), cuts.end(), from) - cuts.begin());
      const auto last =
        static_cast<int>(std::lower_bound(cuts.begin(), cuts.end(), to) - cuts.begin());
      parts[below].push_back(a);
      const Edge edge = from < to ? Edge{ { a, b } } : Edge{ { b, a } };
      const int step = last > below ? 1 : -1;
      for (int i = below; i != last; i += step)
      {
        const int cut =
          step > 0 ? i : i - 1; // a low one bounds the part below it, a high one that above
        parts[cut % 2 == 0 ? cut : cut + 1].push_back(
          this->PointAt(before, edge, cuts[static_cast<std::size_t>(cut)]));
      }
    }
    for (const auto& [number, ring] : parts)
    {
      for (std::size_t i = 2; i < ring.size(); ++i)
      {
        this->Add({ ring[0], ring[i - 1], ring[i] }, t);
      }
    }
  }

  /// Below, the rim of what is left runs along the disc's edges, above against them; a cap runs the other
  /// way.
  void AddCap(const TriangleMesh& before, const SectionDisc& disc, bool above)
  {
    const double height = above ? disc.High : disc.Low;
    std::vector<int> rim;
    std::vector<Point2> corners;
    for (const Edge& edge : disc.Edges)
    {
      rim.push_back(this->PointAt(before, edge, height));
      corners.push_back(CrossingAt(before, this->Frame, edge, height));
    }
    const bool runsCounterclockwise = SignedAreaOf(corners) > 0;
    const auto cap = TrianglesOf(corners); // there is one, else the disc would not be here
    for (const Triangle& triangle : *cap)
    {
      const int a = rim[static_cast<std::size_t>(triangle[0])];
      const int b = rim[static_cast<std::size_t>(triangle[1])];
      const int c = rim[static_cast<std::size_t>(triangle[2])];
      this->Add(runsCounterclockwise == above ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } },
        disc.Triangles[0]);
    }
  }

  TriangleMesh& Mesh;
  const PlanarFrame& Frame;
  std::vector<SectionDisc> Discs;
  std::map<int, std::vector<std::size_t>> DiscsOfTriangle;
  std::map<std::pair<Edge, double>, int> NewPoints;
  SectionCuts Result;
};
}

SectionCuts CutHandles(TriangleMesh& mesh, const PlanarFrame& frame,
  const std::vector<double>& offsets, int handles, Monitor& monitor)
{
  return Cutter(mesh, frame, offsets).Cut(handles, monitor);
}
}
