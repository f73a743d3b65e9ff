// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/DrawnSections.h"

#include "Base/Median.h"
#include "Base/Parallel.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Contours/ContourMeasures.h"
#include "Implicit/Constraints/SquarePatches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
constexpr const char* Stage = "comparing with the drawn planes";
/// The largest squares of a plane, in cells, a power of two.
constexpr int CoarseCells = 8;
/// A small section is looked at by so many squares across, but by none below this part of a cell.
constexpr double SquaresAcross = 64;
constexpr double LeastCells = 0.125;
/// Each look has its squares elsewhere, by so many cells: what is mended at the middles of some is
/// seen between them. (The golden ratio: no two of a few looks are near each other.)
constexpr double LookShift = 0.6180339887;
/// A square whose middle is farther from the surface than this many of its half diagonals has none
/// in it: to first order one is enough.
constexpr double SurelyNone = 1.5;
/// Contours count up to this many gaps.
constexpr double Horizon = 5;
/// A surface between a contour and an empty place on the next plane is at most this part of the gap
/// away from the place.
constexpr double HalfWay = 0.5;
/// Places nearer to a contour than so many of the finest squares stand for the contour's own point.
constexpr double LeastRoom = 1;
/// Places next to contours are so many of the finest squares apart.
constexpr double LeastApart = 2;
/// Samples of a contour, on each axis, and how many it needs to be judged by.
constexpr int SamplesAcross = 12;
constexpr int FewestSamples = 4;
/// Between two planes it is looked at up to so many heights, one for so many cells.
constexpr int MostHeights = 3;
constexpr double CellsPerHeight = 4;
constexpr std::size_t SquaresPerBlock = 256;

bool IsWithin(const ContourSet& set, const Contour& contour, const Point2& p)
{
  bool within = false;
  for (std::size_t i = 0, j = contour.Points.size() - 1; i < contour.Points.size(); j = i++)
  {
    const Point2& a = set.Planar[contour.Points[i]];
    const Point2& b = set.Planar[contour.Points[j]];
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
      p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
    {
      within = !within;
    }
  }
  return within;
}
}

/// A square of a section.
struct DrawnSections::Square
{
  int Section;
  Point2 Middle;
};

/// Places between two sections whose side both tell.
struct DrawnSections::Between
{
  std::vector<ToldPlace> Told;
};

DrawnSections::DrawnSections(const ContourSet& drawn, const std::vector<EmptyPlane>& empty,
  double cell, const SectionTolerances& tolerances)
  : Drawn(drawn),
    Cell(cell),
    Tolerances(tolerances),
    Box(drawn.Bounds())
{
  const Vector3& normal = drawn.Levels.front().Frame.Normal;
  for (int l = 0; l < static_cast<int>(drawn.Levels.size()); ++l)
  {
    const Level& level = drawn.Levels[l];
    Section section;
    section.Frame = level.Frame;
    section.Offset = level.Offset;
    section.Height = HeightOf(level, normal);
    section.Level = l;
    section.Edges = l;
    for (const int c : level.Contours)
    {
      section.Area += drawn.Contours[c].SignedArea;
    }
    while (section.Finest > LeastCells &&
      section.Finest * cell * SquaresAcross > std::sqrt(section.Area))
    {
      section.Finest /= 2;
    }
    this->EdgesOf.emplace_back(drawn, l);
    this->Sections.push_back(section);
  }
  for (const EmptyPlane& plane : empty)
  {
    if (AreParallel(plane.Normal, normal, Parallelism::UpToDrawing))
    {
      Section section;
      section.Frame = drawn.Levels.front().Frame;
      section.Offset = OffsetAlong(normal, plane.Normal, plane.Offset);
      section.Height = section.Offset;
      this->Sections.push_back(section);
    }
  }
  std::sort(this->Sections.begin(), this->Sections.end(),
    [](const Section& a, const Section& b) { return a.Height < b.Height; });
  std::vector<double> gaps;
  for (std::size_t s = 1; s < this->Sections.size(); ++s)
  {
    gaps.push_back(this->Sections[s].Height - this->Sections[s - 1].Height);
  }
  this->Gap = Median(gaps);
}

double DrawnSections::GapAt(int section, int step) const
{
  const int next = section + step;
  return next < 0 || next >= static_cast<int>(this->Sections.size())
    ? 0
    : std::abs(this->Sections[next].Height - this->Sections[section].Height);
}

double DrawnSections::RoomAt(int section, const Point3& p, double limit) const
{
  const Section& s = this->Sections[section];
  if (s.Edges < 0)
  {
    return limit;
  }
  return std::min(limit, this->EdgesOf[s.Edges].DistanceToOthers(-1, s.Frame.ToPlane(p), limit));
}

