// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/DenseFront.h"

#include "Base/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Wide versions fuse operations: the last bits depend on the processor, never on the number of
// threads.

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
constexpr int ColumnsAtOnce = 32;

/// Rows in groups of TileRows, of each group column after column; the last group is filled with zeros.
void Pack(const double* rows, int count, int stride, int width, std::vector<double>& packed)
{
  const int groups = (count + TileRows - 1) / TileRows;
  packed.assign(static_cast<std::size_t>(groups) * TileRows * width, 0.0);
  for (int column = 0; column < width; ++column)
  {
    const double* from = rows + static_cast<std::size_t>(column) * stride;
    for (int i = 0; i < count; ++i)
    {
      const std::size_t group = static_cast<std::size_t>(i / TileRows) * width + column;
      packed[group * TileRows + i % TileRows] = from[i];
    }
  }
}

/// Of TileRows rows with TileColumns others, which begin within a group.
RECON_CLONES_WIDEST void MultiplyTile(
  const double* rows, const double* others, int width, double* product)
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
      product[j * TileRows + i] = sums[j][i];
    }
  }
}

/// square(i, j) -= row i times row j, for i >= j and the first columns.
void SubtractPacked(double* square, std::size_t stride, int count, int columns,
  const std::vector<double>& packed, int width)
{
  double product[TileColumns * TileRows];
  const auto groupOf = [&](int row)
  { return packed.data() + static_cast<std::size_t>(row / TileRows) * TileRows * width; };
  for (int top = 0; top < count; top += RowsAtOnce)
  {
    const int bottom = std::min(count, top + RowsAtOnce);
    for (int left = 0; left < std::min(columns, bottom); left += TileColumns)
    {
      const double* others = groupOf(left) + left % TileRows;
      const int first = std::max(top, left / TileRows * TileRows);
      for (int row = first; row < bottom; row += TileRows)
      {
        MultiplyTile(groupOf(row), others, width, product);
        for (int j = left; j < std::min(columns, left + TileColumns); ++j)
        {
          double* column = square + j * stride;
          for (int i = std::max(row, j); i < std::min(bottom, row + TileRows); ++i)
          {
            column[i] -= product[(j - left) * TileRows + i - row];
          }
        }
      }
    }
  }
}

RECON_CLONES_WIDEST void SubtractColumns(double* a, const double* b, double factor, int count)
{
  for (int i = 0; i < count; ++i)
  {
    a[i] -= factor * b[i];
  }
}

/// Columns [from, to) of a panel, from which all before have been subtracted.
bool FactoriseColumns(double* panel, int rows, int from, int to)
{
  const auto columnOf = [&](int k) { return panel + static_cast<std::size_t>(k) * rows; };
  for (int k = from; k < to; ++k)
  {
    double* column = columnOf(k);
    for (int done = from; done < k; ++done)
    {
      SubtractColumns(column + k, columnOf(done) + k, columnOf(done)[k], rows - k);
    }
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
