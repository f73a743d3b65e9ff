// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/VoronoiSections.h"

#include "Base/BoundingBox.h"
#include "Base/Monitor.h"
#include "Base/StopSignal.h"
#include "Polyhedral/VertexRegions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Share of the levels' diagonal within which all crossings are looked at: some 10^5 times what
/// rounding can amount to.
constexpr double ToleranceShare = 1e-10;

/// Crossings before the middle of a contour edge that are tried one by one; the first nearly always
/// is the one wanted.
constexpr int MostStepsBack = 16;

double DiagonalOf(const JointCells& cells)
{
  Box2 box = Box2::Around(cells.LevelAt(0).Points);
  box.Add(Box2::Around(cells.LevelAt(1).Points));
  return box.Diagonal();
}

const Point2& PointOf(const JointCells& cells, int level, int v)
{
  return cells.LevelAt(level).Points[v];
}

PlanarLine LineOf(const Point2& a, const Point2& b)
{
  return { { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) }, { b[1] - a[1], a[0] - b[0] }, -Infinity,
    Infinity };
}

bool HasTouchingRegions(const LevelTriangulation& level)
{
  const VertexRegions regions(level);
  for (int v = 0; v < static_cast<int>(level.Points.size()); ++v)
  {
    if (regions.IsTouching(v))
    {
      return true;
    }
  }
  return false;
}
}

VoronoiPath ForthAlong(const LevelTriangulation& level, int own, int edge)
{
  const int t = edge / 3, k = edge % 3;
  const auto& corners = level.Triangles[t];
  return { own, edge, corners[(k + 1) % 3], corners[(k + 2) % 3], t, level.Neighbours[t][k], true };
}

VoronoiPath Reversed(const VoronoiPath& path)
{
  return { path.Own, path.Edge, path.B, path.A, path.To, path.From, !path.Forth };
}

JointCrossing CrossingOf(
  const JointCells& cells, const VoronoiPath& path, int cell, const VoronoiEdgeWalk::Exit& exit)
{
  if (path.Own == 0)
  {
    return path.Forth ? JointCrossing{ { { path.Edge, exit.DelaunayEdge } },
      { { path.A, path.B, cell, exit.Cell } } }
                      : JointCrossing{ { { path.Edge, exit.DelaunayEdge } },
                          { { path.B, path.A, exit.Cell, cell } } };
  }
  // Seen from below, edges of level 2 cross those of level 1 the other way.
  const VoronoiPath lower = ForthAlong(cells.LevelAt(0), 0, exit.DelaunayEdge);
  const bool same = lower.A == cell;
  return { { { exit.DelaunayEdge, path.Edge } },
    { { lower.A, lower.B, same ? path.B : path.A, same ? path.A : path.B } } };
}

std::array<bool, 2> SidesOf(const JointCells& cells, const JointCrossing& crossing)
{
  std::array<bool, 2> inside{};
  for (const int level : { 0, 1 })
  {
    const LevelTriangulation& own = cells.LevelAt(level);
    const EdgeKind kind = KindOf(own, crossing.Edges[level]);
    const int other = level == 0 ? 2 : 0;
    inside[level] = kind == EdgeKind::Internal ||
      (kind == EdgeKind::Contour &&
        !IsNodeOutside(own, crossing.Edges[level],
          PointOf(cells, 1 - level, crossing.Corners[other]),
          PointOf(cells, 1 - level, crossing.Corners[other + 1])));
  }
  return inside;
}

/// On its way along a path.
struct VoronoiSections::Walker
{
  Walker(const JointCells& cells, const VoronoiPath& path)
    : Path(path),
      Kind(KindOf(cells.LevelAt(path.Own), path.Edge)),
      A(PointOf(cells, path.Own, path.A)),
      B(PointOf(cells, path.Own, path.B)),
      Walk(cells, path.Own, A, B),
      Back(cells, path.Own, B, A),
      Cell(cells.Apices(path.Own)[path.From]),
      Last(path.To < 0 ? -1 : cells.Apices(path.Own)[path.To])
  {
  }

  VoronoiPath Path;
  EdgeKind Kind;
  const Point2& A;
  const Point2& B;
  VoronoiEdgeWalk Walk;
  VoronoiEdgeWalk Back;
  int Cell;
  int Last;
  int CameFrom = -1;
};

VoronoiSections::VoronoiSections(const JointCells& cells)
  : Cells(cells),
    Search{ { LevelSearch(cells.LevelAt(0)), LevelSearch(cells.LevelAt(1)) } },
    Touching{ { HasTouchingRegions(cells.LevelAt(0)), HasTouchingRegions(cells.LevelAt(1)) } },
    Tolerance(ToleranceShare * DiagonalOf(cells))
{
}

