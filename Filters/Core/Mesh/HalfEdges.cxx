// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/HalfEdges.h"

#include "Base/Monitor.h"

#include <cstdio>
#include <numeric>
#include <string>

namespace recon
{
namespace
{
std::string Shown(const Point3& p)
{
  char text[96];
  std::snprintf(text, sizeof(text), "(%g, %g, %g)", p[0], p[1], p[2]);
  return text;
}

int Root(std::vector<int>& parents, int item)
{
  while (parents[item] != item)
  {
    parents[item] = parents[parents[item]];
    item = parents[item];
  }
  return item;
}
}

HalfEdges::HalfEdges(const TriangleMesh& mesh)
  : Mesh(mesh),
    Opposites(3 * mesh.Triangles.size(), -1),
    Outgoing(3 * mesh.Triangles.size()),
    First(mesh.Points.size() + 1, 0)
{
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const std::array<int, 3>& corners = mesh.Triangles[t];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
    {
      throw Error("Triangle " + std::to_string(t) + " near " + Shown(mesh.Points[corners[0]]) +
        " uses a point twice; remove such triangles first (the Clean filter does).");
    }
    for (const int point : corners)
    {
      ++this->First[point + 1];
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<int> place(this->First.begin(), this->First.end() - 1);
  for (int h = 0; h < this->Count(); ++h)
  {
    this->Outgoing[place[this->From(h)]++] = h;
  }
  for (int h = 0; h < this->Count(); ++h)
  {
    for (const int* g = this->BeginFrom(this->From(h)); g != this->EndFrom(this->From(h)); ++g)
    {
      if (*g < h && this->To(*g) == this->To(h))
      {
        throw Error("Triangles " + std::to_string(*g / 3) + " and " + std::to_string(h / 3) +
          " run along the edge from " + Shown(mesh.Points[this->From(h)]) + " to " +
          Shown(mesh.Points[this->To(h)]) +
          " in the same direction: the surface is no oriented manifold there, so that half-edges "
          "have no partners; the Polyhedral Surface filter makes surfaces that are.");
      }
    }
    for (const int* g = this->BeginFrom(this->To(h)); g != this->EndFrom(this->To(h)); ++g)
    {
      if (this->To(*g) == this->From(h))
      {
        this->Opposites[h] = *g;
      }
    }
  }
}

int HalfEdges::Partner(int h) const
{
  if (this->Opposites[h] >= 0)
  {
    return this->Opposites[h];
  }
  // Turn through the fan of triangles around the end of h, until the fan ends at the border.
  int next = Next(h);
  while (this->Opposites[next] >= 0)
  {
    next = Next(this->Opposites[next]);
  }
  return next;
}

std::vector<int> HalfEdges::Components() const
{
  const int triangles = this->Count() / 3;
  std::vector<int> parents(triangles);
  std::iota(parents.begin(), parents.end(), 0);
  for (int h = 0; h < this->Count(); ++h)
  {
    if (this->Opposites[h] >= 0)
    {
      const int a = Root(parents, h / 3);
      const int b = Root(parents, this->Opposites[h] / 3);
      // The smaller number stays the root, so that roots come first.
      parents[a < b ? b : a] = a < b ? a : b;
    }
  }
  std::vector<int> components(triangles, -1);
  int count = 0;
  for (int t = 0; t < triangles; ++t)
  {
    const int root = Root(parents, t);
    components[t] = root == t ? count++ : components[root];
  }
  return components;
}
}
