// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/RegionOverlaps.h"

#include "Contours/ContourMeasures.h"
#include "Planar/Arrangement.h"
#include "Planar/EdgeSweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace recon
{
namespace
{
/// What crossings are rounded by, and a little more; a fourth of the least that a level's own points
/// are apart (SnapTolerance.h), so that nothing of one level is snapped to itself.
constexpr double OverlaySnapping = 1.0 / (std::int64_t{ 1 } << 46);

/**
 * Contours of a level have numbers from 1, what is outside of all has 0. A face is labelled with the
 * number of the innermost contour around it: an edge weighs its contour's number less that of the
 * contour around that, so the weights up to a face add up to its label, also where walls lie upon one
 * another, and where rounding moved a crossing. One label holds both levels, as a number of two digits.
 */
class Overlay
{
public:
  Overlay(const ContourSet& contours, const Level& lower, const Level& upper)
    : Contours(contours),
      FirstLower(lower.Contours.front()),
      FirstUpper(upper.Contours.front()),
      Base(static_cast<std::int64_t>(lower.Contours.size()) + 1),
      Labels(this->Base * (static_cast<std::int64_t>(upper.Contours.size()) + 1))
  {
    this->AddPoints(lower);
    this->AddPoints(upper);
    std::sort(this->Points.begin(), this->Points.end());
    this->Points.erase(std::unique(this->Points.begin(), this->Points.end()), this->Points.end());
    this->AddEdges(lower, this->FirstLower, 1);
    this->AddEdges(upper, this->FirstUpper, this->Base);
  }

  std::vector<RegionOverlap> Measure()
  {
    Arrangement plane(this->Points, std::move(this->Edges), { OverlaySnapping * this->Largest },
      Arrangement::SumType::Weight);
    plane.Resolve();
    const std::vector<PlanarEdge>& edges = plane.Edges();
    std::vector<std::int64_t> above(edges.size(), 0);
    for (const SweptEdge& swept : SweepEdges(this->Points, edges))
    {
      const PlanarEdge& edge = edges[swept.Edge];
      const std::int64_t below = swept.Below < 0 ? 0 : above[swept.Below];
      const bool right = RunsRight(this->Points, edge);
      above[swept.Edge] = below + (right ? edge.Weight : -edge.Weight);
      const Point2& a = this->Points[right ? edge.A : edge.B];
      const Point2& b = this->Points[right ? edge.B : edge.A];
      this->AddStrip(below, a, b, 1);
      this->AddStrip(above[swept.Edge], a, b, -1);
    }
    return this->Overlaps();
  }

private:
  /// An area as strips between its border and an ordinate near it, which keeps small areas exact.
  struct Strips
  {
    double Ordinate;
    double Area = 0;
  };

  void AddPoints(const Level& level)
  {
    for (int c : level.Contours)
    {
      for (int p : this->Contours.Contours[c].Points)
      {
        const Point2& x = this->Contours.Planar[p];
        this->Points.push_back(x);
        this->Largest = std::max({ this->Largest, std::abs(x[0]), std::abs(x[1]) });
      }
    }
  }

  void AddEdges(const Level& level, int first, std::int64_t digit)
  {
    for (int c : level.Contours)
    {
      const Contour& contour = this->Contours.Contours[c];
      const int around = contour.Parent < 0 ? 0 : contour.Parent - first + 1;
      const std::int64_t step = digit * (c - first + 1 - around);
      std::vector<int> loop;
      for (int p : contour.Points)
      {
        loop.push_back(this->NumberOf(this->Contours.Planar[p]));
      }
      // What is inside a hole's contour is on its right.
      AddLoopEdges(loop, 0, this->Edges, contour.Depth % 2 == 0 ? step : -step);
    }
  }

  int NumberOf(const Point2& x) const
  {
    return static_cast<int>(
      std::lower_bound(this->Points.begin(), this->Points.end(), x) - this->Points.begin());
  }

  /// From a to b, as the upper border (sign 1) or the lower one (-1) of a face.
  void AddStrip(std::int64_t label, const Point2& a, const Point2& b, int sign)
  {
    // Where rounding turned a sliver over its label may be none.
    if (label <= 0 || label >= this->Labels || label % this->Base == 0 || label < this->Base)
    {
      return;
    }
    Strips& strips = this->Areas.emplace(label, Strips{ a[1] }).first->second;
    const double height = 0.5 * (a[1] - strips.Ordinate) + 0.5 * (b[1] - strips.Ordinate);
    strips.Area += sign * (b[0] - a[0]) * height;
  }

  std::vector<RegionOverlap> Overlaps() const
  {
    std::vector<RegionOverlap> overlaps;
    for (const auto& [label, strips] : this->Areas)
    {
      if (strips.Area > 0)
      {
        overlaps.push_back({ this->FirstLower + static_cast<int>(label % this->Base) - 1,
          this->FirstUpper + static_cast<int>(label / this->Base) - 1, strips.Area });
      }
    }
    std::sort(overlaps.begin(), overlaps.end(),
      [](const RegionOverlap& x, const RegionOverlap& y)
      {
        return std::make_pair(x.LowerContour, x.UpperContour) <
          std::make_pair(y.LowerContour, y.UpperContour);
      });
    return overlaps;
  }

  const ContourSet& Contours;
  int FirstLower; ///< contours are sorted by level
  int FirstUpper;
  std::int64_t Base;   ///< of the digits of a label
  std::int64_t Labels; ///< how many there can be
  double Largest = 0;  ///< coordinate
  std::vector<Point2> Points;
  std::vector<PlanarEdge> Edges;
  std::map<std::int64_t, Strips> Areas;
};

/// Also of a level without contours, whose box is empty.
bool ShareNoArea(const Box2& a, const Box2& b)
{
  return a.High[0] <= b.Low[0] || b.High[0] <= a.Low[0] || a.High[1] <= b.Low[1] ||
    b.High[1] <= a.Low[1];
}
}

std::vector<RegionOverlap> MeasureRegionOverlaps(
  const ContourSet& contours, const Level& lower, const Level& upper)
{
  if (ShareNoArea(PlanarBounds(contours, lower.Contours), PlanarBounds(contours, upper.Contours)))
  {
    return {};
  }
  return Overlay(contours, lower, upper).Measure();
}
}
