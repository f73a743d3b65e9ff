// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/VoronoiEdgeWalk.h"

namespace recon
{
std::optional<VoronoiEdgeWalk::Exit> VoronoiEdgeWalk::Leave(int cell, int cameFrom) const
{
  if (this->Stars.OnHull(cell))
  {
    return this->LeaveHullCell(cell);
  }
  const int size = this->Stars.Size(cell);
  int i = 0;
  while (i < size - 1 && this->Stars.Triangle(cell, i) != cameFrom)
  {
    ++i;
  }
  bool side = this->NearerToB(this->Stars.Triangle(cell, i));
  for (int step = 0; step < size; ++step)
  {
    const int next = i + 1 < size ? i + 1 : 0;
    const bool nextSide = this->NearerToB(this->Stars.Triangle(cell, next));
    if (!side && nextSide)
    {
      return this->Across(cell, i);
    }
    i = next;
    side = nextSide;
  }
  return std::nullopt;
}

/// The exit between triangle i around the cell and the next one.
VoronoiEdgeWalk::Exit VoronoiEdgeWalk::Across(int cell, int i) const
{
  const int triangle = this->Stars.Triangle(cell, i);
  const int opposite = CornerOf(this->Level.Triangles[triangle], this->Stars.Before(cell, i));
  return { this->Stars.After(cell, i), triangle, CanonicalEdge(this->Level, triangle, opposite) };
}

std::optional<VoronoiEdgeWalk::Exit> VoronoiEdgeWalk::LeaveHullCell(int cell) const
{
  const int last = this->Stars.Size(cell) - 1;
  const bool first = this->NearerToB(this->Stars.Triangle(cell, 0));
  bool side = first;
  for (int i = 0; i < last; ++i)
  {
    const bool next = this->NearerToB(this->Stars.Triangle(cell, i + 1));
    if (!side && next)
    {
      return this->Across(cell, i);
    }
    side = next;
  }
  const int after = this->Stars.After(cell, last);
  const int before = this->Stars.Before(cell, 0);
  const bool infinite1 = this->AtInfinity(after, cell, side);
  const bool infinite2 = this->AtInfinity(cell, before, first);
  if (!side && infinite1)
  {
    return this->Across(cell, last);
  }
  if (!infinite1 && infinite2)
  {
    return Exit{};
  }
  if (!infinite2 && first)
  {
    const int triangle = this->Stars.Triangle(cell, 0);
    const int opposite = CornerOf(this->Level.Triangles[triangle], this->Stars.After(cell, 0));
    return Exit{ before, -1, CanonicalEdge(this->Level, triangle, opposite) };
  }
  return std::nullopt;
}

/// Side of the far end of the infinite Voronoi edge of the hull edge u->v (outside on its right);
/// one that is parallel to this walk stays on the side where it begins.
bool VoronoiEdgeWalk::AtInfinity(int u, int v, bool sideOfBeginning) const
{
  const int sign =
    SignAlongRightNormal(this->Level.Points[u], this->Level.Points[v], this->A, this->B);
  return sign == 0 ? sideOfBeginning : sign > 0;
}
}
