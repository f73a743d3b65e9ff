# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve Network Reader as a node: one material or several, change of file, errors."""
import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
one = rt.write("one material.csl", rt.CSL)
several = rt.write("two materials.contour", rt.CONTOUR)

reader = simple.CurveNetworkReader(FileName=one)
output = ct.data(reader)
ct.check(output.IsA("vtkPolyData"), f"one material is a {output.GetClassName()}")
ct.check(output.GetNumberOfLines() == 1 and rt.loops_are_closed(output), "one closed loop")
ct.check(output.GetCellData().GetArray("Plane").GetValue(0) == 0, "the number of its plane")
ct.check(output.GetFieldData().GetArray("Material").GetValue(0) == 1, "the label of its material")
ct.check(not rt.strings(output, "Report"), "a report about nothing")

# The type of the output follows the file, and a filter behind it follows the output.
moved = simple.Transform(reader)
ct.check(ct.data(moved).IsA("vtkPolyData"), "a filter on one material")
reader.FileName = several
output = ct.data(reader)
ct.check(output.IsA("vtkPartitionedDataSetCollection"), f"two materials are a {output.GetClassName()}")
ct.check([(name, block.GetNumberOfLines(), block.GetNumberOfPoints()) for name, block in rt.blocks(output)] ==
         [("Material 1", 1, 4), ("Material 2", 1, 4)], "a loop of four points each")
ct.check(len(rt.blocks(ct.data(moved))) == 2, "the filter on two materials")
reader.FileName = one
ct.check(ct.data(moved).IsA("vtkPolyData"), "the filter on one material again")

swapped = rt.write("wrong plane.csl", rt.CSL.replace("1 -2", "1 2"))
ct.check("D has the wrong sign" in rt.strings(ct.data(simple.CurveNetworkReader(FileName=swapped)), "Report")[0],
         "the wrong sign is not told")

for name, content, part in [
        ("truncated.csl", rt.CSL[:50], "expected"),
        ("truncated.contour", rt.CONTOUR[:90], "expected"),
        ("empty.csl", "", "the file is empty"),
        ("binary.contour", rt.CONTOUR.encode() + b"\x00", "binary"),
        ("huge.csl", rt.CSL.replace("1 4 1", "1 2000000000 1"), "more than the rest of the file can hold"),
        ("none.csl", "CSLC\n0 2\n", "it has no contours"),
        ("wrong.csl", "solid thing\n", "begins with 'CSLC'")]:
    rt.expect_error(simple.CurveNetworkReader(FileName=rt.write(name, content)), part, name)
rt.expect_error(simple.CurveNetworkReader(FileName=ct.output("absent.csl")), "no such file", "absent")
rt.expect_error(simple.CurveNetworkReader(), "set FileName", "no name")
reader.FileName = several
ct.data(reader)
reader.FileName = ct.output("truncated.csl")
rt.expect_error(reader, "truncated.csl", "bad after good")
ct.finish()
