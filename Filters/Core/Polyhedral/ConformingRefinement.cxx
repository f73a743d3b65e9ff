// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/ConformingRefinement.h"

#include "Base/StopSignal.h"

#include <CGAL/Triangulation_conformer_2.h>

namespace recon
{
using namespace delaunay;

namespace
{
using Clusters = CGAL::Mesh_2::Clusters<Triangulation>;

/// What the refinement asks of an edge, in the two ways in which it names one.
template <typename Condition>
struct Locally
{
  bool operator()(const Triangulation& triangulation, FaceHandle face, int k) const
  {
    return Condition::Holds(triangulation, face, k);
  }

  bool operator()(const Triangulation& triangulation, VertexHandle a, VertexHandle b) const
  {
    FaceHandle face;
    int k = 0;
    return !triangulation.is_edge(a, b, face, k) || Condition::Holds(triangulation, face, k);
  }
};

/// Neither apex of the edge is in its diametral circle or on it. CGAL's own predicate lets one be on
/// it from release 6.2 on, so the points that are added would depend on the release.
struct Gabriel
{
  static bool Holds(const Triangulation& triangulation, FaceHandle face, int k)
  {
    const auto& a = face->vertex(Triangulation::cw(k))->point();
    const auto& b = face->vertex(Triangulation::ccw(k))->point();
    const auto isOutside = [&](VertexHandle apex)
    { return triangulation.is_infinite(apex) || CGAL::angle(a, apex->point(), b) == CGAL::ACUTE; };
    return isOutside(face->vertex(k)) && isOutside(triangulation.tds().mirror_vertex(face, k));
  }
};

/// An edge with one more point on its circle is Delaunay, too; CGAL's own predicate would split it.
struct Delaunay
{
  static bool Holds(const Triangulation& triangulation, FaceHandle face, int k)
  {
    const VertexHandle far = triangulation.tds().mirror_vertex(face, k);
    return triangulation.is_infinite(face) || triangulation.is_infinite(far) ||
      triangulation.side_of_oriented_circle(face, far->point()) != CGAL::ON_POSITIVE_SIDE;
  }
};

/// Thrown through CGAL's loop, which knows no other way to stop.
struct Stop
{
  RefinementOutcome Outcome;
};

bool IsLeftOf(const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& p)
{
  return CGAL::orientation(a, b, p) == CGAL::LEFT_TURN;
}

/// CGAL's level of the refinement that splits edges, with a look at every point before it goes in.
template <typename Condition>
class GuardedSplitting
  : public CGAL::Mesh_2::Refine_edges_base_with_clusters<Triangulation, Condition>
{
public:
  using Super = CGAL::Mesh_2::Refine_edges_base_with_clusters<Triangulation, Condition>;
  using Super::Super;
  using Edge = delaunay::Edge;
  using Zone = CGAL::Triangulation_mesher_level_traits_2<Triangulation>::Zone;

  std::size_t MaximumPoints = 0;

  Kernel::Point_2 refinement_point_impl(const Edge& edge)
  {
    ThrowIfStopped();
    const Kernel::Point_2 p = Super::refinement_point_impl(edge);
    if (this->tr.number_of_vertices() >= this->MaximumPoints)
    {
      throw Stop{ { RefinementOutcome::TooManyPoints, { p.x(), p.y() } } };
    }
    return p;
  }

  /// The faces that p replaces must be a disc without a vertex inside that is seen from p whole: all
  /// its border lies counterclockwise about p.
  CGAL::Mesher_level_conflict_status private_test_point_conflict_impl(
    const Kernel::Point_2& p, Zone& zone) const
  {
    bool sound = !zone.faces.empty() && zone.boundary_edges.size() == zone.faces.size() + 2;
    for (const Edge& outer : zone.boundary_edges)
    {
      const auto a = outer.first->vertex(Triangulation::cw(outer.second));
      const auto b = outer.first->vertex(Triangulation::ccw(outer.second));
      sound = sound &&
        (this->tr.is_infinite(a) || this->tr.is_infinite(b) || IsLeftOf(a->point(), b->point(), p));
    }
    if (!sound)
    {
      throw Stop{ { RefinementOutcome::NoPlace, { p.x(), p.y() } } };
    }
    return CGAL::NO_CONFLICT;
  }
};

template <typename Condition>
RefinementOutcome Refine(Triangulation& triangulation, std::size_t maximumPoints)
{
  using Splitting =
    CGAL::Mesh_2::Refine_edges_with_clusters<Triangulation, Condition, GuardedSplitting<Condition>>;
  Clusters clusters(triangulation);
  CGAL::Null_mesher_level below;
  Splitting splitting(triangulation, clusters, below);
  splitting.MaximumPoints = maximumPoints;
  try
  {
    clusters.create_clusters();
    splitting.scan_triangulation();
    splitting.refine(CGAL::Null_mesh_visitor());
  }
  catch (const Stop& stop)
  {
    return stop.Outcome;
  }
  return {};
}
}

RefinementOutcome RefineToGabriel(Triangulation& triangulation, std::size_t maximumPoints)
{
  return Refine<Locally<Gabriel>>(triangulation, maximumPoints);
}

RefinementOutcome RefineToDelaunay(Triangulation& triangulation, std::size_t maximumPoints)
{
  return Refine<Locally<Delaunay>>(triangulation, maximumPoints);
}
}
