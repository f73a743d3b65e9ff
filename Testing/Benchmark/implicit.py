# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Surface against the truth, its defaults beside the thesis's own settings.

    ./run bench            (or: pvpython implicit.py [name ...])

Phantoms of 1, 2 and 3 mm slices: error of the volume. Sets with a reference surface: mean and largest distance,
symmetric, between the points of the two surfaces and the other surface, in the units of the set. Reads the shared test
data and says so where it is absent.
"""
import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkSTLReader

SHARED = os.environ["CONTOUR_SHARED_DATA"]
SETTINGS = (("thesis", dict(Values="Unit", Normals="In Plane")),
            ("in plane, distance", dict(Values="Distance", Normals="In Plane")),
            ("default", dict()))
PHANTOMS = {"Sphere": 7238.23, "RtCylinder": 10857.34, "RtCone": 3619.11}
# Points a contour at least, so that the fit takes seconds: sampling below this changes nothing that is measured here.
REFERENCES = {"eight_15": 0.03, "hand_ok": 0.03, "balloondog": 0.03}


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


def euler(data):
    certificate = output(simple.SurfaceCertificate(Input=producer(data)))
    return int(certificate.GetFieldData().GetArray("Euler").GetTuple1(0))


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
                print(f"{name:18s} {label:20s} {error:+8.3f} % of the volume   {seconds:6.1f} s", flush=True)


def bench_references(wanted):
    for name, spacing in REFERENCES.items():
        if wanted and name not in wanted:
            continue
        contours = simple.CurveNetworkReader(FileName=os.path.join(SHARED, "csl", name + ".csl"))
        reader = vtkSTLReader()
        reader.SetFileName(os.path.join(SHARED, "csl", "reference", name + "_scaled.stl"))
        reader.Update()
        triangles = vtkTriangleFilter()
        triangles.SetInputData(reader.GetOutput())
        triangles.Update()
        for label, properties in SETTINGS:
            made, seconds = surface(contours, dict(properties, ResampleSpacing=spacing))
            mean, largest = distance(made, triangles.GetOutput())
            print(f"{name:18s} {label:20s} mean {mean:.5f} largest {largest:.4f} Euler {euler(made):3d}   {seconds:6.1f} s",
                  flush=True)


if not os.path.isdir(SHARED):
    print(f"SKIPPED: {SHARED} is not there")
    sys.exit(77)
bench_phantoms(sys.argv[1:])
bench_references(sys.argv[1:])
