// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/LinkedMesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
int Next(int k)
{
  return k == 2 ? 0 : k + 1;
}

int Previous(int k)
{
  return k == 0 ? 2 : k - 1;
}
}

double TangentOfSmallestAngle(const Point3& a, const Point3& b, const Point3& c)
{
  // Opposite the shortest side, so never obtuse.
  const std::array<Vector3, 3> sides{ c - b, a - c, b - a };
  std::array<double, 3> squares{};
  std::transform(
    sides.begin(), sides.end(), squares.begin(), [](const Vector3& u) { return Dot(u, u); });
  const int shortest =
    squares[1] < squares[0] ? (squares[2] < squares[1] ? 2 : 1) : (squares[2] < squares[0] ? 2 : 0);
  const Vector3& u = sides[Next(shortest)];
  const Vector3& v = sides[Previous(shortest)];
  const double cosine = -Dot(u, v);
  return cosine > 0 ? Norm(Cross(u, v)) / cosine : 0;
}

double SmallestAngle(const Point3& a, const Point3& b, const Point3& c)
{
  return std::atan(TangentOfSmallestAngle(a, b, c));
}

LinkedMesh::LinkedMesh(const TriangleMesh& mesh, const std::vector<char>& parts)
  : Mesh(mesh),
    Points(Mesh.Points),
    Triangles(Mesh.Triangles),
    Parts(parts)
{
  this->Parts.resize(mesh.Triangles.size(), 0);
  this->Tangent.assign(mesh.Triangles.size(), Unknown);
  this->Link();
}

void LinkedMesh::Link()
{
  this->Neighbour.assign(this->Triangles.size(), { None, None, None });
  this->TriangleAt.assign(this->Points.size(), None);
  this->OnBorder.assign(this->Points.size(), 0);
  std::vector<std::tuple<int, int, int>> sides;
  sides.reserve(3 * this->Triangles.size());
  for (int t = 0; t < static_cast<int>(this->Triangles.size()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int u = this->Triangles[t][Next(k)];
      const int v = this->Triangles[t][Previous(k)];
      sides.emplace_back(std::min(u, v), std::max(u, v), 3 * t + k);
      this->TriangleAt[u] = t;
    }
  }
  std::sort(sides.begin(), sides.end());
  const auto sameEdge = [&](std::size_t i, std::size_t j)
  {
    return j < sides.size() && std::get<0>(sides[i]) == std::get<0>(sides[j]) &&
      std::get<1>(sides[i]) == std::get<1>(sides[j]);
  };
  const auto isForward = [this](int side)
  {
    const Triangle& corners = this->Triangles[side / 3];
    return corners[Next(side % 3)] < corners[Previous(side % 3)];
  };
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (sameEdge(i, end))
    {
      ++end;
    }
    // Two triangles that run along it both ways; else a walk around a point would not end.
    if (end == i + 2 && isForward(std::get<2>(sides[i])) != isForward(std::get<2>(sides[i + 1])))
    {
      const int one = std::get<2>(sides[i]);
      const int other = std::get<2>(sides[i + 1]);
      this->Neighbour[one / 3][one % 3] = other / 3;
      this->Neighbour[other / 3][other % 3] = one / 3;
    }
    else
    {
      this->OnBorder[std::get<0>(sides[i])] = 1;
      this->OnBorder[std::get<1>(sides[i])] = 1;
    }
    i = end;
  }
}

int LinkedMesh::CornerOf(int t, int v) const
{
  const Triangle& corners = this->Triangles[t];
  return corners[0] == v ? 0 : corners[1] == v ? 1 : corners[2] == v ? 2 : None;
}

const std::vector<int>& LinkedMesh::Around(int v) const
{
  this->Ring.clear();
  const int first = this->TriangleAt[v];
  int t = first;
  while (t >= 0)
  {
    this->Ring.push_back(t);
    t = this->Neighbour[t][Next(this->CornerOf(t, v))];
    if (t == first)
    {
      return this->Ring;
    }
  }
  // A border: on from the first the other way.
  for (t = first >= 0 ? this->Neighbour[first][Previous(this->CornerOf(first, v))] : None; t >= 0;
       t = this->Neighbour[t][Previous(this->CornerOf(t, v))])
  {
    this->Ring.insert(this->Ring.begin(), t);
  }
  return this->Ring;
}

std::vector<int> LinkedMesh::Neighbours(int v) const
{
  std::vector<int> points;
  for (const int t : this->Around(v))
  {
    const int k = this->CornerOf(t, v);
    for (const int w : { this->Triangles[t][Next(k)], this->Triangles[t][Previous(k)] })
    {
      if (std::find(points.begin(), points.end(), w) == points.end())
      {
        points.push_back(w);
      }
    }
  }
  return points;
}

std::pair<int, int> LinkedMesh::Find(int u, int v) const
{
  if (!this->IsAlivePoint(u) || !this->IsAlivePoint(v))
  {
    return { None, 0 };
  }
  for (const int t : this->Around(u))
  {
    if (this->CornerOf(t, v) != None)
    {
      return { t, 3 - this->CornerOf(t, u) - this->CornerOf(t, v) };
    }
  }
  return { None, 0 };
}

