// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/PlanarRings.h"

#include "Planar/LoopOrder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace recon
{
namespace
{
class Flattener
{
public:
  Flattener(const LoopSoup& soup, const std::vector<Ring>& rings, const PlaneOfRings& plane,
    double grid, ContourNotes& notes)
    : Soup(soup),
      Rings(rings),
      Plane(plane),
      Grid(grid),
      Notes(notes)
  {
  }

  PlanarRings Flatten()
  {
    const std::vector<int> numbers = this->NumberPoints();
    auto next = numbers.begin();
    for (int r : this->Plane.Rings)
    {
      const auto end = next + static_cast<std::ptrdiff_t>(this->RingAt(r).Points.size());
      this->AddLoop(r, std::vector<int>(next, end));
      next = end;
    }
    return std::move(this->Flat);
  }

private:
  const Ring& RingAt(int r) const { return this->Rings[r]; }

  /// A number for every point of every ring in turn, in the order of first use.
  std::vector<int> NumberPoints()
  {
    std::vector<int> input;
    for (int r : this->Plane.Rings)
    {
      const std::vector<int>& p = this->RingAt(r).Points;
      input.insert(input.end(), p.begin(), p.end());
    }
    std::vector<Point2> at;
    at.reserve(input.size());
    for (int p : input)
    {
      at.push_back(SnapToGrid(this->Plane.Frame.ToPlane(this->Soup.Points[p]), this->Grid));
    }
    const std::vector<std::size_t> first = FirstOfEqual(at);
    std::vector<int> numbers(input.size());
    for (std::size_t i = 0; i < input.size(); ++i)
    {
      if (first[i] == i)
      {
        numbers[i] = static_cast<int>(this->Flat.Points.size());
        this->Flat.Points.push_back(at[i]);
        this->Flat.InputPoint.push_back(input[i]);
      }
      numbers[i] = numbers[first[i]];
    }
    return numbers;
  }

  static std::vector<std::size_t> FirstOfEqual(const std::vector<Point2>& at)
  {
    std::vector<std::size_t> sorted(at.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{ 0 });
    std::sort(sorted.begin(), sorted.end(),
      [&at](std::size_t x, std::size_t y) { return at[x] != at[y] ? at[x] < at[y] : x < y; });
    std::vector<std::size_t> first(at.size());
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      const bool same = i > 0 && at[sorted[i]] == at[sorted[i - 1]];
      first[sorted[i]] = same ? first[sorted[i - 1]] : sorted[i];
    }
    return first;
  }

  /// Points that differ only across the plane have become equal neighbours.
  void AddLoop(int ring, std::vector<int> loop)
  {
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back())
    {
      loop.pop_back();
    }
    const Ring& r = this->RingAt(ring);
    if (loop.size() < 3)
    {
      this->Notes.Add(r.Source, r.Points.size(), r.Points[0],
        "has only " + Counted(loop.size(), "distinct point") +
          " in its plane, which enclose nothing; left out");
      return;
    }
    const auto [same, isNew] = this->Seen.emplace(CanonicalLoop(loop), ring);
    if (!isNew)
    {
      this->Notes.Add(r.Source, r.Points.size(), r.Points[0],
        "is the same as that of cell " + std::to_string(this->RingAt(same->second).Source) +
          "; left out");
      return;
    }
    this->Flat.Loops.push_back(std::move(loop));
    this->Flat.Rings.push_back(ring);
  }

  const LoopSoup& Soup;
  const std::vector<Ring>& Rings;
  const PlaneOfRings& Plane;
  double Grid;
  ContourNotes& Notes;
  PlanarRings Flat;
  std::map<std::vector<int>, int> Seen;
};
}

Point2 SnapToGrid(const Point2& p, double grid)
{
  return grid == 0 ? p : Point2{ grid * std::round(p[0] / grid), grid * std::round(p[1] / grid) };
}

double PlanarGridOf(const PlanarFrame& frame, double largest)
{
  const auto isAxis = [](const Vector3& v) { return std::count(v.begin(), v.end(), 0.0) == 2; };
  if (largest == 0 || (isAxis(frame.U) && isAxis(frame.V)))
  {
    return 0;
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, exponent - 40);
}

PlanarRings FlattenLevel(const LoopSoup& soup, const std::vector<Ring>& rings,
  const PlaneOfRings& plane, double grid, ContourNotes& notes)
{
  return Flattener(soup, rings, plane, grid, notes).Flatten();
}
}
