// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/LevelTriangulation.h"

#include "Base/Monitor.h"
#include "Base/Text.h"
#include "Contours/PlanarRings.h"
#include "Polyhedral/ConformingRefinement.h"
#include "Polyhedral/ConstrainedDelaunay.h"
#include "Polyhedral/NeedleContours.h"

#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <string>

namespace recon
{
using namespace delaunay;

namespace
{
/// Circumcentres of cocircular points differ by rounding only: nearer than this share of the
/// level's diagonal they are one point.
constexpr double NearestPoints = 1e-7;

/// Bounds on the points of a level after refinement: so many, and so many more for each that was
/// there before, which are included. For condition 2, drawn contours need at most 2.5 a point, and 1.13
/// where a level has fifty or more (`./run bench levels`).
constexpr std::size_t LeastForGabriel = 200;
constexpr std::size_t ForGabrielAPoint = 20;
/// Conditions 0 and 1 alone take far fewer points; beyond that a level cannot be had at all.
constexpr std::size_t LeastForDelaunay = 4000;
constexpr std::size_t ForDelaunayAPoint = 100;
/// More needles than this are not looked for, as every one takes another attempt.
constexpr std::size_t MostNeedles = 16;

/// The circle with the edge as diameter holds p. On the circle the angle at p is right, which
/// condition 2 allows: the middle of a square, without which its end could not be tapered.
bool Encroaches(const Kernel::Point_2& p, const Edge& edge, bool mayLieOnCircle)
{
  const auto& a = edge.first->vertex(Triangulation::cw(edge.second))->point();
  const auto& b = edge.first->vertex(Triangulation::ccw(edge.second))->point();
  const auto side = CGAL::side_of_bounded_circle(a, b, p);
  return side == CGAL::ON_BOUNDED_SIDE || (side == CGAL::ON_BOUNDARY && !mayLieOnCircle);
}

/// The outer wall of every connected part of IR: the contour of even depth at its border, or the
/// parent of one of its holes where holes that touch cut a part off from the wall.
void NameRegions(const ContourSet& contours, LevelTriangulation& level)
{
  const int count = static_cast<int>(level.Triangles.size());
  level.Region.assign(count, -1);
  std::vector<unsigned char> visited(count, 0);
  std::vector<int> region;
  for (int seed = 0; seed < count; ++seed)
  {
    if (!level.Inside[seed] || visited[seed])
    {
      continue;
    }
    int wall = -1;
    region.assign(1, seed);
    visited[seed] = 1;
    for (std::size_t i = 0; i < region.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int contour = level.EdgeContour[region[i]][k];
        const int neighbour = level.Neighbours[region[i]][k];
        if (contour >= 0)
        {
          const bool outer = contours.Contours[contour].Depth % 2 == 0;
          wall = outer ? contour : (wall < 0 ? contours.Contours[contour].Parent : wall);
        }
        else if (neighbour >= 0 && !visited[neighbour])
        {
          visited[neighbour] = 1;
          region.push_back(neighbour);
        }
      }
    }
    for (int t : region)
    {
      level.Region[t] = wall;
    }
  }
}
}

struct LevelTriangulator::Implementation
{
  const ContourSet& Contours;
  const Level& OfLevel;
  std::vector<int> Wanted; ///< contours of the level but for the needles that were given up
  std::vector<int> Needles;
  Triangulation Delaunay;
  double Diagonal = 0;
  std::size_t GivenPoints = 0; ///< of the contours, and inserted inside
  bool IsGabriel = true;       ///< condition 2 holds
  bool Conformed = false;      ///< was refined before

  Implementation(const ContourSet& contours, int level)
    : Contours(contours),
      OfLevel(contours.Levels[level]),
      Wanted(OfLevel.Contours)
  {
  }

  std::vector<VertexHandle> InsertContourVertices();
  void InsertContourEdges();
  void Begin();
  void Conform();
  void GiveUpNeedle(const RefinementOutcome& outcome);
  std::size_t MaximumForDelaunay() const
  {
    return LeastForDelaunay + ForDelaunayAPoint * this->GivenPoints;
  }
  std::string DescribeProblem(const RefinementOutcome& outcome) const;
  void ClassifyFaces();
  void LabelContourEdges();
  void LabelChain(VertexHandle from, VertexHandle to, int contour);
  void MarkStar(VertexHandle v, bool inside);
  bool IsWithinRounding(const Kernel::Point_2& p, FaceHandle face) const;
  bool MayInsert(const Kernel::Point_2& p, bool inside, bool mayLieOnCircle, FaceHandle hint,
    FaceHandle& where, VertexHandle& twin) const;

