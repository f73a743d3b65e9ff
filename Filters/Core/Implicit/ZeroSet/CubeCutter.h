// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CubeCutter.h
 * @brief The triangles that cut the tracked cubes' inside corners from the outside ones, and the
 * flat ends in the bounds.
 */
#ifndef recon_CubeCutter_h
#define recon_CubeCutter_h

#include "Implicit/ZeroSet/SurfaceTracker.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace recon
{
/// An edge of the lattice: its lesser corner and its direction, bits of (x, y, z) in 1..7; 0 is the
/// corner alone.
struct LatticeEdge
{
  LatticeIndex Corner;
  int Direction;

  LatticeIndex Far() const
  {
    return { this->Corner[0] + (this->Direction & 1),
      this->Corner[1] + ((this->Direction >> 1) & 1),
      this->Corner[2] + ((this->Direction >> 2) & 1) };
  }
  std::uint64_t Key() const
  {
    return Lattice::Key(this->Corner) | (static_cast<std::uint64_t>(this->Direction) << 60);
  }
};

/**
 * @class CubeCutter
 * @brief Collects the cut edges of all cubes, each once, and the triangles between them, which turn
 * outward.
 *
 * Where the solid is closed at the bounds, it ends flat in them: between the cut edges that lie in
 * the bounds, and inside corners there. So the rim is where the wall meets the bounds, not a step a
 * cell beside.
 */
class CubeCutter
{
public:
  explicit CubeCutter(const SurfaceTracker& tracker);

  const std::vector<LatticeEdge>& Edges() const { return this->CutEdges; }
  std::vector<std::array<int, 3>>& Triangles() { return this->Cut; } ///< of Edges()
  /// By triangle: 0, or the face of the bounds that it lies in (Lattice::FaceInside).
  std::vector<char>& Faces() { return this->CutFaces; }

private:
  void March(const LatticeIndex& cube);
  void CutFace(const LatticeIndex& cube, int face);
  void CutFlatTriangle(const LatticeIndex& cube, const std::array<int, 3>& corners, int face);
  int PointOn(const LatticeIndex& cube, int small, int large);

  const SurfaceTracker& Tracker;
  std::vector<LatticeEdge> CutEdges;
  std::vector<std::array<int, 3>> Cut;
  std::vector<char> CutFaces;
  std::unordered_map<std::uint64_t, int, LatticeHash> Index;
};
}

#endif