void VoronoiSections::Find(int own, int edge, bool all, std::vector<JointCrossing>& crossings) const
{
  ThrowIfStopped();
  const LevelTriangulation& level = this->Cells.LevelAt(own);
  const VoronoiPath forth = ForthAlong(level, own, edge);
  const EdgeKind kind = KindOf(level, edge);
  if (kind == EdgeKind::External && !all)
  {
    return;
  }
  const bool reverse = kind == EdgeKind::Contour && !level.Inside[forth.From];
  Walker walker(this->Cells, reverse ? Reversed(forth) : forth);
  // Every step goes forward, and there are no more cells than vertices.
  for (std::size_t steps = 0; walker.Cell != walker.Last; ++steps)
  {
    const auto exit = walker.Walk.Leave(walker.Cell, walker.CameFrom);
    if (!exit || steps > this->Cells.LevelAt(1 - own).Points.size())
    {
      throw Error("Joint Voronoi diagram: a Voronoi edge did not reach its end.");
    }
    if (exit->Cell < 0)
    {
      return;
    }
    crossings.push_back(CrossingOf(this->Cells, walker.Path, walker.Cell, *exit));
    const std::array<bool, 2> inside = SidesOf(this->Cells, crossings.back());
    // Beside regions that touch one cannot tell whose contour comes next.
    const bool mayJump = !all && (inside[1 - own] || !this->Touching[1 - own]);
    const double reached =
      mayJump ? this->PositionOf(walker, walker.Cell, exit->Cell).To : Infinity;
    walker.Cell = exit->Cell;
    walker.CameFrom = exit->SideA;
    if (reached < Infinity &&
      (inside[own] ? this->Jump(walker, reached, inside[1 - own], crossings)
                   : this->JumpOutside(walker, reached, inside[1 - own], crossings)))
    {
      return;
    }
  }
}

/// Where the path crosses the bisector of two vertices of the other level, with what it may err.
LineInterval VoronoiSections::PositionOf(const Walker& walker, int from, int to) const
{
  const PlanarLine line = LineOf(walker.A, walker.B);
  const Point2& u = PointOf(this->Cells, 1 - walker.Path.Own, from);
  const Point2& v = PointOf(this->Cells, 1 - walker.Path.Own, to);
  double n = 0, d = 0, boundN = 0, boundD = 0;
  for (int k = 0; k < 2; ++k)
  {
    const double way = v[k] - u[k];
    const double left = u[k] - walker.A[k], right = v[k] - walker.B[k];
    n += way * (left + right);
    d += line.Direction[k] * way;
    boundN += std::abs(way) * (std::abs(left) + std::abs(right));
    boundD += std::abs(way * line.Direction[k]);
  }
  // As FilterFactor of JointVoronoiPredicates.cxx.
  constexpr double factor = 32 * std::numeric_limits<double>::epsilon();
  if (!(d > 2 * factor * boundD))
  {
    return { -Infinity, Infinity };
  }
  const double s = 0.5 * n / d;
  const double error = factor * (boundN + 2 * std::abs(s) * boundD) / d;
  return { s - error, s + error };
}

/// Before this the path has not come to its triangle To; -infinity where rounding hides the place.
double VoronoiSections::EndOf(const Walker& walker) const
{
  const LevelTriangulation& level = this->Cells.LevelAt(walker.Path.Own);
  const PlanarLine line = LineOf(walker.A, walker.B);
  const Point2 centre = level.VoronoiVertex(walker.Path.To);
  const double error = VoronoiVertexError(level, walker.Path.To);
  const double squared =
    line.Direction[0] * line.Direction[0] + line.Direction[1] * line.Direction[1];
  const double s = (line.Direction[0] * (centre[0] - line.Origin[0]) +
                     line.Direction[1] * (centre[1] - line.Origin[1])) /
    squared;
  const double end = s - (error + this->Tolerance) / std::sqrt(squared);
  return std::isfinite(end) ? end : -Infinity;
}

