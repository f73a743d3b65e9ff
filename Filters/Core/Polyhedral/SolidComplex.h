// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SolidComplex.h
 * @brief All kept tetrahedra of all slabs as one simplicial complex, internal points lifted.
 *
 * One triangulation a level serves the slab below and the slab above, so the slabs fit together and the
 * thesis's last step (11.2.3, homogenising vertices between slabs) is not needed.
 *
 * Lifting (thesis 6.2). An internal point p of a level is moved into the slab towards the level that
 * asked for it, to the fraction t = dA / (dA + dB) of the slab: dA and dB are its distances to the contours
 * of its own level and of the one that asked (shape-based interpolation, there where it is exact).
 * The point in the plane stays: p is split into p and its lifted copy p', and the space between the plane and
 * the lifted triangles is filled with tetrahedra. So the plane still shows the contours as they were, and a
 * point that both neighbours asked for is lifted both ways.
 */
#ifndef recon_SolidComplex_h
#define recon_SolidComplex_h

#include "JointVoronoi.h"

#include <array>
#include <vector>

namespace recon
{
struct SolidComplex
{
  struct Vertex
  {
    Point2 Planar;
    double Height; ///< along the common normal
    int Level;     ///< whose plane the vertex lies in, or was lifted out of
    int Local;     ///< index into that level's LevelTriangulation::Points
    bool Lifted;
  };

  struct Cell
  {
    std::array<int, 4> Vertices;   ///< positively oriented
    std::array<int, 4> Neighbours; ///< across the face opposite vertex k; -1: not solid there
    int Slab;
  };

  /// A region of a level that no solid touches on either side.
  struct Uncovered
  {
    int Level;
    int Triangle;
  };

  std::vector<Vertex> Vertices;
  std::vector<Cell> Cells;
  std::vector<Uncovered> UncoveredTriangles;
};

struct LevelGeometry
{
  const LevelTriangulation* Triangulation;
  double Offset;
};

/**
 * lift: for every level and every point, its height in the slab above and in the slab below where it is
 * lifted there; NaN where it is not. See LiftInternalPoints.
 */
struct LiftedHeights
{
  std::vector<double> Above;
  std::vector<double> Below;
};

SolidComplex BuildSolidComplex(const std::vector<LevelGeometry>& levels,
  const std::vector<SlabTetrahedra>& slabs, const std::vector<LiftedHeights>& lifted);
}

#endif
