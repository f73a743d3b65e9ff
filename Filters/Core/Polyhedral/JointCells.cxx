// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/JointCells.h"

#include "Base/StopSignal.h"
#include "Polyhedral/LevelSearch.h"

#include <cmath>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// After so many steps downhill the rest of the way is looked up. Between neighbouring triangles it
/// is one or two, but across a densely sampled contour it can be as many as there are vertices.
constexpr int MostSteps = 16;

/**
 * Apices of all T1 (or T2) nodes: walk downhill from the apex of a neighbouring triangle.
 *
 * From any vertex but the nearest one, some Delaunay neighbour is nearer; as the distance decides
 * without ties, the walk ends at the one nearest vertex, wherever it began.
 */
class ApexFinder
{
public:
  ApexFinder(const LevelTriangulation& own, const CircumcentreDistance& distance,
    const LevelTriangulation& other, const VertexStars& stars)
    : Own(own),
      Distance(distance),
      Other(other),
      Stars(stars),
      Apices(own.Triangles.size(), -1)
  {
  }

  std::vector<int> Find()
  {
    this->Descend(0, 0);
    while (!this->Stack.empty())
    {
      const int triangle = this->Stack.back();
      this->Stack.pop_back();
      for (const int neighbour : this->Own.Neighbours[triangle])
      {
        if (neighbour >= 0 && this->Apices[neighbour] < 0)
        {
          this->Descend(neighbour, this->Apices[triangle]);
        }
      }
    }
    return std::move(this->Apices);
  }

private:
  void Descend(int triangle, int vertex)
  {
    int steps = 0;
    for (int next = vertex; next >= 0; next = this->Nearer(triangle, vertex))
    {
      vertex = ++steps == MostSteps ? this->LookUp(triangle, next) : next;
    }
    this->Apices[triangle] = vertex;
    this->Stack.push_back(triangle);
  }

  /// A Delaunay neighbour of the vertex that is nearer to the circumcentre, or -1.
  int Nearer(int triangle, int vertex) const
  {
    ThrowIfStopped();
    const int size = this->Stars.Size(vertex);
    for (int i = 0; i < size + (this->Stars.OnHull(vertex) ? 1 : 0); ++i)
    {
      const int next =
        i < size ? this->Stars.Before(vertex, i) : this->Stars.After(vertex, size - 1);
      if (this->Distance.IsNearer(triangle, this->Other.Points[next], this->Other.Points[vertex]))
      {
        return next;
      }
    }
    return -1;
  }

  /// The vertex nearest to the rounded circumcentre, if it is nearer than the one there is.
  int LookUp(int triangle, int vertex)
  {
    const Point2 centre = this->Own.VoronoiVertex(triangle);
    if (!std::isfinite(centre[0]) || !std::isfinite(centre[1]))
    {
      return vertex;
    }
    if (!this->Search)
    {
      this->Search.emplace(this->Other);
    }
    const int found = this->Search->NearestVertex(centre);
    return this->Distance.IsNearer(triangle, this->Other.Points[found], this->Other.Points[vertex])
      ? found
      : vertex;
  }

  const LevelTriangulation& Own;
  const CircumcentreDistance& Distance;
  const LevelTriangulation& Other;
  const VertexStars& Stars;
  std::vector<int> Apices;
  std::vector<int> Stack;
  std::optional<VertexSearch> Search;
};

std::vector<int> FindApices(const LevelTriangulation& own, const CircumcentreDistance& distance,
  const LevelTriangulation& other, const VertexStars& stars)
{
  return ApexFinder(own, distance, other, stars).Find();
}
}

JointCells::JointCells(const LevelTriangulation& lower, const LevelTriangulation& upper)
  : Levels{ { &lower, &upper } },
    AllStars{ { VertexStars(lower), VertexStars(upper) } },
    Distances{ { CircumcentreDistance(lower, true), CircumcentreDistance(upper, false) } },
    AllApices{ { FindApices(lower, Distances[0], upper, AllStars[1]),
      FindApices(upper, Distances[1], lower, AllStars[0]) } }
{
}
}
