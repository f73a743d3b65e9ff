// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/MaterialWalker.h"

#include "Base/Predicates.h"

#include <cstddef>
#include <set>
#include <utility>

namespace recon
{
MaterialWalker::MaterialWalker(
  const Vector3& normal, const std::vector<Point3>& vertices, const std::vector<NetworkEdge>& edges)
  : Edges(edges)
{
  const PlanarFrame frame = PlanarFrame::About(normal);
  for (const Point3& vertex : vertices)
  {
    this->Planar.push_back(frame.ToPlane(vertex));
  }
}

bool MaterialWalker::SwapSidesWhereZeroIsInside()
{
  int extreme = -1;
  for (const NetworkEdge& edge : this->Edges)
  {
    for (const int end : { edge.From, edge.To })
    {
      if (extreme < 0 ||
        this->Planar[static_cast<std::size_t>(end)] >
          this->Planar[static_cast<std::size_t>(extreme)])
      {
        extreme = end;
      }
    }
  }
  // All edges at the extreme vertex run to its left or straight down; counterclockwise from straight
  // to the right, the first of them has the open wedge on its right-hand side.
  const NetworkEdge* first = nullptr;
  const auto other = [extreme](const NetworkEdge& edge)
  { return static_cast<std::size_t>(edge.From == extreme ? edge.To : edge.From); };
  for (const NetworkEdge& edge : this->Edges)
  {
    if (edge.From != extreme && edge.To != extreme)
    {
      continue;
    }
    if (!first ||
      Orientation2(this->Planar[static_cast<std::size_t>(extreme)], this->Planar[other(edge)],
        this->Planar[other(*first)]) > 0)
    {
      first = &edge;
    }
  }
  if (!first)
  {
    return false;
  }
  const bool leaves = first->From == extreme;
  const int outside = leaves ? first->Right : first->Left;
  const int inside = leaves ? first->Left : first->Right;
  if (outside == 0 || inside != 0)
  {
    return false;
  }
  for (NetworkEdge& edge : this->Edges)
  {
    std::swap(edge.Left, edge.Right);
  }
  return true;
}

std::vector<int> MaterialWalker::GetMaterials() const
{
  std::set<int> materials;
  for (const NetworkEdge& edge : this->Edges)
  {
    materials.insert({ edge.Left, edge.Right });
  }
  materials.erase(0);
  return std::vector<int>(materials.begin(), materials.end());
}

std::vector<BorderWalk> MaterialWalker::Walk(int material) const
{
  BorderWalks walks(this->Planar);
  for (const NetworkEdge& edge : this->Edges)
  {
    if (edge.Left == material)
    {
      walks.Add(edge.From, edge.To);
    }
    else if (edge.Right == material)
    {
      walks.Add(edge.To, edge.From);
    }
  }
  return walks.Walk();
}
}
