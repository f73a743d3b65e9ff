# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours whose true surface is known, and how far a surface is from it: what the benches of both methods share.

Distances are between points spread evenly over the one surface (by area, with a fixed seed), with its vertices, and the other
surface, both ways, in the units of the set; means are those of the even points, half of it from either way.
"""
import base64
import gzip
import json
import os
import xml.etree.ElementTree
import zlib

import numpy
from paraview import simple

simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkLogger, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkGenericCell, vtkPlane, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkCutter, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader

# vtkCutter announces every plane.
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)
SOURCE = os.environ["CONTOUR_SOURCE_DIR"]
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(SOURCE, "..", "shared", "data"))
SETS = ("eight_15", "hand_ok", "balloondog")
MESHES = ("femur.off", "bones.off", "couplingdown.off", "knot2.off", "elephant.off", "fertility.off", "kitten.obj",
          "pial_left.gii.gz")
SLICES = 24
SAMPLES = 30000


def poly_data(points, triangles):
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    data.SetPoints(places)
    cells = vtkCellArray()
    corners = numpy.ascontiguousarray(triangles, dtype=numpy.int64).ravel()
    cells.SetData(numpy_to_vtkIdTypeArray(numpy.arange(0, len(corners) + 1, 3, dtype=numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(corners, deep=True))
    data.SetPolys(cells)
    return data


def closed_polylines(loops):
    """Loops of points as closed polylines."""
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for loop in loops:
        ids = [points.InsertNextPoint(p) for p in loop]
        lines.InsertNextCell(len(ids) + 1)
        for i in ids + ids[:1]:
            lines.InsertCellPoint(i)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


def read_off(path):
    with open(path) as file:
        words = [w for line in file for w in line.split("#")[0].split()]
    count, faces = int(words[1]), int(words[2])
    points = numpy.array(words[4:4 + 3 * count], dtype=float).reshape(-1, 3)
    rest = numpy.array(words[4 + 3 * count:4 + 3 * count + 4 * faces], dtype=int).reshape(-1, 4)
    return poly_data(points, rest[:, 1:])


def read_gifti(path):
    """Points and triangles of a GIfTI file whose arrays are zlib-compressed base64."""
    with gzip.open(path) as file:
        root = xml.etree.ElementTree.parse(file).getroot()
    arrays = {}
    for array in root.iter("DataArray"):
        kind = numpy.float32 if "FLOAT" in array.get("DataType") else numpy.int32
        raw = base64.b64decode(array.find("Data").text)
        raw = zlib.decompress(raw) if "GZip" in array.get("Encoding") else raw
        order = "<" if array.get("Endian") == "LittleEndian" else ">"
        arrays[array.get("Intent")] = numpy.frombuffer(raw, numpy.dtype(kind).newbyteorder(order)).reshape(-1, 3)
    return poly_data(arrays["NIFTI_INTENT_POINTSET"], arrays["NIFTI_INTENT_TRIANGLE"])


def read_vtk(reader, path):
    reader.SetFileName(path)
    triangles, merged = vtkTriangleFilter(), vtkCleanPolyData()
    triangles.SetInputConnection(reader.GetOutputPort())
    merged.SetInputConnection(triangles.GetOutputPort())
    merged.SetTolerance(0)
    merged.Update()
    made = merged.GetOutput()
    return poly_data(vtk_to_numpy(made.GetPoints().GetData()), corners_of(made))


def read_mesh(path):
    if path.endswith(".off"):
        return read_off(path)
    if path.endswith(".gii.gz"):
        return read_gifti(path)
    return read_vtk(vtkSTLReader() if path.endswith(".stl") else vtkOBJReader(), path)


def corners_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def output(proxy):
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def cut(mesh, axis):
    """Sections of the mesh at the middles of SLICES equal slices, as loose segments."""
    low, high = mesh.GetBounds()[2 * axis], mesh.GetBounds()[2 * axis + 1]
    plane = vtkPlane()
    plane.SetNormal([1.0 if a == axis else 0.0 for a in range(3)])
    cutter = vtkCutter()
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(plane)
    cutter.SetOutputPointsPrecision(1)
    for i in range(SLICES):
        cutter.SetValue(i, low + (i + 0.5) * (high - low) / SLICES)
    cutter.Update()
    return producer(cutter.GetOutput())


def cases(wanted):
    """(name, contours as a proxy, reference)"""
    for name in SETS:
        if any(w in name for w in wanted) or not wanted:
            yield (name, simple.CurveNetworkReader(FileName=os.path.join(SHARED, "csl", name + ".csl")),
                   read_mesh(os.path.join(SHARED, "csl", "reference", name + "_scaled.stl")))
    for file in MESHES:
        names = [f"{file.split('.')[0]} {axis}" for axis in "xyz"]
        chosen = [n for n in names if not wanted or any(w in n for w in wanted)]
        mesh = read_mesh(os.path.join(SHARED, "mesh", file)) if chosen else None
        for name in chosen:
            yield name, cut(mesh, names.index(name)), mesh


def spread(data, count):
    """Points spread evenly over a surface, always the same ones."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    a, b, c = (points[corners_of(data)[:, k]] for k in range(3))
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    reach = numpy.cumsum(areas)
    random = numpy.random.default_rng(1)
    chosen = numpy.searchsorted(reach, (numpy.arange(count) + random.random(count)) * reach[-1] / count)
    chosen = numpy.minimum(chosen, len(areas) - 1)
    u, v = numpy.sqrt(random.random((count, 1))), random.random((count, 1))
    return (1 - u) * a[chosen] + u * (1 - v) * b[chosen] + u * v * c[chosen]


def distances(points, to):
    locator = vtkStaticCellLocator()
    locator.SetDataSet(to)
    locator.BuildLocator()
    cell, place = vtkGenericCell(), [0.0, 0.0, 0.0]
    number, sub, square = mutable(0), mutable(0), mutable(0.0)
    found = numpy.empty(len(points))
    for i, point in enumerate(points):
        locator.FindClosestPoint(point, place, cell, number, sub, square)
        found[i] = float(square) ** 0.5
    return found


def distance(a, b):
    """Mean and largest, symmetric; and the means of either way."""
    means, largest = [], 0
    for one, other in ((a, b), (b, a)):
        even = distances(spread(one, SAMPLES), other)
        vertices = vtk_to_numpy(one.GetPoints().GetData())
        means.append(float(even.mean()))
        largest = max(largest, float(even.max()), float(distances(vertices[::1 + len(vertices) // SAMPLES], other).max()))
    return sum(means) / 2, largest, means


def certificate(data):
    field = output(simple.SurfaceCertificate(Input=producer(data))).GetFieldData()
    return json.loads(field.GetAbstractArray("CertificateJSON").GetValue(0))["Total"]


def volume(data):
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    a, b, c = (points[corners_of(data)[:, k]] for k in range(3))
    return abs(float(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6))


def value_of(text):
    """A property's value as typed: ParaView takes numbers for numbers only."""
    try:
        return json.loads(text)
    except ValueError:
        return text
