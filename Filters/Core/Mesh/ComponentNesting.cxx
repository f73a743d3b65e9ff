// SPDX-License-Identifier: GPL-3.0-or-later
#include "ComponentNesting.h"

#include "MeshPredicates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace recon
{
namespace
{
constexpr int NumberOfTries = 8;

struct Box
{
  Point3 Low{ std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  Point3 High{ -Low[0], -Low[1], -Low[2] };

  void Add(const Point3& p)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Low[k] = std::min(this->Low[k], p[k]);
      this->High[k] = std::max(this->High[k], p[k]);
    }
  }

  bool Contains(const Point3& p) const
  {
    return p[0] >= this->Low[0] && p[0] <= this->High[0] && p[1] >= this->Low[1] &&
      p[1] <= this->High[1] && p[2] >= this->Low[2] && p[2] <= this->High[2];
  }
};

/// The point whose surroundings are asked for, on behalf of a component.
struct Query
{
  Point3 Point;
  int Component;
};

enum class RayHit
{
  Miss,
  Above,
  OnTriangle
};

/**
 * Does the ray upward from p pass through the triangle?
 *
 * Points of an edge count as left of it, whichever triangle asks, so that a ray through an edge or
 * a corner of a closed surface meets it in the right number of triangles.
 */
RayHit CastUpward(const Point3& p, const Point3& a, const Point3& b, const Point3& c)
{
  const std::array<Point2, 3> flat{ { { a[0], a[1] }, { b[0], b[1] }, { c[0], c[1] } } };
  const Point2 q{ p[0], p[1] };
  bool inside = false;
  for (int k = 0; k < 3; ++k)
  {
    const Point2* low = &flat[k];
    const Point2* high = &flat[(k + 1) % 3];
    if (((*low)[1] > q[1]) == ((*high)[1] > q[1]))
    {
      continue;
    }
    if ((*low)[1] > (*high)[1])
    {
      std::swap(low, high);
    }
    inside ^= Orientation2(*low, *high, q) > 0;
  }
  if (!inside)
  {
    return RayHit::Miss;
  }
  const int side = Orientation3(a, b, c, p) * Orientation2(flat[0], flat[1], flat[2]);
  return side == 0 ? RayHit::OnTriangle : side < 0 ? RayHit::Above : RayHit::Miss;
}

class NestingFinder
{
public:
  NestingFinder(const TriangleMesh& mesh, const std::vector<int>& componentOfTriangle,
    const std::vector<bool>& encloses)
    : Mesh(mesh),
      ComponentOf(componentOfTriangle),
      Encloses(encloses),
      Boxes(encloses.size()),
      Depth(encloses.size(), 0)
  {
    std::vector<int> size(encloses.size(), 0);
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      if (componentOfTriangle[t] < 0)
      {
        continue;
      }
      ++size[componentOfTriangle[t]];
      for (const int p : mesh.Triangles[t])
      {
        this->Boxes[componentOfTriangle[t]].Add(mesh.Points[p]);
      }
    }
    this->CollectCandidates(size);
  }

  std::vector<int> Run()
  {
    std::vector<int> open(this->Encloses.size());
    for (std::size_t c = 0; c < open.size(); ++c)
    {
      open[c] = static_cast<int>(c);
    }
    for (int attempt = 0; attempt < NumberOfTries && !open.empty(); ++attempt)
    {
      open = this->Try(open, attempt);
    }
    return this->Depth;
  }

private:
  /// A corner of every eighth part of each component's triangles.
  void CollectCandidates(const std::vector<int>& size)
  {
    this->Candidates.resize(size.size());
    std::vector<int> seen(size.size(), 0);
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      const int c = this->ComponentOf[t];
      if (c < 0)
      {
        continue;
      }
      const int step = std::max(1, size[c] / NumberOfTries);
      if (seen[c]++ % step == 0 && this->Candidates[c].size() < NumberOfTries)
      {
        this->Candidates[c].push_back(this->Mesh.Triangles[t][0]);
      }
    }
  }

  /// Settles what it can; returns the components whose point lies on another component.
  std::vector<int> Try(const std::vector<int>& components, int attempt)
  {
    std::vector<Query> queries;
    for (const int c : components)
    {
      const auto& candidates = this->Candidates[c];
      queries.push_back({ this->Mesh.Points[candidates[attempt % candidates.size()]], c });
    }
    std::sort(queries.begin(), queries.end(),
      [](const Query& a, const Query& b) { return a.Point[0] < b.Point[0]; });
    std::vector<bool> onSurface(this->Depth.size(), false);
    const auto hits = this->CastAll(queries, onSurface);
    for (const auto& query : queries)
    {
      this->Depth[query.Component] = 0;
    }
    for (std::size_t i = 0; i < hits.size();)
    {
      std::size_t next = i;
      while (next < hits.size() && hits[next] == hits[i])
      {
        ++next;
      }
      this->Depth[hits[i].first] += (next - i) % 2 != 0 ? 1 : 0;
      i = next;
    }
    std::vector<int> open;
    std::copy_if(components.begin(), components.end(), std::back_inserter(open),
      [&](int c) { return onSurface[c]; });
    return open;
  }

  /// (component of the ray's origin, component hit), sorted.
  std::vector<std::pair<int, int>> CastAll(
    const std::vector<Query>& queries, std::vector<bool>& onSurface) const
  {
    std::vector<std::pair<int, int>> hits;
    if (queries.empty())
    {
      return hits;
    }
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      const int component = this->ComponentOf[t];
      if (component < 0 || !this->Encloses[component])
      {
        continue;
      }
      const auto& corners = this->Mesh.Triangles[t];
      const Point3& a = this->Mesh.Points[corners[0]];
      const Point3& b = this->Mesh.Points[corners[1]];
      const Point3& c = this->Mesh.Points[corners[2]];
      Box box;
      box.Add(a);
      box.Add(b);
      box.Add(c);
      auto query = std::lower_bound(queries.begin(), queries.end(), box.Low[0],
        [](const Query& q, double x) { return q.Point[0] < x; });
      for (; query != queries.end() && query->Point[0] <= box.High[0]; ++query)
      {
        const Point3& p = query->Point;
        if (query->Component == component || p[1] < box.Low[1] || p[1] > box.High[1] ||
          p[2] > box.High[2] || !this->Boxes[component].Contains(p))
        {
          continue;
        }
        const RayHit hit = CastUpward(p, a, b, c);
        if (hit == RayHit::Above)
        {
          hits.emplace_back(query->Component, component);
        }
        else if (hit == RayHit::OnTriangle)
        {
          onSurface[query->Component] = true;
        }
      }
    }
    std::sort(hits.begin(), hits.end());
    return hits;
  }

  const TriangleMesh& Mesh;
  const std::vector<int>& ComponentOf;
  const std::vector<bool>& Encloses;
  std::vector<Box> Boxes;
  std::vector<std::vector<int>> Candidates;
  std::vector<int> Depth;
};
}

std::vector<int> FindComponentNesting(const TriangleMesh& mesh,
  const std::vector<int>& componentOfTriangle, const std::vector<bool>& encloses)
{
  if (encloses.size() < 2)
  {
    return std::vector<int>(encloses.size(), 0);
  }
  return NestingFinder(mesh, componentOfTriangle, encloses).Run();
}
}