/// The cell that the path is in at s; none where that cannot be told, or begins before `after`.
std::optional<int> VoronoiSections::CellAt(const Walker& walker, double s, double after) const
{
  const PlanarLine line = LineOf(walker.A, walker.B);
  const int other = 1 - walker.Path.Own;
  const int nearest = this->Search[other].NearestVertex(
    { line.Origin[0] + s * line.Direction[0], line.Origin[1] + s * line.Direction[1] });
  const double margin = this->Tolerance / std::hypot(line.Direction[0], line.Direction[1]);
  const auto holds = [&](int cell)
  {
    const auto exit = walker.Walk.Leave(cell);
    const auto entry = walker.Back.Leave(cell);
    if (!exit || !entry || exit->Cell < 0 || entry->Cell < 0)
    {
      return false;
    }
    const LineInterval begin = this->PositionOf(walker, entry->Cell, cell);
    return begin.From > after && begin.To <= s + margin &&
      this->PositionOf(walker, cell, exit->Cell).From >= s - margin;
  };
  if (holds(nearest))
  {
    return nearest;
  }
  const VertexStars& stars = this->Cells.Stars(other);
  for (int i = 0; i < stars.Size(nearest); ++i)
  {
    if (holds(stars.Before(nearest, i)))
    {
      return stars.Before(nearest, i);
    }
  }
  return std::nullopt;
}

/// To that place, and one crossing back, or so many that one of them is inside the own contours where
/// that is asked for. Stays where the place is too near to be sure.
void VoronoiSections::JumpTo(Walker& walker, double target, double after, bool back,
  std::vector<JointCrossing>& crossings) const
{
  const auto cell = target > after ? this->CellAt(walker, target, after) : std::nullopt;
  if (!cell)
  {
    return;
  }
  int before = *cell;
  for (int steps = 0; steps < MostStepsBack; ++steps)
  {
    const auto entry = walker.Back.Leave(before);
    if (!entry || entry->Cell < 0)
    {
      break;
    }
    crossings.push_back(CrossingOf(this->Cells, Reversed(walker.Path), before, *entry));
    before = entry->Cell;
    if (!back || SidesOf(this->Cells, crossings.back())[walker.Path.Own])
    {
      break;
    }
  }
  walker.Cell = *cell;
  walker.CameFrom = -1;
}

/**
 * From a place inside the own contours to where the next contour of the other level comes, or the next edge of its
 * external skeleton or, on the way out, the middle of the own contour edge.
 *
 * @returns whether there is nothing more to come
 */
bool VoronoiSections::Jump(
  Walker& walker, double after, bool insideOther, std::vector<JointCrossing>& crossings) const
{
  PlanarLine line = LineOf(walker.A, walker.B);
  const double margin = this->Tolerance / std::hypot(line.Direction[0], line.Direction[1]);
  const bool out = walker.Kind == EdgeKind::Contour;
  // A right angle beyond the contour edge puts the end into its middle.
  const double last = walker.Path.To < 0 ? Infinity : this->EndOf(walker);
  const double end = out ? std::min(0.0, last) : last;
  line.From = after;
  line.To = end + (out ? margin : 0);
  const LevelSearch& other = this->Search[1 - walker.Path.Own];
  auto obstacle = end > after ? other.FirstContour(line, this->Tolerance) : std::nullopt;
  const auto external =
    end > after && !insideOther ? other.FirstExternal(line, this->Tolerance) : std::nullopt;
  if (external && (!obstacle || external->From < obstacle->From))
  {
    obstacle = external;
  }
  if (!obstacle && !out)
  {
    return end > after;
  }
  const double target = obstacle ? std::min(obstacle->From - margin, end) : end;
  // What comes before the cell belongs to it as well; in the middle, the last one inside.
  this->JumpTo(walker, target, after, true, crossings);
  return false;
}

/**
 * From a place outside the own contours to where the next contour of the other level comes. Where the path ends inside that
 * one, the last crossing is added.
 *
 * @returns whether there is nothing more to come
 */
bool VoronoiSections::JumpOutside(
  Walker& walker, double after, bool insideOther, std::vector<JointCrossing>& crossings) const
{
  PlanarLine line = LineOf(walker.A, walker.B);
  const double margin = this->Tolerance / std::hypot(line.Direction[0], line.Direction[1]);
  const double end = walker.Path.To < 0 ? Infinity : this->EndOf(walker);
  if (!(end > after))
  {
    return false;
  }
  line.From = after;
  line.To = end;
  const auto contour = this->Search[1 - walker.Path.Own].FirstContour(line, this->Tolerance);
  if (contour)
  {
    this->JumpTo(walker, contour->From - margin, after, false, crossings);
    return false;
  }
  if (insideOther && walker.Path.To < 0)
  {
    return false; // cannot be
  }
  if (insideOther && walker.Last != walker.Cell)
  {
    const auto entry = walker.Back.Leave(walker.Last);
    if (!entry || entry->Cell < 0)
    {
      return false;
    }
    crossings.push_back(CrossingOf(this->Cells, Reversed(walker.Path), walker.Last, *entry));
  }
  return true;
}
}
