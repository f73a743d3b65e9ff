// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SpatialHash.h
 * @brief Things by number in the cubes of a grid, found again by place.
 */
#ifndef recon_SpatialHash_h
#define recon_SpatialHash_h

#include "Base/BoundingBox.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace recon
{
/**
 * @class SpatialHash
 * @brief Numbers hashed by the cubes of a grid of D dimensions.
 *
 * Cubes may share a key, so a query may give too many candidates, and a thing that is in several
 * cubes more than once, but never too few: the caller looks at distances itself. Coordinates
 * divided by the cell size must stay below 2^62 in magnitude.
 */
template <std::size_t D>
class SpatialHash
{
public:
  using Point = std::array<double, D>;
  using Cell = std::array<std::int64_t, D>;
  /// The lowest and the highest cell that a box meets.
  struct Range
  {
    Cell Low{};
    Cell High{};
    bool operator==(const Range& other) const
    {
      return this->Low == other.Low && this->High == other.High;
    }
  };

  explicit SpatialHash(double cellSize) : CellSize(cellSize) {}

  Cell CellOf(const Point& p) const
  {
    Cell cell{};
    for (std::size_t k = 0; k < D; ++k)
    {
      cell[k] = static_cast<std::int64_t>(std::floor(p[k] / this->CellSize));
    }
    return cell;
  }

  Range RangeOf(const BoundingBox<D>& box) const
  {
    return { this->CellOf(box.Low), this->CellOf(box.High) };
  }

  void Put(int number, const Cell& cell) { this->Cells[Key(cell)].push_back(number); }

  void Put(int number, const Range& range)
  {
    ForCells(range,
      [&](const Cell& cell)
      {
        this->Put(number, cell);
        return false;
      });
  }

  /// visit(number) for all in the cell, until it returns true. @returns whether it did.
  template <typename Visit>
  bool AnyIn(const Cell& cell, const Visit& visit) const
  {
    const auto found = this->Cells.find(Key(cell));
    if (found == this->Cells.end())
    {
      return false;
    }
    for (std::size_t i = 0; i < found->second.size(); ++i)
    {
      if (visit(found->second[i]))
      {
        return true;
      }
    }
    return false;
  }

  /// visit(cell) for all cells of the range, in increasing order, until it returns true. @returns
  /// whether it did.
  template <typename Visit>
  static bool ForCells(const Range& range, const Visit& visit)
  {
    Cell cell = range.Low;
    for (;;)
    {
      if (visit(cell))
      {
        return true;
      }
      std::size_t k = D;
      while (k > 0 && cell[k - 1] == range.High[k - 1])
      {
        --k;
        cell[k] = range.Low[k];
      }
      if (k == 0)
      {
        return false;
      }
      ++cell[k - 1];
    }
  }

private:
  static std::uint64_t Key(const Cell& cell)
  {
    constexpr std::uint64_t factors[] = { 0x9E3779B97F4A7C15ull, 0xBF58476D1CE4E5B9ull,
      0x94D049BB133111EBull };
    static_assert(D == 2 || D == 3, "a plane or space");
    std::uint64_t key = static_cast<std::uint64_t>(cell[0]) * factors[0];
    for (std::size_t k = 1; k < D; ++k)
    {
      key = (key ^ (key >> (k == 1 ? 29 : 32))) + static_cast<std::uint64_t>(cell[k]) * factors[k];
    }
    return key;
  }

  double CellSize;
  std::unordered_map<std::uint64_t, std::vector<int>> Cells;
};
}

#endif
