// SPDX-License-Identifier: GPL-3.0-or-later
#include "VertexStars.h"

#include <algorithm>

namespace recon
{
namespace
{
/// The next triangle around v, counterclockwise (step 1) or clockwise (step 2).
int Rotate(const LevelTriangulation& level, int triangle, int v, int step)
{
  const int corner = CornerOf(level.Triangles[triangle], v);
  return level.Neighbours[triangle][(corner + step) % 3];
}
}

VertexStars::VertexStars(const LevelTriangulation& level) : Level(level)
{
  const int count = static_cast<int>(level.Points.size());
  this->First.reserve(count + 1);
  this->Triangles.reserve(3 * level.Triangles.size());
  this->Hull.assign(count, 0);
  for (int v = 0; v < count; ++v)
  {
    this->First.push_back(static_cast<int>(this->Triangles.size()));
    int start = level.StarTriangle[v];
    for (int t = start; t >= 0;)
    {
      const int previous = Rotate(level, t, v, 2);
      this->Hull[v] = previous < 0 ? 1 : 0;
      start = t;
      t = previous == level.StarTriangle[v] ? -1 : previous;
    }
    start = this->Hull[v] ? start : level.StarTriangle[v];
    int t = start;
    do
    {
      this->Triangles.push_back(t);
      t = Rotate(level, t, v, 1);
    } while (t >= 0 && t != start);
  }
  this->First.push_back(static_cast<int>(this->Triangles.size()));
}

int VertexStars::CornerAfter(int v, int i, int step) const
{
  const auto& triangle = this->Level.Triangles[this->Triangle(v, i)];
  return triangle[(CornerOf(triangle, v) + step) % 3];
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
