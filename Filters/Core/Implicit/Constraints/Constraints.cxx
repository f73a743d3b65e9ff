// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/Constraints.h"

#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Implicit/Constraints/NearConstraints.h"
#include "Planar/PlanarEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace recon
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
/// A margin that had to shrink below this part of d says nothing but noise, and is left out.
constexpr double LeastMargin = 1e-6;
/// What is left of d after a step that found no room.
constexpr double ShrinkStep = 0.7;
/// Planes whose normals differ by less (sine) count as parallel: their points are never merged.
constexpr double ParallelSine = 1e-2;
/// Merged margins that cancel to less than this part of d have no common side.
constexpr double LeastMergedMargin = 0.2;

/// A margin distance of less than this part of the bounding box's diagonal is refused: the system's
/// condition grows as d^-3, beyond what doubles can hold.
constexpr double LeastMarginDistance = 1e-6;
/// More contour points than this are refused before they are made.
constexpr double MostResampledPoints = 1e6;

/// How far margins reach across a step, in parts of the distance to the level that makes it; the
/// first that has room counts.
constexpr double StepReaches[] = { 1, 0.7 };
/// A reaching margin keeps this part of its reach from all contours of its level.
constexpr double StepRoom = 0.8;
/// Contours of the other level count up to this many times the distance between the levels.
constexpr double StepHorizon = 10;

/// A contour vertex with the margins on its two sides.
struct VertexMargins
{
  Point3 Vertex{};
  Point3 Inner{};
  Point3 Outer{};
  double InnerDistance = 0; ///< to the contour; 0 = there is no room for this margin
  double OuterDistance = 0;
  double InnerValue = 0; ///< estimated distance to the surface: less than that to the contour where
  double OuterValue = 0; ///< the surface lies nearer above or below
  int Contour = -1;
  int Level = -1;
};

/// Finds room for the two margins of every vertex of one level.
class LevelMargins
{
public:
  LevelMargins(const ContourSet& contours, int level, double distance)
    : Contours(contours),
      Frame(contours.Levels[level].Frame),
      Edges(contours, level),
      Level(level),
      Distance(distance)
  {
  }

  VertexMargins At(int contour, std::size_t position) const
  {
    const std::vector<int>& points = this->Contours.Contours[contour].Points;
    const int v = points[position];
    const int next = points[(position + 1) % points.size()];
    VertexMargins margins;
    margins.Vertex = this->Contours.Points[v];
    margins.Contour = contour;
    margins.Level = this->Level;
    const double along = this->AngleTo(v, next);
    // The solid is on the left of every contour (ContourSet.h).
    const double left = along + 0.5 * this->SectorFrom(v, along, next, +1);
    const double right = along - 0.5 * this->SectorFrom(v, along, next, -1);
    margins.InnerDistance = this->Place(v, left, PlanarEdges::Inside, margins.Inner);
    margins.OuterDistance = this->Place(v, right, PlanarEdges::Outside, margins.Outer);
    margins.InnerValue = margins.InnerDistance;
    margins.OuterValue = margins.OuterDistance;
    return margins;
  }

private:
  double AngleTo(int from, int to) const
  {
    const Point2& a = this->Contours.Planar[from];
    const Point2& b = this->Contours.Planar[to];
    return std::atan2(b[1] - a[1], b[0] - a[0]);
  }

  /// The angle, turning by sign from the edge to `next`, to the first other edge at v (of any
  /// contour).
  double SectorFrom(int v, double along, int next, int sign) const
  {
    double least = 2 * Pi;
    for (const int e : this->Edges.EdgesAt(v))
    {
      const PlanarEdges::Edge& edge = this->Edges.Edges()[e];
      const int other = edge.From == v ? edge.To : edge.From;
      if (other == next)
      {
        continue;
      }
      double turn = std::fmod(sign * (this->AngleTo(v, other) - along), 2 * Pi);
      turn = turn < 0 ? turn + 2 * Pi : turn;
      least = std::min(least, turn);
    }
    return least;
  }

  /// Moves from v in the direction of an angle as far as there is room; returns the distance to the
  /// contour.
  double Place(int v, double angle, PlanarEdges::SideType side, Point3& place) const
  {
    const Point2& from = this->Contours.Planar[v];
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    for (double t = this->Distance; t >= LeastMargin * this->Distance; t *= ShrinkStep)
    {
      place = this->Contours.Points[v] + t * (x * this->Frame.U + y * this->Frame.V);
      // The margin is judged where it will be, after rounding.
      const Point2 at = this->Frame.ToPlane(place);
      const double own = this->Edges.DistanceToOwn(v, at);
      if (this->Edges.DistanceToOthers(v, at, own) > own && this->Edges.SideOf(at) == side &&
        !this->Edges.CrossesOthers(v, from, at))
      {
        return own;
      }
    }
    return 0;
  }

