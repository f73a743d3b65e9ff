# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Surface on real sets of contours on planes of any orientation: sound, and through its contours.

    TestImplicitSets.py [NAME ...]

The armadillo (three directions, as it is and simplified), the skull (nested), the heart (planes of any orientation) and the
vertebra (near-parallel and orthogonal planes, invalid rings, points that nearly coincide). Each surface must be closed, manifold, oriented and free of self-intersections and of angles under a degree, and every drawn
contour must lie within a cell of it; the simplified armadillo is measured against the surface it was cut from. Prints a row
of Markdown a set.

Contours are resampled, those of the vertebra least, as it has walls and gaps as thin as the node's own cells.
"""
import sys
import time

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkHausdorffDistancePointSetFilter
from vtkmodules.vtkIOGeometry import vtkSTLReader

# File, spacing of contour points and size of cells (parts of the bounding box's diagonal; 0: what the node chooses), other
# properties, reference.
SETS = {
    "armadillo": ("armadillo_simplified_from_mesh", 0.008, 0.008, {}, "armadillo_simplified_scaled"),
    "armadillo-full": ("armadillo", 0.008, 0.008, {}, None),
    "Skull-20": ("Skull-20", 0.015, 0.012, {}, None),
    "Heart-25": ("Heart-25-even-better", 0.012, 0.012, {}, None),
    "Vetebrae": ("Vetebrae", 0.006, 0, {}, None),
}
SOUND = ("Closed", "EdgeManifold", "VertexManifold", "Oriented", "Outward")
# Mean and largest distance, symmetric, of the armadillo from its reference, as parts of the diagonal.
NEAREST = (0.0025, 0.03)


def figure(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def distances(surface, reference):
    """Mean and largest distance between points of either and the other surface."""
    both = vtkHausdorffDistancePointSetFilter()
    both.SetInputData(0, surface)
    both.SetInputData(1, reference)
    both.SetTargetDistanceMethodToPointToCell()
    both.Update()
    means = []
    for port in (0, 1):
        array = both.GetOutput(port).GetPointData().GetArray("Distance")
        means.append(sum(array.GetTuple1(i) for i in range(array.GetNumberOfTuples())) / array.GetNumberOfTuples())
    return sum(means) / 2, both.GetHausdorffDistance()


def read_reference(name):
    reader = vtkSTLReader()
    reader.SetFileName(ct.shared(f"csl/reference/{name}.stl"))
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(reader.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def check_set(name, file, spacing, cell, properties, reference):
    contours = simple.CurveNetworkReader(FileName=ct.shared(f"csl/{file}.csl"))
    diagonal = ct.data(contours).GetLength()
    start = time.process_time()
    node = simple.ImplicitSurface(Input=contours, ResampleSpacing=spacing * diagonal, CellSize=cell * diagonal,
                                  **properties)
    surface = ct.data(node)
    seconds = time.process_time() - start
    certificate = ct.data(simple.SurfaceCertificate(Input=node, Contours=contours))
    for kind in SOUND:
        ct.check(figure(certificate, kind) == 1, f"{name}: {kind} is {figure(certificate, kind)}")
    crossing = figure(certificate, "CrossingPairs")
    ct.check(crossing == 0, f"{name}: {crossing} pairs of triangles cross")
    farthest = max(figure(certificate, "FarthestContourVertex"), figure(certificate, "FarthestContourEdge"))
    size = figure(surface, "CellSize")
    ct.check(farthest <= size, f"{name}: a contour is {farthest} away from the surface, more than a cell of {size}")
    angle = figure(surface, "SmallestAngle")
    ct.check(angle >= 1, f"{name}: an angle of {angle} degrees")
    row = [name, f"{figure(surface, 'ConstraintCount'):.0f}", surface.GetNumberOfPolys(),
           f"{figure(certificate, 'Components'):.0f}", f"{figure(certificate, 'Euler'):.0f}", f"{crossing:.0f}",
           f"{farthest / size:.2f}", f"{seconds:.0f}"]
    if reference:
        mean, largest = (d / diagonal for d in distances(surface, read_reference(reference)))
        ct.check(mean <= NEAREST[0] and largest <= NEAREST[1], f"{name}: {mean} and {largest} from its reference")
        row.append(f"{mean:.5f} / {largest:.4f}")
    print("| " + " | ".join(map(str, row)) + " |", flush=True)


print("| set | constraints | triangles | components | Euler | crossing pairs | farthest contour in cells | CPU s | "
      "mean / largest distance to the reference in diagonals |")
for name in sys.argv[1:] or SETS:
    check_set(name, *SETS[name])
ct.finish()
