// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TriangleGrid.h
 * @brief Which triangles of a mesh that is being edited may come near a box.
 */
#ifndef recon_TriangleGrid_h
#define recon_TriangleGrid_h

#include "Base/Geometry.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace recon
{
/**
 * @class TriangleGrid
 * @brief Triangles by number in the cubes of a grid that their boxes meet.
 *
 * A triangle that has changed is put in again; where it was before it stays known, so queries give
 * too many, and some twice, but never too few.
 */
class TriangleGrid
{
public:
  explicit TriangleGrid(double cell) : Cell(cell) {}

  void Put(int triangle, const Point3& low, const Point3& high)
  {
    const Range range = this->RangeOf(low, high);
    if (triangle >= static_cast<int>(this->Last.size()))
    {
      this->Last.resize(static_cast<std::size_t>(triangle) + 1, Range{ 0, 0, 0, -1, -1, -1 });
    }
    if (this->Last[triangle] == range)
    {
      return;
    }
    this->Last[triangle] = range;
    ForCells(range, [&](std::uint64_t key) { this->Cells[key].push_back(triangle); });
  }

  /// visit(triangle) for all that may meet the box, until it returns true. @returns whether it did.
  template <typename Visit>
  bool AnyNear(const Point3& low, const Point3& high, const Visit& visit) const
  {
    bool found = false;
    ForCells(this->RangeOf(low, high),
      [&](std::uint64_t key)
      {
        const auto place = found ? this->Cells.end() : this->Cells.find(key);
        if (place == this->Cells.end())
        {
          return;
        }
        for (std::size_t i = 0; i < place->second.size() && !found; ++i)
        {
          found = visit(place->second[i]);
        }
      });
    return found;
  }

private:
  using Range = std::array<std::int64_t, 6>;

  Range RangeOf(const Point3& low, const Point3& high) const
  {
    Range range{};
    for (int a = 0; a < 3; ++a)
    {
      range[a] = static_cast<std::int64_t>(std::floor(low[a] / this->Cell));
      range[3 + a] = static_cast<std::int64_t>(std::floor(high[a] / this->Cell));
    }
    return range;
  }

  template <typename Visit>
  static void ForCells(const Range& range, const Visit& visit)
  {
    for (auto i = range[0]; i <= range[3]; ++i)
    {
      for (auto j = range[1]; j <= range[4]; ++j)
      {
        for (auto k = range[2]; k <= range[5]; ++k)
        {
          // Cubes may share a key: then there are more candidates.
          std::uint64_t key = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15ull;
          key = (key ^ (key >> 29)) + static_cast<std::uint64_t>(j) * 0xBF58476D1CE4E5B9ull;
          visit((key ^ (key >> 32)) + static_cast<std::uint64_t>(k) * 0x94D049BB133111EBull);
        }
      }
    }
  }

  double Cell;
  std::unordered_map<std::uint64_t, std::vector<int>> Cells;
  std::vector<Range> Last;
};
}

#endif
