// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkPolyhedralSurface
 * @brief The whole Polyhedral Surface Method in one filter: parallel contours in, a closed surface
 * out.
 *
 * Input: vtkPolyData whose closed loops are polylines, polygons or loose two-point segments on two
 * or more parallel planes, in any unit and orientation, in any order. The filter cleans, nests and
 * groups them itself (vtkContourHierarchy need not have run).
 *
 * Output: triangles in the coordinates and unit of the input that bound a solid: closed, oriented
 * outward, a manifold, never crossing themselves, and through every contour vertex to the last bit.
 * - cell arrays: `Slab` (0 = between the two lowest levels), `FaceKind` (0 wall, 1 cap),
 *   `MappingGroup` (that of vtkContourMapping; -1 beyond the first and the last level, and where
 *   Mapping is Proximity), `Piece` (of solid within its slab, counted from 0);
 * - point array: `PointKind` (0 input vertex, 1 added on a contour edge, 2 internal);
 * - field data: `Report` (a line for every contour repaired or left out, and why), `LevelNormal`,
 *   `LevelOffset` (a value a level), `ContourCount`, `LeftOutCount`, `EndCapVolume`, `IsolatedVolume`, `StageName`
 *   and `StageSeconds` (wall time).
 *
 * What an execution made is kept for the next one, up to a million tetrahedra (some 100 MB): where some contours
 * have changed since, only what they reach is made anew, and the output is that of a new filter, to the last bit.
 *
 * Errors (a sentence through vtkErrorMacro, and no output): no usable contour; contours on one
 * plane only; contours of which no surface comes out. A warning: more than a tenth of the contours
 * is left out.
 *
 * Thesis part II: chapters 5 (joint Voronoi diagram) and 6 (elimination, lifting, special cases).
 */
#ifndef vtkPolyhedralSurface_h
#define vtkPolyhedralSurface_h

#include "PolyhedralFiltersModule.h" // for the export macro
#include "vtkPolyhedralAlgorithm.h"

#include <memory> // for std::unique_ptr

namespace recon
{
class KeptStages;
}

class POLYHEDRALFILTERS_EXPORT vtkPolyhedralSurface : public vtkPolyhedralAlgorithm
{
public:
  static vtkPolyhedralSurface* New();
  vtkTypeMacro(vtkPolyhedralSurface, vtkPolyhedralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How far sheets that touch in a point or an edge are drawn apart, as a part of the median edge
   * length; default 0.001. So the surface is a manifold by its coordinates, too, as formats without
   * indices (STL) and programs that merge equal points need it. 0: such sheets have points of their
   * own in one place. One point of each place stays, so every contour vertex is a point of the
   * surface in any case; a point never moves through another sheet.
   */
  vtkSetClampMacro(PinchGap, double, 0.0, 0.1);
  vtkGetMacro(PinchGap, double);
  ///@}

protected:
  vtkPolyhedralSurface();
  ~vtkPolyhedralSurface() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPolyhedralSurface(const vtkPolyhedralSurface&) = delete;
  void operator=(const vtkPolyhedralSurface&) = delete;

  double PinchGap = 1e-3;
  std::unique_ptr<recon::KeptStages> Kept; ///< of the last execution
};

#endif
