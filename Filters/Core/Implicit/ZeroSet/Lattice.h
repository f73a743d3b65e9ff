// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Lattice.h
 * @brief The cubes in which the surface is tracked, by integer coordinates.
 */
#ifndef recon_Lattice_h
#define recon_Lattice_h

#include "Implicit/ZeroSet/BoundedField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace recon
{
/// Integer coordinates of a corner, or of a cube by its least corner.
using LatticeIndex = std::array<int, 3>;

/**
 * @class Lattice
 * @brief Cubes (boxes, nearly) that fill the bounds.
 *
 * Where the surface is open at the bounds, lattice planes lie in them, so that its border does too;
 * where it is closed, they lie half a cell beside, so that no corner is on the cap.
 */
class Lattice
{
public:
  /// Cells a direction that fit into a key.
  static constexpr int MaximumCells = (1 << 20) - 4;

  Lattice(const Bounds& box, double cellSize, bool closed)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double extent = box[2 * a + 1] - box[2 * a];
      const double cells = std::max(1.0, std::ceil(extent / cellSize - 1e-9));
      this->Step[a] = extent / cells;
      this->Origin[a] = box[2 * a] - (closed ? 0.5 * this->Step[a] : 0);
      this->Cells[a] = static_cast<int>(cells) + (closed ? 1 : 0);
    }
  }

  Point3 At(const LatticeIndex& corner) const
  {
    return { this->Origin[0] + corner[0] * this->Step[0],
      this->Origin[1] + corner[1] * this->Step[1], this->Origin[2] + corner[2] * this->Step[2] };
  }

  LatticeIndex CubeOf(const Point3& p) const
  {
    LatticeIndex cube;
    for (int a = 0; a < 3; ++a)
    {
      // Far outside is outside, however far: the number must fit an int.
      const double at = std::floor((p[a] - this->Origin[a]) / this->Step[a]);
      cube[a] = static_cast<int>(std::min(std::max(at, -2.0), 2.0 + MaximumCells));
    }
    return cube;
  }

  bool HasCube(const LatticeIndex& c) const
  {
    return c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < this->Cells[0] && c[1] < this->Cells[1] &&
      c[2] < this->Cells[2];
  }

  static std::uint64_t Key(const LatticeIndex& c)
  {
    return (static_cast<std::uint64_t>(c[0] + 1) << 40) |
      (static_cast<std::uint64_t>(c[1] + 1) << 20) | static_cast<std::uint64_t>(c[2] + 1);
  }

  Point3 Origin{};
  Vector3 Step{};
  std::array<int, 3> Cells{};
};

/// Spreads the bits of lattice keys, whose neighbours differ in few, over a hash table.
struct LatticeHash
{
  std::size_t operator()(std::uint64_t key) const
  {
    key ^= key >> 31;
    key *= 0x9E3779B97F4A7C15ull;
    return static_cast<std::size_t>(key ^ (key >> 29));
  }
};
}

#endif