  std::vector<VertexHandle> VertexOf; ///< by index into ContourSet::Points, from FirstPoint on
  int FirstPoint = 0;
};

std::vector<VertexHandle> LevelTriangulator::Implementation::InsertContourVertices()
{
  std::vector<std::pair<Kernel::Point_2, VertexInfo>> points;
  CGAL::Bbox_2 box;
  for (int c : this->Wanted)
  {
    for (int p : this->Contours.Contours[c].Points)
    {
      VertexInfo info;
      info.Source = p;
      info.Kind = LevelTriangulation::InputVertex;
      points.emplace_back(
        Kernel::Point_2(this->Contours.Planar[p][0], this->Contours.Planar[p][1]), info);
      box += points.back().first.bbox();
    }
  }
  this->Diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  this->GivenPoints = points.size();
  this->Delaunay.insert(points.begin(), points.end());

  // A place a point of the whole set would take memory in the square of the levels.
  const auto [first, last] = std::minmax_element(points.begin(), points.end(),
    [](const auto& a, const auto& b) { return a.second.Source < b.second.Source; });
  this->FirstPoint = points.empty() ? 0 : first->second.Source;
  std::vector<VertexHandle> vertexOf(
    points.empty() ? 0 : last->second.Source - this->FirstPoint + 1);
  for (auto v : this->Delaunay.finite_vertex_handles())
  {
    vertexOf[v->info().Source - this->FirstPoint] = v;
  }
  return vertexOf;
}

void LevelTriangulator::Implementation::InsertContourEdges()
{
  for (int c : this->Wanted)
  {
    const auto& points = this->Contours.Contours[c].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const VertexHandle a = this->VertexOf[points[i] - this->FirstPoint];
      const VertexHandle b = this->VertexOf[points[(i + 1) % points.size()] - this->FirstPoint];
      // Two points of a level with equal coordinates would leave one without a vertex.
      if (a == VertexHandle() || b == VertexHandle())
      {
        throw Error("Level at offset " + std::to_string(this->OfLevel.Offset) +
          ": two contour points have the same place; clean the contours with Contour Hierarchy.");
      }
      this->Delaunay.insert_constraint(a, b);
    }
  }
}

/**
 * Conditions 0-2, then the sides of the contours.
 *
 * Where contours run so near to each other that condition 2 would take too many points, or has no
 * place for them, the level has conditions 0 and 1 only: its edges are still those of a Delaunay
 * triangulation, which is all that the joint Voronoi diagram needs.
 */
void LevelTriangulator::Implementation::Conform()
{
  if (this->IsGabriel)
  {
    const RefinementOutcome outcome =
      RefineToGabriel(this->Delaunay, LeastForGabriel + ForGabrielAPoint * this->GivenPoints);
    this->IsGabriel = outcome.Problem == RefinementOutcome::None;
    if (!this->IsGabriel && !this->Conformed)
    {
      this->Begin();
    }
  }
  if (!this->IsGabriel)
  {
    const RefinementOutcome outcome = RefineToDelaunay(this->Delaunay, this->MaximumForDelaunay());
    if (outcome.Problem != RefinementOutcome::None)
    {
      this->GiveUpNeedle(outcome);
      this->Conform();
      return;
    }
  }
  this->Conformed = true;
  this->ClassifyFaces();
}

void LevelTriangulator::Implementation::Begin()
{
  this->Delaunay.clear();
  this->VertexOf = this->InsertContourVertices();
  this->InsertContourEdges();
}