int DrawnSections::SideAt(int section, const Point3& p) const
{
  const Section& s = this->Sections[section];
  return s.Edges < 0 ? PlanarEdges::Outside : this->EdgesOf[s.Edges].SideOf(s.Frame.ToPlane(p));
}

/// Where a neighbour says otherwise, the surface passes between, as shape-based interpolation has it
/// (StepMargins.h), but no farther than half way.
double DrawnSections::ValueAt(int section, const Point3& p, int side, double room) const
{
  double away = 0;
  for (const int step : { -1, 1 })
  {
    const double gap = this->GapAt(section, step);
    if (gap > 0 && this->SideAt(section + step, p) == -side)
    {
      const double far = this->RoomAt(section + step, p, Horizon * gap);
      const double here = std::min(HalfWay, room / (room + far)) * gap;
      away = away > 0 ? std::min(away, here) : here;
    }
  }
  return side * (away > 0 ? room * away / std::hypot(room, away) : room);
}

std::vector<DrawnSections::Square> DrawnSections::CoarseSquares(int look) const
{
  std::vector<Square> squares;
  const double size = CoarseCells * this->Cell;
  for (int s = 0; s < static_cast<int>(this->Sections.size()); ++s)
  {
    Box2 box;
    for (int corner = 0; corner < 8; ++corner)
    {
      box.Add(this->Sections[s].Frame.ToPlane({ corner & 1 ? this->Box.High[0] : this->Box.Low[0],
        corner & 2 ? this->Box.High[1] : this->Box.Low[1],
        corner & 4 ? this->Box.High[2] : this->Box.Low[2] }));
    }
    box = box.Grown(0.5 * size);
    const double shift = std::fmod(look * LookShift, 1.0) * this->Cell;
    box.Low = { box.Low[0] - shift, box.Low[1] - shift };
    const int columns = static_cast<int>(std::ceil(box.Extent(0) / size));
    const int rows = static_cast<int>(std::ceil(box.Extent(1) / size));
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i)
      {
        squares.push_back({ s, { box.Low[0] + (i + 0.5) * size, box.Low[1] + (j + 0.5) * size } });
      }
    }
  }
  return squares;
}

void DrawnSections::ComparePlanes(const FunctionEvaluator& evaluator, int threads, int look,
  Monitor& monitor, std::vector<std::vector<ToldPlace>>& places, std::vector<int>& wrong) const
{
  std::vector<double> area(this->Sections.size(), 0);
  std::vector<char> deep(this->Sections.size(), 0);
  std::vector<std::vector<PlaneSquare>> small(this->Sections.size());
  std::vector<Square> squares = this->CoarseSquares(look);
  for (double cells = CoarseCells; cells >= LeastCells && !squares.empty(); cells /= 2)
  {
    const double size = cells * this->Cell;
    const double reach = size * std::sqrt(0.5);
    std::vector<Point3> middles;
    for (const Square& q : squares)
    {
      middles.push_back(
        this->Sections[q.Section].Frame.ToSpace(q.Middle, this->Sections[q.Section].Offset));
    }
    std::vector<double> f;
    std::vector<Vector3> slopes;
    if (cells > LeastCells)
    {
      evaluator.ValuesAndGradients(middles, f, slopes, monitor);
    }
    else
    {
      f = evaluator.Values(middles, monitor);
    }
    // 0: nothing; 1: to be split; 2: on the wrong side, with all of it.
    std::vector<char> verdict(squares.size(), 0);
    std::vector<ToldPlace> told(squares.size());
    const auto judge = [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        const int section = squares[i].Section;
        const int side = this->SideAt(section, middles[i]);
        const bool isWrong = side != PlanarEdges::On && (f[i] > 0) != (side > 0);
        if (cells > this->Sections[section].Finest &&
          (std::abs(f[i]) <= SurelyNone * reach * Norm(slopes[i]) ||
            this->RoomAt(section, middles[i], 2 * reach) <= reach))
        {
          verdict[i] = 1;
          continue;
        }
        if (isWrong)
        {
          const double room = this->RoomAt(section, middles[i], Horizon * this->Gap);
          verdict[i] = 2;
          told[i] = { middles[i], this->ValueAt(section, middles[i], side, room), room };
        }
      }
    };
    ParallelForBlocks(squares.size(), SquaresPerBlock, threads, judge, monitor, { 0, 1, Stage }, 4);
    std::vector<Square> next;
    for (std::size_t i = 0; i < squares.size(); ++i)
    {
      const Square& q = squares[i];
      if (verdict[i] == 2)
      {
        area[q.Section] += size * size;
        deep[q.Section] = deep[q.Section] || told[i].Room > this->Tolerances.Depth * this->Cell;
        places[q.Section].push_back(told[i]);
        if (cells < 1)
        {
          small[q.Section].push_back({ q.Middle, size, told[i].Room });
        }
      }
      for (int c = 0; c < 4 && verdict[i] == 1; ++c)
      {
        next.push_back({ q.Section,
          { q.Middle[0] + (c & 1 ? 0.25 : -0.25) * size,
            q.Middle[1] + (c & 2 ? 0.25 : -0.25) * size } });
      }
    }
    squares = std::move(next);
  }
  for (std::size_t s = 0; s < this->Sections.size(); ++s)
  {
    const bool large =
      this->Sections[s].Area > 0 && area[s] > this->Tolerances.Area * this->Sections[s].Area;
    const bool island =
      LargestDetachedPatch(small[s]) > this->Tolerances.Island * this->Cell * this->Cell;
    wrong[s] = deep[s] || large || island ? 1 : 0;
  }
}

