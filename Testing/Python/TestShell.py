# SPDX-License-Identifier: GPL-3.0-or-later
"""What is the same from every node: empty and points-only input, a surface instead of contours, one error line, Report, LevelNormal."""
import math

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPartitionedDataSetCollection, vtkPolyData

POLYHEDRAL = (simple.ContourTriangulation, simple.JointVoronoiDiagram, simple.PolyhedralSurface)
FROM_CONTOURS = (simple.ContourHierarchy, simple.ContourMapping) + POLYHEDRAL + (
    simple.ImplicitConstraints, simple.ImplicitSurface)
FROM_MODEL = (simple.ImplicitFunction, simple.ImplicitPolygonizer, simple.ImplicitContours)


def producer(data):
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def ring(z, radius=5.0, count=24, x=0.0):
    return [(x + radius * math.cos(2 * math.pi * k / count), radius * math.sin(2 * math.pi * k / count), z)
            for k in range(count)]


def lines(data):
    array = data.GetFieldData().GetAbstractArray("Report")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def run(kind, data):
    """The node after its update, and what VTK said."""
    node = kind(Input=producer(data))
    said = ct.errors_of(node.UpdatePipeline)
    return node, said


def output(node, port=0):
    return node.GetClientSideObject().GetOutputDataObject(port)


def points_only(kind=None):
    """Points with vertices of a geometric type, or, of none, without cells."""
    data = vtkPolyData()
    points, vertices, types = vtkPoints(), vtkCellArray(), vtkStringArray()
    for k in range(3):
        vertices.InsertNextCell(1, [points.InsertNextPoint(k, 0, 0)])
        types.InsertNextValue(kind or "")
    data.SetPoints(points)
    if kind:
        data.SetVerts(vertices)
        types.SetName("GeometricType")
        data.GetCellData().AddArray(types)
    return data


GOOD = ct.closed_polylines([ring(z, 5 - abs(z) / 4) for z in (-4, -2, 0, 2, 4)])

# An empty input is no error, and every output of every node says the same.
for kind in FROM_CONTOURS + FROM_MODEL:
    node, said = run(kind, vtkPolyData())
    ct.check(said == "", f"{kind.__name__} said of an empty input: {said!r}")
    for port in range(node.GetClientSideObject().GetNumberOfOutputPorts()):
        if kind is simple.ContourMapping and port == 1:
            continue  # the table of joins has no field data of the contours
        ct.check(lines(output(node, port)) == ["The input is empty, so the output is empty."],
                 f"{kind.__name__}, port {port}: {lines(output(node, port))}")
    ct.check(output(node).GetNumberOfCells() == 0, f"{kind.__name__} makes nothing of nothing")

# Points without cells are a mistake, and one error says so; a region of a structure set that is points only is none.
for kind in FROM_CONTOURS:
    node, said = run(kind, points_only())
    ct.check(said.count("points but no cells") == 1, f"{kind.__name__} said of points: {said!r}")
    ct.check("returned failure" not in said, f"{kind.__name__}: no second line")
    ct.check(output(node).GetNumberOfPoints() == 0, f"{kind.__name__} has no output then")
    node, said = run(kind, points_only("POINT"))
    ct.check("ERR" not in said and said.count("points only, without a contour") == 1,
             f"{kind.__name__} said of an isocentre: {said!r}")
    ct.check("points only" in lines(output(node))[-1], f"{kind.__name__} reports it")

# So are open contours, unless one ends where it begins.
channel = ct.closed_polylines([ring(z) for z in (0, 2, 4)])
for name, last in (("open", 5), ("closed", 0)):
    lines_of, types = vtkCellArray(), vtkStringArray()
    types.SetName("GeometricType")
    for z in range(3):
        ids = [24 * z + k for k in range(24)] + [24 * z + last]
        lines_of.InsertNextCell(25, ids) if name == "closed" else lines_of.InsertNextCell(20, ids[:20])
        types.InsertNextValue("OPEN_PLANAR")
    region = vtkPolyData()
    region.SetPoints(channel.GetPoints())
    region.SetLines(lines_of)
    region.GetCellData().AddArray(types)
    node, said = run(simple.PolyhedralSurface, region)
    if name == "open":
        ct.check("ERR" not in said and said.count("open contours only") == 1, f"a channel is nothing to do: {said!r}")
    else:
        ct.check(said == "" and output(node).GetNumberOfCells() > 0, f"what ends where it begins is closed: {said!r}")

