// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/Keyholes.h"

#include "Base/DisjointSets.h"
#include "Base/Predicates.h"
#include "Planar/BorderWalks.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

/// An outer contour and its holes.
class Region
{
public:
  Region(const ContourSet& set, const std::vector<int>& contours) : Set(set), Contours(contours) {}

  /// The walks around the region, as indices into the set's points.
  std::vector<BorderWalk> Walks();

private:
  /// A vertex of a contour, with its neighbours; points that contours share have several.
  struct Corner
  {
    int Before;
    int After;
    int Contour; ///< index into Contours
  };

  const Point2& At(int point) const { return this->Set.Planar[static_cast<std::size_t>(point)]; }
  int Turn(int a, int b, int c) const
  {
    return Orientation2(this->At(a), this->At(b), this->At(c));
  }

  void AddEdges();
  void AddBridges();
  bool IsInside(int from, int to) const;
  bool IsBetween(const Corner& corner, int at, int to) const;

  const ContourSet& Set;
  const std::vector<int>& Contours;
  std::map<int, std::vector<Corner>> Corners;
  std::map<int, std::vector<int>> Outgoing; ///< ends of the directed edges that leave a point
};

void Region::AddEdges()
{
  for (std::size_t c = 0; c < this->Contours.size(); ++c)
  {
    const std::vector<int>& points =
      this->Set.Contours[static_cast<std::size_t>(this->Contours[c])].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const int before = points[(i + points.size() - 1) % points.size()];
      const int after = points[(i + 1) % points.size()];
      this->Corners[points[i]].push_back({ before, after, static_cast<int>(c) });
      this->Outgoing[points[i]].push_back(after);
    }
  }
}

/// Whether the direction to a point lies strictly in the corner, which has the region on its left.
bool Region::IsBetween(const Corner& corner, int at, int to) const
{
  const bool leftOfBefore = this->Turn(corner.Before, at, to) > 0;
  const bool leftOfAfter = this->Turn(at, corner.After, to) > 0;
  const bool isConvex = this->Turn(corner.Before, at, corner.After) > 0;
  return isConvex ? leftOfBefore && leftOfAfter : leftOfBefore || leftOfAfter;
}

/// Of an edge that crosses no contour, whether it lies in the region.
bool Region::IsInside(int from, int to) const
{
  const std::vector<Corner>& corners = this->Corners.at(from);
  return std::all_of(corners.begin(), corners.end(),
    [&](const Corner& corner) { return this->IsBetween(corner, from, to); });
}

void Region::AddBridges()
{
  Triangulation triangulation;
  std::map<int, Triangulation::Vertex_handle> vertices;
  for (const auto& [point, corners] : this->Corners)
  {
    vertices[point] = triangulation.insert(Point(this->At(point)[0], this->At(point)[1]));
    vertices[point]->info() = point;
  }
  DisjointSets connected(this->Contours.size());
  for (const auto& [point, corners] : this->Corners)
  {
    for (const Corner& corner : corners)
    {
      triangulation.insert_constraint(vertices[point], vertices[corner.After]);
      connected.Join(corners.front().Contour, corner.Contour);
    }
  }
  std::vector<std::tuple<double, int, int>> candidates;
  for (const auto& edge : triangulation.finite_edges())
  {
    if (edge.first->is_constrained(edge.second))
    {
      continue;
    }
    const int a = edge.first->vertex(Triangulation::cw(edge.second))->info();
    const int b = edge.first->vertex(Triangulation::ccw(edge.second))->info();
    if (this->IsInside(a, b) && this->IsInside(b, a))
    {
      candidates.emplace_back(CGAL::squared_distance(Point(this->At(a)[0], this->At(a)[1]),
                                Point(this->At(b)[0], this->At(b)[1])),
        std::min(a, b), std::max(a, b));
    }
  }
  std::sort(candidates.begin(), candidates.end());
  for (const auto& [length, a, b] : candidates)
  {
    const int one = this->Corners.at(a).front().Contour;
    const int other = this->Corners.at(b).front().Contour;
    if (connected.Find(one) != connected.Find(other))
    {
      connected.Join(one, other);
      this->Outgoing[a].push_back(b);
      this->Outgoing[b].push_back(a);
    }
  }
}

std::vector<BorderWalk> Region::Walks()
{
  this->AddEdges();
  this->AddBridges();
  BorderWalks walks(this->Set.Planar);
  for (const auto& [start, ends] : this->Outgoing)
  {
    for (const int end : ends)
    {
      walks.Add(start, end);
    }
  }
  return walks.Walk();
}
}

std::vector<KeyholeContour> JoinHoles(const ContourSet& set)
{
  std::map<int, std::vector<int>> regions;
  for (std::size_t c = 0; c < set.Contours.size(); ++c)
  {
    const Contour& contour = set.Contours[c];
    regions[contour.Depth % 2 == 0 ? static_cast<int>(c) : contour.Parent].push_back(
      static_cast<int>(c));
  }
  std::vector<KeyholeContour> joined;
  for (const auto& [outer, contours] : regions)
  {
    const Contour& contour = set.Contours[static_cast<std::size_t>(outer)];
    const std::vector<BorderWalk> walks = contours.size() == 1
      ? std::vector<BorderWalk>{ { contour.Points, true } }
      : Region(set, contours).Walks();
    for (const BorderWalk& walk : walks)
    {
      KeyholeContour keyhole;
      keyhole.Source = contour.Source;
      for (const int point : walk.Points)
      {
        keyhole.Points.push_back(set.Points[static_cast<std::size_t>(point)]);
      }
      joined.push_back(std::move(keyhole));
    }
  }
  return joined;
}
}
