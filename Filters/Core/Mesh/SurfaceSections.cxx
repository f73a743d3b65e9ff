// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SurfaceSections.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace recon
{
namespace
{
using Edge = std::pair<int, int>;

/// Every edge that is cut, and the one that the section goes on to, the solid on its left.
using Successors = std::map<Edge, Edge>;

Edge Sorted(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

Successors CutTriangles(const TriangleMesh& mesh, const std::vector<double>& heights)
{
  Successors next;
  for (const auto& corners : mesh.Triangles)
  {
    Edge up{ -1, -1 };
    Edge down{ -1, -1 };
    for (int k = 0; k < 3; ++k)
    {
      const int a = corners[k];
      const int b = corners[(k + 1) % 3];
      if ((heights[a] >= 0) != (heights[b] >= 0))
      {
        (heights[b] >= 0 ? up : down) = Sorted(a, b);
      }
    }
    if (up.first >= 0)
    {
      next[down] = up;
    }
  }
  return next;
}

Point3 PointOn(const Edge& edge, const TriangleMesh& mesh, const std::vector<double>& heights)
{
  const double a = heights[edge.first];
  const double t = a / (a - heights[edge.second]);
  return (1 - t) * mesh.Points[edge.first] + t * mesh.Points[edge.second];
}

/// Follows the section from an edge, whose successors are used up; whether it came back.
bool Follow(Edge at, Successors& next, std::vector<Edge>& loop)
{
  const Edge start = at;
  for (auto step = next.find(at); step != next.end(); step = next.find(at))
  {
    loop.push_back(at);
    at = step->second;
    next.erase(step); // so there are no more steps than edges
  }
  return at == start;
}
}

void AppendSection(
  const TriangleMesh& mesh, const PlanarFrame& frame, double offset, LoopSoup& soup)
{
  std::vector<double> heights;
  heights.reserve(mesh.Points.size());
  for (const Point3& p : mesh.Points)
  {
    heights.push_back(frame.OffsetOf(p) - offset);
  }
  Successors next = CutTriangles(mesh, heights);
  while (!next.empty())
  {
    std::vector<Edge> edges;
    const bool closes = Follow(next.begin()->first, next, edges);
    std::vector<Point3> loop;
    for (const Edge& edge : edges)
    {
      loop.push_back(PointOn(edge, mesh, heights));
    }
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    if (closes && loop.size() >= 3)
    {
      soup.Append(loop);
    }
  }
}
}