# A surface that somebody forgot to cut; polygons that lie side by side in their planes are none.
sphere = ct.data(simple.Sphere())
loose = ct.data(simple.Shrink(Input=simple.Sphere(), ShrinkFactor=1.0))
geometry = ct.data(simple.ExtractSurface(Input=simple.Shrink(Input=simple.Sphere(), ShrinkFactor=1.0)))
ct.check(geometry.GetNumberOfPoints() == 3 * geometry.GetNumberOfCells(), "every triangle has points of its own")
strips = vtkPolyData()
strips.SetPoints(sphere.GetPoints())
band = vtkCellArray()
band.InsertNextCell(5, [0, 1, 2, 3, 4])
strips.SetStrips(band)
for kind in FROM_CONTOURS:
    for name, data in (("a sphere", sphere), ("loose triangles", geometry), ("strips", strips)):
        node, said = run(kind, data)
        ct.check(said.count("The input is a surface, not contours: cut it with Slice first.") == 1 and
                 "returned failure" not in said, f"{kind.__name__} said of {name}: {said!r}")
        ct.check(output(node).GetNumberOfPoints() == 0, f"{kind.__name__} has no output for {name}")


def tiles(z):
    """Four squares about the origin that share edges by index."""
    return [[(x, y, z), (x + 1, y, z), (x + 1, y + 1, z), (x, y + 1, z)] for x in (-1, 0) for y in (-1, 0)]


points, polygons, number = vtkPoints(), vtkCellArray(), {}
for z in (0.0, 1.0, 2.0):
    for tile in tiles(z):
        ids = [number.setdefault(p, len(number)) for p in tile]
        polygons.InsertNextCell(4, ids)
for p in number:
    points.InsertNextPoint(p)
tiled = vtkPolyData()
tiled.SetPoints(points)
tiled.SetPolys(polygons)
node, said = run(simple.ContourHierarchy, tiled)
ct.check(said == "" and output(node).GetNumberOfCells() > 0, f"neighbours in a plane are contours: {said!r}")

# LevelNormal: a tuple of three a level, from every node that gives it.
for kind in (simple.ContourHierarchy, simple.ContourMapping) + POLYHEDRAL:
    node, said = run(kind, GOOD)
    for port in range(node.GetClientSideObject().GetNumberOfOutputPorts()):
        if kind is simple.ContourMapping and port == 1:
            continue
        data = output(node, port).GetFieldData()
        normal, offset = data.GetArray("LevelNormal"), data.GetArray("LevelOffset")
        ct.check(normal.GetNumberOfComponents() == 3 and normal.GetNumberOfTuples() == offset.GetNumberOfTuples() == 5,
                 f"{kind.__name__}, port {port}: {normal.GetNumberOfTuples()} normals, {offset.GetNumberOfTuples()} offsets")

# A collection whose blocks are a slice each is one object; regions of their own stay regions.
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet


def blocks_of(names):
    stack = vtkMultiBlockDataSet()
    for i, z in enumerate((0, 2, 4)):
        slice_of = ct.closed_polylines([ring(z)])
        if names:
            name = vtkStringArray()
            name.SetName("ROIName")
            name.InsertNextValue(names[i])
            slice_of.GetFieldData().AddArray(name)
        stack.SetBlock(i, slice_of)
    return stack


for kind in (simple.PolyhedralSurface, simple.ImplicitSurface):
    node, said = run(kind, blocks_of(None))
    sizes = [output(node).GetBlock(i).GetNumberOfCells() for i in range(3)]
    ct.check(said == "" and sizes[0] > 0 and sizes[1:] == [0, 0], f"{kind.__name__} of slices: {sizes} {said!r}")
    ct.check(any("3 blocks of the collection lie in a plane each" in line for line in lines(output(node).GetBlock(0))),
             f"{kind.__name__} says that blocks are slices: {lines(output(node).GetBlock(0))}")
    node, said = run(kind, blocks_of(["A", "B", "C"]))
    ct.check(said.count("one plane") == 3, f"{kind.__name__} of regions with a slice each: {said!r}")

