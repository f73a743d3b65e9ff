// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"

#include "Base/DisjointSets.h"
#include "Base/Monitor.h"
#include "Base/PointHash.h"
#include "Base/Predicates.h"
#include "Mesh/ComponentNesting.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/MassProperties.h"
#include "Mesh/MeshDefects.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string>
#include <unordered_map>

namespace recon
{
namespace
{
/// One run of CheckTopology.
class Checker
{
public:
  explicit Checker(const TriangleMesh& mesh)
    : Mesh(mesh),
      Edges(SortEdges(mesh)),
      Fans(3 * mesh.Triangles.size())
  {
  }

  MeshTopology Run()
  {
    this->Result.DefectOfTriangle.assign(this->Mesh.Triangles.size(), 0);
    this->FindComponents();
    ForEachEdge(this->Edges, [this](const EdgeGroup& edge) { this->VisitEdge(edge); });
    this->CountPoints();
    this->CountTriangles();
    for (auto& component : this->Result.Components)
    {
      Judge(component);
    }
    this->JudgeOutward();
    this->SumUp();
    return std::move(this->Result);
  }

private:
  void FindComponents()
  {
    const auto& triangles = this->Mesh.Triangles;
    DisjointSets sets(this->Mesh.Points.size());
    for (const auto& t : triangles)
    {
      if (!IsCollapsed(t))
      {
        sets.Join(t[0], t[1]);
        sets.Join(t[1], t[2]);
      }
    }
    std::vector<int> componentOfSet(this->Mesh.Points.size(), -1);
    int count = 0;
    for (const auto& t : triangles)
    {
      if (!IsCollapsed(t) && componentOfSet[sets.Find(t[0])] < 0)
      {
        componentOfSet[sets.Find(t[0])] = count++;
      }
    }
    this->Result.Components.resize(count);
    this->HasOddEdge.assign(count, false);
    this->ComponentOfPoint.resize(this->Mesh.Points.size());
    for (std::size_t p = 0; p < this->Mesh.Points.size(); ++p)
    {
      this->ComponentOfPoint[p] = componentOfSet[sets.Find(static_cast<int>(p))];
    }
    for (const auto& t : triangles)
    {
      // A collapsed triangle belongs where one of its corners is in use, if anywhere.
      const auto& of = this->ComponentOfPoint;
      this->Result.ComponentOfTriangle.push_back(std::max({ of[t[0]], of[t[1]], of[t[2]] }));
    }
  }

  TopologyFigures& ComponentAt(int point)
  {
    return this->Result.Components[this->ComponentOfPoint[point]];
  }

  void Mark(const EdgeGroup& edge, int defect)
  {
    for (const EdgeSide* side = edge.Begin; side != edge.End; ++side)
    {
      this->Result.DefectOfTriangle[side->Corner / 3] |= defect;
    }
  }

  void VisitEdge(const EdgeGroup& edge)
  {
    TopologyFigures& figures = this->ComponentAt(edge.Low);
    ++figures.Edges;
    if (edge.Count() == 1)
    {
      ++figures.OpenEdges;
      this->Mark(edge, DefectOpenEdge);
      return;
    }
    for (const EdgeSide* side = edge.Begin; side != edge.End; ++side)
    {
      this->JoinFans(*edge.Begin, *side);
    }
    if (!IsOriented(this->Mesh, edge))
    {
      ++figures.MisorientedEdges;
      this->Mark(edge, DefectMisorientedEdge);
    }
    if (edge.Count() > 2)
    {
      ++figures.OverusedEdges;
      if (edge.Count() % 2 != 0)
      {
        this->HasOddEdge[this->ComponentOfPoint[edge.Low]] = true;
      }
      this->Mark(edge, DefectOverusedEdge);
    }
    this->FindDuplicates(edge, figures);
  }

  /// The corners of two triangles at the two ends of an edge that they share are of one fan each.
  void JoinFans(const EdgeSide& a, const EdgeSide& b)
  {
    const int lowA = this->CornerAtLow(a);
    const int lowB = this->CornerAtLow(b);
    this->Fans.Join(lowA, lowB);
    this->Fans.Join(this->OtherEnd(a, lowA), this->OtherEnd(b, lowB));
  }

