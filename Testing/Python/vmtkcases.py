# SPDX-License-Identifier: GPL-3.0-or-later
"""The package beside VTK and vmtk in one process, as TestWheel.py runs it.

    vmtkcases.py RESULT.npz SOURCE SHARED

vmtk measures a surface of the package and finds the centrelines of its branches. Writes the surface under the name of
wheelcases.py.
"""
import os
import sys

import numpy as np
import vtk
from vmtk import vmtkscripts
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import contour_reconstruction as cr

RESULT, SOURCE = sys.argv[1:3]
SAME_VOLUME = 1e-6  # relative; vmtk has its own sum


def poly_data(surface):
    points, triangles, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(surface.points, deep=True))
    triangles.SetData(3, numpy_to_vtk(surface.triangles.ravel(), deep=True, array_type=vtk.VTK_ID_TYPE))
    data.SetPoints(points)
    data.SetPolys(triangles)
    return data


def end_of(contours, z):
    """The middle of a contour at this height."""
    return next(loop for loop in contours if np.allclose(loop[:, 2], z)).mean(axis=0)


contours = cr.read(os.path.join(SOURCE, "Data/branching_pipe.cnt"))
surface = cr.fair_surface(contours, EndCaps="Flat")
data = poly_data(surface)

measured = vmtkscripts.vmtkSurfaceMassProperties()
measured.Surface = data
measured.Execute()
volume = cr.certificate(surface).figures["Volume"]
assert abs(measured.Volume / volume - 1) < SAME_VOLUME, (measured.Volume, volume)

heights = [loop[0, 2] for loop in contours]
low, high = end_of(contours, min(heights)), end_of(contours, max(heights))
inside = (high - low) * 0.05
lines = vmtkscripts.vmtkCenterlines()
lines.Surface, lines.SeedSelectorName = data, "pointlist"
lines.SourcePoints, lines.TargetPoints = (low + inside).tolist(), (high - inside).tolist()
lines.Execute()
radius = vtk_to_numpy(lines.Centerlines.GetPointData().GetArray("MaximumInscribedSphereRadius"))
middle = vtk_to_numpy(lines.Centerlines.GetPoints().GetData())
assert len(middle) > 10 and radius.min() > 0, (len(middle), radius.min())
length = np.linalg.norm(np.diff(middle, axis=0), axis=1).sum()
assert length >= 0.8 * np.linalg.norm(high - low), (length, low, high)
print(f"vmtk {vtk.vtkVersion().GetVTKVersion()}: volume {measured.Volume:.6f}, a centreline of length {length:.3f}")

np.savez(RESULT, **{"branching_pipe.cnt fair/mesh/points": surface.points,
                    "branching_pipe.cnt fair/mesh/triangles": surface.triangles})
