// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PinchedPoints.h"

#include "Base/DisjointSets.h"

#include <cstdint>
#include <unordered_map>

namespace recon
{
namespace
{
std::uint64_t KeyOf(int from, int to)
{
  return (static_cast<std::uint64_t>(from) << 32) | static_cast<std::uint32_t>(to);
}

/// Corners, numbered 3 * triangle + k, that hang together across edges.
DisjointSets JoinCornersAcrossEdges(const TriangleMesh& mesh)
{
  const int count = static_cast<int>(3 * mesh.Triangles.size());
  std::unordered_map<std::uint64_t, int> edges; // from, to -> the corner where it begins
  edges.reserve(count);
  for (int corner = 0; corner < count; ++corner)
  {
    const auto& t = mesh.Triangles[corner / 3];
    edges.emplace(KeyOf(t[corner % 3], t[(corner + 1) % 3]), corner);
  }
  DisjointSets sets(count);
  for (int corner = 0; corner < count; ++corner)
  {
    const auto& t = mesh.Triangles[corner / 3];
    const auto across = edges.find(KeyOf(t[(corner + 1) % 3], t[corner % 3]));
    if (across != edges.end())
    {
      // There the edge ends at this corner's point, at the corner after the one where it begins.
      const int begin = across->second;
      sets.Join(corner, begin - begin % 3 + (begin + 1) % 3);
    }
  }
  return sets;
}
}

std::vector<int> CutPinchedPoints(TriangleMesh& mesh)
{
  DisjointSets sets = JoinCornersAcrossEdges(mesh);
  const int count = static_cast<int>(3 * mesh.Triangles.size());
  std::vector<int> pointOfFan(count, -1);
  std::vector<unsigned char> taken(mesh.Points.size(), 0);
  std::vector<int> copied;
  for (int corner = 0; corner < count; ++corner)
  {
    int& point = mesh.Triangles[corner / 3][corner % 3];
    int& own = pointOfFan[sets.Find(corner)];
    if (own < 0 && !taken[point])
    {
      taken[point] = 1;
      own = point;
    }
    else if (own < 0)
    {
      own = static_cast<int>(mesh.Points.size());
      const Point3 position = mesh.Points[point];
      mesh.Points.push_back(position);
      copied.push_back(point);
    }
    point = own;
  }
  return copied;
}
}
