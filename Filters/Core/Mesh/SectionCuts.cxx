// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionCuts.h"

#include "Base/DisjointSets.h"
#include "Base/SubMonitor.h"
#include "Mesh/SectionDiscs.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
/// Directions in which planes are tilted, where those along the levels do not do: points between two
/// levels often lie at one height, and loops that meet there are apart in a tilted plane.
constexpr int TiltDirections = 8;

/// Each far from all others, and from the directions of pixels.
constexpr double GoldenAngle = 2.399963229728653;

/// How far a tilted plane rises over the whole surface, in thicknesses of the thinnest slab.
constexpr double RiseAcross = 0.5;

using Edge = std::array<int, 2>;
using Triangle = std::array<int, 3>;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

using Polygon = std::vector<Point2>;
using FaceSet = std::set<Triangulation::Face_handle>;

/// All faces that are reached without crossing a polygon; those just beyond are added to the second.
FaceSet ReachedFrom(std::vector<Triangulation::Face_handle> stack, const FaceSet& known,
  std::vector<Triangulation::Face_handle>& beyond)
{
  FaceSet reached;
  while (!stack.empty())
  {
    const Triangulation::Face_handle face = stack.back();
    stack.pop_back();
    if (known.count(face) > 0 || !reached.insert(face).second)
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      (face->is_constrained(k) ? beyond : stack).push_back(face->neighbor(k));
    }
  }
  return reached;
}

