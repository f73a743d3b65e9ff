// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/EdgeTree.h"

#include "Base/BoundingBox.h"
#include "Base/Predicates.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace recon
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Edges = std::vector<Kernel::Segment_3>;
#if CGAL_VERSION_MAJOR >= 6 // since then the names say of how many dimensions
using Primitive = CGAL::AABB_segment_primitive_3<Kernel, Edges::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
using Primitive = CGAL::AABB_segment_primitive<Kernel, Edges::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

Kernel::Point_3 At(const Point2& p)
{
  return { p[0], p[1], 0 };
}

/// The tree is of three dimensions, the plane is at 0.
Box2 BoxOf(const CGAL::Bbox_3& box)
{
  return { { box.xmin(), box.ymin() }, { box.xmax(), box.ymax() } };
}

/// What the tree asks for on its way down.
template <typename Meets, typename Visit>
struct Descent
{
  const Meets& MeetsBox;
  const Visit& VisitEdge;
  Edges::const_iterator First;

  bool go_further() const { return true; }
  template <typename Query, typename Node>
  bool do_intersect(const Query&, const Node& node) const
  {
    return this->MeetsBox(node.bbox());
  }
  template <typename Query>
  void intersection(const Query&, const Primitive& edge) const
  {
    this->VisitEdge(static_cast<int>(edge.id() - this->First));
  }
};
}

struct EdgeTree::Implementation
{
  std::vector<PlanarSegment> Segments;
  Edges Lines;
  Tree Boxes;

  template <typename Meets, typename Visit>
  void Descend(const Meets& meets, const Visit& visit) const
  {
    Descent<Meets, Visit> descent{ meets, visit, this->Lines.begin() };
    this->Boxes.traversal(0, descent);
  }

  template <typename Count>
  double Nearest(const Point2& p, double reach, const Count& count) const;

  template <typename Visit>
  void ForNear(const Box2& window, const Visit& visit) const
  {
    this->Descend([&window](const CGAL::Bbox_3& box) { return window.Meets(BoxOf(box)); },
      [&](int e)
      {
        const PlanarSegment& s = this->Segments[static_cast<std::size_t>(e)];
        if (window.Meets(Box2::Around(std::array<Point2, 2>{ s.A, s.B })))
        {
          visit(e);
        }
      });
  }
};

bool Meet(const PlanarSegment& a, const PlanarSegment& b)
{
  const auto ends = [](const PlanarSegment& s) {
    return Kernel::Segment_2({ s.A[0], s.A[1] }, { s.B[0], s.B[1] });
  };
  return CGAL::do_intersect(ends(a), ends(b));
}

double DistanceToSegment(const Point2& p, const PlanarSegment& segment)
{
  const Point2& a = segment.A;
  const double ux = segment.B[0] - a[0];
  const double uy = segment.B[1] - a[1];
  const double length2 = ux * ux + uy * uy;
  const double along = ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / length2;
  const double t = std::min(1.0, std::max(0.0, along));
  return std::hypot(p[0] - (a[0] + t * ux), p[1] - (a[1] + t * uy));
}

EdgeTree::EdgeTree(std::vector<PlanarSegment> segments) : Impl(std::make_unique<Implementation>())
{
  this->Impl->Segments = std::move(segments);
  this->Impl->Lines.reserve(this->Impl->Segments.size());
  for (const PlanarSegment& s : this->Impl->Segments)
  {
    this->Impl->Lines.emplace_back(At(s.A), At(s.B));
  }
  this->Impl->Boxes.rebuild(this->Impl->Lines.begin(), this->Impl->Lines.end());
  // Now, as the first of several threads to ask must not be the one to build.
  this->Impl->Boxes.build();
}

EdgeTree::~EdgeTree() = default;
EdgeTree::EdgeTree(EdgeTree&& other) noexcept = default;
EdgeTree& EdgeTree::operator=(EdgeTree&& other) noexcept = default;

const std::vector<PlanarSegment>& EdgeTree::Segments() const
{
  return this->Impl->Segments;
}

EdgeTree::SideType EdgeTree::SideOf(const Point2& p) const
{
  bool inside = false;
  bool on = false;
  this->Impl->ForNear(Box2(p, { HUGE_VAL, p[1] }),
    [&](int e)
    {
      const PlanarSegment& s = this->Impl->Segments[static_cast<std::size_t>(e)];
      const int turn = Orientation2(s.A, s.B, p);
      on =
        on || (turn == 0 && std::min(s.A[0], s.B[0]) <= p[0] && p[0] <= std::max(s.A[0], s.B[0]));
      const bool upward = s.A[1] <= p[1] && p[1] < s.B[1];
      const bool downward = s.B[1] <= p[1] && p[1] < s.A[1];
      inside = inside != ((upward && turn > 0) || (downward && turn < 0));
    });
  return on ? On : inside ? Inside : Outside;
}

template <typename Count>
double EdgeTree::Implementation::Nearest(const Point2& p, double reach, const Count& count) const
{
  const auto meets = [&](const CGAL::Bbox_3& box)
  {
    const double dx = std::max({ box.xmin() - p[0], p[0] - box.xmax(), 0.0 });
    const double dy = std::max({ box.ymin() - p[1], p[1] - box.ymax(), 0.0 });
    return dx <= reach && dy <= reach;
  };
  this->Descend(meets,
    [&](int e)
    {
      if (count(e))
      {
        reach = std::min(reach, DistanceToSegment(p, this->Segments[static_cast<std::size_t>(e)]));
      }
    });
  return reach;
}

double EdgeTree::DistanceWithin(const Point2& p, double reach) const
{
  return this->Impl->Nearest(p, reach, [](int) { return true; });
}

double EdgeTree::DistanceWithin(
  const Point2& p, double reach, const std::function<bool(int)>& count) const
{
  return this->Impl->Nearest(p, reach, count);
}

double EdgeTree::DistanceWithin(const PlanarSegment& segment, double reach) const
{
  // Segments that do not cross are nearest at an end of one of them.
  reach = this->DistanceWithin(segment.B, this->DistanceWithin(segment.A, reach));
  this->Impl->ForNear(Box2::Around(std::array<Point2, 2>{ segment.A, segment.B }).Grown(reach),
    [&](int e)
    {
      const PlanarSegment& s = this->Impl->Segments[static_cast<std::size_t>(e)];
      reach = std::min({ reach, DistanceToSegment(s.A, segment), DistanceToSegment(s.B, segment) });
    });
  return reach;
}

double EdgeTree::Distance(const Point2& p) const
{
  return std::sqrt(this->Impl->Boxes.squared_distance(At(p)));
}

void EdgeTree::ForNear(
  const Point2& low, const Point2& high, const std::function<void(int)>& visit) const
{
  this->Impl->ForNear(Box2(low, high), visit);
}
}