/// Begins again without a needle at the place of the problem. @throws Error where there is none.
void LevelTriangulator::Implementation::GiveUpNeedle(const RefinementOutcome& outcome)
{
  const std::vector<int> needle = this->Conformed || this->Needles.size() >= MostNeedles
    ? std::vector<int>()
    : FindNeedle(this->Contours, this->Wanted, outcome.Place);
  if (needle.empty() || needle.size() == this->Wanted.size())
  {
    throw Error(this->DescribeProblem(outcome));
  }
  this->Needles.insert(this->Needles.end(), needle.begin(), needle.end());
  for (int c : needle)
  {
    this->Wanted.erase(std::find(this->Wanted.begin(), this->Wanted.end(), c));
  }
  this->IsGabriel = true;
  this->Begin();
}

std::string LevelTriangulator::Implementation::DescribeProblem(
  const RefinementOutcome& outcome) const
{
  const Point3 place = this->OfLevel.Frame.ToSpace(outcome.Place, this->OfLevel.Offset);
  const bool tooMany = outcome.Problem == RefinementOutcome::TooManyPoints;
  return "Level at offset " + Text(this->OfLevel.Offset) + ": near " + Text(place) +
    " contours run so near to each other, or to themselves, that " +
    (tooMany ? "more than " + std::to_string(this->MaximumForDelaunay()) +
          " points would have to be put on their edges"
             : std::string("no number lies between them")) +
    "; remove or merge there what is narrower than the contours are accurate.";
}

/// Even-odd: crossing a contour edge changes the side; the infinite faces are outside.
void LevelTriangulator::Implementation::ClassifyFaces()
{
  for (auto f : this->Delaunay.all_face_handles())
  {
    f->info().Index = -1;
  }
  std::deque<FaceHandle> front{ this->Delaunay.infinite_face() };
  front.front()->info().Index = 0;
  front.front()->info().Inside = false;
  while (!front.empty())
  {
    const FaceHandle f = front.front();
    front.pop_front();
    for (int k = 0; k < 3; ++k)
    {
      const FaceHandle n = f->neighbor(k);
      if (n->info().Index < 0)
      {
        n->info().Index = 0;
        n->info().Inside = f->info().Inside != f->is_constrained(k);
        front.push_back(n);
      }
    }
  }
}

void LevelTriangulator::Implementation::LabelContourEdges()
{
  for (auto f : this->Delaunay.all_face_handles())
  {
    f->info().EdgeContour = { { -1, -1, -1 } };
  }
  for (int c : this->Wanted)
  {
    const auto& points = this->Contours.Contours[c].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->LabelChain(this->VertexOf[points[i] - this->FirstPoint],
        this->VertexOf[points[(i + 1) % points.size()] - this->FirstPoint], c);
    }
  }
}

/// Name the pieces into which the contour edge from-to was cut. Points added on a contour edge have
/// exactly two contour edges, so a chain that leaves `from` can be followed to the next contour
/// vertex.
void LevelTriangulator::Implementation::LabelChain(VertexHandle from, VertexHandle to, int contour)
{
  auto start = this->Delaunay.incident_edges(from);
  const auto end = start;
  do
  {
    if (this->Delaunay.is_infinite(start) || !start->first->is_constrained(start->second))
    {
      continue;
    }
    std::vector<Edge> chain{ *start };
    VertexHandle previous = from;
    VertexHandle current = start->first->vertex(Triangulation::ccw(start->second));
    if (current == from)
    {
      current = start->first->vertex(Triangulation::cw(start->second));
    }
    while (current->info().Kind == LevelTriangulation::AddedOnContour)
    {
      auto next = this->Delaunay.incident_edges(current);
      VertexHandle other;
      for (;; ++next)
      {
        if (this->Delaunay.is_infinite(next) || !next->first->is_constrained(next->second))
        {
          continue;
        }
        other = next->first->vertex(Triangulation::ccw(next->second));
        other = other == current ? next->first->vertex(Triangulation::cw(next->second)) : other;
        if (other != previous)
        {
          break;
        }
      }
      chain.push_back(*next);
      previous = current;
      current = other;
    }
    if (current != to)
    {
      continue;
    }
    for (const Edge& edge : chain)
    {
      const Edge mirror = this->Delaunay.mirror_edge(edge);
      edge.first->info().EdgeContour[edge.second] = contour;
      mirror.first->info().EdgeContour[mirror.second] = contour;
    }
    return;
  } while (++start != end);
}

/**
 * p lies in IR (or in ER, where it is not to be inside), on no other vertex, and in no contour
 * edge's diametral circle.
 *
 * `where` is the face that holds p, `twin` an internal point that p repeats within rounding, if
 * any.
 */
