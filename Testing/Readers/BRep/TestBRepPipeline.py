# SPDX-License-Identifier: GPL-3.0-or-later
"""BRep Reader and Writer through ParaView: the example file, round trips, contours, and what they refuse."""
import os
import re

import contourtesting as ct
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

simple = ct.load_plugin()


def read(path):
    return ct.data(simple.BRepReader(FileName=path))


def write(path, surface, contours=None):
    """The writer after it wrote, and what it said."""
    if os.path.exists(path):
        os.remove(path)
    writer = simple.servermanager.writers.BRepWriter()
    algorithm = writer.GetClientSideObject()
    heard = ct.silent(algorithm)
    algorithm.SetInputDataObject(0, surface)
    if contours is not None:
        algorithm.SetInputDataObject(1, contours)
    writer.FileName = path
    writer.UpdateVTKObjects()
    algorithm.Write()
    return algorithm, heard


def tokens(path):
    with open(path, encoding="ascii") as file:
        text = re.sub(r"#[^\n]*", "", file.read())
    found = re.findall(r"[()]|[^\s()]+", text)
    return [float(t) if re.match(r"[-+.\d]", t) else t for t in found]


def cells(array):
    result = []
    points = vtkIdList()
    for i in range(array.GetNumberOfCells()):
        array.GetCellAtId(i, points)
        result.append(tuple(points.GetId(k) for k in range(points.GetNumberOfIds())))
    return result


def same(a, b):
    points = [[d.GetPoint(i) for i in range(d.GetNumberOfPoints())] for d in (a, b)]
    return (points[0] == points[1] and cells(a.GetPolys()) == cells(b.GetPolys())
            and cells(a.GetLines()) == cells(b.GetLines()))


# ---- the example of the appendix ------------------------------------------------------------------
example = ct.own("example.brep")
data = read(example)
ct.check(data.GetNumberOfPoints() == 26, "8 + 18 points")
ct.check(data.GetNumberOfPolys() == 32, "12 + 20 triangles")
ct.check(data.GetNumberOfLines() == 2, "2 contours")
shell = data.GetCellData().GetArray("ShellId")
ct.check(shell is not None and shell.GetNumberOfTuples() == 34, "a ShellId a cell")
if shell:
    ids = [int(shell.GetTuple1(i)) for i in range(34)]
    ct.check(ids == [1, 1] + [0] * 12 + [1] * 20, "contours are of shell 1, triangles of shells 0 and 1")
ct.check(data.GetCellData().GetArray("ShellSet") is not None, "there is a ShellSet")

back = ct.output("example_back.brep")
algorithm, heard = write(back, data)
ct.check(algorithm.GetErrorCode() == 0 and not heard["ErrorEvent"], "the example is written")
ct.check(not heard["WarningEvent"], "both contours lie in it")
ct.check(tokens(back) == tokens(example), "token by token what was read, partner table included")
ct.check(same(read(back), data), "reads again as the same data")

# ParaView's own way to write
reader = simple.BRepReader(FileName=example)
saved = ct.output("example_saved.brep")
simple.SaveData(saved, reader)
ct.check(os.path.exists(saved) and tokens(saved) == tokens(example), "SaveData chooses the writer by extension")
ct.check(simple.OpenDataFile(saved).GetXMLName() == "BRepReader", "OpenDataFile chooses the reader")

# ---- a surface and contours of two inputs ---------------------------------------------------------
sphere = simple.Sphere(ThetaResolution=12, PhiResolution=8, Radius=1.7)
surface = vtkPolyData()
surface.DeepCopy(ct.data(sphere))
# The ring of the points of one latitude.
height = sorted({round(surface.GetPoint(i)[2], 4) for i in range(surface.GetNumberOfPoints())})[3]
ring = [i for i in range(surface.GetNumberOfPoints()) if round(surface.GetPoint(i)[2], 4) == height]
contours = vtkPolyData()
points = vtkPoints()
points.SetDataTypeToDouble()
lines = vtkCellArray()
lines.InsertNextCell(len(ring) + 1)
for i in ring:
    lines.InsertCellPoint(points.InsertNextPoint(surface.GetPoint(i)))
