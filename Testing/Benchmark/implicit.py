# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Surface against the truth, its defaults beside the thesis's own settings.

    ./run bench implicit [name ...]

Phantoms of 1, 2 and 3 mm slices: error of the volume. Sets with a reference surface (femur: 24 cuts along z): error of the
volume, mean and largest distance, symmetric, between the points of the two surfaces and the other surface, in the units of
the set, and Euler numbers; of all, crossing triangle pairs and the least angle. "refined" is what Implicit Surface does by default. Reads the shared test
data and says so where it is absent.
"""
import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkGenericCell, vtkPlane, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCutter, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkSTLReader

SHARED = os.environ["CONTOUR_SHARED_DATA"]
SETTINGS = (("thesis", dict(Values="Unit", Normals="In Plane")),
            ("in plane, distance", dict(Values="Distance", Normals="In Plane")),
            ("refined", dict()))
PHANTOMS = {"Sphere": 7238.23, "RtCylinder": 10857.34, "RtCone": 3619.11}
# Distance between contour points, so that the fit takes seconds and all settings see the same points.
REFERENCES = {"eight_15": 0.03, "hand_ok": 0.03, "balloondog": 0.03, "femur": 0.015}
FEMUR_CUTS = 24


def output(proxy):
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def first_block(collection):
    """The block with the most contours: the phantom, not its point of interest."""
    best = None
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        block = collection.GetPartition(i, 0)
        if block and (best is None or block.GetNumberOfCells() > best.GetNumberOfCells()):
            best = block
    return best


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def surface(contours, properties):
    start = time.perf_counter()
    made = output(simple.ImplicitSurface(Input=contours, **properties))
    return made, time.perf_counter() - start


def volume(data):
    mass = vtkMassProperties()
    mass.SetInputData(data)
    return mass.GetVolume()


def one_way(points_of, to, step):
    locator = vtkStaticCellLocator()
    locator.SetDataSet(to)
    locator.BuildLocator()
    cell, place = vtkGenericCell(), [0.0, 0.0, 0.0]
    number, sub, square = mutable(0), mutable(0), mutable(0.0)
    distances = []
    for i in range(0, points_of.GetNumberOfPoints(), step):
        locator.FindClosestPoint(points_of.GetPoint(i), place, cell, number, sub, square)
        distances.append(float(square) ** 0.5)
    return sum(distances) / len(distances), max(distances)


def distance(a, b):
    forth = one_way(a, b, max(1, a.GetNumberOfPoints() // 8000))
    back = one_way(b, a, max(1, b.GetNumberOfPoints() // 8000))
    return (forth[0] + back[0]) / 2, max(forth[1], back[1])


def figures(data):
    """Euler number, crossing triangle pairs and least angle in degrees."""
    found = output(simple.SurfaceCertificate(Input=producer(data))).GetFieldData()
    angle = data.GetFieldData().GetArray("LeastAngle")
    return (int(found.GetArray("Euler").GetTuple1(0)), int(found.GetArray("CrossingPairs").GetTuple1(0)),
            angle.GetTuple1(0) if angle else float("nan"))


def femur():
    """24 cuts in the middles of as many slabs along z, and the mesh they are of."""
    with open(os.path.join(SHARED, "mesh", "femur.off")) as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    count, faces = int(words[1]), int(words[2])
    points, cells, at = vtkPoints(), vtkCellArray(), 4 + 3 * count
    points.SetDataTypeToDouble()
    for i in range(count):
        points.InsertNextPoint(*map(float, words[4 + 3 * i:7 + 3 * i]))
    for _ in range(faces):
        size = int(words[at])
        cells.InsertNextCell(size, [int(word) for word in words[at + 1:at + 1 + size]])
        at += size + 1
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    low, high = mesh.GetBounds()[4:]
    cuts = vtkAppendPolyData()
    for i in range(FEMUR_CUTS):
        plane = vtkPlane()
        plane.SetNormal(0, 0, 1)
        plane.SetOrigin(0, 0, low + (high - low) * (i + 0.5) / FEMUR_CUTS)
        cutter = vtkCutter()
        cutter.SetCutFunction(plane)
        cutter.SetInputData(mesh)
        cutter.Update()
        cuts.AddInputData(cutter.GetOutput())
    cuts.Update()
    return producer(cuts.GetOutput()), mesh


def reference(name):
    """Contours and the surface they are of."""
    if name == "femur":
        return femur()
    reader = vtkSTLReader()
    reader.SetFileName(os.path.join(SHARED, "csl", "reference", name + "_scaled.stl"))
    reader.Update()
    return simple.CurveNetworkReader(FileName=os.path.join(SHARED, "csl", name + ".csl")), reader.GetOutput()


def bench_phantoms(wanted):
    for shape, truth in PHANTOMS.items():
        for slices in (10, 20, 30):
            name = f"{shape}_{slices}_0"
            if wanted and name not in wanted:
                continue
            reader = simple.DICOMRTStructureSetReader(FileName=os.path.join(SHARED, "rtstruct", "phantoms", name + ".dcm"))
            contours = producer(first_block(output(reader)))
            for label, properties in SETTINGS:
                made, seconds = surface(contours, dict(properties, ResampleSpacing=0.75))
                error = 100 * (volume(made) / truth - 1)
                number, crossing, angle = figures(made)
                print(f"{name:18s} {label:20s} volume {error:+8.3f} % Euler {number:3d} crossing {crossing} "
                      f"angle {angle:5.2f}   {seconds:6.1f} s", flush=True)


def bench_references(wanted):
    for name, spacing in REFERENCES.items():
        if wanted and name not in wanted:
            continue
        contours, surface_of = reference(name)
        triangles = vtkTriangleFilter()
        triangles.SetInputData(surface_of)
        triangles.Update()
        truth = triangles.GetOutput()
        print(f"{name:18s} {'truth':20s} Euler {figures(truth)[0]:3d}")
        for label, properties in SETTINGS:
            made, seconds = surface(contours, dict(properties, ResampleSpacing=spacing))
            mean, largest = distance(made, truth)
            number, crossing, angle = figures(made)
            error = 100 * (volume(made) / volume(truth) - 1)
            print(f"{name:18s} {label:20s} mean {mean:.5f} largest {largest:.4f} volume {error:+7.3f} % Euler {number:3d} "
                  f"crossing {crossing} angle {angle:5.2f}   {seconds:6.1f} s", flush=True)


if not os.path.isdir(SHARED):
    print(f"SKIPPED: {SHARED} is not there")
    sys.exit(77)
bench_phantoms(sys.argv[1:])
bench_references(sys.argv[1:])