/// Samples within a contour of one section, at a part of the way to the other one.
void DrawnSections::SampleContour(
  int section, int other, int contour, double part, Between& samples) const
{
  const Contour& c = this->Drawn.Contours[contour];
  const Section& from = this->Sections[section];
  const Section& to = this->Sections[other];
  const int inside = c.Depth % 2 == 0 ? PlanarEdges::Inside : PlanarEdges::Outside;
  const double limit = Horizon * (section == other ? this->Gap : std::abs(to.Height - from.Height));
  Box2 box;
  for (const int p : c.Points)
  {
    box.Add(this->Drawn.Planar[p]);
  }
  const Vector3 up =
    (Dot(from.Frame.Normal, this->Drawn.Levels.front().Frame.Normal) < 0 ? -1 : 1) *
    from.Frame.Normal;
  for (int k = 0; k < SamplesAcross * SamplesAcross; ++k)
  {
    const Point2 at{ box.Low[0] + (k % SamplesAcross + 0.5) / SamplesAcross * box.Extent(0),
      box.Low[1] + (k / SamplesAcross + 0.5) / SamplesAcross * box.Extent(1) };
    const Point3 p = from.Frame.ToSpace(at, from.Offset);
    if (!IsWithin(this->Drawn, c, at) || this->SideAt(section, p) != inside ||
      this->SideAt(other, p) != inside)
    {
      continue;
    }
    const double here = this->RoomAt(section, p, limit);
    const double there = this->RoomAt(other, p, limit);
    samples.Told.push_back({ p + (part * (to.Height - from.Height)) * up,
      inside * ((1 - part) * here + part * there), std::min(here, there) });
  }
}

/// Contours that are lost: small ones beside the rest of their plane.
void DrawnSections::CompareContours(const FunctionEvaluator& evaluator, Monitor& monitor,
  std::vector<std::vector<ToldPlace>>& places, std::vector<int>& wrong) const
{
  for (int s = 0; s < static_cast<int>(this->Sections.size()); ++s)
  {
    if (this->Sections[s].Level < 0)
    {
      continue;
    }
    for (const int c : this->Drawn.Levels[this->Sections[s].Level].Contours)
    {
      Between samples;
      this->SampleContour(s, s, c, 0, samples);
      std::vector<Point3> points;
      for (const ToldPlace& told : samples.Told)
      {
        points.push_back(told.Place);
      }
      const std::vector<double> f = evaluator.Values(points, monitor);
      double missed = 0;
      for (std::size_t i = 0; i < f.size(); ++i)
      {
        missed += (f[i] > 0) != (samples.Told[i].Value > 0) ? 1 : 0;
      }
      if (missed > this->Tolerances.Lost * static_cast<double>(f.size()))
      {
        wrong[s] = 1;
        places[s].insert(places[s].end(), samples.Told.begin(), samples.Told.end());
      }
    }
  }
}

