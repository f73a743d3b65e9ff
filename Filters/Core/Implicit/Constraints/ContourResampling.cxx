// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/ContourResampling.h"

#include "Base/Median.h"
#include "Planar/PlanarEdges.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// By so much a spacing grows that would take too many points.
constexpr double WiderSpacing = 1.25;
/// Edges longer than so many usual ones were drawn straight, as were those between two corners that
/// turn by so much together (radians; right angles are 3.1): coarsely drawn curves turn less. (Of a
/// pelvis in 136 points, 101 edges are longer than twice the gap, and none is straight.)
constexpr double UnusualEdge = 4;
constexpr double TwoCorners = 2.6;

double SignedAreaOf(const ContourSet& set, const std::vector<int>& points)
{
  const Point2& o = set.Planar[points.front()];
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point2& a = set.Planar[points[i]];
    const Point2& b = set.Planar[points[(i + 1) % points.size()]];
    twice += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  }
  return 0.5 * twice;
}

/// Appends the point at fraction t of the way from point a to point b; returns its index.
int AppendBetween(ContourSet& set, int a, int b, double t)
{
  const auto blend = [t](const auto& p, const auto& q)
  {
    auto r = p;
    for (std::size_t k = 0; k < r.size(); ++k)
    {
      r[k] = (1 - t) * p[k] + t * q[k];
    }
    return r;
  };
  const Point3 space = blend(set.Points[a], set.Points[b]);
  const Point2 plane = blend(set.Planar[a], set.Planar[b]);
  set.Points.push_back(space);
  set.Planar.push_back(plane);
  return static_cast<int>(set.Points.size()) - 1;
}

/// Positions along a closed contour, with the whole length at the end.
std::vector<double> LengthsAlong(const ContourSet& set, const std::vector<int>& points)
{
  const std::size_t n = points.size();
  std::vector<double> along(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    along[i + 1] = along[i] + Distance(set.Planar[points[i]], set.Planar[points[(i + 1) % n]]);
  }
  return along;
}

/// The first point stays; the others stand at equal distances along the contour.
std::vector<int> Even(ContourSet& set, const std::vector<int>& points, double spacing)
{
  const std::size_t n = points.size();
  std::vector<double> along(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    along[i + 1] = along[i] + Distance(set.Planar[points[i]], set.Planar[points[(i + 1) % n]]);
  }
  const int count = std::max(MinimumPoints, static_cast<int>(std::lround(along[n] / spacing)));
  std::vector<int> even{ points.front() };
  std::size_t edge = 0;
  for (int k = 1; k < count; ++k)
  {
    const double at = along[n] * k / count;
    while (edge + 1 < n && along[edge + 1] <= at)
    {
      ++edge;
    }
    const double t = (at - along[edge]) / (along[edge + 1] - along[edge]);
    const int next = points[(edge + 1) % n];
    even.push_back(t <= 0 ? points[edge] : AppendBetween(set, points[edge], next, t));
  }
  return even;
}

double DistanceToChord(const Point2& p, const Point2& a, const Point2& b)
{
  const double ux = b[0] - a[0];
  const double uy = b[1] - a[1];
  const double length2 = ux * ux + uy * uy;
  const double along = length2 > 0 ? ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / length2 : 0.0;
  const double t = std::min(1.0, std::max(0.0, along));
  return Distance(p, { a[0] + t * ux, a[1] + t * uy });
}

/// Marks what must stay of the open piece [from, to] (positions modulo the contour's length).
void MarkPiece(const ContourSet& set, const std::vector<int>& points, std::size_t from,
  std::size_t to, double tolerance, std::vector<char>& keep)
{
  std::vector<std::pair<std::size_t, std::size_t>> pieces{ { from, to } };
  while (!pieces.empty())
  {
    const auto [a, b] = pieces.back();
    pieces.pop_back();
    double worst = tolerance;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i)
    {
      const double d = DistanceToChord(set.Planar[points[i % points.size()]],
        set.Planar[points[a % points.size()]], set.Planar[points[b % points.size()]]);
      if (d > worst)
      {
        worst = d;
        at = i;
      }
    }
    if (at != a)
    {
      keep[at % points.size()] = 1;
      pieces.push_back({ a, at });
      pieces.push_back({ at, b });
    }
  }
}