  const ContourSet& Contours;
  const PlanarFrame Frame;
  const PlanarEdges Edges;
  const int Level;
  const double Distance;
};

std::vector<VertexMargins> AllMargins(const ContourSet& contours, double distance, Monitor& monitor)
{
  std::vector<VertexMargins> all;
  const int levels = static_cast<int>(contours.Levels.size());
  for (int level = 0; level < levels; ++level)
  {
    monitor.Update(static_cast<double>(level) / levels, "placing the margins");
    const LevelMargins margins(contours, level, distance);
    for (const int c : contours.Levels[level].Contours)
    {
      for (std::size_t i = 0; i < contours.Contours[c].Points.size(); ++i)
      {
        all.push_back(margins.At(c, i));
      }
    }
  }
  return all;
}

/**
 * Lets margins reach across steps: where the next level says otherwise of the place that lies as
 * far from the vertex, within the level, as the next level does. There the surface lies flat and
 * between the levels, which a short margin of unit slope denies: the surface would rise upright
 * from the contour and bulge. The value is the distance to a plane that cuts the level at the
 * contour and the line to the next level where shape-based interpolation has the surface.
 */
class StepMargins
{
public:
  explicit StepMargins(const ContourSet& contours) : Contours(contours)
  {
    for (int level = 0; level < static_cast<int>(contours.Levels.size()); ++level)
    {
      this->Edges.emplace_back(contours, level);
      this->Order.push_back(level);
    }
    std::sort(this->Order.begin(), this->Order.end(),
      [this](int a, int b) { return this->HeightOf(a) < this->HeightOf(b); });
    this->Rank.resize(this->Order.size());
    for (std::size_t r = 0; r < this->Order.size(); ++r)
    {
      this->Rank[this->Order[r]] = r;
    }
  }

  void Reach(int vertex, VertexMargins& m) const
  {
    this->Reach(vertex, m, PlanarEdges::Inside, m.Inner, m.InnerDistance, m.InnerValue);
    this->Reach(vertex, m, PlanarEdges::Outside, m.Outer, m.OuterDistance, m.OuterValue);
  }

private:
  double HeightOf(int level) const
  {
    const Vector3& normal = this->Contours.Levels.front().Frame.Normal;
    const Level& l = this->Contours.Levels[level];
    return l.Offset * (Dot(l.Frame.Normal, normal) < 0 ? -1 : 1);
  }

  std::vector<int> NeighboursOf(int level) const
  {
    std::vector<int> neighbours;
    const std::size_t rank = this->Rank[level];
    if (rank > 0)
    {
      neighbours.push_back(this->Order[rank - 1]);
    }
    if (rank + 1 < this->Order.size())
    {
      neighbours.push_back(this->Order[rank + 1]);
    }
    return neighbours;
  }

  void Reach(int vertex, const VertexMargins& m, PlanarEdges::SideType side, Point3& place,
    double& distance, double& value) const
  {
    if (!(distance > 0))
    {
      return;
    }
    const Vector3 direction = (1 / Norm(place - m.Vertex)) * (place - m.Vertex);
    for (const double part : StepReaches)
    {
      for (const int next : this->NeighboursOf(m.Level))
      {
        const double reach = part * std::abs(this->HeightOf(next) - this->HeightOf(m.Level));
        const Point3 there = m.Vertex + reach * direction;
        const double room = this->RoomAt(vertex, m.Level, there, side, reach);
        if (!(reach > distance && room >= StepRoom * reach))
        {
          continue;
        }
        const double away = this->SurfaceAwayFrom(m.Level, there, side, room);
        if (away > 0)
        {
          place = there;
          distance = room;
          value = room * away / std::hypot(room, away);
          return;
        }
      }
    }
  }

  /// Distance to the contours of the level, 0 on the wrong side of one.
  double RoomAt(
    int vertex, int level, const Point3& there, PlanarEdges::SideType side, double reach) const
  {
    const PlanarEdges& edges = this->Edges[level];
    const PlanarFrame& frame = this->Contours.Levels[level].Frame;
    const Point2 at = frame.ToPlane(there);
    const Point2& from = this->Contours.Planar[vertex];
    if (edges.SideOf(at) != side || edges.CrossesOthers(vertex, from, at))
    {
      return 0;
    }
    return std::min(edges.DistanceToOwn(vertex, at), edges.DistanceToOthers(vertex, at, reach));
  }

