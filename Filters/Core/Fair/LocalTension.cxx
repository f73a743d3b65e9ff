// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/LocalTension.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Where a surface bends as much as slices can show; and where it bends more, as a thin plate swings too far
/// there.
constexpr double SmoothTension = 0.04;
constexpr double SharpTension = 0.85;
/// Bends (the sum of both curvatures, by the slices' distance) that slices can show, and that they cannot;
/// tension rises between them.
constexpr double SmoothBend = 1.4;
constexpr double SharpBend = 2.4;
/// Where the polyhedral surface bends less the shape is flat, and would swing out beside its edges.
constexpr double FlatBend = 0.1;
/// Bends are evened out over the slices' distance, in no more rounds.
constexpr double MostEvenings = 8;

/// Of each point the mean of those around, over the slices' distance.
std::vector<double> EvenedOut(const TriangleMesh& mesh, std::vector<double> values, double edges)
{
  const double rounds = std::clamp(std::ceil(edges), 1.0, MostEvenings);
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<double> sums(values.size(), 0);
    std::vector<double> counts(values.size(), 0);
    for (const auto& t : mesh.Triangles)
    {
      const double sum = values[t[0]] + (values[t[1]] + values[t[2]]);
      for (const int v : t)
      {
        sums[v] += sum;
        counts[v] += 3;
      }
    }
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      values[v] = counts[v] > 0 ? sums[v] / counts[v] : values[v];
    }
  }
  return values;
}
}

std::vector<double> TensionByBend(const TriangleMesh& mesh, const std::vector<double>& rest,
  const std::vector<double>& bends, double edges)
{
  const std::vector<double> flat = EvenedOut(mesh, rest, edges);
  const std::vector<double> sharp = EvenedOut(mesh, bends, edges);
  const auto between = [](double low, double high, double value)
  { return std::clamp((value - low) / (high - low), 0.0, 1.0); };
  std::vector<double> tension(bends.size());
  for (std::size_t v = 0; v < bends.size(); ++v)
  {
    const double share = std::max(
      1 - between(FlatBend, 2 * FlatBend, flat[v]), between(SmoothBend, SharpBend, sharp[v]));
    tension[v] = SmoothTension + share * (SharpTension - SmoothTension);
  }
  return tension;
}

}
