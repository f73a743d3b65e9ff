// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PointGrid.h
 * @brief Which points lie within a distance of a place.
 */
#ifndef recon_PointGrid_h
#define recon_PointGrid_h

#include "Base/Geometry.h"
#include "Base/SpatialHash.h"

#include <vector>

namespace recon
{
/**
 * @class PointGrid
 * @brief Points hashed by the cubes of a grid. Points are copied; indices are those of the input.
 */
class PointGrid
{
public:
  PointGrid(const std::vector<Point3>& points, double cell) : Points(points), Hash(cell)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Hash.Put(static_cast<int>(i), this->Hash.CellOf(points[i]));
    }
  }

  /// visit(index, squared distance) for every point within radius of x, in no particular order of
  /// distance.
  template <typename Visit>
  void ForNear(const Point3& x, double radius, const Visit& visit) const
  {
    SpatialHash<3>::ForCells(this->Hash.RangeOf(Box3(x, x).Grown(radius)),
      [&](const SpatialHash<3>::Cell& cell)
      {
        this->VisitCell(cell, x, radius, visit);
        return false;
      });
  }

  /// The nearest point within radius, or -1; the smaller index where two are equally near.
  int Nearest(const Point3& x, double radius) const
  {
    int best = -1;
    double least = radius * radius;
    this->ForNear(x, radius,
      [&](int i, double r2)
      {
        if (r2 < least || (r2 == least && (best < 0 || i < best)))
        {
          least = r2;
          best = i;
        }
      });
    return best;
  }

private:
  /// Cells may share a key: distances are looked at, and a point counts in its own cell only.
  template <typename Visit>
  void VisitCell(
    const SpatialHash<3>::Cell& cell, const Point3& x, double radius, const Visit& visit) const
  {
    this->Hash.AnyIn(cell,
      [&](int i)
      {
        const Vector3 d = this->Points[i] - x;
        const double r2 = Dot(d, d);
        if (r2 <= radius * radius && this->Hash.CellOf(this->Points[i]) == cell)
        {
          visit(i, r2);
        }
        return false;
      });
  }

  std::vector<Point3> Points;
  SpatialHash<3> Hash;
};
}

#endif