  /// How far above or below the surface lies by shape-based interpolation (the ratio of the
  /// distances to the contours of both levels); 0 where no neighbour says otherwise of the place.
  double SurfaceAwayFrom(
    int level, const Point3& there, PlanarEdges::SideType side, double room) const
  {
    double least = 0;
    for (const int next : this->NeighboursOf(level))
    {
      const PlanarEdges& edges = this->Edges[next];
      const Point2 at = this->Contours.Levels[next].Frame.ToPlane(there);
      const PlanarEdges::SideType other = edges.SideOf(at);
      if (other == side || other == PlanarEdges::On)
      {
        continue;
      }
      const double gap = std::abs(this->HeightOf(next) - this->HeightOf(level));
      const double horizon = StepHorizon * gap;
      const double far = std::min(edges.DistanceToOthers(-1, at, horizon), horizon);
      const double away = room / (room + far) * gap;
      least = least > 0 ? std::min(least, away) : away;
    }
    return least;
  }

  const ContourSet& Contours;
  std::vector<PlanarEdges> Edges;
  std::vector<int> Order; ///< of the levels, by height
  std::vector<std::size_t> Rank;
};

void ReachAcrossSteps(
  const ContourSet& contours, std::vector<VertexMargins>& margins, Monitor& monitor)
{
  if (!AllLevelsParallel(contours))
  {
    return;
  }
  const StepMargins steps(contours);
  std::size_t i = 0;
  for (const Level& level : contours.Levels)
  {
    monitor.Update(static_cast<double>(i) / margins.size(), "placing the margins");
    for (const int c : level.Contours)
    {
      for (const int vertex : contours.Contours[c].Points)
      {
        steps.Reach(vertex, margins[i++]);
      }
    }
  }
}

