// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MeshShapes.h
 * @brief Meshes with known answers.
 */
#ifndef recon_Testing_MeshShapes_h
#define recon_Testing_MeshShapes_h

#include "Mesh/TriangleMesh.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace recon
{
namespace testing
{
constexpr double Pi = 3.14159265358979323846;

/// Put b beside a; no points are shared.
inline void Append(TriangleMesh& a, const TriangleMesh& b)
{
  const int first = static_cast<int>(a.Points.size());
  a.Points.insert(a.Points.end(), b.Points.begin(), b.Points.end());
  for (const auto& t : b.Triangles)
  {
    a.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
}

inline void TurnInsideOut(TriangleMesh& mesh)
{
  for (auto& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
}

inline void Move(TriangleMesh& mesh, const Vector3& by)
{
  for (auto& p : mesh.Points)
  {
    p = p + by;
  }
}

/// Twelve triangles outward.
inline TriangleMesh MakeBox(const Point3& low, const Point3& high)
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back({ (i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
      (i & 4) != 0 ? high[2] : low[2] });
  }
  const std::array<std::array<int, 4>, 6> sides{ { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } } };
  for (const auto& s : sides)
  {
    mesh.Triangles.push_back({ s[0], s[1], s[2] });
    mesh.Triangles.push_back({ s[0], s[2], s[3] });
  }
  return mesh;
}

inline TriangleMesh MakeCube()
{
  return MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
}

/// The boundary of the unit cells for which solid is true, out of n[0] x n[1] x n[2].
inline TriangleMesh MakeFromCells(
  const std::array<int, 3>& n, const std::function<bool(int, int, int)>& solid)
{
  TriangleMesh mesh;
  std::map<std::array<int, 3>, int> index;
  const auto pointAt = [&](const std::array<int, 3>& p)
  {
    const auto [at, isNew] = index.emplace(p, static_cast<int>(mesh.Points.size()));
    if (isNew)
    {
      mesh.Points.push_back({ double(p[0]), double(p[1]), double(p[2]) });
    }
    return at->second;
  };
  const auto isSolid = [&](const std::array<int, 3>& c)
  {
    const bool inside =
      c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < n[0] && c[1] < n[1] && c[2] < n[2];
    return inside && solid(c[0], c[1], c[2]);
  };
  const auto addSide = [&](const std::array<int, 3>& cell, int axis, int up)
  {
    std::array<int, 3> a = cell;
    a[axis] += up;
    std::array<int, 3> b = a, c = a, d = a;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    ++b[u];
    ++c[u];
    ++c[v];
    ++d[v];
    const std::array<int, 4> q{ pointAt(a), pointAt(up != 0 ? b : d), pointAt(c),
      pointAt(up != 0 ? d : b) };
    mesh.Triangles.push_back({ q[0], q[1], q[2] });
    mesh.Triangles.push_back({ q[0], q[2], q[3] });
  };
  for (int x = 0; x < n[0]; ++x)
  {
    for (int y = 0; y < n[1]; ++y)
    {
      for (int z = 0; z < n[2]; ++z)
      {
        const std::array<int, 3> cell{ x, y, z };
        if (!isSolid(cell))
        {
          continue;
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          for (const int up : { 0, 1 })
          {
            std::array<int, 3> next = cell;
            next[axis] += up != 0 ? 1 : -1;
            if (!isSolid(next))
            {
              addSide(cell, axis, up);
            }
          }
        }
      }
    }
  }
  return mesh;
}

/// `count` square rings in a row, joined: genus count, volume 5 * count + 3.
inline TriangleMesh MakeRingChain(int count)
{
  return MakeFromCells(
    { 2 * count + 1, 3, 1 }, [](int x, int y, int) { return y != 1 || x % 2 == 0; });
}

/// A scaffold of (k+1)^3 nodes joined along the axes: genus 3 k (k+1)^2 - (k+1)^3 + 1.
inline TriangleMesh MakeSponge(int k)
{
  return MakeFromCells({ 2 * k + 1, 2 * k + 1, 2 * k + 1 },
    [](int x, int y, int z) { return x % 2 + y % 2 + z % 2 <= 1; });
}

/// A torus about the z axis; where tube equals radius its hole is a single point, of one index.
inline TriangleMesh MakeTorus(double radius, double tube, int around = 40, int across = 20)
{
  TriangleMesh mesh;
  const bool pinched = tube == radius;
  std::vector<int> index(around * across);
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2 * Pi * i / around;
      const double v = 2 * Pi * j / across;
      const bool inMiddle = pinched && 2 * j == across;
      if (inMiddle && i > 0)
      {
        index[i * across + j] = index[j];
        continue;
      }
      const double r = inMiddle ? 0 : radius + tube * std::cos(v);
      index[i * across + j] = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(
        { r * std::cos(u), r * std::sin(u), inMiddle ? 0 : tube * std::sin(v) });
    }
  }
  const auto add = [&](int a, int b, int c)
  {
    if (a != b && b != c && c != a)
    {
      mesh.Triangles.push_back({ a, b, c });
    }
  };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const int a = index[i * across + j];
      const int b = index[(i + 1) % around * across + j];
      const int c = index[(i + 1) % around * across + (j + 1) % across];
      const int d = index[i * across + (j + 1) % across];
      add(a, b, c);
      add(a, c, d);
    }
  }
  return mesh;
}

