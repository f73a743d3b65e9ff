# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces with known defects, for the tests of Surface Certificate."""
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

SIDES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def surface(points, cells, precision=VTK_DOUBLE):
    """vtkPolyData of polygons."""
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetDataType(precision)
    for p in points:
        vtk_points.InsertNextPoint(*p)
    polys = vtkCellArray()
    for cell in cells:
        polys.InsertNextCell(len(cell))
        for i in cell:
            polys.InsertCellPoint(i)
    data.SetPoints(vtk_points)
    data.SetPolys(polys)
    return data


def box_corners(low, high):
    return [tuple(high[k] if i >> k & 1 else low[k] for k in range(3)) for i in range(8)]


def box_triangles(first=0):
    return [tuple(first + i for i in t) for s in SIDES for t in ((s[0], s[1], s[2]), (s[0], s[2], s[3]))]


def boxes(*extents):
    """Boxes (low, high) side by side, no points shared: (points, triangles)."""
    points, triangles = [], []
    for low, high in extents:
        triangles += box_triangles(len(points))
        points += box_corners(low, high)
    return points, triangles


def square_contour(z, x=0.0, size=1.0):
    """One closed polyline."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataType(VTK_DOUBLE)
    for p in ((x, 0, z), (x + size, 0, z), (x + size, size, z), (x, size, z)):
        points.InsertNextPoint(*p)
    lines = vtkCellArray()
    lines.InsertNextCell(5)
    for i in (0, 1, 2, 3, 0):
        lines.InsertCellPoint(i)
    data.SetPoints(points)
    data.SetLines(lines)
    return data