/// Groups of points of crossing planes that fit in one small box (thesis 9.1).
class MergeGroups
{
public:
  MergeGroups(
    const ContourSet& contours, const std::vector<VertexMargins>& margins, const Vector3& box)
    : Boxes(margins.size()),
      Parent(margins.size()),
      Limit(box)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
    for (std::size_t i = 0; i < margins.size(); ++i)
    {
      this->Boxes[i].Add(margins[i].Vertex);
    }
    for (const auto& pair : CrossingPairs(contours, margins, box))
    {
      this->Join(this->Find(pair.I), this->Find(pair.J));
    }
  }

  int Find(int i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

private:
  struct Pair
  {
    double Distance2;
    int I;
    int J;
    bool operator<(const Pair& o) const
    {
      return std::tie(this->Distance2, this->I, this->J) < std::tie(o.Distance2, o.I, o.J);
    }
  };

  static std::vector<Pair> CrossingPairs(
    const ContourSet& contours, const std::vector<VertexMargins>& margins, const Vector3& box)
  {
    std::vector<Point3> vertices;
    for (const VertexMargins& m : margins)
    {
      vertices.push_back(m.Vertex);
    }
    const double reach = Norm(box);
    const PointGrid grid(vertices, reach);
    std::vector<Pair> pairs;
    for (int i = 0; i < static_cast<int>(margins.size()); ++i)
    {
      grid.ForNear(vertices[i], reach,
        [&](int j, double r2)
        {
          const Vector3& a = contours.Levels[margins[i].Level].Frame.Normal;
          const Vector3& b = contours.Levels[margins[j].Level].Frame.Normal;
          if (j > i && Norm(Cross(a, b)) > ParallelSine)
          {
            pairs.push_back({ r2, i, j });
          }
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  void Join(int i, int j)
  {
    if (i == j)
    {
      return;
    }
    Box3 joint = this->Boxes[i];
    joint.Add(this->Boxes[j]);
    for (int a = 0; a < 3; ++a)
    {
      if (joint.High[a] - joint.Low[a] > this->Limit[a])
      {
        return;
      }
    }
    this->Parent[std::max(i, j)] = std::min(i, j);
    this->Boxes[std::min(i, j)] = joint;
  }

  std::vector<Box3> Boxes;
  std::vector<int> Parent;
  Vector3 Limit;
};

/// One vertex in the place of a group: centroids of the points and of their margins.
VertexMargins Centroid(const std::vector<VertexMargins>& margins, const std::vector<int>& group)
{
  VertexMargins mean;
  mean.Level = margins[group.front()].Level;
  const auto centroid = [&](Point3 VertexMargins::*place, double VertexMargins::*distance)
  {
    Point3 sum{ 0, 0, 0 };
    int count = 0;
    for (const int i : group)
    {
      if (!distance || margins[i].*distance > 0)
      {
        // An offset, not a place: a member without this margin must not pull the others' mean.
        sum = sum + (distance ? margins[i].*place - margins[i].Vertex : margins[i].*place);
        ++count;
      }
    }
    return count > 0 ? (1.0 / count) * sum : Point3{ 0, 0, 0 };
  };
  mean.Vertex = centroid(&VertexMargins::Vertex, nullptr);
  const Vector3 inner = centroid(&VertexMargins::Inner, &VertexMargins::InnerDistance);
  const Vector3 outer = centroid(&VertexMargins::Outer, &VertexMargins::OuterDistance);
  mean.Inner = mean.Vertex + inner;
  mean.Outer = mean.Vertex + outer;
  mean.InnerDistance = mean.InnerValue = Norm(inner);
  mean.OuterDistance = mean.OuterValue = Norm(outer);
  return mean;
}

std::vector<VertexMargins> MergeAtCrossings(const ContourSet& contours,
  const std::vector<VertexMargins>& margins, double part, double distance,
  std::vector<std::string>& report)
{
  const Box3 box = contours.Bounds();
  MergeGroups groups(contours, margins, part * (box.High - box.Low));
  std::vector<std::vector<int>> members(margins.size());
  for (int i = 0; i < static_cast<int>(margins.size()); ++i)
  {
    members[groups.Find(i)].push_back(i);
  }
  std::vector<VertexMargins> merged;
  std::size_t gone = 0;
  std::size_t places = 0;
  for (const auto& group : members)
  {
    if (group.size() == 1)
    {
      merged.push_back(margins[group.front()]);
    }
    if (group.size() < 2)
    {
      continue;
    }
    gone += group.size();
    ++places;
    VertexMargins mean = Centroid(margins, group);
    // Contours that disagree about the side leave a point without one.
    mean.InnerDistance = mean.InnerDistance < LeastMergedMargin * distance ? 0 : mean.InnerDistance;
    mean.OuterDistance = mean.OuterDistance < LeastMergedMargin * distance ? 0 : mean.OuterDistance;
    merged.push_back(mean);
  }
  if (places > 0)
  {
    report.push_back(std::to_string(gone) + " points near the crossings of planes became " +
      std::to_string(places) + " centroids.");
  }
  return merged;
}

void Append(ConstraintSet& set, const Point3& p, double value, int kind, int contour)
{
  set.Points.push_back(p);
  set.Values.push_back(value);
  set.Kind.push_back(kind);
  set.Contour.push_back(contour);
}

void AppendMargins(const std::vector<VertexMargins>& margins, bool unit, ConstraintSet& set)
{
  std::size_t missing = 0;
  for (const VertexMargins& m : margins)
  {
    Append(set, m.Vertex, 0, ConstraintSet::Boundary, m.Contour);
    if (m.InnerDistance > 0)
    {
      Append(set, m.Inner, unit ? 1 : m.InnerValue, ConstraintSet::Inner, m.Contour);
    }
    if (m.OuterDistance > 0)
    {
      Append(set, m.Outer, unit ? -1 : -m.OuterValue, ConstraintSet::Outer, m.Contour);
    }
    missing += (m.InnerDistance > 0 ? 0 : 1) + (m.OuterDistance > 0 ? 0 : 1);
  }
  set.LeftOut += missing;
  if (missing > 0)
  {
    set.Report.push_back(std::to_string(missing) +
      " margin points were left out: the contours leave no room for them.");
  }
}

/// Thesis 10.3: no margins, the corners of the bounding box are outside, by their distance to the
/// contours.
void AppendCorners(
  const ContourSet& contours, const std::vector<VertexMargins>& margins, ConstraintSet& set)
{
  for (const VertexMargins& m : margins)
  {
    Append(set, m.Vertex, 0, ConstraintSet::Boundary, m.Contour);
  }
  const Box3 box = contours.Bounds();
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point3 p{ corner & 1 ? box.High[0] : box.Low[0], corner & 2 ? box.High[1] : box.Low[1],
      corner & 4 ? box.High[2] : box.Low[2] };
    double least = std::numeric_limits<double>::infinity();
    for (const VertexMargins& m : margins)
    {
      least = std::min(least, Norm(m.Vertex - p));
    }
    Append(set, p, -least, ConstraintSet::Outer, -1);
  }
}

std::vector<double> EdgeLengths(const ContourSet& contours)
{
  std::vector<double> lengths;
  for (const Contour& contour : contours.Contours)
  {
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Point3& a = contours.Points[contour.Points[i]];
      const Point3& b = contours.Points[contour.Points[(i + 1) % contour.Points.size()]];
      lengths.push_back(Norm(b - a));
    }
  }
  return lengths;
}

void CheckResampledPoints(const ContourSet& contours, double spacing)
{
  const std::vector<double> lengths = EdgeLengths(contours);
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (spacing > 0 && length / spacing > MostResampledPoints)
  {
    throw Error("ResampleSpacing " + Text(spacing) + " would make about " + Text(length / spacing) +
      " contour points, more than the " + Text(MostResampledPoints) + " allowed: choose " +
      Text(1.01 * length / MostResampledPoints) + " or more.");
  }
}

void CheckPositive(double value, const char* name, const char* meaningOfZero)
{
  if (!(value >= 0) || !std::isfinite(value))
  {
    throw Error(
      std::string(name) + " must be positive, or 0 " + meaningOfZero + ", and a finite number.");
  }
}
}

bool AllLevelsParallel(const ContourSet& contours)
{
  return std::all_of(contours.Levels.begin(), contours.Levels.end(),
    [&contours](const Level& level) {
      return Norm(Cross(level.Frame.Normal, contours.Levels.front().Frame.Normal)) < ParallelSine;
    });
}

void CheckConstraintInput(const ContourSet& contours, const ConstraintOptions& options)
{
  CheckPositive(options.MarginDistance, "MarginDistance", "to have it chosen from the sampling");
  CheckPositive(options.ResampleSpacing, "ResampleSpacing", "to keep the points");
  CheckPositive(options.ResampleTolerance, "ResampleTolerance", "to keep the points");
  if (!(options.MergeBox >= 0 && options.MergeBox < 1))
  {
    throw Error("MergeBox must be a part, between 0 and 1, of the bounding box.");
  }
  if (contours.Contours.empty())
  {
    throw Error("There is no contour to make constraints of: give at least two closed contours.");
  }
  if (contours.Levels.size() < 2)
  {
    throw Error(
      "All contours lie in one plane, where they say nothing about the space around it: add a "
      "contour on another plane.");
  }
  CheckResampledPoints(contours, options.ResampleSpacing);
  const Box3 box = contours.Bounds();
  const double diagonal = Norm(box.High - box.Low);
  if (options.MarginDistance > 0 && options.MarginDistance < LeastMarginDistance * diagonal)
  {
    throw Error(
      "MarginDistance is less than a millionth of the contours' bounding box, where inside "
      "and outside cannot be told apart any more: choose about a third of the distance "
      "between contour points, or 0.");
  }
  if (options.MarginDistance > diagonal)
  {
    throw Error(
      "MarginDistance is larger than the contours' bounding box: choose about a third of the "
      "distance between contour points, or 0.");
  }
}

double ChooseMarginDistance(const ContourSet& contours, const ConstraintOptions& options)
{
  if (options.MarginDistance > 0)
  {
    return options.MarginDistance;
  }
  std::vector<double> lengths = EdgeLengths(contours);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle / 3;
}

ConstraintSet BuildInPlaneConstraints(
  const ContourSet& contours, const ConstraintOptions& options, Monitor& monitor)
{
  CheckConstraintInput(contours, options);
  ConstraintSet set;
  set.MarginDistance = ChooseMarginDistance(contours, options);
  SubMonitor placing(monitor, 0, 0.5);
  std::vector<VertexMargins> margins = AllMargins(contours, set.MarginDistance, placing);
  SubMonitor reaching(monitor, 0.5, 1);
  if (options.ReachAcrossSteps && options.Values == ConstraintOptions::Distance)
  {
    ReachAcrossSteps(contours, margins, reaching);
  }
  if (options.MergeBox > 0)
  {
    margins = MergeAtCrossings(contours, margins, options.MergeBox, set.MarginDistance, set.Report);
  }
  if (options.Mode == ConstraintOptions::Margins)
  {
    AppendMargins(margins, options.Values == ConstraintOptions::Unit, set);
  }
  else
  {
    AppendCorners(contours, margins, set);
  }
  ResolveNearConstraints(set);
  monitor.Update(1, "placing the margins");
  return set;
}
}
