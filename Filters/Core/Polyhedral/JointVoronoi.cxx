// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/JointVoronoi.h"

#include "Base/Monitor.h"
#include "Polyhedral/JointVoronoiPredicates.h"
#include "Polyhedral/VertexStars.h"

#include <utility>

namespace recon
{
namespace
{
using Tetrahedron = SlabTetrahedra::Tetrahedron;

/**
 * Apices of all T1 (or T2) nodes: walk downhill from the apex of a neighbouring triangle.
 *
 * From any vertex but the nearest one, some Delaunay neighbour is nearer; as the distance decides
 * without ties, the walk ends at the one nearest vertex.
 */
std::vector<int> FindApices(const LevelTriangulation& own, const CircumcentreDistance& distance,
  const LevelTriangulation& other, const VertexStars& stars)
{
  std::vector<int> apices(own.Triangles.size(), -1);
  std::vector<int> stack;
  const auto descend = [&](int triangle, int vertex)
  {
    for (bool moved = true; moved;)
    {
      moved = false;
      const int size = stars.Size(vertex);
      for (int i = 0; i < size + (stars.OnHull(vertex) ? 1 : 0) && !moved; ++i)
      {
        const int next = i < size ? stars.Before(vertex, i) : stars.After(vertex, size - 1);
        if (distance.IsNearer(triangle, other.Points[next], other.Points[vertex]))
        {
          vertex = next;
          moved = true;
        }
      }
    }
    apices[triangle] = vertex;
    stack.push_back(triangle);
  };

  descend(0, 0);
  while (!stack.empty())
  {
    const int triangle = stack.back();
    stack.pop_back();
    for (int neighbour : own.Neighbours[triangle])
    {
      if (neighbour >= 0 && apices[neighbour] < 0)
      {
        descend(neighbour, apices[triangle]);
      }
    }
  }
  return apices;
}

/**
 * The crossings of one Voronoi edge of level 1 with the Voronoi cells of level 2.
 *
 * The edge is dual to a-b and runs so that b is on its left; the side of a Voronoi vertex of
 * level 2 is whether it is nearer to b. Around a cell, counterclockwise, the edge leaves where the
 * side changes from a to b. A cell on the hull has two corners at infinity after its last triangle.
 */
class VoronoiEdgeWalk
{
public:
  struct Exit
  {
    int Cell = -1;         ///< the next cell, or -1 to infinity
    int SideA = -1;        ///< triangle before the exit, or -1 at infinity
    int DelaunayEdge = -1; ///< of level 2, canonical
  };

  VoronoiEdgeWalk(const LevelTriangulation& level2, const VertexStars& stars,
    const CircumcentreDistance& distance, const Point2& a, const Point2& b)
    : Level2(level2),
      Stars(stars),
      Distance(distance),
      A(a),
      B(b)
  {
  }

  /// cameFrom: Exit::SideA of the step that led here, or -1.
  Exit Leave(int cell, int cameFrom) const
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
    throw Error("Joint Voronoi diagram: a Voronoi edge found no way out of a cell.");
  }

private:
  bool NearerToB(int triangle) const { return this->Distance.IsNearer(triangle, this->B, this->A); }

  /// The exit between triangle i around the cell and the next one.
  Exit Across(int cell, int i) const
  {
    const int triangle = this->Stars.Triangle(cell, i);
    const int opposite = CornerOf(this->Level2.Triangles[triangle], this->Stars.Before(cell, i));
    return { this->Stars.After(cell, i), triangle,
      CanonicalEdge(this->Level2, triangle, opposite) };
  }

  Exit LeaveHullCell(int cell) const
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
      return {};
    }
    if (!infinite2 && first)
    {
      const int triangle = this->Stars.Triangle(cell, 0);
      const int opposite = CornerOf(this->Level2.Triangles[triangle], this->Stars.After(cell, 0));
      return { before, -1, CanonicalEdge(this->Level2, triangle, opposite) };
    }
    throw Error("Joint Voronoi diagram: a Voronoi edge found no way out of a cell on the hull.");
  }

  /// Side of the far end of the infinite Voronoi edge of the hull edge u->v (outside on its right);
  /// one that is parallel to this walk stays on the side where it begins.
  bool AtInfinity(int u, int v, bool sideOfBeginning) const
  {
    const int sign =
      SignAlongRightNormal(this->Level2.Points[u], this->Level2.Points[v], this->A, this->B);
    return sign == 0 ? sideOfBeginning : sign > 0;
  }

  const LevelTriangulation& Level2;
  const VertexStars& Stars;
  const CircumcentreDistance& Distance;
  const Point2& A;
  const Point2& B;
};

