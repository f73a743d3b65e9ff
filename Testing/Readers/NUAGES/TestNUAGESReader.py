# SPDX-License-Identifier: GPL-3.0-or-later
"""NUAGES Contour Reader and Writer as nodes: output, round trip, errors."""
import os

import contourtesting as ct
import readertesting as rt
from contourreconstruction.NUAGESReaders import vtkNUAGESWriter
from vtkmodules.vtkCommonCore import vtkIdList, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkRegularPolygonSource

simple = ct.load_plugin()

reader = simple.NUAGESContourReader(FileName=rt.write("some contours.cnt", rt.NUAGES))
output = ct.data(reader)
ct.check(output.IsA("vtkPolyData"), "the output is no vtkPolyData")
ct.check(output.GetNumberOfLines() == 3 and output.GetNumberOfPoints() == 10, "3 contours of 10 points")
ct.check(rt.loops_are_closed(output), "loops are not closed")
ct.check(output.GetPoints().GetDataType() == 11, "points are not double")
ct.check(output.GetPoint(7) == (1, 0.5, -15), "a point is elsewhere")
ct.check(not rt.strings(output, "Report"), "a report about nothing")

# Windows line ends and a small s; an empty contour is told.
odd = simple.NUAGESContourReader(FileName=rt.write("odd.cnt", "s 1\r\nv 3 z 1\r\n{ 0 0 1 0 1 1 }\r\n{ }\r\n"))
ct.check(ct.data(odd).GetNumberOfLines() == 1, "one contour of two is empty")
ct.check(len(rt.strings(ct.data(odd), "Report")) == 1, "the empty contour is not reported")

# Round trip.
copy = ct.output("a copy.cnt")
simple.SaveData(copy, reader)
again = ct.data(simple.OpenDataFile(copy))
ct.check([again.GetPoint(i) for i in range(10)] ==
         [output.GetPoint((i + 7) % 10) for i in range(10)], "the copy has other points (lowest section first)")

# Loose segments of a slice are chained.
slice = simple.Slice(simple.Cylinder(Resolution=12, Height=2))
slice.SliceType.Normal = [0, 0, 1]
slice.SliceType.Origin = [0, 0, 0.1]
simple.SaveData(ct.output("slice.cnt"), slice)
sliced = ct.data(simple.NUAGESContourReader(FileName=ct.output("slice.cnt")))
ct.check(sliced.GetNumberOfLines() == 1 and sliced.GetNumberOfPoints() >= 4, "the slice is not one contour")


# With the depth known, outer contours run clockwise and holes counterclockwise.
def signed_area(poly, line):
    ids = vtkIdList()
    poly.GetLines().GetCellAtId(line, ids)
    p = [poly.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:])) / 2


with_depth = vtkPolyData()
with_depth.ShallowCopy(output)
depth = vtkIntArray()
depth.SetName("Depth")
for value in (0, 1, 0):
    depth.InsertNextValue(value)
with_depth.GetCellData().AddArray(depth)
writer = vtkNUAGESWriter()
writer.SetInputData(with_depth)
writer.SetFileName(ct.output("depth.cnt"))
ct.check(writer.Write(), "contours with depth are not written")
oriented = ct.data(simple.NUAGESContourReader(FileName=ct.output("depth.cnt")))
ct.check([signed_area(oriented, i) > 0 for i in range(3)] == [False, False, True], "orientation does not follow Depth")

# What is wrong gives one sentence and nothing else.
for name, content, part in [
        ("truncated.cnt", rt.NUAGES[:60], "it is truncated or the count is wrong"),
        ("empty.cnt", "", "the file is empty"),
        ("binary.cnt", b"S 1\n\x00\x01\x02", "binary"),
        ("huge.cnt", "S 1\nv 2000000000 z 0\n", "more than the rest of the file can hold"),
        ("nan.cnt", "S 1\nv 3 z 0\n{\n0 0\nnan 0\n1 1\n}\n", "line 5: expected x of a vertex")]:
    rt.expect_error(simple.NUAGESContourReader(FileName=rt.write(name, content)), part, name)
rt.expect_error(simple.NUAGESContourReader(FileName=ct.output("absent.cnt")), "no such file", "absent")
rt.expect_error(simple.NUAGESContourReader(), "set FileName", "no name")
# A good file first: its contours must not stay behind.
reader.FileName = rt.write("truncated.cnt", rt.NUAGES[:60])
rt.expect_error(reader, "truncated.cnt", "bad after good")

# What cannot be written leaves no file.
for source, part in [(vtkRegularPolygonSource(), "not perpendicular to z"), (vtkLineSource(), "does not close")]:
    if source.IsA("vtkRegularPolygonSource"):
        source.SetNormal(0, 1, 1)
    writer = vtkNUAGESWriter()
    sentences = []

    def keep(_, __, sentence):
        sentences.append(sentence)
    keep.CallDataType = "string0"
    writer.AddObserver("ErrorEvent", keep)
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(ct.output("never.cnt"))
    ct.check(not writer.Write(), f"{part}: written all the same")
    ct.check(len(sentences) == 1 and part in sentences[0], f"'{part}' is not in {sentences}")
    ct.check(not os.path.exists(ct.output("never.cnt")), f"{part}: a file is left")
ct.finish()
