// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/EdgeTable.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace recon
{
EdgeTable SortEdges(const TriangleMesh& mesh)
{
  EdgeTable table;
  table.First.assign(mesh.Points.size() + 1, 0);
  const auto forEachSide = [&](const auto& visit)
  {
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      const auto& corners = mesh.Triangles[t];
      if (IsCollapsed(corners))
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
        visit(low, EdgeSide{ high, static_cast<int>(3 * t) + k });
      }
    }
  };
  forEachSide([&](int low, const EdgeSide&) { ++table.First[low + 1]; });
  std::partial_sum(table.First.begin(), table.First.end(), table.First.begin());
  table.Sides.resize(table.First.back());
  std::vector<int> next(table.First.begin(), table.First.end() - 1);
  forEachSide([&](int low, const EdgeSide& side) { table.Sides[next[low]++] = side; });
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    std::sort(table.Sides.begin() + table.First[p], table.Sides.begin() + table.First[p + 1],
      [](const EdgeSide& a, const EdgeSide& b)
      { return a.High != b.High ? a.High < b.High : a.Corner < b.Corner; });
  }
  return table;
}

bool IsOriented(const TriangleMesh& mesh, const EdgeGroup& edge)
{
  int balance = 0;
  for (const EdgeSide* side = edge.Begin; side != edge.End; ++side)
  {
    balance += RunsUpward(mesh, *side) ? 1 : -1;
  }
  return std::abs(balance) <= edge.Count() % 2;
}
}
