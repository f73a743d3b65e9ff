// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EditedMeshes.h
 * @brief Meshes on surfaces that are known, for the tests of what edits meshes.
 */
#ifndef recon_EditedMeshes_h
#define recon_EditedMeshes_h

#include "Implicit/ZeroSet/Remeshing.h"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace edited
{
using namespace recon;

struct Shape
{
  TriangleMesh Mesh;
  std::vector<Vector3> Normals;

  void Add(const Point3& p, const Vector3& normal)
  {
    this->Mesh.Points.push_back(p);
    this->Normals.push_back(normal);
  }
};

/// A unit sphere of rings x points vertices and two poles, shaken along the surface.
inline Shape Ball(int rings, int points, double shake = 0)
{
  constexpr double pi = 3.14159265358979323846;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-shake, shake);
  Shape ball;
  const auto add = [&ball](double theta, double phi)
  {
    const Point3 p{ std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
      std::cos(theta) };
    ball.Add(p, p);
  };
  add(0, 0);
  for (int r = 1; r <= rings; ++r)
  {
    for (int k = 0; k < points; ++k)
    {
      add(pi * (r + uniform(random)) / (rings + 1), 2 * pi * (k + uniform(random)) / points);
    }
  }
  add(pi, 0);
  const int last = 1 + rings * points;
  const auto at = [points](int r, int k) { return 1 + r * points + k % points; };
  for (int k = 0; k < points; ++k)
  {
    ball.Mesh.Triangles.push_back({ 0, at(0, k), at(0, k + 1) });
    ball.Mesh.Triangles.push_back({ last, at(rings - 1, k + 1), at(rings - 1, k) });
    for (int r = 0; r + 1 < rings; ++r)
    {
      ball.Mesh.Triangles.push_back({ at(r, k), at(r + 1, k), at(r + 1, k + 1) });
      ball.Mesh.Triangles.push_back({ at(r, k), at(r + 1, k + 1), at(r, k + 1) });
    }
  }
  return ball;
}

/// Back onto the unit sphere.
inline void OntoBall(
  std::vector<Point3>& points, std::vector<Vector3>& normals, std::vector<char>& done)
{
  normals = points;
  done.assign(points.size(), 1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = normals[i] = (1 / Norm(points[i])) * points[i];
  }
}

/// An open square of n x n unit cells in the plane z = height, facing up, or down.
inline Shape Sheet(int n, double height = 0, bool up = true)
{
  Shape sheet;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      sheet.Add({ 1.0 * i, 1.0 * j, height }, { 0, 0, up ? 1.0 : -1.0 });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      const int b = a + 1;
      const int c = b + n + 1;
      const int d = a + n + 1;
      sheet.Mesh.Triangles.push_back(
        up ? std::array<int, 3>{ a, b, c } : std::array<int, 3>{ a, c, b });
      sheet.Mesh.Triangles.push_back(
        up ? std::array<int, 3>{ a, c, d } : std::array<int, 3>{ a, d, c });
    }
  }
  return sheet;
}

/// Two shapes in one mesh.
inline Shape Both(Shape first, const Shape& second)
{
  const int offset = static_cast<int>(first.Mesh.Points.size());
  for (std::size_t i = 0; i < second.Mesh.Points.size(); ++i)
  {
    first.Add(second.Mesh.Points[i], second.Normals[i]);
  }
  for (std::array<int, 3> t : second.Mesh.Triangles)
  {
    for (int& v : t)
    {
      v += offset;
    }
    first.Mesh.Triangles.push_back(t);
  }
  return first;
}
}

#endif
