// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SurfaceSummary.h"

#include "Base/Text.h"
#include "Mesh/MassProperties.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace recon
{
namespace
{
constexpr double CubicMillimetres = 1000; // in a cm3

/// One triangle's side, seen from the lower one of its points.
struct Side
{
  int Other;  ///< the higher point
  int Upward; ///< 1 where the triangle runs from the lower point to the higher one, else -1
};

/// All sides, those of a lower point together.
struct SidesByPoint
{
  std::vector<Side> Sides;
  std::vector<std::size_t> First; ///< a point: where its sides begin
};

template <typename Visit>
void ForEachSide(const TriangleMesh& mesh, const Visit& visit)
{
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      visit(t[i], t[(i + 1) % 3]);
    }
  }
}

SidesByPoint SortSides(const TriangleMesh& mesh)
{
  SidesByPoint sorted;
  sorted.First.resize(mesh.Points.size() + 1);
  ForEachSide(mesh, [&](int from, int to) { ++sorted.First[std::min(from, to) + 1]; });
  std::partial_sum(sorted.First.begin(), sorted.First.end(), sorted.First.begin());
  sorted.Sides.resize(sorted.First.back());
  std::vector<std::size_t> next(sorted.First.begin(), sorted.First.end() - 1);
  ForEachSide(mesh,
    [&](int from, int to) {
      sorted.Sides[next[std::min(from, to)]++] = { std::max(from, to), from < to ? 1 : -1 };
    });
  return sorted;
}

/// Of the sides of one lower point.
void CountSides(
  std::vector<Side>::iterator begin, std::vector<Side>::iterator end, EdgeCensus& census)
{
  std::sort(begin, end, [](const Side& a, const Side& b) { return a.Other < b.Other; });
  while (begin != end)
  {
    const int other = begin->Other;
    int count = 0;
    int direction = 0;
    for (; begin != end && begin->Other == other; ++begin)
    {
      ++count;
      direction += begin->Upward;
    }
    census.Open += count == 1 ? 1 : 0;
    census.Irregular += count > 2 || (count == 2 && direction != 0) ? 1 : 0;
  }
}

std::string VolumeText(const TriangleMesh& mesh, bool millimetres)
{
  const std::vector<int> together(mesh.Triangles.size(), 0);
  const double volume = ComputeSignedVolumes(mesh, together, 1).front();
  return millimetres ? Text(volume / CubicMillimetres) + " cm3" : "volume " + Text(volume);
}
}

EdgeCensus CountEdges(const TriangleMesh& mesh)
{
  SidesByPoint sorted = SortSides(mesh);
  EdgeCensus census;
  for (std::size_t p = 0; p + 1 < sorted.First.size(); ++p)
  {
    CountSides(sorted.Sides.begin() + static_cast<std::ptrdiff_t>(sorted.First[p]),
      sorted.Sides.begin() + static_cast<std::ptrdiff_t>(sorted.First[p + 1]), census);
  }
  return census;
}

std::string SummariseSurface(const TriangleMesh& mesh, bool millimetres)
{
  if (mesh.Triangles.empty())
  {
    return "no surface";
  }
  const EdgeCensus census = CountEdges(mesh);
  if (census.Irregular > 0)
  {
    return "no manifold (" + Counted(census.Irregular, "edge") +
      " not of two triangles), no volume";
  }
  if (census.Open > 0)
  {
    return "open (" + Counted(census.Open, "open edge") + "), no volume";
  }
  return "closed, " + VolumeText(mesh, millimetres);
}
}
