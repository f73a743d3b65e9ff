// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/KernelOctree.h"

#include "Base/BoundingBox.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
constexpr int Deepest = KernelOctree::DeepestLevel;

/// Puts two zeros between the lowest 21 bits.
std::uint64_t Spread(std::uint64_t v)
{
  v &= 0x1FFFFF;
  v = (v | v << 32) & 0x1F00000000FFFF;
  v = (v | v << 16) & 0x1F0000FF0000FF;
  v = (v | v << 8) & 0x100F00F00F00F00F;
  v = (v | v << 4) & 0x10C30C30C30C30C3;
  v = (v | v << 2) & 0x1249249249249249;
  return v;
}

/// The cell of the deepest level along one axis.
std::uint64_t CellOf(double unit)
{
  return static_cast<std::uint64_t>(unit * (1 << Deepest));
}

std::uint64_t KeyOf(const Point3& unit)
{
  return Spread(CellOf(unit[0])) | Spread(CellOf(unit[1])) << 1 | Spread(CellOf(unit[2])) << 2;
}

OctreeBox BoxOf(const Point3& unit, int level, std::int32_t from, std::int32_t to)
{
  OctreeBox box;
  box.Level = level;
  for (int a = 0; a < 3; ++a)
  {
    box.Cell[a] = static_cast<std::int32_t>(CellOf(unit[a]) >> (Deepest - level));
  }
  box.From = from;
  box.To = to;
  return box;
}
}

RootCube RootCube::Around(const std::vector<Point3>& points)
{
  RootCube cube;
  if (points.empty())
  {
    return cube;
  }
  const Box3 box = Box3::Around(points);
  const double longest = box.LongestExtent();
  if (longest > 0)
  {
    cube.Size = std::ldexp(1.0, std::ilogb(1.5 * longest) + 1);
  }
  cube.Low = 0.5 * (box.Low + box.High) - 0.5 * cube.Size * Vector3{ 1, 1, 1 };
  return cube;
}

bool RootCube::Contains(const Point3& x) const
{
  const Point3 unit = this->ToUnit(x);
  return std::all_of(unit.begin(), unit.end(), [](double u) { return u >= 0 && u < 1; });
}

KernelOctree::KernelOctree() : OfPoints(false), Nodes(1), LevelStart({ 0, 1 }) {}

KernelOctree::KernelOctree(const std::vector<Point3>& points, const RootCube& cube) : OfPoints(true)
{
  std::vector<std::pair<std::uint64_t, std::int32_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    order.emplace_back(KeyOf(cube.ToUnit(points[i])), static_cast<std::int32_t>(i));
  }
  std::sort(order.begin(), order.end());
  this->Keys.reserve(points.size());
  this->Order.reserve(points.size());
  this->Sorted.reserve(points.size());
  for (const auto& [key, number] : order)
  {
    this->Keys.push_back(key);
    this->Order.push_back(number);
    this->Sorted.push_back(cube.ToUnit(points[number]));
  }
  if (!points.empty())
  {
    this->Nodes.emplace_back();
    this->Nodes.back().To = static_cast<std::int32_t>(points.size());
  }
  this->LevelStart = { 0, static_cast<int>(this->Nodes.size()) };
}

void KernelOctree::AppendChildren(std::int32_t box)
{
  const OctreeBox parent = this->Nodes[box];
  const int level = parent.Level + 1;
  const int shift = 3 * (Deepest - level);
  this->Nodes[box].FirstChild = static_cast<std::int32_t>(this->Nodes.size());
  for (std::int32_t from = parent.From; from < parent.To;)
  {
    const std::uint64_t last = this->Keys[from] | ((std::uint64_t{ 1 } << shift) - 1);
    const auto end =
      std::upper_bound(this->Keys.begin() + from, this->Keys.begin() + parent.To, last);
    const auto to = static_cast<std::int32_t>(end - this->Keys.begin());
    OctreeBox child = BoxOf(this->Sorted[from], level, from, to);
    child.Parent = box;
    this->Nodes.push_back(child);
    from = to;
  }
  this->Nodes[box].Children =
    static_cast<std::int32_t>(this->Nodes.size()) - this->Nodes[box].FirstChild;
}

void KernelOctree::AppendAllChildren(std::int32_t box)
{
  const OctreeBox parent = this->Nodes[box];
  this->Nodes[box].FirstChild = static_cast<std::int32_t>(this->Nodes.size());
  this->Nodes[box].Children = 8;
  for (int octant = 0; octant < 8; ++octant)
  {
    OctreeBox child;
    child.Level = parent.Level + 1;
    child.Parent = box;
    for (int a = 0; a < 3; ++a)
    {
      child.Cell[a] = 2 * parent.Cell[a] + ((octant >> a) & 1);
    }
    this->Nodes.push_back(child);
  }
}

bool KernelOctree::SplitLastLevel(const std::function<bool(int)>& wanted)
{
  const int level = this->Levels() - 1;
  if (level >= Deepest)
  {
    return false;
  }
  const int begin = this->LevelBegin(level);
  const int end = this->LevelEnd(level);
  for (int box = begin; box < end; ++box)
  {
    if (wanted(box))
    {
      this->OfPoints ? this->AppendChildren(box) : this->AppendAllChildren(box);
    }
  }
  if (static_cast<int>(this->Nodes.size()) == end)
  {
    return false;
  }
  this->LevelStart.push_back(static_cast<int>(this->Nodes.size()));
  return true;
}

std::int32_t KernelOctree::LeafAround(const Point3& unit) const
{
  const std::uint64_t x = CellOf(unit[0]);
  const std::uint64_t y = CellOf(unit[1]);
  const std::uint64_t z = CellOf(unit[2]);
  std::int32_t box = 0;
  for (int shift = Deepest - 1; !this->Nodes[box].IsLeaf(); --shift)
  {
    const auto octant = (x >> shift & 1) | (y >> shift & 1) << 1 | (z >> shift & 1) << 2;
    box = this->Nodes[box].FirstChild + static_cast<std::int32_t>(octant);
  }
  return box;
}

Point3 KernelOctree::CentreOf(const OctreeBox& box)
{
  Point3 centre{};
  for (int a = 0; a < 3; ++a)
  {
    centre[a] = std::ldexp(box.Cell[a] + 0.5, -box.Level);
  }
  return centre;
}

double KernelOctree::HalfWidthOf(int level)
{
  return std::ldexp(0.5, -level);
}
}