std::vector<int> Simplified(const ContourSet& set, const std::vector<int>& points, double tolerance)
{
  const std::size_t n = points.size();
  std::vector<char> keep(n, 0);
  // Anchors all around, so that a contour smaller than the tolerance stays a contour.
  const std::size_t anchors = std::min<std::size_t>(n, MinimumPoints);
  for (std::size_t k = 0; k < anchors; ++k)
  {
    keep[k * n / anchors] = 1;
  }
  for (std::size_t k = 0; k < anchors; ++k)
  {
    MarkPiece(set, points, k * n / anchors, (k + 1) * n / anchors, tolerance, keep);
  }
  std::vector<int> kept;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (keep[i])
    {
      kept.push_back(points[i]);
    }
  }
  return kept;
}

/// Marks points between two marked ones (from < to, to <= n for the first again), evenly.
void FillPiece(const std::vector<double>& along, std::size_t from, std::size_t to, double spacing,
  std::vector<char>& keep)
{
  const double length = along[to] - along[from];
  const auto pieces = std::max<long>(1, std::lround(length / spacing));
  std::size_t i = from + 1;
  for (long k = 1; k < pieces; ++k)
  {
    const double at = along[from] + length * static_cast<double>(k) / static_cast<double>(pieces);
    while (i + 1 < to && std::abs(along[i + 1] - at) <= std::abs(along[i] - at))
    {
      ++i;
    }
    if (i < to && along[i] - along[from] > 0.5 * spacing && along[to] - along[i] > 0.5 * spacing)
    {
      keep[i] = 1;
    }
  }
}

std::vector<int> Thinned(const ContourSet& set, const std::vector<int>& points, double spacing)
{
  const std::size_t n = points.size();
  const std::vector<double> along = LengthsAlong(set, points);
  // A contour of few points per spacing keeps so many that it stays the shape it is.
  const double step = std::min(spacing, along[n] / MinimumPoints);
  std::vector<char> keep(n, 0);
  keep[0] = 1;
  keep[n / 2] = 1;
  MarkPiece(set, points, 0, n / 2, ThinOutTolerance * step, keep);
  MarkPiece(set, points, n / 2, n, ThinOutTolerance * step, keep);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (keep[i] && (corners.empty() || along[i] - along[corners.back()] >= ClosestPart * step))
    {
      corners.push_back(i);
    }
  }
  while (corners.size() > 2 && along[n] - along[corners.back()] < ClosestPart * step)
  {
    corners.pop_back();
  }
  keep.assign(n, 0);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    keep[corners[c]] = 1;
    FillPiece(along, corners[c], c + 1 < corners.size() ? corners[c + 1] : n, step, keep);
  }
  std::vector<int> kept;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (keep[i])
    {
      kept.push_back(points[i]);
    }
  }
  return kept.size() < 3 ? points : kept;
}

/// Edges that were drawn straight, not chords of a curve with few points.
class StraightEdges
{
public:
  /// @param longest edges up to that are none. @param contours outlive this
  StraightEdges(const ContourSet& contours, double longest) : Contours(contours), Longest(longest)
  {
    std::vector<double> all;
    for (const Contour& contour : contours.Contours)
    {
      for (std::size_t i = 0; i < contour.Points.size(); ++i)
      {
        all.push_back(this->LengthOf(contour.Points, i));
      }
    }
    this->Usual = Median(all);
    for (const Contour& contour : contours.Contours)
    {
      for (std::size_t i = 0; i < contour.Points.size(); ++i)
      {
        if (this->Has(contour.Points, i))
        {
          this->All.push_back(this->LengthOf(contour.Points, i));
        }
      }
    }
  }

  /// The edge from the i-th point of a contour.
  bool Has(const std::vector<int>& points, std::size_t i) const
  {
    const double length = this->LengthOf(points, i);
    return length > this->Longest &&
      (length > UnusualEdge * this->Usual ||
        this->TurnAt(points, i) + this->TurnAt(points, i + 1) >= TwoCorners);
  }

  const std::vector<double>& Lengths() const { return this->All; }

private:
  const Point2& At(const std::vector<int>& points, std::size_t i) const
  {
    return this->Contours.Planar[points[i % points.size()]];
  }

  double LengthOf(const std::vector<int>& points, std::size_t i) const
  {
    return Distance(this->At(points, i), this->At(points, i + 1));
  }