# More than a tenth of the contours left out is said aloud, an empty surface is an error.
two = ct.closed_polylines([ring(z) for z in (0, 2, 4)] + [ring(z, x=40) for z in (0,)])
node = simple.PolyhedralSurface(Input=producer(two), IsolatedContours="Drop")
said = ct.errors_of(node.UpdatePipeline)
ct.check("1 of 4 contours are left out of the surface" in said and "ERR" not in said, f"a warning: {said!r}")
ct.check(output(node).GetFieldData().GetArray("LeftOutCount").GetValue(0) == 1, "and the count is there")
apart = ct.closed_polylines([ring(0), ring(2, x=40)])
node = simple.PolyhedralSurface(Input=producer(apart), IsolatedContours="Drop", AlignLevels=0)
said = ct.errors_of(node.UpdatePipeline)
ct.check(said.count("No surface came out") == 1, f"an empty surface is an error: {said!r}")

# Report as the panel shows it: what each surface is worth, how much there is to know, and what.
def panel(node):
    node.UpdatePropertyInformation()
    return node.GetProperty("Report").GetData().splitlines()


SURFACES = (simple.PolyhedralSurface, simple.ImplicitSurface)
for kind in FROM_CONTOURS:
    node, said = run(kind, GOOD)
    shown = panel(node)
    if kind in SURFACES:
        figures = simple.SurfaceCertificate(Input=node)
        figures.UpdatePipeline()
        volume = output(figures).GetFieldData().GetArray("Volume").GetValue(0)
        word, _, number = shown.pop(0).partition(", volume ")
        ct.check(word == "closed" and abs(float(number) - volume) < 1e-5 * volume,
                 f"{kind.__name__} says {word}, {number}, and the certificate {volume}")
    ct.check(lines(output(node)) or shown == ["Nothing was changed or left out."], f"{kind.__name__} reports {shown!r}")
    ct.check(kind in SURFACES or not output(node).GetFieldData().HasArray("Summary"), f"{kind.__name__} is no surface")
odd = ct.closed_polylines([ring(z) for z in (0, 2, 4)] + [[(0, 0, 6), (1, 0, 6)]])
node, _ = run(simple.PolyhedralSurface, odd)
shown = panel(node)
ct.check(shown[0].startswith("closed, ") and shown[1].endswith("to know:") and lines(output(node)) and
         " ".join(" ".join(shown[2:]).split()) == "- " + " - ".join(lines(output(node))), f"the panel shows {shown!r}")
node = simple.PolyhedralSurface(Input=producer(GOOD), EndCaps="None")
node.UpdatePipeline()
ct.check(panel(node)[0] == "open (48 open edges), no volume", f"an open surface is said to be {panel(node)[0]!r}")
again = simple.ContourHierarchy(Input=simple.FeatureEdges(Input=node))
again.UpdatePipeline()
ct.check(not output(again).GetFieldData().HasArray("Summary"), "what is made of a surface has not its summary")
collection = vtkPartitionedDataSetCollection()
for i, (name, data) in enumerate((("Heart", odd), ("Lung", GOOD))):
    collection.SetPartition(i, 0, data)
    collection.GetMetaData(i).Set(collection.NAME(), name)
    number = vtkIntArray()
    number.SetName("ROINumber")
    number.SetNumberOfTuples(1)
    data.GetFieldData().AddArray(number)
node, _ = run(simple.PolyhedralSurface, collection)
shown = panel(node)
ct.check(shown[0].startswith("Heart: closed, ") and shown[1].startswith("Lung: closed, ") and shown[1].endswith(" cm3"),
         f"of a collection the panel shows {shown!r}")
told = "\n".join(shown[2:])
ct.check("- Heart: " in told and "Lung: " not in told, f"of a collection the panel shows {shown!r}")
ct.finish()
