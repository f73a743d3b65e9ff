// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleTree.h"

#include "Mesh/TriangleMeasures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace recon
{
namespace
{
/// Spread the low 21 bits of x so that two zeros follow each.
std::uint64_t SpreadBits(std::uint64_t x)
{
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFFull;
  x = (x | x << 16) & 0x1F0000FF0000FFull;
  x = (x | x << 8) & 0x100F00F00F00F00Full;
  x = (x | x << 4) & 0x10C30C30C30C30C3ull;
  x = (x | x << 2) & 0x1249249249249249ull;
  return x;
}

Point3 Along(const Point3& a, const Vector3& direction, double t)
{
  return a + t * direction;
}

/// Inside the prism over the triangle the distance to its plane, elsewhere that to its border.
double SquaredDistanceToCorners(const Point3& p, const Point3& a, const Point3& b, const Point3& c)
{
  // Of a corner the answer is 0, not the rounding of its height: contour vertices are corners.
  if (p == a || p == b || p == c)
  {
    return 0;
  }
  const Vector3 normal = Cross(b - a, c - a);
  const double squaredNorm = Dot(normal, normal);
  const bool inside = squaredNorm > 0 && Dot(Cross(b - a, p - a), normal) >= 0 &&
    Dot(Cross(c - b, p - b), normal) >= 0 && Dot(Cross(a - c, p - c), normal) >= 0;
  if (inside)
  {
    const double height = Dot(p - a, normal);
    return height * height / squaredNorm;
  }
  return std::min({ SquaredDistanceToSegment(p, a, b), SquaredDistanceToSegment(p, b, c),
    SquaredDistanceToSegment(p, c, a) });
}

std::vector<Box3> BoxesOf(const TriangleMesh& mesh)
{
  std::vector<Box3> boxes(mesh.Triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
  {
    boxes[t] = BoxOf(mesh, static_cast<int>(t));
  }
  return boxes;
}
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : TriangleTree(mesh, BoxesOf(mesh)) {}

TriangleTree::TriangleTree(const TriangleMesh& mesh, const std::vector<Box3>& boxes) : Mesh(mesh)
{
  std::vector<int> all(mesh.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  this->Build(all, boxes);
}

TriangleTree::TriangleTree(
  const TriangleMesh& mesh, const std::vector<Box3>& boxes, std::vector<int> near)
  : Mesh(mesh)
{
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  this->Build(near, boxes);
  std::vector<int> meeting;
  for (std::size_t t = 0; t < boxes.size(); ++t)
  {
    if (this->AnyMeeting(boxes[t], [](int) { return true; }))
    {
      meeting.push_back(static_cast<int>(t));
    }
  }
  this->Build(meeting, boxes);
}

void TriangleTree::Build(const std::vector<int>& triangles, const std::vector<Box3>& boxes)
{
  this->Order = {};
  this->TriangleBoxes = {};
  this->FirstLeaf = 1;
  this->SortTriangles(triangles);
  this->BuildBoxes(boxes);
}

void TriangleTree::SortTriangles(const std::vector<int>& triangles)
{
  const auto middleOf = [this](const std::array<int, 3>& t)
  {
    const auto& points = this->Mesh.Points;
    return (1.0 / 3) * points[t[0]] + ((1.0 / 3) * points[t[1]] + (1.0 / 3) * points[t[2]]);
  };
  Box3 bounds;
  for (const int t : triangles)
  {
    bounds.Add(middleOf(this->Mesh.Triangles[t]));
  }
  const double size = bounds.LongestExtent();
  const double scale = size > 0 ? 2097151.0 / size : 0;
  std::vector<std::pair<std::uint64_t, int>> codes(triangles.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    const Point3 middle = middleOf(this->Mesh.Triangles[triangles[i]]);
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k)
    {
      code |= SpreadBits(static_cast<std::uint64_t>((middle[k] - bounds.Low[k]) * scale)) << k;
    }
    codes[i] = { code, triangles[i] };
  }
  std::sort(codes.begin(), codes.end());
  this->Order.reserve(codes.size());
  for (const auto& code : codes)
  {
    this->Order.push_back(code.second);
  }
}

void TriangleTree::BuildBoxes(const std::vector<Box3>& boxes)
{
  const int count = static_cast<int>(this->Order.size());
  this->NumberOfLeaves = (count + LeafSize - 1) / LeafSize;
  while (this->FirstLeaf < this->NumberOfLeaves)
  {
    this->FirstLeaf *= 2;
  }
  this->TriangleBoxes.reserve(count);
  for (const int t : this->Order)
  {
    this->TriangleBoxes.push_back(boxes[t]);
  }
  this->Nodes.assign(2 * static_cast<std::size_t>(this->FirstLeaf), Box3());
  for (int i = 0; i < count; ++i)
  {
    this->Nodes[this->FirstLeaf + i / LeafSize].Add(this->TriangleBoxes[i]);
  }
  for (int node = this->FirstLeaf - 1; node > 0; --node)
  {
    this->Nodes[node].Add(this->Nodes[2 * node]);
    this->Nodes[node].Add(this->Nodes[2 * node + 1]);
  }
}

double TriangleTree::DistanceTo(const Point3& p, double limit) const
{
  return std::sqrt(this->SquaredDistanceTo(p, limit * limit));
}

double TriangleTree::SquaredDistanceToTriangle(const Point3& p, int triangle) const
{
  const auto& t = this->Mesh.Triangles[triangle];
  return SquaredDistanceToCorners(
    p, this->Mesh.Points[t[0]], this->Mesh.Points[t[1]], this->Mesh.Points[t[2]]);
}

double TriangleTree::SquaredDistanceTo(const Point3& p, double best) const
{
  std::pair<double, int> stack[128];
  int size = 0;
  const auto push = [&](double distance, int node)
  {
    if (distance < best)
    {
      stack[size++] = { distance, node };
    }
  };
  push(this->Nodes[1].SquaredDistanceTo(p), 1);
  while (size > 0)
  {
    const auto [distance, node] = stack[--size];
    if (distance >= best)
    {
      continue;
    }
    if (node < this->FirstLeaf)
    {
      const double left = this->Nodes[2 * node].SquaredDistanceTo(p);
      const double right = this->Nodes[2 * node + 1].SquaredDistanceTo(p);
      // The nearer child last, so that it is looked at first.
      const bool leftIsNearer = left <= right;
      push(leftIsNearer ? right : left, leftIsNearer ? 2 * node + 1 : 2 * node);
      push(leftIsNearer ? left : right, leftIsNearer ? 2 * node : 2 * node + 1);
      continue;
    }
    const int leaf = node - this->FirstLeaf;
    for (int i = this->FirstOfLeaf(leaf); i < this->EndOfLeaf(leaf); ++i)
    {
      if (this->TriangleBoxes[i].SquaredDistanceTo(p) >= best)
      {
        continue;
      }
      best = std::min(best, this->SquaredDistanceToTriangle(p, this->Order[i]));
    }
  }
  return best;
}
}