  /// The angle between the edges at a point.
  double TurnAt(const std::vector<int>& points, std::size_t i) const
  {
    const Point2& before = this->At(points, i + points.size() - 1);
    const Point2& here = this->At(points, i);
    const Point2& after = this->At(points, i + 1);
    const Point2 u{ here[0] - before[0], here[1] - before[1] };
    const Point2 v{ after[0] - here[0], after[1] - here[1] };
    return std::atan2(std::abs(u[0] * v[1] - u[1] * v[0]), u[0] * v[0] + u[1] * v[1]);
  }

  const ContourSet& Contours;
  double Longest;
  double Usual = 0; ///< length
  std::vector<double> All;
};

/// Drops the points that no contour uses any more.
void Compact(ContourSet& set)
{
  std::vector<int> renamed(set.Points.size(), -1);
  std::vector<Point3> points;
  std::vector<Point2> planar;
  for (Contour& contour : set.Contours)
  {
    for (int& p : contour.Points)
    {
      if (renamed[p] < 0)
      {
        renamed[p] = static_cast<int>(points.size());
        points.push_back(set.Points[p]);
        planar.push_back(set.Planar[p]);
      }
      p = renamed[p];
    }
  }
  set.Points = std::move(points);
  set.Planar = std::move(planar);
}

/// Puts new points on a level's contours; where they cross, the level keeps its own.
template <typename Resample>
ContourSet Resampled(const ContourSet& contours, const Resample& resample)
{
  ContourSet set = contours;
  for (int level = 0; level < static_cast<int>(set.Levels.size()); ++level)
  {
    for (const int c : set.Levels[level].Contours)
    {
      set.Contours[c].Points = resample(set, contours.Contours[c].Points);
    }
    if (!PlanarEdges(set, level).SelfCrossing())
    {
      continue;
    }
    for (const int c : set.Levels[level].Contours)
    {
      set.Contours[c].Points = contours.Contours[c].Points;
    }
    set.Report.push_back("Level " + std::to_string(level) +
      " keeps its own points: resampled, its contours would cross.");
  }
  for (Contour& contour : set.Contours)
  {
    contour.SignedArea = SignedAreaOf(set, contour.Points);
  }
  Compact(set);
  return set;
}
}

ContourSet ResampleToSpacing(const ContourSet& contours, double spacing)
{
  return Resampled(contours,
    [spacing](ContourSet& set, const std::vector<int>& points)
    { return Even(set, points, spacing); });
}

ContourSet ResampleToTolerance(const ContourSet& contours, double tolerance)
{
  return Resampled(contours,
    [tolerance](const ContourSet& set, const std::vector<int>& points)
    { return Simplified(set, points, tolerance); });
}

ContourSet ThinOut(const ContourSet& contours, double spacing)
{
  if (!(spacing > 0))
  {
    return contours;
  }
  return Resampled(contours,
    [spacing](const ContourSet& set, const std::vector<int>& points)
    { return Thinned(set, points, spacing); });
}

FilledEdges FillLongEdges(
  const ContourSet& contours, double longest, double spacing, std::size_t mostPoints)
{
  FilledEdges filled;
  const StraightEdges straight(contours, longest);
  if (!(spacing > 0) || straight.Lengths().empty())
  {
    filled.Contours = contours;
    return filled;
  }
  const auto pointsAt = [&straight](double apart)
  {
    double points = 0;
    for (const double length : straight.Lengths())
    {
      points += std::ceil(length / apart) - 1;
    }
    return points;
  };
  while (pointsAt(spacing) > static_cast<double>(mostPoints))
  {
    spacing *= WiderSpacing;
  }
  filled.Contours = Resampled(contours,
    [&](ContourSet& set, const std::vector<int>& points)
    {
      std::vector<int> more;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        more.push_back(points[i]);
        const int next = points[(i + 1) % points.size()];
        const double length = Distance(set.Planar[points[i]], set.Planar[next]);
        const int pieces =
          straight.Has(points, i) ? static_cast<int>(std::ceil(length / spacing)) : 1;
        filled.Edges += pieces > 1 ? 1 : 0;
        for (int k = 1; k < pieces; ++k)
        {
          more.push_back(AppendBetween(set, points[i], next, static_cast<double>(k) / pieces));
        }
      }
      return more;
    });
  const std::size_t before = contours.Points.size();
  filled.Points = filled.Contours.Points.size() - std::min(before, filled.Contours.Points.size());
  return filled;
}
}
