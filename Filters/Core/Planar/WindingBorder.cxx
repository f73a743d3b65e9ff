// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/WindingBorder.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace recon
{
namespace
{
struct Winding
{
  bool Known = false;
  int Number = 0;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel,
  CGAL::Triangulation_face_base_with_info_2<Winding, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel,
  CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
using FaceHandle = Triangulation::Face_handle;
using VertexHandle = Triangulation::Vertex_handle;

class BorderFinder
{
public:
  BorderFinder(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
    : Points(points),
      Edges(edges),
      OnBorder(edges.size(), false)
  {
  }

  std::vector<bool> Find()
  {
    if (this->Edges.empty())
    {
      return {};
    }
    this->InsertEdges();
    std::vector<FaceHandle> front{ this->Plane.infinite_face() };
    front.front()->info().Known = true; // nothing winds around what is infinitely far out
    while (!front.empty())
    {
      const FaceHandle face = front.back();
      front.pop_back();
      for (int i = 0; i < 3; ++i)
      {
        this->Cross(face, i, front);
      }
    }
    return std::move(this->OnBorder);
  }

private:
  void InsertEdges()
  {
    // Sorted along a space-filling curve by the triangulation itself.
    std::map<int, VertexHandle> vertexOf;
    std::vector<std::pair<Kernel::Point_2, int>> used;
    for (const PlanarEdge& e : this->Edges)
    {
      for (int p : { e.A, e.B })
      {
        if (vertexOf.emplace(p, VertexHandle()).second)
        {
          used.emplace_back(Kernel::Point_2(this->Points[p][0], this->Points[p][1]), p);
        }
      }
    }
    this->Plane.insert(used.begin(), used.end());
    for (auto v = this->Plane.finite_vertices_begin(); v != this->Plane.finite_vertices_end(); ++v)
    {
      vertexOf[v->info()] = v;
    }
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      const PlanarEdge& edge = this->Edges[e];
      this->Plane.insert_constraint(vertexOf.at(edge.A), vertexOf.at(edge.B));
      this->EdgeOf.emplace(std::minmax(edge.A, edge.B), e);
    }
  }

  void Cross(const FaceHandle& face, int i, std::vector<FaceHandle>& front)
  {
    const FaceHandle next = face->neighbor(i);
    int across = face->info().Number;
    if (face->is_constrained(i))
    {
      // The face is to the left of its edge from a to b.
      const int a = face->vertex(Triangulation::ccw(i))->info();
      const int b = face->vertex(Triangulation::cw(i))->info();
      const std::size_t e = this->EdgeOf.at(std::minmax(a, b));
      const int weight = this->Edges[e].A == a ? this->Edges[e].Weight : -this->Edges[e].Weight;
      across -= weight;
      this->OnBorder[e] = (face->info().Number == 0) != (across == 0);
    }
    if (!next->info().Known)
    {
      next->info() = { true, across };
      front.push_back(next);
    }
  }

  const std::vector<Point2>& Points;
  const std::vector<PlanarEdge>& Edges;
  std::vector<bool> OnBorder;
  Triangulation Plane;
  std::map<std::pair<int, int>, std::size_t> EdgeOf;
};
}

std::vector<bool> FindWindingBorder(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  return BorderFinder(points, edges).Find();
}
}
