// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/RegionOverlaps.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace recon
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

constexpr int Outside = -1; ///< of all contours

/// The innermost contours of either level around a face.
struct Place
{
  bool Known = false;
  int Lower = Outside;
  int Upper = Outside;
};

/// Crossings are exact, too. Rounded ones were tried: they save a fifth of the time, but where
/// walls nearly touch they can put a region on the wrong side of a wall.
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_2<Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel,
  CGAL::Triangulation_face_base_with_info_2<Place, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel,
  CGAL::Triangulation_data_structure_2<Vertices, Faces>, CGAL::Exact_intersections_tag>;
using Overlay = CGAL::Constrained_triangulation_plus_2<Triangulation>;
using FaceHandle = Overlay::Face_handle;
using VertexHandle = Overlay::Vertex_handle;

class OverlapMeter
{
public:
  OverlapMeter(const ContourSet& contours, const Level& lower, const Level& upper)
    : Contours(contours)
  {
    this->InsertPoints({ &lower, &upper });
    this->InsertEdges(lower);
    this->InsertEdges(upper);
    this->FirstUpper = upper.Contours.front();
  }

  std::vector<RegionOverlap> Measure()
  {
    std::vector<FaceHandle> front{ this->Plane.infinite_face() };
    front.front()->info().Known = true; // infinitely far out
    while (!front.empty())
    {
      const FaceHandle face = front.back();
      front.pop_back();
      this->AddArea(face);
      for (int i = 0; i < 3; ++i)
      {
        const FaceHandle next = face->neighbor(i);
        if (!next->info().Known)
        {
          next->info() = this->Across(face, i);
          front.push_back(next);
        }
      }
    }
    std::vector<RegionOverlap> overlaps;
    for (const auto& [pair, area] : this->Areas)
    {
      overlaps.push_back({ pair.first, pair.second, area });
    }
    return overlaps;
  }

private:
  /// All points first, along a space-filling curve, so that none has to be looked for from afar.
  void InsertPoints(const std::vector<const Level*>& levels)
  {
    std::vector<Kernel::Point_2> points;
    std::vector<int> ids;
    for (const Level* level : levels)
    {
      for (int c : level->Contours)
      {
        for (int p : this->Contours.Contours[Index(c)].Points)
        {
          const Point2& x = this->Contours.Planar[Index(p)];
          points.emplace_back(x[0], x[1]);
          ids.push_back(p);
        }
      }
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    using PointMap = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;
    CGAL::spatial_sort(order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_2<Kernel, PointMap>(
        CGAL::make_property_map(static_cast<const std::vector<Kernel::Point_2>&>(points))));
    FaceHandle hint;
    for (std::size_t i : order)
    {
      const VertexHandle vertex = this->Plane.insert(points[i], hint);
      hint = vertex->face();
      this->VertexOf.emplace(ids[i], vertex);
    }
  }

  void InsertEdges(const Level& level)
  {
    for (int c : level.Contours)
    {
      const std::vector<int>& points = this->Contours.Contours[Index(c)].Points;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const auto edge = this->Plane.insert_constraint(
          this->VertexOf.at(points[i]), this->VertexOf.at(points[(i + 1) % points.size()]));
        this->ContourOf.emplace(edge, c);
      }
    }
  }

  /// The place on the other side of a face's edge.
  Place Across(const FaceHandle& face, int i)
  {
    Place place = face->info();
    if (!face->is_constrained(i))
    {
      return place;
    }
    const VertexHandle a = face->vertex(Overlay::cw(i));
    const VertexHandle b = face->vertex(Overlay::ccw(i));
    const auto end = this->Plane.contexts_end(a, b);
    for (auto edge = this->Plane.contexts_begin(a, b); edge != end; ++edge)
    {
      const int contour = this->ContourOf.at(edge->id());
      this->Cross(contour, contour < this->FirstUpper ? place.Lower : place.Upper);
    }
    return place;
  }

  /// Contours of a level meet in points only: a place is just inside the contour, or just outside.
  void Cross(int contour, int& innermost) const
  {
    innermost = innermost == contour ? this->Contours.Contours[Index(contour)].Parent : contour;
  }

  void AddArea(const FaceHandle& face)
  {
    if (this->Plane.is_infinite(face))
    {
      return;
    }
    const Place& place = face->info();
    if (place.Lower != Outside && place.Upper != Outside)
    {
      this->Areas[{ place.Lower, place.Upper }] += AreaOf(face);
    }
  }

  static double AreaOf(const FaceHandle& face)
  {
    std::array<Point2, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Kernel::Point_2& x = face->vertex(static_cast<int>(k))->point();
      p[k] = { CGAL::to_double(x.x()), CGAL::to_double(x.y()) };
    }
    return 0.5 *
      ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
  }

  const ContourSet& Contours;
  int FirstUpper = 0; ///< contours are sorted by level
  Overlay Plane;
  std::map<int, VertexHandle> VertexOf;
  std::map<Overlay::Constraint_id, int> ContourOf;
  std::map<std::pair<int, int>, double> Areas;
};

/// The box around a level's contours.
struct Box
{
  Point2 Low{ std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  Point2 High{ -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };

  Box(const ContourSet& contours, const Level& level)
  {
    for (int c : level.Contours)
    {
      for (int p : contours.Contours[Index(c)].Points)
      {
        for (std::size_t k = 0; k < 2; ++k)
        {
          this->Low[k] = std::min(this->Low[k], contours.Planar[Index(p)][k]);
          this->High[k] = std::max(this->High[k], contours.Planar[Index(p)][k]);
        }
      }
    }
  }

  bool IsApartFrom(const Box& other) const
  {
    return this->High[0] <= other.Low[0] || other.High[0] <= this->Low[0] ||
      this->High[1] <= other.Low[1] || other.High[1] <= this->Low[1];
  }
};
}

std::vector<RegionOverlap> MeasureRegionOverlaps(
  const ContourSet& contours, const Level& lower, const Level& upper)
{
  // Also true for a level without contours, whose box is empty.
  if (Box(contours, lower).IsApartFrom(Box(contours, upper)))
  {
    return {};
  }
  return OverlapMeter(contours, lower, upper).Measure();
}
}
