// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarDifference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// A segment from its lower to its upper end.
struct Rising
{
  Point2 Low;
  Point2 High;
  int Winding; ///< +1 where it was given upward
  PlanarRegions::LayerType Layer;

  double XAt(double y) const
  {
    // The ends themselves, so that segments that share one agree on it to the last bit.
    if (y <= this->Low[1])
    {
      return this->Low[0];
    }
    if (y >= this->High[1])
    {
      return this->High[0];
    }
    const double t = (y - this->Low[1]) / (this->High[1] - this->Low[1]);
    return this->Low[0] + t * (this->High[0] - this->Low[0]);
  }
};

/// Where a segment enters and leaves a strip.
struct Crossing
{
  const Rising* Segment;
  double Bottom;
  double Top;

  double Middle() const { return this->Bottom + this->Top; } // twice the middle; only compared
};

/// Inside or outside of all layers, from left to right.
struct State
{
  std::array<int, 4> Count{ 0, 0, 0, 0 };

  void Pass(const Rising& segment)
  {
    int& count = this->Count[segment.Layer];
    count = segment.Layer == PlanarRegions::InPlane ? count + segment.Winding : 1 - count;
  }
  bool InSurface() const
  {
    return this->Count[PlanarRegions::Below] != 0 || this->Count[PlanarRegions::Above] != 0 ||
      this->Count[PlanarRegions::InPlane] != 0;
  }
  bool InContour() const { return this->Count[PlanarRegions::Contour] != 0; }
};

class Sweep
{
public:
  explicit Sweep(const PlanarRegions& regions)
  {
    this->TakeSegments(regions);
    for (const auto& segment : this->Segments)
    {
      this->Ordinates.push_back(segment.Low[1]);
      this->Ordinates.push_back(segment.High[1]);
    }
    std::sort(this->Ordinates.begin(), this->Ordinates.end());
    this->Ordinates.erase(
      std::unique(this->Ordinates.begin(), this->Ordinates.end()), this->Ordinates.end());
    std::sort(this->Segments.begin(), this->Segments.end(),
      [](const Rising& a, const Rising& b) { return a.Low[1] < b.Low[1]; });
  }

  PlanarDifference Run()
  {
    std::vector<Crossing> active;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < this->Ordinates.size(); ++i)
    {
      const double bottom = this->Ordinates[i];
      active.erase(std::remove_if(active.begin(), active.end(),
                     [bottom](const Crossing& c) { return c.Segment->High[1] <= bottom; }),
        active.end());
      for (; next < this->Segments.size() && this->Segments[next].Low[1] <= bottom; ++next)
      {
        active.push_back({ &this->Segments[next], 0, 0 });
      }
      this->MeasureStrip(active, bottom, this->Ordinates[i + 1], 0);
    }
    return this->Result;
  }

private:
  /// Move the middle to the origin, which costs no digits, and leave out what is level.
  void TakeSegments(const PlanarRegions& regions)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point2 low{ infinity, infinity };
    Point2 high{ -infinity, -infinity };
    for (const auto& segment : regions.Segments)
    {
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min({ low[k], segment.A[k], segment.B[k] });
        high[k] = std::max({ high[k], segment.A[k], segment.B[k] });
      }
    }
    const Point2 middle{ 0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1] };
    this->Negligible = 1e-14 * (high[0] - low[0]);
    for (const auto& segment : regions.Segments)
    {
      const Point2 from{ segment.A[0] - middle[0], segment.A[1] - middle[1] };
      const Point2 to{ segment.B[0] - middle[0], segment.B[1] - middle[1] };
      if (from[1] < to[1])
      {
        this->Segments.push_back({ from, to, 1, segment.Layer });
      }
      else if (to[1] < from[1])
      {
        this->Segments.push_back({ to, from, -1, segment.Layer });
      }
    }
  }

  /// `active` is left sorted from left to right, which makes sorting it for the next strip cheap.
  void MeasureStrip(std::vector<Crossing>& active, double bottom, double top, int depth)
  {
    for (auto& crossing : active)
    {
      crossing.Bottom = crossing.Segment->XAt(bottom);
      crossing.Top = crossing.Segment->XAt(top);
    }
    SortByMiddle(active);
    const double split = depth < 60 ? this->FindCrossing(active, bottom, top) : bottom;
    if (split > bottom && split < top)
    {
      this->MeasureStrip(active, bottom, split, depth + 1);
      this->MeasureStrip(active, split, top, depth + 1);
      return;
    }
    this->AddTrapezia(active, top - bottom);
  }

  /// Insertion: from strip to strip the order hardly changes.
  static void SortByMiddle(std::vector<Crossing>& active)
  {
    for (std::size_t i = 1; i < active.size(); ++i)
    {
      const Crossing moved = active[i];
      std::size_t j = i;
      for (; j > 0 && active[j - 1].Middle() > moved.Middle(); --j)
      {
        active[j] = active[j - 1];
      }
      active[j] = moved;
    }
  }

  /// The ordinate at which two neighbours cross by more than is negligible, or bottom where none
  /// do.
  double FindCrossing(const std::vector<Crossing>& active, double bottom, double top) const
  {
    for (std::size_t i = 1; i < active.size(); ++i)
    {
      const double gapBelow = active[i].Bottom - active[i - 1].Bottom;
      const double gapAbove = active[i].Top - active[i - 1].Top;
      if (std::min(gapBelow, gapAbove) < -this->Negligible &&
        std::max(gapBelow, gapAbove) > this->Negligible)
      {
        return bottom + (top - bottom) * (gapBelow / (gapBelow - gapAbove));
      }
    }
    return bottom;
  }

  void AddTrapezia(const std::vector<Crossing>& active, double height)
  {
    State state;
    for (std::size_t i = 0; i < active.size(); ++i)
    {
      if (i > 0)
      {
        const double area = 0.5 * (active[i].Middle() - active[i - 1].Middle()) * height;
        this->Result.SurfaceArea += state.InSurface() ? area : 0;
        this->Result.ContourArea += state.InContour() ? area : 0;
        this->Result.SymmetricDifference += state.InSurface() != state.InContour() ? area : 0;
      }
      state.Pass(*active[i].Segment);
    }
  }

  std::vector<Rising> Segments;
  std::vector<double> Ordinates;
  double Negligible = 0;
  PlanarDifference Result;
};

/// Whether every end of a segment of the layer is that of an even number of them.
bool IsClosed(const PlanarRegions& regions, PlanarRegions::LayerType layer)
{
  std::vector<Point2> ends;
  for (const auto& segment : regions.Segments)
  {
    if (segment.Layer == layer)
    {
      ends.push_back(segment.A);
      ends.push_back(segment.B);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size();)
  {
    const auto next = std::upper_bound(ends.begin() + i, ends.end(), ends[i]) - ends.begin();
    if ((next - i) % 2 != 0)
    {
      return false;
    }
    i = next;
  }
  return true;
}
}

PlanarDifference MeasurePlanarDifference(const PlanarRegions& regions)
{
  PlanarDifference result = Sweep(regions).Run();
  result.SurfaceIsClosed =
    IsClosed(regions, PlanarRegions::Below) && IsClosed(regions, PlanarRegions::Above);
  return result;
}
}
