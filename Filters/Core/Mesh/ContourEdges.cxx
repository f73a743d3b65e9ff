// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ContourEdges.h"

#include "Base/BoundingBox.h"

#include <algorithm>
#include <set>

namespace recon
{
namespace
{
constexpr double RelativeTolerance = 1e-9; ///< part of the diagonal of the mesh

double Diagonal(const TriangleMesh& mesh)
{
  Box3 box;
  for (const auto& corners : mesh.Triangles)
  {
    for (const int point : corners)
    {
      box.Add(mesh.Points[point]);
    }
  }
  return box.Diagonal();
}

/// Without points that repeat the one before.
SpaceLoop WithoutRepeats(const SpaceLoop& loop)
{
  SpaceLoop result;
  for (const Point3& p : loop)
  {
    if (result.empty() || result.back() != p)
    {
      result.push_back(p);
    }
  }
  while (result.size() > 1 && result.back() == result.front())
  {
    result.pop_back();
  }
  return result;
}
}

/// One attempt: a depth-first walk over (edge of the loop, point of the mesh).
struct ContourEdges::Search
{
  const SpaceLoop& Loop;
  bool Hops; ///< go on from any point of the position reached
  std::vector<int> Path;
  /// Where the walk has been (edge of the loop, point, component): how it got there does not matter
  /// to how it can go on.
  std::set<std::array<int, 3>> Visited;
};

ContourEdges::ContourEdges(
  const TriangleMesh& mesh, const HalfEdges& edges, const std::vector<int>& components)
  : Mesh(mesh),
    Edges(edges),
    Components(components),
    Tolerance(RelativeTolerance * Diagonal(mesh))
{
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    this->PointsAt[mesh.Points[p]].push_back(static_cast<int>(p));
  }
}

/// Whether the mesh's edge from-to lies on the loop's edge after `corner` and leads towards its
/// end.
bool ContourEdges::Advances(const SpaceLoop& loop, int corner, int from, int to) const
{
  const Point3& a = loop[corner];
  const Vector3 edge = loop[(corner + 1) % loop.size()] - a;
  const double length = Norm(edge);
  const Vector3 away = this->Mesh.Points[to] - a;
  const double along = Dot(away, edge) / length;
  const double before = Dot(this->Mesh.Points[from] - a, edge) / length;
  return along > before && along < length &&
    Norm(away - (along / length) * edge) <= this->Tolerance;
}

bool ContourEdges::FindFrom(Search& search, int start) const
{
  struct Step
  {
    int Corner;        ///< of the loop: the edge after it is being followed
    int Point;         ///< of the mesh
    int Component;     ///< that the walk is on, -1 before the first half-edge
    int Edge;          ///< half-edge that led here
    std::size_t Depth; ///< length of the path before that half-edge
  };
  const SpaceLoop& loop = search.Loop;
  const int corners = static_cast<int>(loop.size());
  std::vector<Step> stack{ { 0, start, -1, -1, 0 } };
  while (!stack.empty())
  {
    const Step step = stack.back();
    stack.pop_back();
    search.Path.resize(step.Depth);
    if (step.Edge >= 0)
    {
      search.Path.push_back(step.Edge);
    }
    const Point3& here = this->Mesh.Points[step.Point];
    if (step.Corner == corners)
    {
      if (step.Point == start || (search.Hops && here == this->Mesh.Points[start]))
      {
        return true;
      }
      continue;
    }
    const Point3& goal = loop[(step.Corner + 1) % corners];
    const std::vector<int> onlyThis{ step.Point };
    for (const int point : search.Hops ? this->PointsAt.at(here) : onlyThis)
    {
      if (!search.Visited.insert({ step.Corner, point, step.Component }).second)
      {
        continue;
      }
      const int* end = this->Edges.EndFrom(point);
      for (const int* h = this->Edges.BeginFrom(point); h != end; ++h)
      {
        const int component = this->Components[*h / 3];
        if (step.Component >= 0 && component != step.Component)
        {
          continue;
        }
        const int to = this->Edges.To(*h);
        if (this->Mesh.Points[to] == goal)
        {
          stack.push_back({ step.Corner + 1, to, component, *h, search.Path.size() });
        }
        else if (this->Advances(loop, step.Corner, point, to))
        {
          stack.push_back({ step.Corner, to, component, *h, search.Path.size() });
        }
      }
    }
  }
  return false;
}

std::vector<int> ContourEdges::Find(const SpaceLoop& given) const
{
  const SpaceLoop loop = WithoutRepeats(given);
  const auto starts = loop.size() < 3 ? this->PointsAt.end() : this->PointsAt.find(loop.front());
  if (starts == this->PointsAt.end())
  {
    return {};
  }
  // Hops only where there is no way without: where a pinched surface was cut apart at the contour.
  for (const bool hops : { false, true })
  {
    for (const int start : starts->second)
    {
      Search search{ loop, hops, {}, {} };
      if (this->FindFrom(search, start))
      {
        return search.Path;
      }
    }
  }
  return {};
}
}
