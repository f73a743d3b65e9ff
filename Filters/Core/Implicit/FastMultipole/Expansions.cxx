// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/Expansions.h"

#include <algorithm>

namespace recon
{
int SideOf(const OctreeBox& box)
{
  int side = 0;
  for (int a = 0; a < 3; ++a)
  {
    side |= (box.Cell[a] & 1) == 0 ? 1 << a : 0;
  }
  return side;
}

LanePoints LocalBlock(
  const std::vector<Point3>& points, const OctreeBox& box, std::int32_t from, std::int32_t to)
{
  const Point3 centre = KernelOctree::CentreOf(box);
  const double scale = 1 / KernelOctree::HalfWidthOf(box.Level);
  LanePoints block;
  for (int b = 0; b < ExpansionLanes; ++b)
  {
    const Point3& p = points[std::min(from + b, to - 1)];
    block.X[b] = scale * (p[0] - centre[0]);
    block.Y[b] = scale * (p[1] - centre[1]);
    block.Z[b] = scale * (p[2] - centre[2]);
  }
  return block;
}

LanePoints UnitBlock(const std::vector<Point3>& points, std::int32_t from, std::int32_t to)
{
  LanePoints block;
  for (int b = 0; b < ExpansionLanes; ++b)
  {
    const Point3& p = points[std::min(from + b, to - 1)];
    block.X[b] = p[0];
    block.Y[b] = p[1];
    block.Z[b] = p[2];
  }
  return block;
}
}