  static int NextCorner(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  int CornerAtLow(const EdgeSide& side) const
  {
    return RunsUpward(this->Mesh, side) ? side.Corner : NextCorner(side.Corner);
  }

  static int OtherEnd(const EdgeSide& side, int corner)
  {
    return corner == side.Corner ? NextCorner(side.Corner) : side.Corner;
  }

  int PointOpposite(const EdgeSide& side) const
  {
    return this->Mesh.Triangles[side.Corner / 3][(side.Corner % 3 + 2) % 3];
  }

  /// Triangles on the same points share three edges; they are compared at the one of the two
  /// smallest points.
  void FindDuplicates(const EdgeGroup& edge, TopologyFigures& figures)
  {
    this->Opposite.clear();
    for (const EdgeSide* side = edge.Begin; side != edge.End; ++side)
    {
      const int third = this->PointOpposite(*side);
      if (third > edge.High)
      {
        this->Opposite.emplace_back(third, side->Corner / 3);
      }
    }
    std::sort(this->Opposite.begin(), this->Opposite.end());
    for (std::size_t i = 1; i < this->Opposite.size(); ++i)
    {
      if (this->Opposite[i].first == this->Opposite[i - 1].first)
      {
        ++figures.DuplicateTriangles;
        this->Result.DefectOfTriangle[this->Opposite[i].second] |= DefectDuplicate;
        this->Result.DefectOfTriangle[this->Opposite[i - 1].second] |= DefectDuplicate;
      }
    }
  }

  void CountPoints()
  {
    std::vector<int> fansOfPoint(this->Mesh.Points.size(), 0);
    const int corners = static_cast<int>(3 * this->Mesh.Triangles.size());
    for (int c = 0; c < corners; ++c)
    {
      const auto& t = this->Mesh.Triangles[c / 3];
      if (!IsCollapsed(t) && this->Fans.Find(c) == c)
      {
        ++fansOfPoint[t[c % 3]];
      }
    }
    for (std::size_t p = 0; p < fansOfPoint.size(); ++p)
    {
      if (fansOfPoint[p] == 0)
      {
        continue;
      }
      TopologyFigures& figures = this->ComponentAt(static_cast<int>(p));
      ++figures.Points;
      figures.PinchedVertices += fansOfPoint[p] > 1 ? 1 : 0;
    }
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      const auto& corners3 = this->Mesh.Triangles[t];
      const bool pinched =
        std::any_of(corners3.begin(), corners3.end(), [&](int p) { return fansOfPoint[p] > 1; });
      if (pinched && !IsCollapsed(corners3))
      {
        this->Result.DefectOfTriangle[t] |= DefectPinchedVertex;
      }
    }
  }

  void CountTriangles()
  {
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      const auto& t = this->Mesh.Triangles[i];
      const auto& points = this->Mesh.Points;
      const int component = this->Result.ComponentOfTriangle[i];
      TopologyFigures& figures =
        component < 0 ? this->Result.Total : this->Result.Components[component];
      ++figures.Triangles;
      if (IsCollapsed(t) || Collinear(points[t[0]], points[t[1]], points[t[2]]))
      {
        ++figures.DegenerateTriangles;
        this->Result.DefectOfTriangle[i] |= DefectDegenerate;
      }
      figures.Euler += IsCollapsed(t) ? 0 : 1;
    }
    for (std::size_t c = 0; c < this->Result.Components.size(); ++c)
    {
      TopologyFigures& figures = this->Result.Components[c];
      figures.Components = 1;
      figures.Euler += figures.Points - figures.Edges;
      figures.Closed = figures.OpenEdges == 0 && !this->HasOddEdge[c];
    }
  }

  /// All but Closed and Outward, which need more than the counts.
  static void Judge(TopologyFigures& figures)
  {
    figures.EdgeManifold = figures.OverusedEdges == 0;
    figures.VertexManifold = figures.PinchedVertices == 0;
    figures.Oriented = figures.MisorientedEdges == 0;
    if (figures.Closed && figures.Manifold() && figures.Oriented)
    {
      figures.Genus = (2 - figures.Euler) / 2;
    }
  }