void DrawnSections::CompareBetween(const FunctionEvaluator& evaluator, Monitor& monitor,
  std::vector<std::vector<ToldPlace>>& places, std::vector<int>& wrong) const
{
  const int count = static_cast<int>(this->Sections.size());
  for (int s = 0; s + 1 < count; ++s)
  {
    if (this->Sections[s].Level < 0 || this->Sections[s + 1].Level < 0)
    {
      continue;
    }
    std::vector<Between> all;
    const double gap = this->GapAt(s, 1);
    const int heights =
      std::clamp(static_cast<int>(gap / (CellsPerHeight * this->Cell)), 1, MostHeights);
    for (const int step : { 0, 1 })
    {
      for (const int c : this->Drawn.Levels[this->Sections[s + step].Level].Contours)
      {
        for (int h = 1; h <= heights; ++h)
        {
          all.emplace_back();
          this->SampleContour(
            s + step, s + 1 - step, c, static_cast<double>(h) / (heights + 1), all.back());
        }
      }
    }
    std::vector<Point3> points;
    for (const Between& b : all)
    {
      for (const ToldPlace& told : b.Told)
      {
        points.push_back(told.Place);
      }
    }
    const std::vector<double> f = evaluator.Values(points, monitor);
    std::size_t at = 0;
    for (const Between& b : all)
    {
      int missed = 0;
      for (const ToldPlace& told : b.Told)
      {
        missed += (f[at++] > 0) != (told.Value > 0) ? 1 : 0;
      }
      const int told = static_cast<int>(b.Told.size());
      if (told >= FewestSamples && missed > this->Tolerances.WaistArea * told)
      {
        wrong[s] = 1;
        places[s].insert(places[s].end(), b.Told.begin(), b.Told.end());
      }
    }
  }
}

/// The nearest point of the section's contours; in a plane with contours.
Point3 DrawnSections::NearestDrawn(int section, const Point3& p) const
{
  const Section& s = this->Sections[section];
  const Point2 at = s.Frame.ToPlane(p);
  const Point3 flat{ at[0], at[1], 0 };
  Point3 nearest = p;
  double least = std::numeric_limits<double>::infinity();
  for (const PlanarEdges::Edge& edge : this->EdgesOf[s.Edges].Edges())
  {
    const Point2& from = this->Drawn.Planar[edge.From];
    const Point2& to = this->Drawn.Planar[edge.To];
    const Point3 a{ from[0], from[1], 0 };
    const Vector3 along = Point3{ to[0], to[1], 0 } - a;
    const double t = std::clamp(Dot(flat - a, along) / Dot(along, along), 0.0, 1.0);
    const Point3 q = a + t * along;
    const double distance = Norm(q - flat);
    if (distance < least)
    {
      least = distance;
      nearest = s.Frame.ToSpace({ q[0], q[1] }, s.Offset);
    }
  }
  return nearest;
}

/// The roomiest first, each as far from those before as it is itself from the contours, or a gap.
/// Next to a contour it is the contour's own point that is told: on the surface.
void DrawnSections::Spread(
  int section, const std::vector<ToldPlace>& from, std::vector<ToldPlace>& to) const
{
  const double finest = this->Sections[section].Finest * this->Cell;
  std::vector<ToldPlace> sorted = from;
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const ToldPlace& a, const ToldPlace& b) { return a.Room > b.Room; });
  std::vector<Point3> taken;
  for (const ToldPlace& place : sorted)
  {
    const double apart = std::max(LeastApart * finest, std::min(place.Room, this->Gap));
    if (std::any_of(taken.begin(), taken.end(),
          [&](const Point3& p) { return Norm(p - place.Place) < apart; }))
    {
      continue;
    }
    taken.push_back(place.Place);
    to.push_back(place);
    if (place.Room < LeastRoom * finest)
    {
      to.back().Place = this->NearestDrawn(section, place.Place);
      to.back().Value = 0;
    }
  }
}

DrawnSections::Disagreements DrawnSections::Compare(
  const ImplicitFunction& function, int threads, Monitor& monitor, int look) const
{
  const FunctionEvaluator evaluator(function, threads);
  const std::size_t count = this->Sections.size();
  Disagreements found;
  std::vector<std::vector<ToldPlace>> onPlanes(count);
  std::vector<std::vector<ToldPlace>> between(count);
  std::vector<int> wrongPlanes(count, 0);
  std::vector<int> wrongBetween(count, 0);
  AbortMonitor stop(monitor);
  this->ComparePlanes(evaluator, threads, look, stop, onPlanes, wrongPlanes);
  this->CompareContours(evaluator, stop, onPlanes, wrongPlanes);
  this->CompareBetween(evaluator, stop, between, wrongBetween);
  for (std::size_t s = 0; s < count; ++s)
  {
    if (wrongPlanes[s])
    {
      found.Sections.push_back(static_cast<int>(2 * s));
      this->Spread(static_cast<int>(s), onPlanes[s], found.Places);
    }
    if (wrongBetween[s])
    {
      found.Sections.push_back(static_cast<int>(2 * s + 1));
      this->Spread(static_cast<int>(s), between[s], found.Places);
    }
  }
  return found;
}

std::string DrawnSections::NameOf(int section) const
{
  const double low = this->Sections[section / 2].Height;
  return section % 2 == 0 ? Text(low)
                          : Text(low) + " to " + Text(this->Sections[section / 2 + 1].Height);
}
}