Vector3 LinkedMesh::AreaNormal(const Triangle& t) const
{
  return Cross(this->Points[t[1]] - this->Points[t[0]], this->Points[t[2]] - this->Points[t[0]]);
}

double LinkedMesh::LeastTangent(const Triangle& t) const
{
  return TangentOfSmallestAngle(this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]);
}

double LinkedMesh::SideLength(int t, int k) const
{
  // From the lower number, so that both triangles at an edge find the same bits.
  const auto [low, high] =
    std::minmax(this->Triangles[t][Next(k)], this->Triangles[t][Previous(k)]);
  return Norm(this->Points[high] - this->Points[low]);
}

int LinkedMesh::LongestSide(int t) const
{
  const double first = this->SideLength(t, 0);
  const double second = this->SideLength(t, 1);
  const double third = this->SideLength(t, 2);
  return second > first ? (third > second ? 2 : 1) : (third > first ? 2 : 0);
}

void LinkedMesh::Relink(int t, int was, int now)
{
  if (t >= 0)
  {
    std::replace(this->Neighbour[t].begin(), this->Neighbour[t].end(), was, now);
  }
}

int LinkedMesh::Split(int t, int k)
{
  // (a, b, c) and, across, (d, c, b) become (a, b, m), (a, m, c), (d, c, m), (d, m, b).
  const int a = this->Triangles[t][k];
  const int b = this->Triangles[t][Next(k)];
  const int c = this->Triangles[t][Previous(k)];
  const int across = this->Neighbour[t][k];
  const int ab = this->Neighbour[t][Previous(k)];
  const int ca = this->Neighbour[t][Next(k)];
  const int m = static_cast<int>(this->Points.size());
  const int half = static_cast<int>(this->Triangles.size());
  const int acrossHalf = across >= 0 ? half + 1 : None;
  this->Points.push_back(0.5 * (this->Points[b] + this->Points[c]));
  this->TriangleAt.push_back(t);
  this->OnBorder.push_back(across < 0 ? 1 : 0);
  this->Tangent[t] = Unknown;
  this->Tangent.push_back(Unknown);
  this->Triangles[t] = { a, b, m };
  this->Neighbour[t] = { acrossHalf, half, ab };
  this->Triangles.push_back({ a, m, c });
  this->Parts.push_back(this->Parts[t]);
  this->Neighbour.push_back({ across, ca, t });
  this->Relink(ca, t, half);
  this->TriangleAt[c] = half;
  this->TriangleAt[b] = t;
  this->TriangleAt[a] = t;
  if (across >= 0)
  {
    const int j = 3 - this->CornerOf(across, b) - this->CornerOf(across, c);
    const int d = this->Triangles[across][j];
    const int bd = this->Neighbour[across][Next(j)];
    const int dc = this->Neighbour[across][Previous(j)];
    this->Tangent[across] = Unknown;
    this->Tangent.push_back(Unknown);
    this->Triangles[across] = { d, c, m };
    this->Neighbour[across] = { half, acrossHalf, dc };
    this->Triangles.push_back({ d, m, b });
    this->Parts.push_back(this->Parts[across]);
    this->Neighbour.push_back({ t, bd, across });
    this->Relink(bd, across, acrossHalf);
    this->TriangleAt[d] = across;
  }
  return m;
}

bool LinkedMesh::MayFlip(int t, int k) const
{
  const int across = this->Neighbour[t][k];
  if (across < 0 || this->Parts[across] != this->Parts[t])
  {
    return false;
  }
  const int b = this->Triangles[t][Next(k)];
  const int c = this->Triangles[t][Previous(k)];
  const int d = this->Triangles[across][3 - this->CornerOf(across, b) - this->CornerOf(across, c)];
  const auto isLow = [this](int v)
  { return this->Around(v).size() < (this->OnBorder[v] ? 3u : 4u); };
  return d != this->Triangles[t][k] && !isLow(b) && !isLow(c) &&
    this->Find(this->Triangles[t][k], d).first == None;
}

void LinkedMesh::Flip(int t, int k)
{
  // (a, b, c) and (d, c, b) become (a, b, d) and (a, d, c).
  const int across = this->Neighbour[t][k];
  const int a = this->Triangles[t][k];
  const int b = this->Triangles[t][Next(k)];
  const int c = this->Triangles[t][Previous(k)];
  const int j = 3 - this->CornerOf(across, b) - this->CornerOf(across, c);
  const int d = this->Triangles[across][j];
  const int ab = this->Neighbour[t][Previous(k)];
  const int ca = this->Neighbour[t][Next(k)];
  const int bd = this->Neighbour[across][Next(j)];
  const int dc = this->Neighbour[across][Previous(j)];
  this->Tangent[t] = this->Tangent[across] = Unknown;
  this->Triangles[t] = { a, b, d };
  this->Neighbour[t] = { bd, across, ab };
  this->Triangles[across] = { a, d, c };
  this->Neighbour[across] = { dc, ca, t };
  this->Relink(bd, across, t);
  this->Relink(ca, t, across);
  this->TriangleAt[a] = t;
  this->TriangleAt[b] = t;
  this->TriangleAt[c] = across;
  this->TriangleAt[d] = t;
}

