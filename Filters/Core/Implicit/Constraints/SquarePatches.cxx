// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/SquarePatches.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Squares of one grid and of halved ones touch to rounding.
constexpr double Touching = 1 + 1e-6;

double LowOf(const PlaneSquare& square)
{
  return square.Middle[0] - 0.5 * square.Size;
}

bool Touch(const PlaneSquare& a, const PlaneSquare& b)
{
  const double reach = 0.5 * (a.Size + b.Size) * Touching;
  return std::abs(a.Middle[0] - b.Middle[0]) <= reach &&
    std::abs(a.Middle[1] - b.Middle[1]) <= reach;
}
}

double LargestDetachedPatch(std::vector<PlaneSquare> squares)
{
  std::sort(squares.begin(), squares.end(),
    [](const PlaneSquare& a, const PlaneSquare& b)
    { return LowOf(a) < LowOf(b) || (LowOf(a) == LowOf(b) && a.Middle[1] < b.Middle[1]); });
  DisjointSets patches(squares.size());
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    const double high = LowOf(squares[i]) + Touching * squares[i].Size;
    for (std::size_t j = i + 1; j < squares.size() && LowOf(squares[j]) <= high; ++j)
    {
      if (Touch(squares[i], squares[j]))
      {
        patches.Join(static_cast<int>(i), static_cast<int>(j));
      }
    }
  }
  std::vector<double> areas(squares.size(), 0);
  std::vector<char> attached(squares.size(), 0);
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    const int patch = patches.Find(static_cast<int>(i));
    areas[patch] += squares[i].Size * squares[i].Size;
    attached[patch] = attached[patch] || squares[i].Room <= squares[i].Size;
  }
  double largest = 0;
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    largest = attached[i] ? largest : std::max(largest, areas[i]);
  }
  return largest;
}
}
