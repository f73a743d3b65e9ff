// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleComponents.h"

#include "Base/DisjointSets.h"

namespace recon
{
TriangleComponents FindTriangleComponents(const TriangleMesh& mesh)
{
  DisjointSets sets(mesh.Points.size());
  for (const auto& t : mesh.Triangles)
  {
    sets.Join(t[0], t[1]);
    sets.Join(t[0], t[2]);
  }
  TriangleComponents components;
  std::vector<int> number(mesh.Points.size(), -1);
  for (const auto& t : mesh.Triangles)
  {
    int& own = number[sets.Find(t[0])];
    own = own < 0 ? components.Count++ : own;
    components.Of.push_back(own);
  }
  return components;
}
}
