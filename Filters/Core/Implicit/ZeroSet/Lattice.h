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
 * Lattice planes lie in the bounds, so that the surface is cut exactly there. Where it is closed
 * there, a layer of cubes lies around: its far corners are beyond the bounds.
 */
class Lattice
{
public:
  /// Cells a direction that fit into a key.
  static constexpr int MaximumCells = (1 << 20) - 4;

  Lattice(const Bounds& box, double cellSize, bool closed) : Box(box), Layer(closed ? 1 : 0)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double extent = box[2 * a + 1] - box[2 * a];
      const double cells = std::max(1.0, std::ceil(extent / cellSize - 1e-9));
      this->Step[a] = extent / cells;
      this->Origin[a] = box[2 * a] - this->Layer * this->Step[a];
      this->Cells[a] = static_cast<int>(cells) + 2 * this->Layer;
    }
  }

  /// To the last bit in the bounds where it is one of theirs.
  Point3 At(const LatticeIndex& corner) const
  {
    Point3 p{};
    for (int a = 0; a < 3; ++a)
    {
      const int side = this->BoundAt(a, corner[a]);
      p[a] = side < 0 ? this->Origin[a] + corner[a] * this->Step[a] : this->Box[2 * a + side];
    }
    return p;
  }

  bool IsBeyond(const LatticeIndex& corner) const
  {
    for (int a = 0; a < 3; ++a)
    {
      if (corner[a] < this->Layer || corner[a] > this->Cells[a] - this->Layer)
      {
        return true;
      }
    }
    return false;
  }

  /// Of a cube: 0 within the bounds, 1 + 2 axis + (0 low, 1 high) outside of that face of theirs,
  /// -1 beside more than one.
  int FaceInside(const LatticeIndex& cube) const
  {
    int face = 0;
    for (int a = 0; a < 3; ++a)
    {
      const bool low = cube[a] < this->Layer;
      if (low || cube[a] >= this->Cells[a] - this->Layer)
      {
        face = face == 0 ? 1 + 2 * a + (low ? 0 : 1) : -1;
      }
    }
    return face;
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

private:
  /// 0 or 1 where corners of that index lie in the low or high bound, else -1.
  int BoundAt(int axis, int index) const
  {
    return index == this->Layer ? 0 : index == this->Cells[axis] - this->Layer ? 1 : -1;
  }

  Bounds Box;
  int Layer; ///< of cubes around the bounds
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