/// Triangles of a polygon without those inside it, by corners, numbered on from polygon to polygon,
/// counterclockwise; nothing where one is not simple, or two cross.
std::optional<std::vector<Triangle>> TrianglesOf(const std::vector<Polygon>& polygons)
{
  Triangulation triangulation;
  std::size_t count = 0;
  for (const Polygon& polygon : polygons)
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
    std::vector<Triangulation::Vertex_handle> vertices;
    for (const Kernel::Point_2& corner : corners)
    {
      vertices.push_back(triangulation.insert(corner));
      vertices.back()->info() = static_cast<int>(count++);
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % corners.size()]);
    }
  }
  if (triangulation.number_of_vertices() != count)
  {
    return std::nullopt; // corners that coincide, or crossings
  }
  std::vector<Triangulation::Face_handle> first;
  std::vector<Triangulation::Face_handle> second;
  const FaceSet outside = ReachedFrom({ triangulation.infinite_face() }, {}, first);
  std::vector<Triangle> triangles;
  for (const Triangulation::Face_handle face : ReachedFrom(first, outside, second))
  {
    triangles.push_back(
      { face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info() });
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

/// Joins points by the edges that are not crossed, whichever way they run.
template <typename EdgesByKey>
void JoinUncrossed(const TriangleMesh& mesh, const EdgesByKey& crossed, DisjointSets& sets)
{
  for (const Triangle& triangle : mesh.Triangles)
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
}

/// Cuts along planes of one direction.
class Cutter
{
public:
  Cutter(TriangleMesh& mesh, const SectionPlanes& planes, const Vector3& normal,
    const std::vector<double>& offsets, Monitor& monitor)
    : Mesh(mesh),
      Frame(planes.Frame),
      Normal(normal),
      Discs(FindSectionDiscs(mesh, planes, normal, offsets, monitor))
  {
  }

  SectionCuts Cut(int handles)
  {
    const std::vector<Cutting> cuttings = this->Choose(static_cast<std::size_t>(handles));
    for (const Cutting& cutting : cuttings)
    {
      const SectionDisc& disc = *cutting.Disc;
      const double height = (disc.Low + disc.High) / 2;
      const Point3 place = this->Frame.ToSpace(
        CrossingAt(this->Mesh, this->Frame, disc.Loop.Edges[0], height), height);
      this->Result.Cuts.push_back(
        { disc.Slab, Dot(this->Normal, place), disc.Area, disc.Solid, place });
      for (const Opening& opening : cutting.Openings)
      {
        for (const int t : opening.Loop->Triangles)
        {
          std::vector<double>& cuts = this->CutsOfTriangle[t];
          cuts.insert(cuts.end(), { opening.Low, opening.High });
        }
      }
    }
    const TriangleMesh before = this->Mesh;
    this->Mesh.Triangles.clear();
    for (std::size_t t = 0; t < before.Triangles.size(); ++t)
    {
      this->AddParts(before, static_cast<int>(t));
    }
    for (const Cutting& cutting : cuttings)
    {
      for (const Cap& cap : cutting.Caps)
      {
        this->AddCap(before, cap);
      }
    }
    return std::move(this->Result);
  }

private:
  /// A loop along which the surface is taken away between two heights.
  struct Opening
  {
    const SectionLoop* Loop;
    double Low;
    double High;
  };

  /// Closes the surface at one height, from a loop to those inside it.
  struct Cap
  {
    std::vector<const SectionLoop*> Loops;
    double Height;
    bool Above;                        ///< above what is taken away
    std::vector<Triangle> Triangles;   ///< by the corners of the loops, counterclockwise
    bool RunsCounterclockwise = false; ///< the first loop
  };

  struct Cutting
  {
    const SectionDisc* Disc;
    std::vector<Opening> Openings;
    std::vector<Cap> Caps;
  };

  /// The cheapest that can be made, up to so many.
  std::vector<Cutting> Choose(std::size_t handles)
  {
    while (true)
    {
      std::vector<std::size_t> chosen = this->DiscsThatPartNothing();
      chosen.resize(std::min(chosen.size(), handles));
      std::vector<Cutting> cuttings;
      std::vector<std::size_t> useless;
      for (const std::size_t d : chosen)
      {
        if (auto cutting = this->CuttingOf(this->Discs[d]))
        {
          cuttings.push_back(std::move(*cutting));
        }
        else
        {
          useless.push_back(d);
        }
      }
      if (useless.empty())
      {
        return cuttings;
      }
      std::sort(useless.rbegin(), useless.rend());
      for (const std::size_t d : useless) // so this ends
      {
        this->Discs.erase(this->Discs.begin() + static_cast<std::ptrdiff_t>(d));
      }
    }
  }

  /**
   * A disc is taken away between its two heights. Of a ring each loop inside parts the surface: what
   * hangs there on the one side goes on hanging on the ring's cap of that side; to the other side the
   * loop is closed, a little farther out, so that the ring's cap there is a disc.
   */
  std::optional<Cutting> CuttingOf(const SectionDisc& disc) const
  {
    const double margin = disc.Inside.empty() ? 0 : (disc.High - disc.Low) / 4;
    const double low = disc.Low + margin;
    const double high = disc.High - margin;
    Cutting cutting{ &disc, { { &disc.Loop, low, high } },
      { { { &disc.Loop }, low, false, {} }, { { &disc.Loop }, high, true, {} } } };
    for (const SectionLoop& inner : disc.Inside)
    {
      const std::optional<bool> hangsAbove = this->HangsAbove(inner, disc.Loop);
      if (!hangsAbove)
      {
        return std::nullopt;
      }
      cutting.Openings.push_back(
        { &inner, *hangsAbove ? disc.Low : low, *hangsAbove ? high : disc.High });
      cutting.Caps.push_back({ { &inner }, *hangsAbove ? disc.Low : disc.High, !*hangsAbove, {} });
      cutting.Caps[*hangsAbove ? 1 : 0].Loops.push_back(&inner);
    }
    for (Cap& cap : cutting.Caps)
    {
      const std::vector<Polygon> corners = this->CornersOf(cap);
      std::optional<std::vector<Triangle>> triangles = TrianglesOf(corners);
      if (!triangles)
      {
        return std::nullopt;
      }
      cap.Triangles = std::move(*triangles);
      cap.RunsCounterclockwise = SignedAreaOf(corners[0]) > 0;
    }
    return cutting;
  }

  /// Whether what a loop parts from the one around it lies above; nothing where it parts nothing.
  std::optional<bool> HangsAbove(const SectionLoop& inner, const SectionLoop& around) const
  {
    const std::set<Edge> crossed(inner.Edges.begin(), inner.Edges.end());
    DisjointSets sets(this->Mesh.Points.size());
    JoinUncrossed(this->Mesh, crossed, sets);
    const int below = sets.Find(inner.Edges[0][0]);
    const int above = sets.Find(inner.Edges[0][1]);
    const int own = sets.Find(around.Edges[0][0]);
    return below == above || (own != below && own != above) ? std::nullopt
                                                            : std::make_optional(own == below);
  }

  std::vector<Polygon> CornersOf(const Cap& cap) const
  {
    std::vector<Polygon> polygons;
    for (const SectionLoop* loop : cap.Loops)
    {
      polygons.emplace_back();
      for (const Edge& edge : loop->Edges)
      {
        polygons.back().push_back(CrossingAt(this->Mesh, this->Frame, edge, cap.Height));
      }
    }
    return polygons;
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
      for (const Edge& edge : this->Discs[d].Loop.Edges)
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
    JoinUncrossed(this->Mesh, crossed, sets);
    std::vector<std::size_t> order(this->Discs.size());
    for (std::size_t d = 0; d < order.size(); ++d)
    {
      order[d] = d;
    }
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b)
      {
        const bool isRing = !this->Discs[a].Inside.empty();
        const bool isOther = !this->Discs[b].Inside.empty();
        return isRing != isOther ? isOther : this->Discs[a].Area > this->Discs[b].Area;
      });
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

  /// A triangle without what lies between the two heights of each loop that crosses it.
  void AddParts(const TriangleMesh& before, int t)
  {
    const auto crossed = this->CutsOfTriangle.find(t);
    if (crossed == this->CutsOfTriangle.end())
    {
      this->Add(before.Triangles[t], t);
      return;
    }
    std::vector<double>& cuts = crossed->second; // low and high, from below
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

  /// Below, the rim of what is left runs along a loop's edges, above against them; a cap runs the other
  /// way.
  void AddCap(const TriangleMesh& before, const Cap& cap)
  {
    std::vector<int> rim;
    for (const SectionLoop* loop : cap.Loops)
    {
      for (const Edge& edge : loop->Edges)
      {
        rim.push_back(this->PointAt(before, edge, cap.Height));
      }
    }
    for (const Triangle& triangle : cap.Triangles)
    {
      const int a = rim[static_cast<std::size_t>(triangle[0])];
      const int b = rim[static_cast<std::size_t>(triangle[1])];
      const int c = rim[static_cast<std::size_t>(triangle[2])];
      this->Add(
        cap.RunsCounterclockwise == cap.Above ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } },
        cap.Loops[0]->Triangles[0]);
    }
  }

  TriangleMesh& Mesh;
  const PlanarFrame& Frame;
  const Vector3& Normal; ///< of the levels
  std::vector<SectionDisc> Discs;
  std::map<int, std::vector<double>> CutsOfTriangle;
  std::map<std::pair<Edge, double>, int> NewPoints;
  SectionCuts Result;
};

