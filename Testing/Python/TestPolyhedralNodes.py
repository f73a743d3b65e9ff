# SPDX-License-Identifier: GPL-3.0-or-later
"""The nodes of the polyhedral method: their arrays, their outputs' invariants, and bad input."""
import numpy as np

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.util.numpy_support import vtk_to_numpy


def array(attributes, name):
    found = attributes.GetArray(name)
    ct.check(found is not None, f"there is an array {name}")
    return vtk_to_numpy(found)


def loops(*polygons):
    """Contours of lists of points."""
    producer = simple.PVTrivialProducer()
    producer.GetClientSideObject().SetOutput(ct.closed_polylines(polygons))
    return producer


def square(z, half=1.0, x=0.0):
    return [(x - half, -half, z), (x + half, -half, z), (x + half, half, z), (x - half, half, z)]


def finer(polygon, parts=6):
    """The same polygon with more vertices on its edges."""
    fine = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        fine += [tuple(a + (b - a) * k / parts for a, b in zip(p, q)) for k in range(parts)]
    return fine


def corners(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def volume(data):
    points = vtk_to_numpy(data.GetPoints().GetData())
    a, b, c = (points[corners(data)[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def closed(data):
    triangles = corners(data)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    forward = {tuple(e) for e in edges}
    return len(forward) == len(edges) and all((b, a) in forward for a, b in forward)


# A prism has one answer.
data = ct.data(simple.PolyhedralSurface(Input=loops(square(0), square(3)), EndCaps="Flat"))
ct.check(closed(data), "the prism is closed and oriented")
ct.check(abs(volume(data) - 12) < 1e-12, f"the prism's volume is 12, not {volume(data)}")
kind = array(data.GetCellData(), "FaceKind")
ct.check((kind == 1).sum() == 4 and (kind == 0).sum() == 8, f"two caps of 2 and four walls of 2 triangles: {kind}")
ct.check(set(array(data.GetPointData(), "PointKind")) == {0}, "all its points are input vertices")
ct.check(list(array(data.GetFieldData(), "LevelOffset")) == [0, 3], "its levels are at 0 and 3")
ct.check(list(array(data.GetFieldData(), "LevelNormal")) == [0, 0, 1] or
         tuple(data.GetFieldData().GetArray("LevelNormal").GetTuple(0)) == (0, 0, 1), "its normal is z")

# One contour becomes two: the surface branches, and every input vertex is a point of it, to the last bit.
given = [finer(square(0, 3)), finer(square(2, 1, -2)), finer(square(2, 1, 2))]
branching = loops(*given)
data = ct.data(simple.PolyhedralSurface(Input=branching))
ct.check(closed(data), "the branching is closed and oriented")
points = {tuple(p) for p in vtk_to_numpy(data.GetPoints().GetData())}
missing = {tuple(map(float, p)) for polygon in given for p in polygon} - points
ct.check(not missing, f"every contour vertex is in the surface; missing: {missing}")
ct.check(data.GetFieldData().GetAbstractArray("Report") is None, "and there is nothing to report")
ct.check(12 < volume(data) < 72, f"its volume {volume(data)} lies between what its ends allow")
apart = ct.data(simple.PolyhedralSurface(Input=branching, InternalPoints=0))
ct.check(closed(apart), "also without internal points")

# Where contours are so coarse that one is joined to nothing, it is named, not lost.
coarse = ct.data(simple.PolyhedralSurface(Input=loops(square(0, 3), square(2, 1, -2), square(2, 1, 2))))
points = {tuple(p) for p in vtk_to_numpy(coarse.GetPoints().GetData())}
lines = coarse.GetFieldData().GetAbstractArray("Report")
named = " ".join(lines.GetValue(i) for i in range(lines.GetNumberOfValues())) if lines else ""
for contour, x in ((1, -2), (2, 2)):
    there = {tuple(map(float, p)) for p in square(2, 1, x)} <= points
    ct.check(there or f"Contour {contour} " in named, f"contour {contour} is in the surface or named in Report")
ct.check(closed(coarse), "and the surface is closed all the same")

# Stages.
triangulation = simple.ContourTriangulation(Input=branching)
data = ct.data(triangulation)
inside = array(data.GetCellData(), "Inside")
points = vtk_to_numpy(data.GetPoints().GetData())
a, b, c = (points[corners(data)[:, k]] for k in range(3))
areas = 0.5 * np.cross(b - a, c - a)[:, 2]
level = array(data.GetCellData(), "Level")
ct.check((areas > 0).all(), "triangles run counterclockwise about the level's normal")
ct.check(abs(areas[(inside == 1) & (level == 0)].sum() - 36) < 1e-9, "the lower contour's inside has its area")
ct.check(abs(areas[(inside == 1) & (level == 1)].sum() - 8) < 1e-9, "the upper contours' inside has theirs")
ct.check(array(data.GetCellData(), "ContourEdges").max() >= 1, "contour edges are marked")
skeletons = triangulation.GetClientSideObject().GetOutputDataObject(1)
ct.check(skeletons.GetNumberOfLines() > 0, "there are skeletons")
ct.check(set(array(skeletons.GetCellData(), "Internal")) <= {0, 1}, "they are internal or external")

diagram = simple.JointVoronoiDiagram(Input=branching)
data = ct.data(diagram)
points = vtk_to_numpy(data.GetPoints().GetData())
ids = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, 4)
p, q, r, s = (points[ids[:, k]] for k in range(4))
volumes = np.einsum("ij,ij->i", np.cross(q - p, r - p), s - p) / 6
ct.check((volumes > 0).all(), "every tetrahedron is positively oriented")
node_type = array(data.GetCellData(), "NodeType")
ct.check(set(node_type) == {1, 2, 12}, f"all kinds of nodes occur: {set(node_type)}")
# The hull of a square of side 6 and a rectangle of 6 by 2, 2 apart: by the prismatoid formula.
hull = 2 / 6 * (36 + 12 + 4 * 6 * 4)
ct.check(abs(volumes.sum() - hull) < 1e-9, f"tetrahedra fill the convex hull: {volumes.sum()} of {hull}")
kept, reason = array(data.GetCellData(), "Kept"), array(data.GetCellData(), "Reason")
ct.check(((kept == 1) == (reason == 0)).all() and 0 < kept.sum() < len(kept), "some are kept, the others say why not")
graph = diagram.GetClientSideObject().GetOutputDataObject(1)
ct.check(graph.GetNumberOfPoints() == len(ids), "the graph has a point a tetrahedron")
ct.check(np.isfinite(vtk_to_numpy(graph.GetPoints().GetData())).all(), "each of them at a finite place")


# Bad input: a sentence, no output, no crash.
class Listener:
    def __init__(self, proxy):
        self.lines = []

        def note(_, __, message):
            self.lines.append(message)

        note.CallDataType = "string0"
        algorithm = proxy.GetClientSideObject()
        algorithm.AddObserver("ErrorEvent", note)
        algorithm.GetExecutive().AddObserver("ErrorEvent", note)


for node in (simple.PolyhedralSurface, simple.JointVoronoiDiagram):
    for name, source in (("one plane", loops(square(0), square(0, 0.5))),
                         ("not a number", loops([(float("nan"), 0, 0), (1, 0, 0), (0, 1, 0)])),
                         ("two points", loops([(0, 0, 0), (1, 0, 0)]))):
        proxy = node(Input=source)
        listener = Listener(proxy)
        out = ct.data(proxy)
        ct.check(listener.lines, f"{proxy.GetXMLLabel()} says what is wrong with {name}")
        ct.check(out.GetNumberOfCells() == 0 and out.GetNumberOfPoints() == 0, f"and gives nothing for {name}")

# No contours at all is common among regions of interest and no error; the report says so.
out = ct.data(simple.PolyhedralSurface(Input=loops()))
report = out.GetFieldData().GetAbstractArray("Report")
ct.check(report is not None and "is empty" in report.GetValue(0), "an empty input is reported")

# A collection: one region that fails takes none of the others with it.
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection
collection = vtkPartitionedDataSetCollection()
parts = [loops(square(0), square(1)), loops(square(0)), loops(square(5), square(7))]
collection.SetNumberOfPartitionedDataSets(len(parts))
for i, part in enumerate(parts):
    collection.SetPartition(i, 0, ct.data(part))
producer = simple.PVTrivialProducer()
producer.GetClientSideObject().SetOutput(collection)
proxy = simple.PolyhedralSurface(Input=producer, EndCaps="Flat")
listener = Listener(proxy)
out = ct.data(proxy)
blocks = [out.GetPartition(i, 0) if out.GetNumberOfPartitions(i) else None for i in range(3)]
sizes = [block.GetNumberOfCells() if block else 0 for block in blocks]
ct.check(sizes[0] == 12 and sizes[2] == 12, f"the good regions have surfaces: {sizes}")
ct.check(sizes[1] == 0 and listener.lines, "the bad one has none, and says why")

# Progress begins, ends, and never goes back, whichever stages repeat.
tower = [finer(square(float(z), 3 - 0.2 * z)) for z in range(8)]
for node in (simple.PolyhedralSurface(Input=loops(*tower), EndCaps="Extrapolated"), simple.FairSurface(Input=loops(*tower)),
             simple.ImplicitSurface(Input=loops(*tower))):
    seen = []
    tag = node.GetClientSideObject().AddObserver("ProgressEvent", lambda caller, _, seen=seen: seen.append(caller.GetProgress()))
    node.UpdatePipeline()
    node.GetClientSideObject().RemoveObserver(tag)
    ct.check(len(seen) > 3 and seen == sorted(seen) and seen[0] < 0.5,
             f"progress of {node.GetXMLName()} never goes back: {seen[:12]}")
ct.finish()
