// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PointGrid.h
 * @brief Which points lie within a distance of a place.
 */
#ifndef recon_PointGrid_h
#define recon_PointGrid_h

#include "Base/Geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace recon
{
/**
 * @class PointGrid
 * @brief Points hashed by the cubes of a grid. Points are copied; indices are those of the input.
 */
class PointGrid
{
public:
  PointGrid(const std::vector<Point3>& points, double cell) : Points(points), Cell(cell)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Cells[Key(this->CellOf(points[i]))].push_back(static_cast<int>(i));
    }
  }

  /// visit(index, squared distance) for every point within radius of x, in no particular order of
  /// distance.
  template <typename Visit>
  void ForNear(const Point3& x, double radius, const Visit& visit) const
  {
    const auto low = this->CellOf({ x[0] - radius, x[1] - radius, x[2] - radius });
    const auto high = this->CellOf({ x[0] + radius, x[1] + radius, x[2] + radius });
    for (auto i = low[0]; i <= high[0]; ++i)
    {
      for (auto j = low[1]; j <= high[1]; ++j)
      {
        for (auto k = low[2]; k <= high[2]; ++k)
        {
          this->VisitCell({ i, j, k }, x, radius, visit);
        }
      }
    }
  }

  /// The nearest point within radius, or -1; the smaller index where two are equally near.
  int Nearest(const Point3& x, double radius) const
  {
    int best = -1;
    double least = radius * radius;
    this->ForNear(x, radius,
      [&](int i, double r2)
      {
        if (r2 < least || (r2 == least && (best < 0 || i < best)))
        {
          least = r2;
          best = i;
        }
      });
    return best;
  }

private:
  using Index3 = std::array<std::int64_t, 3>;

  Index3 CellOf(const Point3& p) const
  {
    return { static_cast<std::int64_t>(std::floor(p[0] / this->Cell)),
      static_cast<std::int64_t>(std::floor(p[1] / this->Cell)),
      static_cast<std::int64_t>(std::floor(p[2] / this->Cell)) };
  }

  /// Cells may share a key; distances are checked, and VisitCell takes a point in its own cell
  /// only.
  static std::uint64_t Key(const Index3& c)
  {
    std::uint64_t key = static_cast<std::uint64_t>(c[0]) * 0x9E3779B97F4A7C15ull;
    key = (key ^ (key >> 29)) + static_cast<std::uint64_t>(c[1]) * 0xBF58476D1CE4E5B9ull;
    return (key ^ (key >> 32)) + static_cast<std::uint64_t>(c[2]) * 0x94D049BB133111EBull;
  }

  template <typename Visit>
  void VisitCell(const Index3& cell, const Point3& x, double radius, const Visit& visit) const
  {
    const auto found = this->Cells.find(Key(cell));
    if (found == this->Cells.end())
    {
      return;
    }
    for (const int i : found->second)
    {
      const Vector3 d = this->Points[i] - x;
      const double r2 = Dot(d, d);
      if (r2 <= radius * radius && this->CellOf(this->Points[i]) == cell)
      {
        visit(i, r2);
      }
    }
  }

  std::vector<Point3> Points;
  double Cell;
  std::unordered_map<std::uint64_t, std::vector<int>> Cells;
};
}

#endif
