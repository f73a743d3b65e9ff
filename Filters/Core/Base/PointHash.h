// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PointHash.h
 * @brief Hash of a point's coordinates, for tables of points that are equal to the last bit.
 */
#ifndef recon_PointHash_h
#define recon_PointHash_h

#include "Base/Geometry.h"

#include <cstddef>
#include <functional>

namespace recon
{
/// For std::unordered_map: -0 and 0, which are equal, have one hash.
struct PointHash
{
  std::size_t operator()(const Point3& p) const
  {
    std::size_t seed = 0;
    for (const double c : p)
    {
      seed ^= std::hash<double>()(c) + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2);
    }
    return seed;
  }
};
}

#endif
