// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Polygonizer.h
 * @brief Triangles of the zero set: Bloomenthal's continuation on tetrahedral cells (thesis 9.3).
 */
#ifndef recon_Polygonizer_h
#define recon_Polygonizer_h

#include "Base/Monitor.h"
#include "Implicit/ZeroSet/BoundedField.h"
#include "Mesh/TriangleMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace recon
{
struct PolygonizerOptions
{
  /// How much a surface may cost; all are closed, manifold and oriented.
  enum DetailType
  {
    Full = 0,   ///< as the other options say
    Medium = 1, ///< cells of at least 1/100 of the seeds' diagonal
    Coarse = 2  ///< cells of at least 1/50, triangles as the cells cut them: for under a second
  };

  DetailType Detail = Full;
  /// Edge of a cell in the units of the input. 0 = the median distance between neighbouring seeds,
  /// but not below 1/160 nor above 1/80 of their bounding box's diagonal; 0.7 of that where seeds
  /// or Witnesses are on a wall or gap that such cells miss and those find.
  double CellSize = 0;
  /// Tracking never leaves this box. Not given = that of the seeds, larger by a tenth of its
  /// diagonal.
  std::optional<Bounds> Box;
  /// true: the solid ends at the box and is closed there; false: the surface has a border in the
  /// box's faces.
  bool ClosedAtBounds = true;
  /// Largest distance, in cells, of a mesh vertex from the true zero along its normal.
  double Tolerance = 1e-6;
  /// Short edges collapsed, diagonals flipped, vertices spread on the surface, until no angle is
  /// small. Not where Detail is Coarse.
  bool CleanUp = true;
  /// Further points of the contours that seeds stand for: cells become smaller where the surface
  /// passes by one of these and is missed, too, where CellSize is to be chosen.
  std::vector<Point3> Witnesses;
  /// Each seed moves the nearest mesh vertex onto itself where that leaves a good mesh.
  bool SnapToSeeds = false;
  /// More cells than this are refused, before and while they are made.
  double MaximumCells = 4e6;
  int Threads = 0;
};

struct ImplicitMesh
{
  TriangleMesh Mesh;
  std::vector<Vector3>
    Normals;                ///< at the points, out of the solid, unit: the function's own gradient
  double CellSize = 0;      ///< the one that was used
  double SmallestAngle = 0; ///< of all triangles, degrees
  /// Seeds and Witnesses within the bounds that are more than a cell away from the surface.
  std::size_t FarContourPoints = 0;
  std::vector<std::string> Report;
};

/**
 * Closed, manifold by index, oriented outward (with ClosedAtBounds; else but for the border at the
 * bounds).
 *
 * @param seeds points on the surface: all contour vertices. Components that no seed touches are not
 * meshed.
 * @throws Error where CellSize is negative or would take more than MaximumCells, the bounds are
 * empty, or no surface is near the seeds; Aborted.
 */
ImplicitMesh Polygonize(const ImplicitFunction& function, const std::vector<Point3>& seeds,
  const PolygonizerOptions& options, Monitor& monitor);

/// The cell size and the box that options stand for.
double ChooseCellSize(const std::vector<Point3>& seeds, double asked);
/// With regard to Detail.
double ChooseCellSize(const std::vector<Point3>& seeds, const PolygonizerOptions& options);
Bounds ChooseBounds(const std::vector<Point3>& seeds, const std::optional<Bounds>& asked);
/**
 * An estimate from the box of the seeds, which the surface about fills, however far the bounds
 * reach.
 * @throws Error where the surface would take more cells than allowed, with the number and a better
 * size; where a cell is larger than the bounds, and where maximumCells is no number of cells.
 */
void CheckCellCount(const Bounds& ofSeeds, const Bounds& box, double cellSize, double maximumCells);

/// What a fitted function was asked to be zero at: its seeds.
std::vector<Point3> SeedsOf(const ImplicitFunction& function);
}

#endif
