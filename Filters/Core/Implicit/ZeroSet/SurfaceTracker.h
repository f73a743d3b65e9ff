// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceTracker.h
 * @brief Bloomenthal's continuation: from seeds on the surface to all cubes that it passes through
 * (thesis 9.3).
 */
#ifndef recon_SurfaceTracker_h
#define recon_SurfaceTracker_h

#include "Base/Monitor.h"
#include "Implicit/ZeroSet/Lattice.h"

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace recon
{
/**
 * @class SurfaceTracker
 * @brief Evaluates the field at the corners near the surface only, each once, and never leaves the
 * bounds.
 *
 * Every contour vertex is a seed, so every component that a contour touches is found, and a sheet
 * of the function's zero set far from all contours is not.
 */
class SurfaceTracker
{
public:
  /**
   * @param field not closed: where the lattice has a layer around the bounds, what lies there is
   * outside, and the surface is followed along the bounds.
   * @param maximumCubes refuse to go on beyond, instead of filling the memory.
   * @throws Error where no seed is near a change of sign, or the cubes are too many; Aborted.
   */
  SurfaceTracker(const BoundedField& field, const Lattice& lattice,
    const std::vector<Point3>& seeds, double maximumCubes, Monitor& monitor);

  /// Cubes with corners on both sides, in the order they were found.
  const std::vector<LatticeIndex>& Cubes() const { return this->Active; }
  /// g at a corner of such a cube. Inside is g > 0.
  double ValueAt(const LatticeIndex& corner) const { return this->Values.at(Lattice::Key(corner)); }
  /// Is the point in such a cube or one with a seed, or in a neighbour of one?
  bool Near(const Point3& p) const;
  const Lattice& Grid() const { return this->Cells; }

private:
  using CubeList = std::vector<LatticeIndex>;

  void EvaluateCorners(const CubeList& cubes);
  bool IsMixed(const LatticeIndex& cube) const;
  bool FaceIsMixed(const LatticeIndex& cube, int axis, int side) const;
  bool IsInside(const LatticeIndex& corner) const { return this->ValueAt(corner) > 0; }
  CubeList SeedCubes(const std::vector<Point3>& seeds);
  CubeList Next(const CubeList& wave);
  void PushNew(const LatticeIndex& cube, CubeList& list);

  const BoundedField& Field;
  Lattice Cells;
  CubeList Active;
  std::unordered_map<std::uint64_t, double, LatticeHash> Values;
  std::unordered_set<std::uint64_t, LatticeHash> Visited;
  std::unordered_set<std::uint64_t, LatticeHash> ActiveKeys;
};
}

#endif