class Builder
{
public:
  Builder(const LevelTriangulation& level1, const LevelTriangulation& level2)
    : Level1(level1),
      Level2(level2),
      Stars1(level1),
      Stars2(level2),
      Distance1(level1, true),
      Distance2(level2, false)
  {
  }

  SlabTetrahedra Build()
  {
    this->Apices1 = FindApices(this->Level1, this->Distance1, this->Level2, this->Stars2);
    this->Apices2 = FindApices(this->Level2, this->Distance2, this->Level1, this->Stars1);
    this->AddNodesOfVoronoiVertices();
    for (int t = 0; t < this->Slab.NumberOfT1; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (CanonicalEdge(this->Level1, t, k) == 3 * t + k)
        {
          this->AddNodesOfVoronoiEdge(t, k);
        }
      }
    }
    this->LinkAlongLevel2();
    return std::move(this->Slab);
  }

private:
  Tetrahedron& At(int i) { return this->Slab.Tetrahedra[i]; }

  void AddNodesOfVoronoiVertices()
  {
    this->Slab.NumberOfT1 = static_cast<int>(this->Level1.Triangles.size());
    this->Slab.NumberOfT2 = static_cast<int>(this->Level2.Triangles.size());
    for (int t = 0; t < this->Slab.NumberOfT1; ++t)
    {
      const auto& c = this->Level1.Triangles[t];
      this->Slab.Tetrahedra.push_back({ { c[0], c[1], c[2], this->Apices1[t] }, None, { t, -1 },
        SlabTetrahedra::T1, SlabTetrahedra::Kept });
    }
    for (int t = 0; t < this->Slab.NumberOfT2; ++t)
    {
      // The apex lies below, so the corners run the other way round to be positively oriented.
      const auto& c = this->Level2.Triangles[t];
      this->Slab.Tetrahedra.push_back({ { c[0], c[2], c[1], this->Apices2[t] }, None, { t, -1 },
        SlabTetrahedra::T2, SlabTetrahedra::Kept });
    }
  }

  /// T12 nodes on the Voronoi edge of level 1 that leaves triangle t across corner k.
  void AddNodesOfVoronoiEdge(int t, int k)
  {
    const auto& corners = this->Level1.Triangles[t];
    const int a = corners[(k + 1) % 3];
    const int b = corners[(k + 2) % 3];
    const int end = this->Level1.Neighbours[t][k];
    const int lastCell = end < 0 ? -1 : this->Apices1[end];
    const VoronoiEdgeWalk walk(
      this->Level2, this->Stars2, this->Distance2, this->Level1.Points[a], this->Level1.Points[b]);

    int previous = t; // the tetrahedron before, and its corner opposite the face passed through
    int face = k;
    int cell = this->Apices1[t];
    int cameFrom = -1;
    std::size_t steps = 0;
    while (cell != lastCell)
    {
      const VoronoiEdgeWalk::Exit exit = walk.Leave(cell, cameFrom);
      if (exit.Cell < 0 && end < 0)
      {
        break;
      }
      if (exit.Cell < 0 || ++steps > this->Level2.Points.size())
      {
        throw Error("Joint Voronoi diagram: a Voronoi edge did not reach its end.");
      }
      const int added = static_cast<int>(this->Slab.Tetrahedra.size());
      this->Slab.Tetrahedra.push_back({ { a, b, cell, exit.Cell }, None,
        { 3 * t + k, exit.DelaunayEdge }, SlabTetrahedra::T12, SlabTetrahedra::Kept });
      this->At(added).Neighbours[3] = previous;
      this->At(previous).Neighbours[face] = added;
      previous = added;
      face = 2;
      cell = exit.Cell;
      cameFrom = exit.SideA;
    }
    if (end >= 0)
    {
      const auto& back = this->Level1.Neighbours[end];
      const int corner = back[0] == t ? 0 : (back[1] == t ? 1 : 2);
      this->At(end).Neighbours[corner] = previous;
      this->At(previous).Neighbours[face] = end;
    }
  }

  /// The same T12 nodes in the order in which they lie on the Voronoi edges of level 2.
  void LinkAlongLevel2()
  {
    const int firstT12 = this->Slab.NumberOfT1 + this->Slab.NumberOfT2;
    const int count = static_cast<int>(this->Slab.Tetrahedra.size());
    std::vector<int> first(3 * this->Level2.Triangles.size() + 1, 0);
    for (int i = firstT12; i < count; ++i)
    {
      ++first[this->At(i).Origin[1] + 1];
    }
    for (std::size_t e = 1; e < first.size(); ++e)
    {
      first[e] += first[e - 1];
    }
    std::vector<int> nodes(count - firstT12);
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int i = firstT12; i < count; ++i)
    {
      nodes[next[this->At(i).Origin[1]]++] = i;
    }
    this->NodesAt.assign(this->Level1.Points.size(), { { -1, -1 } });
    for (int t = 0; t < this->Slab.NumberOfT2; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int edge = 3 * t + k;
        if (CanonicalEdge(this->Level2, t, k) == edge)
        {
          this->LinkVoronoiEdge(t, k, nodes.data() + first[edge], nodes.data() + first[edge + 1]);
        }
      }
    }
  }

  /// Chain the nodes of one Voronoi edge of level 2 through the cells of level 1 that they share; a
  /// Voronoi edge passes through a convex cell once, so a cell has two of its nodes at most.
  void LinkVoronoiEdge(int t, int k, const int* begin, const int* end)
  {
    for (const int* i = begin; i != end; ++i)
    {
      for (int corner : { 0, 1 })
      {
        auto& slots = this->NodesAt[this->At(*i).Corners[corner]];
        slots[slots[0] < 0 ? 0 : 1] = *i;
      }
    }
    // T2's corners 1 and 2 are the triangle's 2 and 1.
    const auto cornerOfT2 = [](int corner) { return corner == 0 ? 0 : 3 - corner; };
    int previous = this->Slab.NumberOfT1 + t;
    int face = cornerOfT2(k);
    int cell = this->Apices2[t];
    for (const int* i = begin; i != end; ++i)
    {
      const auto& slots = this->NodesAt[cell];
      const int node = slots[0] == previous ? slots[1] : slots[0];
      if (node < 0)
      {
        throw Error("Joint Voronoi diagram: the crossings of a Voronoi edge do not form a chain.");
      }
      const int entered = this->At(node).Corners[0] == cell ? 0 : 1;
      this->At(node).Neighbours[1 - entered] =
        previous; // the face that holds `cell` and not the other
      this->At(previous).Neighbours[face] = node;
      previous = node;
      face = entered;
      cell = this->At(node).Corners[1 - entered];
    }
    for (const int* i = begin; i != end; ++i)
    {
      this->NodesAt[this->At(*i).Corners[0]] = { { -1, -1 } };
      this->NodesAt[this->At(*i).Corners[1]] = { { -1, -1 } };
    }
    const int last = this->Level2.Neighbours[t][k];
    if (last < 0)
    {
      return;
    }
    if (this->Apices2[last] != cell)
    {
      throw Error("Joint Voronoi diagram: a Voronoi edge of the upper level ends in a wrong cell.");
    }
    const auto& back = this->Level2.Neighbours[last];
    const int corner = cornerOfT2(back[0] == t ? 0 : (back[1] == t ? 1 : 2));
    this->At(this->Slab.NumberOfT1 + last).Neighbours[corner] = previous;
    this->At(previous).Neighbours[face] = this->Slab.NumberOfT1 + last;
  }

  static constexpr std::array<int, 4> None{ { -1, -1, -1, -1 } };

  const LevelTriangulation& Level1;
  const LevelTriangulation& Level2;
  VertexStars Stars1;
  VertexStars Stars2;
  CircumcentreDistance Distance1;
  CircumcentreDistance Distance2;
  std::vector<int> Apices1;
  std::vector<int> Apices2;
  std::vector<std::array<int, 2>> NodesAt; ///< of a cell of level 1: nodes of the edge being linked
  SlabTetrahedra Slab;
};
}

SlabTetrahedra BuildJointVoronoi(const LevelTriangulation& level1, const LevelTriangulation& level2)
{
  return Builder(level1, level2).Build();
}
}
