// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/TracedRaster.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
/// Lengths are the same within this part, as decimals of files are.
constexpr double Same = 0.01;
/// Of all edges: so many at least go from one line of the raster to the next in either direction, and
/// so many go no farther.
constexpr double LeastAcross = 0.12;
constexpr double LeastWithin = 0.95;
/// Of all vertices, so many are as steady as is said.
constexpr double SteadyPart = 0.75;
/// Contours of fewer vertices say nothing about it.
constexpr std::size_t FewestVertices = 8;

/// visit(i-2, i-1, i, i+1, i+2) for every vertex.
template <typename Visit>
void ForVertices(const ContourSet& contours, const Visit& visit)
{
  for (const Contour& contour : contours.Contours)
  {
    const std::size_t count = contour.Points.size();
    for (std::size_t i = 0; i < count && count >= FewestVertices; ++i)
    {
      std::array<Point2, 5> around;
      for (std::size_t k = 0; k < 5; ++k)
      {
        around[k] = contours.Planar[contour.Points[(i + count + k - 2) % count]];
      }
      visit(around);
    }
  }
}

/// The length that comes up most often, and how often.
std::pair<double, std::size_t> MostFrequent(std::vector<double> lengths)
{
  std::sort(lengths.begin(), lengths.end());
  std::pair<double, std::size_t> most{ 0, 0 };
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < lengths.size(); ++begin)
  {
    while (end < lengths.size() && lengths[end] <= (1 + Same) * lengths[begin])
    {
      ++end;
    }
    if (end - begin > most.second)
    {
      most = { lengths[begin + (end - begin) / 2], end - begin };
    }
  }
  return most;
}

/// 0 where there is none.
double PitchOf(const ContourSet& contours)
{
  std::array<std::vector<double>, 2> lengths;
  std::size_t edges = 0;
  ForVertices(contours,
    [&](const std::array<Point2, 5>& p)
    {
      ++edges;
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double length = std::abs(p[3][k] - p[2][k]);
        if (length > 0)
        {
          lengths[k].push_back(length);
        }
      }
    });
  const auto [pitch, often] = MostFrequent(lengths[0]);
  const auto [other, otherOften] = MostFrequent(lengths[1]);
  const double all = static_cast<double>(edges);
  const double most = (1 + Same) * std::max(pitch, other);
  const auto goFarther = [most](const std::vector<double>& of)
  { return std::count_if(of.begin(), of.end(), [most](double l) { return l > most; }); };
  const bool isRaster = std::abs(pitch - other) <= Same * pitch &&
    static_cast<double>(std::min(often, otherOften)) > LeastAcross * all &&
    static_cast<double>(goFarther(lengths[0]) + goFarther(lengths[1])) < (1 - LeastWithin) * all;
  return isRaster ? pitch : 0;
}

/// How far the middle one is beside the cubic through the others, over chord length; negative where
/// they do not tell. Divided by what errors of all five, as large everywhere, make of it.
double OffCubic(const std::array<Point2, 5>& p)
{
  std::array<double, 5> at{ 0, 0, 0, 0, 0 };
  for (std::size_t k = 1; k < 5; ++k)
  {
    at[k] = at[k - 1] + Distance(p[k - 1], p[k]);
  }
  Point2 on{ 0, 0 };
  double squares = 1;
  for (const std::size_t j : { 0, 1, 3, 4 })
  {
    double share = 1;
    for (const std::size_t k : { 0, 1, 3, 4 })
    {
      share *= k == j ? 1 : (at[2] - at[k]) / (at[j] - at[k]);
    }
    on = { on[0] + share * p[j][0], on[1] + share * p[j][1] };
    squares += share * share;
  }
  const double x = p[3][0] - p[1][0];
  const double y = p[3][1] - p[1][1];
  const double off = std::abs((p[2][0] - on[0]) * y - (p[2][1] - on[1]) * x) /
    (std::hypot(x, y) * std::sqrt(squares));
  return std::isfinite(off) ? off : -1;
}
}

TracedRaster FindTracedRaster(const ContourSet& contours)
{
  TracedRaster raster;
  raster.Pitch = PitchOf(contours);
  std::vector<double> off;
  ForVertices(contours,
    [&](const std::array<Point2, 5>& p)
    {
      const double distance = OffCubic(p);
      if (distance >= 0)
      {
        off.push_back(distance);
      }
    });
  if (raster.Pitch > 0 && !off.empty())
  {
    const auto place =
      off.begin() + static_cast<std::ptrdiff_t>(SteadyPart * static_cast<double>(off.size() - 1));
    std::nth_element(off.begin(), place, off.end());
    raster.Unsteadiness = *place;
  }
  return raster;
}
}
