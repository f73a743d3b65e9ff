# SPDX-License-Identifier: GPL-3.0-or-later
"""Every real NUAGES file opens by itself, has the contours of its table, and survives a round trip."""
import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
# Contours, points, and points that repeat the first of their contour at its end, which are not written: of a contour that is
# one point several times (a summit) one is left.
TABLE = {"manytomany": (6, 960, 0), "amygdala_label3": (185, 12812, 0), "frog_label3": (143, 11866, 0),
         "spl_left_hippocampus": (69, 2720, 0), "sainthelens_100m": (68, 20994, 14),
         "sainthelens_unequal": (78, 19782, 17)}
for name, (contours, points, repeated) in TABLE.items():
    reader = simple.OpenDataFile(ct.shared(f"cnt/{name}.cnt"))
    ct.check(reader.GetXMLName() == "NUAGESContourReader", f"{name}: opened by {reader.GetXMLName()}")
    output = ct.data(reader)
    ct.check((output.GetNumberOfLines(), output.GetNumberOfPoints()) == (contours, points),
             f"{name}: {output.GetNumberOfLines()} contours of {output.GetNumberOfPoints()} points")
    ct.check(rt.loops_are_closed(output), f"{name}: loops are not closed")
    copy = ct.output(f"{name} copy.cnt")
    simple.SaveData(copy, reader)
    again = ct.data(simple.NUAGESContourReader(FileName=copy))
    ct.check((again.GetNumberOfCells(), again.GetNumberOfPoints()) == (contours, points - repeated),
             f"{name}: the copy has {again.GetNumberOfCells()} contours of {again.GetNumberOfPoints()} points")
    before = {output.GetPoint(i) for i in range(output.GetNumberOfPoints())}
    after = {again.GetPoint(i) for i in range(again.GetNumberOfPoints())}
    ct.check(before == after, f"{name}: points changed in a round trip")
ct.finish()
