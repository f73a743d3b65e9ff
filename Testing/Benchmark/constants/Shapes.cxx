// SPDX-License-Identifier: GPL-3.0-or-later
#include "Shapes.h"

#include "Base/BoundingBox.h"
#include "Base/Monitor.h"
#include "Mesh/MassProperties.h"
#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace recon::shapes
{
namespace
{
constexpr int Samples = 4000;

Box3 BoxOf(const TriangleMesh& mesh)
{
  Box3 box;
  for (const Point3& p : mesh.Points)
  {
    box.Add(p);
  }
  return box;
}

std::vector<Point3> Spread(const TriangleMesh& mesh)
{
  std::vector<double> reach{ 0 };
  for (const auto& t : mesh.Triangles)
  {
    const Vector3 across =
      Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]]);
    reach.push_back(reach.back() + Norm(across));
  }
  std::mt19937_64 random(1);
  const auto part = [&random]() { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Point3> points;
  for (int i = 0; i < Samples; ++i)
  {
    const double at = (i + part()) / Samples * reach.back();
    const auto next = std::upper_bound(reach.begin() + 1, reach.end() - 1, at);
    const auto& t = mesh.Triangles[next - reach.begin() - 1];
    const double u = std::sqrt(part());
    const double v = part();
    points.push_back((1 - u) * mesh.Points[t[0]] + (u * (1 - v)) * mesh.Points[t[1]] +
      (u * v) * mesh.Points[t[2]]);
  }
  return points;
}

Deviation OneWay(const TriangleMesh& from, const TriangleMesh& to)
{
  const TriangleTree tree(to);
  Deviation found;
  for (const Point3& p : Spread(from))
  {
    const double d = tree.DistanceTo(p, std::numeric_limits<double>::max());
    found.Mean += d / Samples;
    found.Largest = std::max(found.Largest, d);
  }
  return found;
}
}

TriangleMesh ReadOFF(const std::string& path)
{
  std::ifstream file(path);
  std::string word;
  std::size_t points = 0, triangles = 0, edges = 0;
  file >> word >> points >> triangles >> edges;
  TriangleMesh mesh;
  mesh.Points.resize(points);
  for (Point3& p : mesh.Points)
  {
    file >> p[0] >> p[1] >> p[2];
  }
  mesh.Triangles.resize(triangles);
  for (auto& t : mesh.Triangles)
  {
    int corners = 0;
    file >> corners >> t[0] >> t[1] >> t[2];
  }
  if (!file)
  {
    throw Error(path + " is no .off file of triangles.");
  }
  return mesh;
}

LoopSoup Cut(const TriangleMesh& mesh, int axis, int slices, double phase)
{
  const Box3 box = BoxOf(mesh);
  LoopSoup soup;
  for (int s = 0; s < slices; ++s)
  {
    const double height = box.Low[axis] + (s + phase) / slices * box.Extent(axis);
    std::map<std::pair<int, int>, int> pointOfEdge;
    const auto pointOn = [&](int a, int b)
    {
      const auto [found, isNew] =
        pointOfEdge.emplace(std::minmax(a, b), static_cast<int>(soup.Points.size()));
      if (isNew)
      {
        const Point3& p = mesh.Points[std::min(a, b)];
        const Point3& q = mesh.Points[std::max(a, b)];
        const double t = (height - p[axis]) / (q[axis] - p[axis]);
        soup.Points.push_back((1 - t) * p + t * q);
        soup.Points.back()[axis] = height;
      }
      return found->second;
    };
    for (const auto& t : mesh.Triangles)
    {
      LoopSoup::Chain chain;
      for (int k = 0; k < 3; ++k)
      {
        const int a = t[k], b = t[(k + 1) % 3];
        if ((mesh.Points[a][axis] > height) != (mesh.Points[b][axis] > height))
        {
          chain.Points.push_back(pointOn(a, b));
        }
      }
      if (chain.Points.size() == 2)
      {
        chain.Source = static_cast<int>(soup.Chains.size());
        soup.Chains.push_back(chain);
      }
    }
  }
  return soup;
}

Deviation Compare(const TriangleMesh& one, const TriangleMesh& other)
{
  const Deviation out = OneWay(one, other);
  const Deviation back = OneWay(other, one);
  return { 0.5 * (out.Mean + back.Mean), std::max(out.Largest, back.Largest) };
}

int EulerOf(const TriangleMesh& mesh)
{
  std::set<int> used;
  for (const auto& t : mesh.Triangles)
  {
    used.insert(t.begin(), t.end());
  }
  return static_cast<int>(used.size()) - static_cast<int>(mesh.Triangles.size() / 2);
}

double VolumeOf(const TriangleMesh& mesh)
{
  const std::vector<int> one(mesh.Triangles.size(), 0);
  return ComputeSignedVolumes(mesh, one, 1).front();
}
}
