// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/JointVoronoi.h"

#include "Base/Monitor.h"
#include "Base/StopSignal.h"
#include "Polyhedral/VoronoiEdgeWalk.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace recon
{
namespace
{
using Tetrahedron = SlabTetrahedra::Tetrahedron;

constexpr std::array<int, 4> None{ { -1, -1, -1, -1 } };

class Builder
{
public:
  Builder(const JointCells& cells, std::size_t maximumT12)
    : Cells(cells),
      Level1(cells.LevelAt(0)),
      Level2(cells.LevelAt(1)),
      Apices1(cells.Apices(0)),
      Apices2(cells.Apices(1)),
      Maximum(maximumT12)
  {
  }

  std::optional<SlabTetrahedra> Build()
  {
    AddNodesOfVoronoiVertices(this->Cells, this->Slab);
    this->Maximum += std::min(
      std::numeric_limits<std::size_t>::max() - this->Maximum, this->Slab.Tetrahedra.size());
    for (int t = 0; t < this->Slab.NumberOfT1; ++t)
    {
      ThrowIfStopped();
      for (int k = 0; k < 3; ++k)
      {
        if (CanonicalEdge(this->Level1, t, k) == 3 * t + k)
        {
          this->AddNodesOfVoronoiEdge(t, k);
        }
      }
      if (this->Slab.Tetrahedra.size() > this->Maximum)
      {
        return std::nullopt;
      }
    }
    this->LinkAlongLevel2();
    return std::move(this->Slab);
  }

private:
  Tetrahedron& At(int i) { return this->Slab.Tetrahedra[i]; }

  /// T12 nodes on the Voronoi edge of level 1 that leaves triangle t across corner k.
  void AddNodesOfVoronoiEdge(int t, int k)
  {
    const auto& corners = this->Level1.Triangles[t];
    const int a = corners[(k + 1) % 3];
    const int b = corners[(k + 2) % 3];
    const int end = this->Level1.Neighbours[t][k];
    const int lastCell = end < 0 ? -1 : this->Apices1[end];
    const VoronoiEdgeWalk walk(this->Cells, 0, this->Level1.Points[a], this->Level1.Points[b]);

    int previous = t; // the tetrahedron before, and its corner opposite the face passed through
    int face = k;
    int cell = this->Apices1[t];
    int cameFrom = -1;
    std::size_t steps = 0;
    while (cell != lastCell)
    {
      const auto exit = walk.Leave(cell, cameFrom);
      if (exit && exit->Cell < 0 && end < 0)
      {
        break;
      }
      if (!exit || exit->Cell < 0 || ++steps > this->Level2.Points.size())
      {
        throw Error("Joint Voronoi diagram: a Voronoi edge did not reach its end.");
      }
      const int added = static_cast<int>(this->Slab.Tetrahedra.size());
      this->Slab.Tetrahedra.push_back({ { a, b, cell, exit->Cell }, None,
        { 3 * t + k, exit->DelaunayEdge }, SlabTetrahedra::T12, SlabTetrahedra::Kept });
      this->At(added).Neighbours[3] = previous;
      this->At(previous).Neighbours[face] = added;
      previous = added;
      face = 2;
      cell = exit->Cell;
      cameFrom = exit->SideA;
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

  const JointCells& Cells;
  const LevelTriangulation& Level1;
  const LevelTriangulation& Level2;
  const std::vector<int>& Apices1;
  const std::vector<int>& Apices2;
  std::size_t Maximum;                     ///< tetrahedra of all types
  std::vector<std::array<int, 2>> NodesAt; ///< of a cell of level 1: nodes of the edge being linked
  SlabTetrahedra Slab;
};
}

void AddNodesOfVoronoiVertices(const JointCells& cells, SlabTetrahedra& slab)
{
  for (const int level : { 0, 1 })
  {
    const auto& triangles = cells.LevelAt(level).Triangles;
    const auto node = level == 0 ? SlabTetrahedra::T1 : SlabTetrahedra::T2;
    const auto& apices = cells.Apices(level);
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    {
      // The apex of T2 lies below, so its corners run the other way round to be positively oriented.
      const auto& c = triangles[t];
      const int second = c[level == 0 ? 1 : 2];
      const int third = c[level == 0 ? 2 : 1];
      slab.Tetrahedra.push_back(
        { { c[0], second, third, apices[t] }, None, { t, -1 }, node, SlabTetrahedra::Kept });
    }
  }
  slab.NumberOfT1 = static_cast<int>(cells.LevelAt(0).Triangles.size());
  slab.NumberOfT2 = static_cast<int>(cells.LevelAt(1).Triangles.size());
}

SlabTetrahedra BuildJointVoronoi(const LevelTriangulation& level1, const LevelTriangulation& level2)
{
  const JointCells cells(level1, level2);
  return *BuildJointVoronoi(cells, std::numeric_limits<std::size_t>::max());
}

std::optional<SlabTetrahedra> BuildJointVoronoi(const JointCells& cells, std::size_t maximumT12)
{
  return Builder(cells, maximumT12).Build();
}
}
