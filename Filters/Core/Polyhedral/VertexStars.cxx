// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/VertexStars.h"

#include <algorithm>

namespace recon
{
namespace
{
/// The triangle before this one around v, counterclockwise, or -1 on the hull.
int PreviousAround(const LevelTriangulation& level, int triangle, int v)
{
  return level.Neighbours[triangle][(CornerOf(level.Triangles[triangle], v) + 2) % 3];
}
}

VertexStars::VertexStars(const LevelTriangulation& level)
{
  const int count = static_cast<int>(level.Points.size());
  this->First.reserve(count + 1);
  this->Triangles.reserve(3 * level.Triangles.size());
  this->Rim.reserve(3 * level.Triangles.size());
  this->LastOfRim.reserve(count);
  this->Hull.assign(count, 0);
  for (int v = 0; v < count; ++v)
  {
    this->First.push_back(static_cast<int>(this->Triangles.size()));
    int start = level.StarTriangle[v];
    for (int t = start; t >= 0;)
    {
      const int previous = PreviousAround(level, t, v);
      this->Hull[v] = previous < 0 ? 1 : 0;
      start = t;
      t = previous == level.StarTriangle[v] ? -1 : previous;
    }
    start = this->Hull[v] ? start : level.StarTriangle[v];
    int t = start;
    int last = -1;
    do
    {
      const auto& triangle = level.Triangles[t];
      const int corner = CornerOf(triangle, v);
      this->Triangles.push_back(t);
      this->Rim.push_back(triangle[(corner + 1) % 3]);
      last = triangle[(corner + 2) % 3];
      t = level.Neighbours[t][(corner + 1) % 3];
    } while (t >= 0 && t != start);
    this->LastOfRim.push_back(last);
  }
  this->First.push_back(static_cast<int>(this->Triangles.size()));
}

int CanonicalEdge(const LevelTriangulation& level, int triangle, int corner)
{
  const int own = 3 * triangle + corner;
  const int other = level.Neighbours[triangle][corner];
  if (other < 0)
  {
    return own;
  }
  const auto& neighbours = level.Neighbours[other];
  // Two triangles share one edge at most, so the neighbour knows it by its own neighbour.
  const int back = neighbours[0] == triangle ? 0 : (neighbours[1] == triangle ? 1 : 2);
  return std::min(own, 3 * other + back);
}
}