  void JudgeOutward()
  {
    const int count = static_cast<int>(this->Result.Components.size());
    std::vector<bool> encloses;
    for (const auto& component : this->Result.Components)
    {
      encloses.push_back(component.EnclosesVolume());
    }
    this->Result.Nesting =
      FindComponentNesting(this->Mesh, this->Result.ComponentOfTriangle, encloses);
    const auto volumes = ComputeSignedVolumes(this->Mesh, this->Result.ComponentOfTriangle, count);
    for (int c = 0; c < count; ++c)
    {
      const bool cavity = this->Result.Nesting[c] % 2 != 0;
      this->Result.Components[c].Outward =
        encloses[c] && (cavity ? volumes[c] < 0 : volumes[c] > 0);
    }
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      const int c = this->Result.ComponentOfTriangle[t];
      if (c >= 0 && encloses[c] && !this->Result.Components[c].Outward)
      {
        this->Result.DefectOfTriangle[t] |= DefectInward;
      }
    }
  }

  /// Total already holds the collapsed triangles that belong to no component.
  void SumUp()
  {
    TopologyFigures& total = this->Result.Total;
    const bool any = !this->Result.Components.empty();
    total.Closed = total.EdgeManifold = total.VertexManifold = total.Oriented = total.Outward = any;
    total.Genus = any ? std::optional<int>(0) : std::nullopt;
    for (const auto& c : this->Result.Components)
    {
      total.Triangles += c.Triangles;
      total.Points += c.Points;
      total.Edges += c.Edges;
      total.Components += c.Components;
      total.OpenEdges += c.OpenEdges;
      total.OverusedEdges += c.OverusedEdges;
      total.MisorientedEdges += c.MisorientedEdges;
      total.PinchedVertices += c.PinchedVertices;
      total.DuplicateTriangles += c.DuplicateTriangles;
      total.DegenerateTriangles += c.DegenerateTriangles;
      total.Euler += c.Euler;
      total.Closed = total.Closed && c.Closed;
      total.EdgeManifold = total.EdgeManifold && c.EdgeManifold;
      total.VertexManifold = total.VertexManifold && c.VertexManifold;
      total.Oriented = total.Oriented && c.Oriented;
      total.Outward = total.Outward && c.Outward;
      total.Genus =
        total.Genus && c.Genus ? std::optional<int>(*total.Genus + *c.Genus) : std::nullopt;
    }
  }

  const TriangleMesh& Mesh;
  EdgeTable Edges;
  DisjointSets Fans; ///< of corners, 3 * triangle + k
  std::vector<int> ComponentOfPoint;
  std::vector<bool> HasOddEdge;              ///< has an edge of 3, 5, ... triangles
  std::vector<std::pair<int, int>> Opposite; ///< third point and triangle, reused by FindDuplicates
  MeshTopology Result;
};

}

void RequireUsable(const TriangleMesh& mesh)
{
  const int points = static_cast<int>(mesh.Points.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (const int p : mesh.Triangles[t])
    {
      if (p < 0 || p >= points)
      {
        throw Error("Triangle " + std::to_string(t) + " refers to point " + std::to_string(p) +
          " of " + std::to_string(points) + "; the surface is not whole, read it again.");
      }
      const Point3& x = mesh.Points[p];
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        throw Error("Point " + std::to_string(p) +
          " of the surface has a coordinate that is no "
          "finite number; remove it, for nothing can be said about such a surface.");
      }
    }
  }
}

MeshTopology CheckTopology(const TriangleMesh& mesh)
{
  RequireUsable(mesh);
  return Checker(mesh).Run();
}

TriangleMesh WeldPoints(const TriangleMesh& mesh)
{
  RequireUsable(mesh);
  std::unordered_map<Point3, int, PointHash> numbers(mesh.Points.size());
  std::vector<int> renamed(mesh.Points.size());
  TriangleMesh result;
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    const auto [at, isNew] =
      numbers.emplace(mesh.Points[p], static_cast<int>(result.Points.size()));
    if (isNew)
    {
      result.Points.push_back(mesh.Points[p]);
    }
    renamed[p] = at->second;
  }
  result.Triangles = mesh.Triangles;
  for (auto& t : result.Triangles)
  {
    for (int& p : t)
    {
      p = renamed[p];
    }
  }
  return result;
}
}