bool LinkedMesh::IsOnCrease(int v) const
{
  const std::vector<int>& around = this->Around(v);
  return std::any_of(around.begin(), around.end(),
    [&](int t) { return this->Parts[t] != this->Parts[around.front()]; });
}

/// A crease may become shorter along itself, where it runs through a point once, and nowhere else.
bool LinkedMesh::KeepsCrease(int from, int into) const
{
  int creases = 0;
  bool along = false;
  for (const int t : this->Around(from))
  {
    const int k = Next(this->CornerOf(t, from));
    const int across = this->Neighbour[t][k];
    if (across >= 0 && this->Parts[across] != this->Parts[t])
    {
      ++creases;
      along = along || this->Triangles[t][Next(k)] == into;
    }
  }
  return creases == 0 || (creases == 2 && along);
}

bool LinkedMesh::MayCollapse(int from, int into) const
{
  if (this->OnBorder[from] || !this->KeepsCrease(from, into))
  {
    return false;
  }
  const std::vector<int> these = this->Neighbours(from);
  const std::vector<int> those = this->Neighbours(into);
  int shared = 0;
  for (const int w : these)
  {
    if (std::find(those.begin(), those.end(), w) == those.end())
    {
      continue;
    }
    ++shared;
    if (this->Around(w).size() < (this->OnBorder[w] ? 3u : 4u))
    {
      return false;
    }
  }
  return shared == 2;
}

/// A triangle on the collapsed edge goes; its other neighbours meet.
bool LinkedMesh::TakeAway(int t, int from, int into)
{
  if (this->CornerOf(t, into) == None)
  {
    return false;
  }
  const int atFrom = this->Neighbour[t][this->CornerOf(t, into)];
  const int atInto = this->Neighbour[t][this->CornerOf(t, from)];
  const int apex = this->Triangles[t][3 - this->CornerOf(t, from) - this->CornerOf(t, into)];
  this->Relink(atFrom, t, atInto);
  this->Relink(atInto, t, atFrom);
  this->TriangleAt[apex] = atFrom >= 0 ? atFrom : atInto;
  this->TriangleAt[into] = atInto >= 0 ? atInto : atFrom;
  this->Triangles[t] = { None, None, None };
  return true;
}

void LinkedMesh::Collapse(int from, int into)
{
  const std::vector<int> around = this->Around(from);
  this->Forget(around);
  for (const int t : around)
  {
    if (!this->TakeAway(t, from, into))
    {
      std::replace(this->Triangles[t].begin(), this->Triangles[t].end(), from, into);
    }
  }
  this->TriangleAt[from] = None;
}

LinkedMesh::Memory LinkedMesh::Remember(const std::vector<int>& triangles) const
{
  Memory memory;
  memory.Numbers = triangles;
  for (const int t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (this->Neighbour[t][k] >= 0)
      {
        memory.Numbers.push_back(this->Neighbour[t][k]);
      }
      memory.Points.emplace_back(this->Triangles[t][k], this->TriangleAt[this->Triangles[t][k]]);
    }
  }
  for (const int t : memory.Numbers)
  {
    memory.Triangles.push_back({ this->Triangles[t], this->Neighbour[t] });
  }
  return memory;
}

void LinkedMesh::PutBack(const Memory& memory)
{
  this->Forget(memory.Numbers);
  for (std::size_t i = 0; i < memory.Numbers.size(); ++i)
  {
    this->Triangles[memory.Numbers[i]] = memory.Triangles[i][0];
    this->Neighbour[memory.Numbers[i]] = memory.Triangles[i][1];
  }
  for (const auto& [point, triangle] : memory.Points)
  {
    this->TriangleAt[point] = triangle;
  }
}

TriangleMesh LinkedMesh::Compact(std::vector<int>* oldNumbers) const
{
  TriangleMesh mesh;
  std::vector<int> renamed(this->Points.size(), None);
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    if (this->TriangleAt[v] >= 0)
    {
      renamed[v] = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(this->Points[v]);
      if (oldNumbers)
      {
        oldNumbers->push_back(static_cast<int>(v));
      }
    }
  }
  for (const Triangle& t : this->Triangles)
  {
    if (t[0] >= 0)
    {
      mesh.Triangles.push_back({ renamed[t[0]], renamed[t[1]], renamed[t[2]] });
    }
  }
  return mesh;
}

std::vector<char> LinkedMesh::CompactParts() const
{
  std::vector<char> parts;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->Triangles[t][0] >= 0)
    {
      parts.push_back(this->Parts[t]);
    }
  }
  return parts;
}
}