lines.InsertCellPoint(0)
elsewhere = [points.InsertNextPoint(p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0))]
lines.InsertNextCell(4)
for i in elsewhere + elsewhere[:1]:
    lines.InsertCellPoint(i)
contours.SetPoints(points)
contours.SetLines(lines)
path = ct.output("sphere.brep")
algorithm, heard = write(path, surface, contours)
ct.check(algorithm.GetErrorCode() == 0 and not heard["ErrorEvent"], "a sphere and contours are written")
ct.check(len(heard["WarningEvent"]) == 1 and "1 of 2 contours" in heard["WarningEvent"][0],
         f"the contour that is not on the sphere is said: {heard['WarningEvent']}")
again = read(path)
ct.check(again.GetNumberOfLines() == 1, "the ring came along")
ct.check(cells(again.GetPolys()) == cells(surface.GetPolys()), "the triangles are the same")
ct.check([again.GetPoint(i) for i in cells(again.GetLines())[0][:-1]] == [surface.GetPoint(i) for i in ring],
         "the ring's points are the sphere's to the last bit")
twice = ct.output("sphere_twice.brep")
write(twice, again)
with open(path, "rb") as a, open(twice, "rb") as b:
    ct.check(a.read() == b.read(), "written again it is the same file")

# ---- what the writer refuses ----------------------------------------------------------------------
def polydata(coordinates, polygons):
    result = vtkPolyData()
    where = vtkPoints()
    where.SetDataTypeToDouble()
    for p in coordinates:
        where.InsertNextPoint(p)
    polys = vtkCellArray()
    for polygon in polygons:
        polys.InsertNextCell(len(polygon))
        for i in polygon:
            polys.InsertCellPoint(i)
    result.SetPoints(where)
    result.SetPolys(polys)
    return result


corners = [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, -1, 0)]
for name, wrong, word in (
        ("three triangles at an edge", polydata(corners, [(0, 1, 2), (1, 0, 3), (0, 1, 4)]), "same direction"),
        ("neighbours against each other", polydata(corners, [(0, 1, 2), (0, 1, 3)]), "same direction"),
        ("a quadrilateral", polydata(corners, [(0, 1, 2, 3)]), "Triangulate"),
        ("no triangles", polydata(corners, []), "no triangles"),
        ("a coordinate that is no number", polydata([(0, 0, float("nan"))] + corners[1:], [(0, 1, 2)]), "finite")):
    path = ct.output("refused.brep")
    algorithm, heard = write(path, wrong)
    ct.check(algorithm.GetErrorCode() != 0, f"{name}: an error code")
    ct.check(len(heard["ErrorEvent"]) == 1 and word in heard["ErrorEvent"][0],
             f"{name}: one sentence with '{word}': {heard['ErrorEvent']}")
    ct.check(not os.path.exists(path), f"{name}: no file")

# ---- what the reader refuses: the 100 mutated files -----------------------------------------------
with open(example, encoding="ascii") as file:
    words = file.read().split()
sentences = 0
for k in range(100):
    at = (k * 7919) % (len(words) - 1)
    mutation = list(words)
    if k % 4 == 0:
        mutation[at] = "junk"
    elif k % 4 == 1:
        mutation = mutation[:at]
    elif k % 4 == 2:
        mutation[at] += "("
    else:
        mutation[at] = "1e999"
    path = ct.output("mutated.brep")
    with open(path, "w", encoding="ascii") as file:
        # A word a line, so that what was a comment's text becomes part of the file: wrong as well.
        file.write("\n".join(mutation))
    proxy = simple.servermanager.sources.BRepReader()
    algorithm = proxy.GetClientSideObject()
    heard = ct.silent(algorithm)
    proxy.FileName = path
    proxy.UpdateVTKObjects()
    algorithm.Update()
    one = len(heard["ErrorEvent"]) == 1 and "Cannot read " in heard["ErrorEvent"][0]
    if ct.check(one, f"mutation {k}: one sentence: {heard['ErrorEvent']}"):
        sentences += 1
    ct.check(algorithm.GetOutput().GetNumberOfCells() == 0, f"mutation {k}: no output")
ct.check(sentences == 100, "100 mutated files, 100 sentences")
ct.finish()
