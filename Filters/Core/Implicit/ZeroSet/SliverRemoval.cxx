// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/SliverRemoval.h"

#include "Base/Angles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace recon
{
namespace
{
/// A needle that can neither be flipped nor collapsed, as its short edge is the waist of a neck,
/// has an end of that edge moved along the surface: by so many edge lengths, in so many directions.
constexpr double Shifts[] = { 0.02, 0.04, 0.08, 0.16 };
constexpr int ShiftDirections = 8;
constexpr int MaximumShiftPasses = 8;
constexpr int MaximumSliverPasses = 12;

/// One try at each sliver: the diagonal across it, or its shortest edge away.
std::size_t MendSlivers(Remesher& remesher, double angle, const Agreement& agreement)
{
  const EditableMesh& mesh = remesher.Edited;
  std::size_t mended = 0;
  for (std::size_t t = 0; t < mesh.T.size(); ++t)
  {
    if (mesh.T[t][0] < 0 || mesh.AngleOf(mesh.T[t]) >= angle)
    {
      continue;
    }
    std::array<std::tuple<double, int, int>, 3> edges;
    for (int k = 0; k < 3; ++k)
    {
      const int u = mesh.T[t][k];
      const int v = mesh.T[t][(k + 1) % 3];
      edges[k] = { Norm(mesh.P[v] - mesh.P[u]), u, v };
    }
    std::sort(edges.begin(), edges.end());
    const auto [longest, a, b] = edges[2];
    bool changed = remesher.Flip(a, b, agreement);
    for (int k = 0; k < 3 && !changed; ++k)
    {
      changed = remesher.Collapse(std::get<1>(edges[k]), std::get<2>(edges[k]), agreement);
    }
    mended += changed ? 1 : 0;
  }
  return mended;
}

/// Places along the surface that a vertex may be moved to.
struct ShiftedVertices
{
  std::vector<int> Vertices;
  std::vector<Point3> Points;
  std::vector<Vector3> Normals;
  std::vector<char> Done;

  void Add(const EditableMesh& mesh, int v, double edgeLength)
  {
    const Vector3& n = mesh.N[v];
    const int least = std::abs(n[0]) < std::abs(n[1]) ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                                                      : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
    Vector3 axis{ 0, 0, 0 };
    axis[least] = 1;
    const Vector3 u = (1 / Norm(Cross(axis, n))) * Cross(axis, n);
    const Vector3 w = Cross(n, u);
    for (const double shift : Shifts)
    {
      for (int k = 0; k < ShiftDirections; ++k)
      {
        const double angle = 2 * Pi * k / ShiftDirections;
        this->Vertices.push_back(v);
        this->Points.push_back(mesh.P[v] + (shift * edgeLength * std::cos(angle)) * u +
          (shift * edgeLength * std::sin(angle)) * w);
      }
    }
  }

  /// Along the crease that it is on.
  void AddOnCrease(const EditableMesh& mesh, int v, double edgeLength)
  {
    for (const int w : mesh.Neighbours(v))
    {
      const Vector3 edge = mesh.P[w] - mesh.P[v];
      const double length = Norm(edge);
      for (const double shift : Shifts)
      {
        if (mesh.IsBorderEdge(v, w) && shift * edgeLength < length)
        {
          this->Vertices.push_back(v);
          this->Points.push_back(mesh.P[v] + (shift * edgeLength / length) * edge);
        }
      }
    }
  }
};

/// Moves the ends of needles' short edges to where the least angle around them is largest.
std::size_t ShiftNeedles(Remesher& remesher, const Projector& project)
{
  const EditableMesh& mesh = remesher.Edited;
  ShiftedVertices shifted;
  for (const EditableMesh::Triangle& t : mesh.T)
  {
    if (t[0] < 0 || mesh.AngleOf(t) >= NeedleAngle * RadiansPerDegree)
    {
      continue;
    }
    for (const int v : t)
    {
      if (!mesh.Border[v] && !mesh.Pinned[v] && Norm(mesh.N[v]) > 0.5)
      {
        shifted.Add(mesh, v, remesher.EdgeLength);
      }
      else if (mesh.Border[v] == EditableMesh::OnCrease && !mesh.Pinned[v])
      {
        shifted.AddOnCrease(mesh, v, remesher.EdgeLength);
      }
    }
  }
  if (shifted.Points.empty())
  {
    return 0;
  }
  project(shifted.Points, shifted.Normals, shifted.Done);
  std::size_t moved = 0;
  for (std::size_t from = 0, to = 0; from < shifted.Points.size(); from = to)
  {
    const int v = shifted.Vertices[from];
    while (to < shifted.Points.size() && shifted.Vertices[to] == v)
    {
      ++to;
    }
    const double before = remesher.QualityAround(v, WithItself);
    if (before >= NeedleAngle * RadiansPerDegree)
    {
      continue;
    }
    std::vector<std::pair<double, std::size_t>> better;
    for (std::size_t i = from; i < to; ++i)
    {
      const double quality = shifted.Done[i] ? remesher.QualityOfMove(v, shifted.Points[i]) : -1;
      if (quality > before)
      {
        better.emplace_back(-quality, i);
      }
    }
    std::sort(better.begin(), better.end());
    // The best one where nothing crosses.
    moved += std::any_of(better.begin(), better.end(),
               [&](const auto& place)
               {
                 const std::size_t i = place.second;
                 const Vector3 normal =
                   mesh.Border[v] == EditableMesh::OnCrease ? mesh.N[v] : shifted.Normals[i];
                 return remesher.Move(v, shifted.Points[i], normal, true);
               })
      ? 1
      : 0;
  }
  return moved;
}
}

void RemoveSlivers(Remesher& remesher, const Projector& project)
{
  for (int pass = 0; pass < MaximumSliverPasses; ++pass)
  {
    const Agreement& agreement = pass < MaximumSliverPasses / 2 ? Usual : LastResort;
    if (MendSlivers(remesher, SliverAngle * RadiansPerDegree, agreement) == 0 && pass > 0)
    {
      break;
    }
    remesher.FlipEdges();
    if (pass % 3 == 2)
    {
      remesher.Spread(project);
    }
  }
  for (int pass = 0; pass < MaximumSliverPasses; ++pass)
  {
    if (MendSlivers(remesher, NeedleAngle * RadiansPerDegree, WithItself) == 0)
    {
      break;
    }
  }
  for (int pass = 0; pass < MaximumShiftPasses; ++pass)
  {
    if (ShiftNeedles(remesher, project) == 0)
    {
      break;
    }
    MendSlivers(remesher, NeedleAngle * RadiansPerDegree, WithItself);
  }
}
}