/// Two tori, one through the other's hole, that do not meet.
inline TriangleMesh MakeLinkedTori()
{
  TriangleMesh mesh = MakeTorus(1, 0.3);
  TriangleMesh other = MakeTorus(1, 0.3);
  for (auto& p : other.Points)
  {
    p = { p[0] + 1, -p[2], p[1] }; // a quarter turn about x
  }
  Append(mesh, other);
  return mesh;
}

/// A band of 2 * around triangles with half a twist: one open loop, not orientable.
inline TriangleMesh MakeMoebiusStrip(int around = 30)
{
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    const double u = 2 * Pi * i / around;
    for (const double w : { -0.3, 0.3 })
    {
      const double r = 1 + w * std::cos(u / 2);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), w * std::sin(u / 2) });
    }
  }
  for (int i = 0; i < around; ++i)
  {
    const int a = 2 * i;
    const int b = 2 * i + 1;
    const bool last = i + 1 == around;
    const int c = last ? 1 : 2 * i + 2; // the twist: the ends meet crosswise
    const int d = last ? 0 : 2 * i + 3;
    mesh.Triangles.push_back({ a, c, d });
    mesh.Triangles.push_back({ a, d, b });
  }
  return mesh;
}

/// A ball of rings of quadrilaterals, radius 1.
inline TriangleMesh MakeSphere(int around, int rings)
{
  TriangleMesh mesh;
  mesh.Points.push_back({ 0, 0, -1 });
  for (int j = 1; j < rings; ++j)
  {
    const double v = Pi * j / rings;
    for (int i = 0; i < around; ++i)
    {
      const double u = 2 * Pi * i / around;
      mesh.Points.push_back({ std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v) });
    }
  }
  mesh.Points.push_back({ 0, 0, 1 });
  const int north = static_cast<int>(mesh.Points.size()) - 1;
  const auto at = [&](int j, int i) { return 1 + (j - 1) * around + i % around; };
  for (int i = 0; i < around; ++i)
  {
    mesh.Triangles.push_back({ 0, at(1, i + 1), at(1, i) });
    mesh.Triangles.push_back({ north, at(rings - 1, i), at(rings - 1, i + 1) });
    for (int j = 1; j + 1 < rings; ++j)
    {
      mesh.Triangles.push_back({ at(j, i), at(j, i + 1), at(j + 1, i + 1) });
      mesh.Triangles.push_back({ at(j, i), at(j + 1, i + 1), at(j + 1, i) });
    }
  }
  return mesh;
}
}
}

#endif
