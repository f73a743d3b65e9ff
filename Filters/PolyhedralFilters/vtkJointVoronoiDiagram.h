// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkJointVoronoiDiagram
 * @brief The tetrahedra between every two adjacent levels, and the graph they come from.
 *
 * The second stage of the Polyhedral Surface Method, to be looked at. Input: contours on two or
 * more parallel planes, as vtkPolyhedralSurface takes them. Coordinates and units are those of the
 * input.
 *
 * Output port 0, vtkUnstructuredGrid: all tetrahedra; those of a slab fill the convex hull of its
 * two levels.
 * - cell arrays `Slab` (0 = between the two lowest levels), `NodeType` (1: a triangle of the lower
 * level and an apex of the upper; 2: the other way round; 12: an edge of each), `Kept` (1 = part of
 * the solid), `Reason` (0 kept, 1 an edge outside its contours, 2 outside both contours, 3 touches
 * a level in less than a triangle);
 * - point arrays `Level`, `PointKind`.
 *
 * Output port 1, vtkPolyData: the graph of the joint Voronoi diagram, a point a tetrahedron and a
 * line where two tetrahedra share a face. A node lies where the projections of the two levels'
 * Voronoi diagrams have it, half way up the slab; where two coincident Voronoi edges leave a node
 * no place, it lies at its corners' centre.
 * - point arrays `NodeType`, `Kept`, `Reason`; cell array `Slab`.
 *
 * All points are shown in their planes: lifting (thesis 6.2) belongs to vtkPolyhedralSurface.
 *
 * Errors (a sentence, no output): no usable contour; contours on one plane only.
 *
 * Thesis 5.4, 5.5, 6.3, 6.4; algorithms 7 to 12.
 */
#ifndef vtkJointVoronoiDiagram_h
#define vtkJointVoronoiDiagram_h

#include "PolyhedralFiltersModule.h" // for the export macro
#include "vtkPolyhedralAlgorithm.h"

class vtkUnstructuredGrid;

class POLYHEDRALFILTERS_EXPORT vtkJointVoronoiDiagram : public vtkPolyhedralAlgorithm
{
public:
  static vtkJointVoronoiDiagram* New();
  vtkTypeMacro(vtkJointVoronoiDiagram, vtkPolyhedralAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The tetrahedra.
  vtkUnstructuredGrid* GetOutput();

protected:
  vtkJointVoronoiDiagram();
  ~vtkJointVoronoiDiagram() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkJointVoronoiDiagram(const vtkJointVoronoiDiagram&) = delete;
  void operator=(const vtkJointVoronoiDiagram&) = delete;
};

#endif
