// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourTriangulation
 * @brief The 2D Delaunay triangulation and the Voronoi skeletons of every level.
 *
 * The first stage of the Polyhedral Surface Method, to be looked at. Input: contours on parallel
 * planes, as vtkPolyhedralSurface takes them; one level is enough. Coordinates and units are those
 * of the input.
 *
 * Output port 0, the triangles of all levels, each in its plane:
 * - cell arrays `Level`, `Inside` (1 within the contours, the thesis's IR; 0 outside, ER),
 * `ContourEdges` (how many of the triangle's edges are contour edges);
 * - point arrays `Level`, `PointKind` (0 input vertex, 1 added on a contour edge, 2 internal),
 * `AskedBy` (of an internal point: 1 the level below, 2 the level above, 3 both).
 *
 * Output port 1, the Voronoi skeletons as line segments: Voronoi edges between two triangles of one
 * region.
 * - cell arrays `Level`, `Internal` (1 internal skeleton IVS, 0 external skeleton EVS).
 *
 * Both have field data `LevelNormal`, `LevelOffset`, `Report`.
 *
 * Every contour edge is an edge of the triangulation and no angle that faces one is obtuse
 * (conditions 0 to 2). Thesis 5.1 to 5.3, algorithms 4, 5 and 6.
 */
#ifndef vtkContourTriangulation_h
#define vtkContourTriangulation_h

#include "PolyhedralFiltersModule.h" // for the export macro
#include "vtkPolyhedralAlgorithm.h"

class POLYHEDRALFILTERS_EXPORT vtkContourTriangulation : public vtkPolyhedralAlgorithm
{
public:
  static vtkContourTriangulation* New();
  vtkTypeMacro(vtkContourTriangulation, vtkPolyhedralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkContourTriangulation();
  ~vtkContourTriangulation() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkContourTriangulation(const vtkContourTriangulation&) = delete;
  void operator=(const vtkContourTriangulation&) = delete;
};

#endif