bool LevelTriangulator::Implementation::MayInsert(const Kernel::Point_2& p, bool inside,
  bool mayLieOnCircle, FaceHandle hint, FaceHandle& where, VertexHandle& twin) const
{
  Triangulation::Locate_type type;
  int index = 0;
  where = this->Delaunay.locate(p, type, index, hint);
  if (where->info().Inside != inside)
  {
    return false;
  }
  if (type == Triangulation::VERTEX)
  {
    twin = where->vertex(index);
    return false;
  }
  std::vector<FaceHandle> conflicts;
  this->Delaunay.get_conflicts(p, std::back_inserter(conflicts), where);
  const double nearest = NearestPoints * this->Diagonal;
  for (FaceHandle f : conflicts)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (!this->Delaunay.is_infinite(f->vertex(k)) &&
        CGAL::squared_distance(f->vertex(k)->point(), p) < nearest * nearest)
      {
        twin = f->vertex(k);
        return false;
      }
      // A contour edge that p encroaches upon always faces p across a triangle in conflict. One
      // without condition 2 must stay Delaunay.
      if (f->is_constrained(k) &&
        (Encroaches(p, Edge(f, k), mayLieOnCircle) ||
          (!this->IsGabriel && this->Delaunay.test_conflict(p, f->neighbor(k)))))
      {
        return false;
      }
    }
  }
  return true;
}

/// An insertion in IR replaces triangles of IR only, one in ER those of ER.
void LevelTriangulator::Implementation::MarkStar(VertexHandle v, bool inside)
{
  auto star = this->Delaunay.incident_faces(v);
  const auto end = star;
  do
  {
    star->info().Inside = inside;
  } while (++star != end);
}

/// p is nearer to a corner or a contour edge of its triangle than coordinates can tell reliably.
bool LevelTriangulator::Implementation::IsWithinRounding(
  const Kernel::Point_2& p, FaceHandle face) const
{
  const double nearest = NearestPoints * this->Diagonal;
  for (int k = 0; k < 3; ++k)
  {
    const auto& a = face->vertex(Triangulation::ccw(k))->point();
    const auto& b = face->vertex(Triangulation::cw(k))->point();
    if (CGAL::squared_distance(a, p) < nearest * nearest ||
      (face->is_constrained(k) &&
        CGAL::squared_distance(Kernel::Segment_2(a, b), p) < nearest * nearest))
    {
      return true;
    }
  }
  return false;
}

LevelTriangulator::LevelTriangulator(const ContourSet& contours, int level)
  : Impl(std::make_unique<Implementation>(contours, level))
{
  this->Impl->Begin();
  this->Impl->Conform();
}

LevelTriangulator::~LevelTriangulator() = default;
LevelTriangulator::LevelTriangulator(LevelTriangulator&&) noexcept = default;
LevelTriangulator& LevelTriangulator::operator=(LevelTriangulator&&) noexcept = default;

const std::vector<int>& LevelTriangulator::Needles() const
{
  return this->Impl->Needles;
}

bool LevelTriangulator::HasCondition2() const
{
  return this->Impl->IsGabriel;
}

std::vector<int> LevelTriangulator::Locate(const std::vector<Point2>& points) const
{
  std::vector<int> triangles;
  FaceHandle hint;
  for (const Point2& p : points)
  {
    hint = this->Impl->Delaunay.locate({ p[0], p[1] }, hint);
    triangles.push_back(this->Impl->Delaunay.is_infinite(hint) ? -1 : hint->info().Index);
  }
  return triangles;
}

void LevelTriangulator::AddInternalPoints(
  const std::vector<Point2>& candidates, LevelTriangulation::AskedByType askedBy)
{
  this->AddPoints(candidates, askedBy);
}

void LevelTriangulator::AddExternalPoints(const std::vector<Point2>& candidates)
{
  this->AddPoints(candidates, LevelTriangulation::External);
}

