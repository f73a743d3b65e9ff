// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfacePart.h
 * @brief The boundary of the solid of some neighbouring slabs, and what is known of its faces and points.
 */
#ifndef recon_SurfacePart_h
#define recon_SurfacePart_h

#include "Contours/ContourSet.h"
#include "Polyhedral/FaceGroups.h"
#include "Polyhedral/PolyhedralStages.h"
#include "Polyhedral/SolidBoundary.h"
#include "Polyhedral/SolidComplex.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace recon
{
struct PointOnSurface
{
  Point3 Position;
  int Kind;     ///< LevelTriangulation::PointKindType
  bool IsExact; ///< the point that was decided on is the one that is given out, to the last bit
};

/// An edge of which the middle is a point: its vertices as the whole stack orders them, the lesser first, and
/// which it is of those that lie there.
using HalvedEdge = std::tuple<std::uint64_t, std::uint64_t, int>;

struct SurfacePart
{
  SlabRange Slabs;    ///< whose faces are wanted
  SolidComplex Solid; ///< of one slab more on either side
  SolidBoundary Boundary;
  std::vector<int> Pieces; ///< see FindPieces
  std::vector<int> Groups; ///< see FaceGroups
  std::vector<PointOnSurface> Points;
  std::vector<HalvedEdge> Halved; ///< of the points that are middles, which are the last ones

  /// Cells of a slab of Solid.
  int FirstCellOf(int slab) const { return this->Solid.FirstCell[slab - this->Solid.Slabs.First]; }
  /// The first face of the cells from that one on.
  std::size_t FirstFaceOf(int cell) const;
  /// Index into Points from which on they are middles.
  std::size_t FirstMiddle() const { return this->Points.size() - this->Halved.size(); }
};

/// The stages have all levels and slabs of the range, and one slab more on either side where there is one.
SurfacePart BuildSurfacePart(const ContourSet& contours, const PolyhedralStages& stages,
  const FaceGroups& groups, const SlabRange& slabs);

/// Whether all corners lie in the plane of one level, none lifted out of it. @param face of the boundary, whole
bool LiesInPlane(const SurfacePart& part, const std::array<int, 3>& face);

/// Cubic units.
double VolumeOf(const SolidComplex& solid, const SolidComplex::Cell& cell);
}

#endif
