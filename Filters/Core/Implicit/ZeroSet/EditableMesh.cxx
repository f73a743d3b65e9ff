// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/EditableMesh.h"

#include "Base/Angles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace recon
{
Vector3 FaceNormal(int face)
{
  Vector3 normal{ 0, 0, 0 };
  normal[(face - 1) / 2] = face % 2 == 0 ? 1 : -1;
  return normal;
}

EditableMesh::EditableMesh(
  TriangleMesh& mesh, std::vector<Vector3>& normals, const std::vector<char>& faces)
  : P(mesh.Points),
    N(normals),
    T(mesh.Triangles),
    Around(mesh.Points.size()),
    Faces(faces),
    Border(mesh.Points.size(), 0),
    Pinned(mesh.Points.size(), 0)
{
  this->Faces.resize(this->T.size(), 0);
  for (int t = 0; t < static_cast<int>(this->T.size()); ++t)
  {
    for (const int v : this->T[t])
    {
      this->Around[v].push_back(t);
    }
  }
  for (int v = 0; v < static_cast<int>(this->P.size()); ++v)
  {
    this->FindBorder(v);
  }
}

void EditableMesh::FindBorder(int v)
{
  int creases = 0;
  for (const int w : this->Neighbours(v))
  {
    const bool isBorder = this->TrianglesAt(v, w).size() == 1;
    if (isBorder)
    {
      this->Border[v] = OnBorder;
    }
    else if (this->IsBorderEdge(v, w))
    {
      ++creases;
      this->Border[v] = this->Border[v] == OnBorder ? OnBorder : OnCrease;
    }
  }
  // Where creases meet there is a corner.
  this->Pinned[v] = creases > 2 ? 1 : 0;
}

bool EditableMesh::IsBorderEdge(int u, int v) const
{
  const std::vector<int> at = this->TrianglesAt(u, v);
  return at.size() == 1 || (at.size() == 2 && this->Faces[at[0]] != this->Faces[at[1]]);
}

Vector3 EditableMesh::NormalAt(int v, int face) const
{
  return face == 0 ? this->N[v] : FaceNormal(face);
}

std::vector<int> EditableMesh::Neighbours(int v) const
{
  std::vector<int> all;
  for (const int t : this->Around[v])
  {
    for (const int w : this->T[t])
    {
      if (w != v)
      {
        all.push_back(w);
      }
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<int> EditableMesh::TrianglesAt(int u, int v) const
{
  std::vector<int> found;
  for (const int t : this->Around[u])
  {
    if (Has(this->T[t], v))
    {
      found.push_back(t);
    }
  }
  return found;
}

std::vector<std::pair<int, int>> EditableMesh::EdgesShorterThan(double limit) const
{
  std::vector<std::tuple<double, int, int>> edges;
  for (const Triangle& t : this->T)
  {
    for (int k = 0; k < 3 && t[0] >= 0; ++k)
    {
      const int u = t[k];
      const int v = t[(k + 1) % 3];
      const double length = Norm(this->P[v] - this->P[u]);
      if (length < limit)
      {
        edges.emplace_back(length, std::min(u, v), std::max(u, v));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [length, u, v] : edges)
  {
    pairs.emplace_back(u, v);
  }
  return pairs;
}

double EditableMesh::AngleOf(const Triangle& t) const
{
  const Vector3 ab = this->P[t[1]] - this->P[t[0]];
  const Vector3 bc = this->P[t[2]] - this->P[t[1]];
  const Vector3 ca = this->P[t[0]] - this->P[t[2]];
  return std::atan2(1.0, CotangentOfSmallestAngle(ab, bc, ca, Norm(Cross(ab, bc))));
}

double EditableMesh::LongestEdge(const Triangle& t) const
{
  return std::max({ Norm(this->P[t[1]] - this->P[t[0]]), Norm(this->P[t[2]] - this->P[t[1]]),
    Norm(this->P[t[0]] - this->P[t[2]]) });
}

Vector3 EditableMesh::AreaNormal(const Triangle& t) const
{
  return Cross(this->P[t[1]] - this->P[t[0]], this->P[t[2]] - this->P[t[0]]);
}

bool EditableMesh::LinkAllows(int u, int v) const
{
  const std::vector<int> shared = this->TrianglesAt(u, v);
  if (shared.empty() || shared.size() > 2)
  {
    return false;
  }
  // Two border vertices across an inner edge: the border would be pinched.
  if (this->Border[u] && this->Border[v] && !this->IsBorderEdge(u, v))
  {
    return false;
  }
  const std::vector<int> nu = this->Neighbours(u);
  const std::vector<int> nv = this->Neighbours(v);
  std::vector<int> common;
  std::set_intersection(nu.begin(), nu.end(), nv.begin(), nv.end(), std::back_inserter(common));
  if (common.size() != shared.size())
  {
    return false;
  }
  for (const int w : common)
  {
    if (this->Around[w].size() < (this->Border[w] == OnBorder ? 2u : 4u))
    {
      return false;
    }
  }
  return true;
}

void EditableMesh::Merge(int u, int v)
{
  const std::vector<int> all = this->Around[u];
  for (const int t : all)
  {
    if (Has(this->T[t], v))
    {
      this->Detach(t);
      this->T[t] = { -1, -1, -1 };
      continue;
    }
    Triangle moved = this->T[t];
    std::replace(moved.begin(), moved.end(), u, v);
    this->Replace(t, moved);
  }
}

EditableMesh::Changes EditableMesh::Remember(const std::vector<int>& triangles) const
{
  Changes all;
  for (const int t : triangles)
  {
    all.emplace_back(t, this->T[t]);
  }
  return all;
}

void EditableMesh::Compact()
{
  std::vector<int> renamed(this->P.size(), -1);
  std::size_t points = 0;
  std::size_t triangles = 0;
  for (const Triangle& t : this->T)
  {
    if (t[0] >= 0)
    {
      this->T[triangles++] = t;
    }
  }
  this->T.resize(triangles);
  for (std::size_t v = 0; v < this->P.size(); ++v)
  {
    if (!this->Around[v].empty())
    {
      renamed[v] = static_cast<int>(points);
      this->P[points] = this->P[v];
      this->N[points] = this->N[v];
      ++points;
    }
  }
  this->P.resize(points);
  this->N.resize(points);
  for (Triangle& t : this->T)
  {
    for (int& v : t)
    {
      v = renamed[v];
    }
  }
}

int EditableMesh::Third(const Triangle& t, int u, int v)
{
  for (const int w : t)
  {
    if (w != u && w != v)
    {
      return w;
    }
  }
  return -1;
}

bool EditableMesh::Follows(const Triangle& t, int u, int v)
{
  return (t[0] == u && t[1] == v) || (t[1] == u && t[2] == v) || (t[2] == u && t[0] == v);
}

void EditableMesh::Detach(int t)
{
  for (const int v : this->T[t])
  {
    auto& list = this->Around[v];
    list.erase(std::find(list.begin(), list.end(), t));
  }
}

void EditableMesh::Attach(int t)
{
  for (const int v : this->T[t])
  {
    this->Around[v].push_back(t);
  }
  if (this->Changed)
  {
    this->Changed(t);
  }
}

void EditableMesh::Replace(int t, const Triangle& by)
{
  this->Detach(t);
  this->T[t] = by;
  this->Attach(t);
}

void EditableMesh::Restore(const Changes& before)
{
  for (const auto& [t, old] : before)
  {
    if (this->IsAlive(t))
    {
      this->Detach(t);
    }
    this->T[t] = old;
    this->Attach(t);
  }
}

void EditableMesh::MoveTo(int v, const Point3& to)
{
  this->P[v] = to;
  if (!this->Changed)
  {
    return;
  }
  for (const int t : this->Around[v])
  {
    this->Changed(t);
  }
}
}
