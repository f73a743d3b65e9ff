// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TriangleGrid.h
 * @brief Which triangles of a mesh that is being edited may come near a box.
 */
#ifndef recon_TriangleGrid_h
#define recon_TriangleGrid_h

#include "Base/Geometry.h"
#include "Base/SpatialHash.h"

#include <vector>

namespace recon
{
/**
 * @class TriangleGrid
 * @brief Triangles by number in the cubes of a grid that their boxes meet.
 *
 * A triangle that has changed is put in again; where it was before it stays known, so queries give
 * too many, and some twice, but never too few.
 */
class TriangleGrid
{
public:
  explicit TriangleGrid(double cell) : Hash(cell) {}

  void Put(int triangle, const Point3& low, const Point3& high)
  {
    const SpatialHash<3>::Range range = this->Hash.RangeOf({ low, high });
    if (triangle >= static_cast<int>(this->Last.size()))
    {
      this->Last.resize(static_cast<std::size_t>(triangle) + 1, { { 0, 0, 0 }, { -1, -1, -1 } });
    }
    if (this->Last[triangle] == range)
    {
      return;
    }
    this->Last[triangle] = range;
    this->Hash.Put(triangle, range);
  }

  /// visit(triangle) for all that may meet the box, until it returns true. @returns whether it did.
  template <typename Visit>
  bool AnyNear(const Point3& low, const Point3& high, const Visit& visit) const
  {
    return SpatialHash<3>::ForCells(this->Hash.RangeOf({ low, high }),
      [&](const SpatialHash<3>::Cell& cell) { return this->Hash.AnyIn(cell, visit); });
  }

private:
  SpatialHash<3> Hash;
  std::vector<SpatialHash<3>::Range> Last;
};
}

#endif