void LevelTriangulator::AddPoints(
  const std::vector<Point2>& candidates, LevelTriangulation::AskedByType askedBy)
{
  auto& impl = *this->Impl;
  std::vector<Kernel::Point_2> points;
  for (const Point2& candidate : candidates)
  {
    const Point2 p = SnapToGrid(candidate, impl.OfLevel.Grid);
    points.emplace_back(p[0], p[1]);
  }
  CGAL::spatial_sort(points.begin(), points.end());
  const bool inside = askedBy != LevelTriangulation::External;
  const bool mayLieOnCircle = askedBy == LevelTriangulation::EndCap;
  FaceHandle hint;
  for (const auto& p : points)
  {
    FaceHandle where;
    VertexHandle twin;
    const bool insert = impl.MayInsert(p, inside, mayLieOnCircle, hint, where, twin);
    hint = where;
    if (twin != VertexHandle() && twin->info().Kind == LevelTriangulation::Internal)
    {
      twin->info().AskedBy = static_cast<unsigned char>(twin->info().AskedBy | askedBy);
    }
    if (!insert)
    {
      continue;
    }
    const VertexHandle v = impl.Delaunay.insert(p, where);
    v->info().Kind = LevelTriangulation::Internal;
    ++impl.GivenPoints;
    v->info().AskedBy = static_cast<unsigned char>(v->info().AskedBy | askedBy);
    impl.MarkStar(v, inside);
    hint = v->face();
  }
}

void LevelTriangulator::AddCoverPoints(const std::vector<Point2>& points)
{
  auto& impl = *this->Impl;
  FaceHandle hint;
  for (const Point2& point : points)
  {
    const Kernel::Point_2 p(point[0], point[1]);
    Triangulation::Locate_type type;
    int index = 0;
    hint = impl.Delaunay.locate(p, type, index, hint);
    const bool inside = !impl.Delaunay.is_infinite(hint) && hint->info().Inside;
    if (!inside || type == Triangulation::VERTEX || impl.IsWithinRounding(p, hint))
    {
      continue;
    }
    const VertexHandle v = impl.Delaunay.insert(p, type, hint, index);
    v->info().Kind = LevelTriangulation::Internal;
    ++impl.GivenPoints;
    v->info().AskedBy = LevelTriangulation::Cover;
    impl.MarkStar(v, true);
    hint = v->face();
  }
  impl.Conform();
}

LevelTriangulation LevelTriangulator::Finish() const
{
  auto& impl = *this->Impl;
  impl.LabelContourEdges();
  LevelTriangulation out;
  out.IsGabriel = impl.IsGabriel;
  for (auto v : impl.Delaunay.finite_vertex_handles())
  {
    v->info().Index = static_cast<int>(out.Points.size());
    out.Points.push_back({ v->point().x(), v->point().y() });
    out.Source.push_back(v->info().Source);
    out.Kind.push_back(v->info().Kind);
    out.AskedBy.push_back(v->info().AskedBy);
  }
  for (auto f : impl.Delaunay.all_face_handles())
  {
    f->info().Index = -1;
  }
  for (auto f : impl.Delaunay.finite_face_handles())
  {
    f->info().Index = static_cast<int>(out.Triangles.size());
    out.Triangles.push_back(
      { { f->vertex(0)->info().Index, f->vertex(1)->info().Index, f->vertex(2)->info().Index } });
    out.EdgeContour.push_back(f->info().EdgeContour);
    out.Inside.push_back(f->info().Inside ? 1 : 0);
  }
  out.StarTriangle.assign(out.Points.size(), -1);
  for (auto f : impl.Delaunay.finite_face_handles())
  {
    std::array<int, 3> neighbours{};
    for (int k = 0; k < 3; ++k)
    {
      neighbours[k] = f->neighbor(k)->info().Index;
      out.StarTriangle[f->vertex(k)->info().Index] = f->info().Index;
    }
    out.Neighbours.push_back(neighbours);
  }
  NameRegions(impl.Contours, out);
  return out;
}

Point2 LevelTriangulation::VoronoiVertex(int triangle) const
{
  const auto& t = this->Triangles[triangle];
  return Circumcentre(this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]);
}

Point2 Circumcentre(const Point2& a, const Point2& b, const Point2& c)
{
  // CGAL's construction asserts a determinant that is not zero; a flat triangle gives infinity.
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double twice = 2 * (bx * cy - by * cx);
  return { a[0] + (b2 * cy - c2 * by) / twice, a[1] + (c2 * bx - b2 * cx) / twice };
}
}