/// How far the points of a mesh reach along the levels.
double ExtentOf(const TriangleMesh& mesh, const PlanarFrame& frame)
{
  std::array<double, 2> low{ { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() } };
  std::array<double, 2> high{ { -low[0], -low[1] } };
  for (const Point3& point : mesh.Points)
  {
    const Point2 p = frame.ToPlane(point);
    for (std::size_t k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

/// A frame of planes that rise in the direction of that number, by so much a unit.
PlanarFrame Tilted(const PlanarFrame& frame, int direction, double slope)
{
  const double angle = direction * GoldenAngle;
  const Vector3 normal =
    frame.Normal - (slope * std::cos(angle)) * frame.U - (slope * std::sin(angle)) * frame.V;
  return PlanarFrame::About((1 / Norm(normal)) * normal);
}

/// What is looked at, one after the other, until there are discs enough.
std::vector<SectionPlanes> PlanesToTry(
  const TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets)
{
  std::vector<SectionPlanes> planes{ { frame, SectionPlanes::Even, false },
    { frame, SectionPlanes::Critical, false } };
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < offsets.size(); ++i)
  {
    thinnest = std::min(thinnest, offsets[i] - offsets[i - 1]);
  }
  const double slope = RiseAcross * thinnest / ExtentOf(mesh, frame);
  for (int direction = 0; direction < TiltDirections; ++direction)
  {
    planes.push_back({ Tilted(frame, direction, slope), SectionPlanes::Critical, false });
  }
  return planes;
}
}

SectionCuts CutHandles(TriangleMesh& mesh, const PlanarFrame& frame,
  const std::vector<double>& offsets, int handles, Monitor& monitor)
{
  SectionCuts all;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    all.PartOf.push_back(static_cast<int>(t));
  }
  if (offsets.size() < 2)
  {
    return all;
  }
  const auto cut = [&](const SectionPlanes& along, int most, Monitor& progress)
  {
    const SectionCuts cuts = Cutter(mesh, along, frame.Normal, offsets, progress).Cut(most);
    all.Cuts.insert(all.Cuts.end(), cuts.Cuts.begin(), cuts.Cuts.end());
    std::vector<int> partOf;
    for (const int part : cuts.PartOf)
    {
      partOf.push_back(all.PartOf[static_cast<std::size_t>(part)]);
    }
    all.PartOf = std::move(partOf);
    return static_cast<int>(cuts.Cuts.size());
  };
  const std::vector<SectionPlanes> planes = PlanesToTry(mesh, frame, offsets);
  int left = std::max(0, handles);
  for (std::size_t i = 0; i < planes.size() && left > 0; ++i)
  {
    SubMonitor progress(monitor, static_cast<double>(i) / static_cast<double>(planes.size()),
      static_cast<double>(i + 1) / static_cast<double>(planes.size()));
    left -= cut(planes[i], left, progress);
    SectionPlanes rings = planes[i];
    rings.WithRings = rings.Spacing == SectionPlanes::Critical;
    // One at a time, as each changes what hangs on the others; each takes a handle, so this ends.
    for (int made = 1; made > 0 && left > 0 && rings.WithRings; left -= made)
    {
      AbortMonitor stop(progress);
      made = cut(rings, 1, stop);
    }
  }
  return all;
}
}
