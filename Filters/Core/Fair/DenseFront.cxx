// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/DenseFront.h"

#include "Base/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Each value is a sum of its own, taken in one order, and nothing is fused (CMakeLists.txt): wide
// registers change no bit.

namespace recon
{
namespace
{
/// A tile of the product that stays in registers.
constexpr int TileRows = 8;
constexpr int TileColumns = 4;
/// Rows of tiles that stay in the cache while all columns go over them.
constexpr int RowsAtOnce = 64;
/// Columns that are factorised one by one before the rest of the panel hears of them.
constexpr int ColumnsAtOnce = 16;

/// Rows in groups of TileRows, of each group column after column; the last group is filled with zeros.
void Pack(const double* rows, int count, int stride, int width, std::vector<double>& packed)
{
  const int groups = (count + TileRows - 1) / TileRows;
  packed.resize(static_cast<std::size_t>(groups) * TileRows * width);
  double* to = packed.data();
  for (int group = 0; group < groups; ++group)
  {
    const double* from = rows + static_cast<std::ptrdiff_t>(group) * TileRows;
    const int own = std::min(TileRows, count - group * TileRows);
    for (int column = 0; column < width; ++column, from += stride, to += TileRows)
    {
      if (own == TileRows)
      {
        std::copy_n(from, TileRows, to);
        continue;
      }
      std::fill(std::copy_n(from, own, to), to + TileRows, 0.0);
    }
  }
}

/// Of a tile, less the product of TileRows rows with TileColumns others, which begin within a group.
RECON_CLONES_WIDEST void SubtractTile(
  double* tile, std::size_t stride, const double* rows, const double* others, int width)
{
  double sums[TileColumns][TileRows] = {};
  for (int k = 0; k < width; ++k)
  {
    for (int j = 0; j < TileColumns; ++j)
    {
      for (int i = 0; i < TileRows; ++i)
      {
        sums[j][i] += rows[i] * others[j];
      }
    }
    rows += TileRows;
    others += TileRows;
  }
  for (int j = 0; j < TileColumns; ++j)
  {
    for (int i = 0; i < TileRows; ++i)
    {
      tile[i] -= sums[j][i];
    }
    tile += stride;
  }
}

/// square(i, j) -= row i times row j, for i >= j and the first columns.
void SubtractPacked(double* square, std::size_t stride, int count, int columns,
  const std::vector<double>& packed, int width)
{
  const auto groupOf = [&](int row)
  { return packed.data() + static_cast<std::size_t>(row / TileRows) * TileRows * width; };
  for (int top = 0; top < count; top += RowsAtOnce)
  {
    const int bottom = std::min(count, top + RowsAtOnce);
    for (int left = 0; left < std::min(columns, bottom); left += TileColumns)
    {
      const double* others = groupOf(left) + left % TileRows;
      const int right = std::min(columns, left + TileColumns);
      for (int row = std::max(top, left / TileRows * TileRows); row < bottom; row += TileRows)
      {
        if (row >= right && row + TileRows <= bottom && right == left + TileColumns)
        {
          SubtractTile(square + left * stride + row, stride, groupOf(row), others, width);
          continue;
        }
        // At the diagonal and at the ends only a part of it is there.
        double tile[TileColumns * TileRows] = {};
        SubtractTile(tile, TileRows, groupOf(row), others, width);
        for (int j = left; j < right; ++j)
        {
          for (int i = std::max(row, j); i < std::min(bottom, row + TileRows); ++i)
          {
            square[j * stride + i] += tile[(j - left) * TileRows + i - row];
          }
        }
      }
    }
  }
}

/// Of `count` rows of one column, less the columns of the `width` before by their factors, which are
/// `stride` apart, as the columns are.
RECON_CLONES_WIDEST void SubtractColumns(
  double* a, const double* columns, const double* factors, std::size_t stride, int width, int count)
{
  for (int k = 0; k < width; ++k)
  {
    const double factor = factors[k * stride];
    const double* b = columns + k * stride;
    for (int i = 0; i < count; ++i)
    {
      a[i] -= factor * b[i];
    }
  }
}

/// Columns [from, to) of a panel, from which all before have been subtracted.
bool FactoriseColumns(double* panel, int rows, int from, int to)
{
  const auto columnOf = [&](int k) { return panel + static_cast<std::size_t>(k) * rows; };
  for (int k = from; k < to; ++k)
  {
    double* column = columnOf(k);
    SubtractColumns(column + k, columnOf(from) + k, columnOf(from) + k, rows, k - from, rows - k);
    if (!(column[k] > 0))
    {
      return false;
    }
    column[k] = std::sqrt(column[k]);
    const double factor = 1 / column[k];
    std::for_each(column + k + 1, column + rows, [factor](double& value) { value *= factor; });
  }
  return true;
}
}

bool FactorisePanel(double* panel, int rows, int width)
{
  std::vector<double> packed;
  for (int from = 0; from < width; from += ColumnsAtOnce)
  {
    const int to = std::min(width, from + ColumnsAtOnce);
    if (!FactoriseColumns(panel, rows, from, to))
    {
      return false;
    }
    if (to < width)
    {
      const std::size_t stride = rows;
      Pack(panel + from * stride + to, rows - to, rows, to - from, packed);
      SubtractPacked(panel + to * stride + to, stride, rows - to, width - to, packed, to - from);
    }
  }
  return true;
}

void SubtractOwnProduct(double* square, int count, const double* rows, int stride, int width)
{
  std::vector<double> packed;
  Pack(rows, count, stride, width, packed);
  SubtractPacked(square, count, count, count, packed, width);
}
}
