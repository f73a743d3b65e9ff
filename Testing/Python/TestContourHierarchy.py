# SPDX-License-Identifier: GPL-3.0-or-later
"""Contour Hierarchy on what ParaView itself makes: slices of a sphere, contours of an image, collections.

Also what it says about input that is no contour, and that it does not take ParaView down.
"""
import math

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkIdList, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkPartitionedDataSetCollection, vtkPolyData)

SIZE = 60


def cells(data):
    """The point ids of every line."""
    lists = []
    for c in range(data.GetNumberOfCells()):
        ids = vtkIdList()
        data.GetCellPoints(c, ids)
        lists.append([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
    return lists


def column(data, name):
    array = data.GetCellData().GetArray(name)
    return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())]


def report(data):
    array = data.GetFieldData().GetAbstractArray("Report")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def loops(*polygons, closed=True):
    """vtkPolyData with a polyline a polygon."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataType(VTK_DOUBLE)
    lines = vtkCellArray()
    for polygon in polygons:
        ids = [points.InsertNextPoint(*p) for p in polygon]
        if closed:
            ids.append(ids[0])
        lines.InsertNextCell(len(ids))
        for i in ids:
            lines.InsertCellPoint(i)
    data.SetPoints(points)
    data.SetLines(lines)
    return data


def source(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def square(x, y, size, z=0.0):
    return [(x, y, z), (x + size, y, z), (x + size, y + size, z), (x, y + size, z)]


# Slices of a sphere: loose segments in an order of ParaView's own.
sphere = simple.Sphere(Radius=1.0, ThetaResolution=SIZE, PhiResolution=SIZE)
slices = simple.Slice(Input=sphere, SliceType="Plane", Triangulatetheslice=0)
slices.SliceType.Normal = [0.0, 0.0, 1.0]
slices.SliceOffsetValues = [-0.51, 0.52, 0.013, 0.25]
hierarchy = simple.ContourHierarchy(Input=slices)
out = ct.data(hierarchy)
ct.check(out.GetNumberOfCells() == 4, "four slices of a sphere are four contours")
ct.check(all(c[0] == c[-1] for c in cells(out)), "every contour is closed by its first point")
ct.check(column(out, "Level") == [0, 1, 2, 3], "a level each, from low to high")
ct.check(column(out, "Depth") == [0] * 4 and column(out, "Parent") == [-1] * 4, "no holes")
offsets = out.GetFieldData().GetArray("LevelOffset")
found = [offsets.GetValue(i) for i in range(4)]
ct.check(all(abs(a - b) < 1e-6 for a, b in zip(found, [-0.51, 0.013, 0.25, 0.52])),
         "offsets are those of the slices")
ct.check(out.GetFieldData().GetArray("LevelNormal").GetTuple(0) == (0, 0, 1), "the normal is z")
for offset, area in zip(found, column(out, "SignedArea")):
    ct.check(0.98 < area / (math.pi * (1 - offset * offset)) < 1, f"area of the slice at {offset}")
ct.check(report(out) == [], "nothing to report")
before = ct.data(slices)
ct.check({before.GetPoint(i) for i in range(before.GetNumberOfPoints())}
         >= {out.GetPoint(i) for i in range(out.GetNumberOfPoints())}, "no point was moved")

# A hollow ball, cut along and across: planes of any orientation, or parallel ones only.
hollow = simple.AppendGeometry(Input=[sphere, simple.Sphere(Radius=0.5, ThetaResolution=SIZE,
                                                            PhiResolution=SIZE)])
across = simple.Slice(Input=hollow, SliceType="Plane", Triangulatetheslice=0)
across.SliceType.Normal = [0.0, 0.3, 1.0]
across.SliceOffsetValues = [-0.2, 0.2]
along = simple.Slice(Input=hollow, SliceType="Plane", Triangulatetheslice=0)
along.SliceType.Normal = [1.0, 0.0, 0.0]
along.SliceOffsetValues = [0.1]
both = simple.AppendGeometry(Input=[across, along])
hierarchy = simple.ContourHierarchy(Input=both)
out = ct.data(hierarchy)
ct.check(out.GetNumberOfCells() == 6, "three planes, two contours each")
ct.check(sorted(column(out, "Depth")) == [0, 0, 0, 1, 1, 1], "each a wall and a hole")
ct.check(all((a > 0) == (d == 0) for a, d in zip(column(out, "SignedArea"), column(out, "Depth"))),
         "holes have negative area")
ct.check(all(p == -1 or column(out, "Depth")[int(p)] == 0 for p in column(out, "Parent")),
         "the parent of a hole is a wall")
hierarchy.ParallelPlanesOnly = 1
out = ct.data(hierarchy)
ct.check(out.GetNumberOfCells() == 4, "two parallel planes stay")
ct.check(len(report(out)) == 2 and report(out)[0] == "2 contours were left out, 4 are kept."
         and report(out)[1].startswith("2 contours, the first of cell ") and "not parallel" in report(out)[1]
         and "Likewise cell " in report(out)[1], f"the others are named in one line: {report(out)}")

# Contours of an image, in a plane: pixel loops with holes.
wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0])
isolines = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150.0])
out = ct.data(simple.ContourHierarchy(Input=isolines))
ct.check(out.GetNumberOfCells() > 0, "isolines of an image are contours")
ct.check(len({z for z in (out.GetPoint(i)[2] for i in range(out.GetNumberOfPoints()))}) == 1,
         "in one plane")

# Cell data and field data of the input stay with the contours that came from it.
data = loops(square(0, 0, 1), square(5, 0, 1), square(-1, -1, 3))
label = vtkStringArray()
label.SetName("Material")
for name in ("inner", "other", "outer"):
    label.InsertNextValue(name)
data.GetCellData().AddArray(label)
name = vtkStringArray()
name.SetName("ROIName")
name.InsertNextValue("Heart")
data.GetFieldData().AddArray(name)
out = ct.data(simple.ContourHierarchy(Input=source(data)))
material = out.GetCellData().GetAbstractArray("Material")
ct.check(material is not None and
         [material.GetValue(i) for i in range(3)] == ["inner", "other", "outer"], "cell data stays")
ct.check(out.GetFieldData().GetAbstractArray("ROIName") is not None, "field data stays")
ct.check(report(out) == [], "nothing to report about nested squares")

# The small square lies in the large one's corner, on two of its edges: even-odd makes an L of the two.
out = ct.data(simple.ContourHierarchy(Input=source(loops(square(0, 0, 1), square(0, 0, 3)))))
ct.check(column(out, "SignedArea") == [8], "an L remains")
ct.check(len(report(out)) == 1 and "even-odd" in report(out)[0], "what was resolved is said")

# What cannot be a contour is named, the rest stays.
nan = float("nan")
bad = loops(square(0, 0, 1), [(5, 5, 0), (6, 5, 0)], [(9, 9, nan), (8, 9, 0), (8, 8, 0)])
out = ct.data(simple.ContourHierarchy(Input=source(bad)))
ct.check(out.GetNumberOfCells() == 1 and len(report(out)) == 3
         and report(out)[0] == "2 contours were left out, 1 is kept.", f"one good contour, two sentences: {report(out)}")
empty = ct.data(simple.ContourHierarchy(Input=source(vtkPolyData())))
ct.check(empty.GetNumberOfPoints() == 0, "nothing in, nothing out")
hopeless = simple.ContourHierarchy(Input=source(loops(square(0, 0, 1)[:3], closed=False)))
said = ct.errors_of(hopeless.UpdatePipeline)
ct.check("nothing to do" in said and "is open" in said, "open lines only are an error: " + said)
ct.check(ct.data(hopeless).GetNumberOfCells() == 0, "and give no output")
hopeless.OpenLines = "Chord"
ct.check(ct.data(hopeless).GetNumberOfCells() == 1, "unless they are to be closed")

# A collection is handled block by block; one that is empty or hopeless does not stop the others.
collection = vtkPartitionedDataSetCollection()
blocks = [loops(square(0, 0, 1)), vtkPolyData(), loops([(1, 1, 1), (2, 2, 2)], closed=False),
          loops(square(0, 0, 2), square(0.5, 0.5, 1))]
for i, block in enumerate(blocks):
    collection.SetPartition(i, 0, block)
per_roi = simple.ContourHierarchy(Input=source(collection))
said = ct.errors_of(per_roi.UpdatePipeline)
ct.check("nothing to do" in said, "the hopeless block is named: " + said)
out = ct.data(per_roi)
ct.check(out.IsA("vtkPartitionedDataSetCollection"), "a collection stays a collection")
counts = [out.GetPartition(i, 0).GetNumberOfCells() if out.GetPartition(i, 0) else 0 for i in range(4)]
ct.check(counts == [1, 0, 0, 2], f"good blocks come through: {counts}")

# The rule for holes: named, applied and reported.
def holes(data):
    array = data.GetFieldData().GetAbstractArray("LevelHoleRule")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


nested = loops(square(0, 0, 10), square(3, 3, 4))
hierarchy = simple.ContourHierarchy(Input=source(nested))
for rule, areas, note in (
        ("Automatic", [100, -16], "Even-odd (automatic): 1 hole (1 drawn in the direction of the wall around)."),
        ("Even-Odd", [100, -16], "Even-odd: 1 hole (1 drawn in the direction of the wall around)."),
        ("Winding", [100], "Winding: no holes, 1 contour within solid left out."),
        ("Keyhole", [100], "Keyhole: no holes, 1 contour within solid left out.")):
    hierarchy.HoleRule = rule
    out = ct.data(hierarchy)
    ct.check(column(out, "SignedArea") == areas, f"{rule}: areas {column(out, 'SignedArea')}")
    ct.check(holes(out) == [note], f"{rule}: {holes(out)}")
types = vtkStringArray()
types.SetName("GeometricType")
for _ in range(2):
    types.InsertNextValue("CLOSEDPLANAR_XOR")
nested.GetCellData().AddArray(types)
hierarchy = simple.ContourHierarchy(Input=source(nested), HoleRule="Winding")
out = ct.data(hierarchy)
ct.check(column(out, "SignedArea") == [100, -16], "XOR contours go by even-odd whatever the rule")
ct.check(len(report(out)) == 1 and "CLOSEDPLANAR_XOR" in report(out)[0], "and that is reported")
ct.check(holes(out)[0].startswith("Even-odd, as CLOSEDPLANAR_XOR contours ask for: 1 hole"), holes(out)[0])
ct.check(out.GetCellData().GetAbstractArray("GeometricType").GetValue(1) == "CLOSEDPLANAR_XOR",
         "the type stays with the contours")
ct.finish()
