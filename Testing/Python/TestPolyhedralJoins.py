# SPDX-License-Identifier: GPL-3.0-or-later
"""Joins of Polyhedral Surface that the user forces or forbids, by property and by table, and its end caps.

Three levels of the branching pipe's kind, made here: one square below two squares, a small one aside above.
"""
import math

import contourtesting as ct

simple = ct.load_plugin()

from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkTable


def polygons(corners, placed):
    """Closed polylines: (x, y, z, scale) each of one outline."""
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for x, y, z, scale in placed:
        first = points.GetNumberOfPoints()
        for dx, dy in corners:
            points.InsertNextPoint(x + dx * scale, y + dy * scale, z)
        lines.InsertNextCell(len(corners) + 1)
        for i in range(len(corners) + 1):
            lines.InsertCellPoint(first + i % len(corners))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def squares(*placed):
    """(x, y, z, half side) each."""
    return polygons(((-1, -1), (1, -1), (1, 1), (-1, 1)), placed)


def circles(*placed):
    """(x, y, z, radius) each."""
    return polygons([(math.cos(a * math.pi / 20), math.sin(a * math.pi / 20)) for a in range(40)], placed)


def overrides(*rows):
    table = vtkTable()
    for column, name in enumerate(("LowerContour", "UpperContour", "Join")):
        array = vtkIntArray()
        array.SetName(name)
        for row in rows:
            array.InsertNextValue(row[column])
        table.AddColumn(array)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(table)
    return producer


def certificate(surface):
    figures = ct.data(simple.SurfaceCertificate(Input=surface)).GetFieldData()
    return {name: figures.GetAbstractArray(name).GetTuple1(0)
            for name in ("Components", "Sound", "CrossingPairs", "Volume")}


def expect(surface, components, what):
    found = certificate(surface)
    ct.check(found["Sound"] == 1 and found["CrossingPairs"] == 0, f"{what}: closed, manifold, not crossing itself")
    ct.check(found["Components"] == components, f"{what}: {found['Components']} components, not {components}")
    return found["Volume"]


# Two towers side by side: contours 0, 1 below, 2, 3 above.
towers = squares((0, 0, 0, 1), (4, 0, 0, 1), (0, 0, 1, 1), (4, 0, 1, 1))
both = expect(simple.PolyhedralSurface(Input=towers, IsolatedContours="Drop", EndCaps="Flat"), 2, "two towers")
ct.check(abs(both - 8) < 1e-9, f"two towers: volume {both}, not 8")
one = expect(simple.PolyhedralSurface(Input=towers, IsolatedContours="Drop", ForbiddenJoins=[1, 3], EndCaps="Flat"), 1, "one join forbidden")
ct.check(abs(one - 4) < 1e-9, f"one join forbidden: volume {one}, not 4")
expect(simple.PolyhedralSurface(Input=towers, IsolatedContours="Drop", Overrides=overrides((1, 3, 0))), 1, "one join forbidden by table")
expect(simple.PolyhedralSurface(Input=towers, IsolatedContours="Drop", Overrides=overrides((1, 3, 1)), ForbiddenJoins=[1, 3]), 1,
       "forbidding wins over forcing")

# Squares that do not overlap: joined by proximity, apart by overlap, joined again where that is forced.
aside = squares((0, 0, 0, 1), (2.5, 0, 1, 1), (2.5, 0, 2, 1))
expect(simple.PolyhedralSurface(Input=aside, IsolatedContours="Drop", Mapping="Overlap", EndCaps="Flat"), 1, "the upper two by overlap")
ct.check(abs(expect(simple.PolyhedralSurface(Input=aside, IsolatedContours="Drop", Mapping="Overlap", EndCaps="Flat"), 1, "again") - 4) < 1e-9,
         "by overlap the lowest square is no part of the solid")
forced = simple.PolyhedralSurface(Input=aside, IsolatedContours="Drop", Mapping="Overlap", ForcedJoins=[0, 1])
report = ct.data(forced).GetFieldData().GetAbstractArray("Report")
lines = [report.GetValue(i) for i in range(report.GetNumberOfValues())] if report else []
ct.check(certificate(forced)["Volume"] > 4 or any("cannot be made" in line for line in lines),
         "a forced join is made, or the report says why not")

# One join, forced and forbidden: a wide circle below, above it one within it and one that leans out of it,
# each with a circle of its own on top. The leaning one shares 4% of its area, which is not enough by itself.
forked = circles((0, 0, 0, 2), (-1, 0, 1, 0.9), (2.8, 0, 1, 1), (-1, 0, 2, 0.9), (2.8, 0, 2, 1))
by_overlap = dict(Mapping="Overlap", EndCaps="Flat")
expect(simple.PolyhedralSurface(Input=forked, **by_overlap), 2, "a branch that hardly overlaps stays apart")
expect(simple.PolyhedralSurface(Input=forked, ForcedJoins=[0, 2], **by_overlap), 1, "and is joined by force")
expect(simple.PolyhedralSurface(Input=forked, ForbiddenJoins=[0, 2], **by_overlap), 2, "the same join forbidden")
expect(simple.PolyhedralSurface(Input=forked, ForcedJoins=[0, 2], ForbiddenJoins=[0, 1], **by_overlap), 2,
       "one branch for the other")
expect(simple.PolyhedralSurface(Input=forked, Mapping="Proximity", EndCaps="Flat"), 1, "all by proximity")
expect(simple.PolyhedralSurface(Input=forked, ForbiddenJoins=[0, 2], Mapping="Proximity", EndCaps="Flat"), 2,
       "but for what is forbidden")


def check_kept(surface, what):
    """1 forced onto the other branch's 4 and 0 cut off from 2, on the branching pipe."""
    ct.check(list(surface.ForcedJoins) == [0, 1] and list(surface.ForbiddenJoins) == [0, 2],
             f"{what}: the overrides are there")
    ct.check(surface.Overrides is not None, f"{what}: the table is connected")
    found = certificate(surface)
    ct.check(found == expected, f"{what}: the surface is the same: {found}, {expected}")


def pipe_with_overrides():
    path = ct.output("TestPolyhedralJoinsOverrides.csv")
    with open(path, "w") as file:
        file.write("LowerContour,UpperContour,Join\n1,3,0\n")
    reader = simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))
    table = simple.CSVReader(FileName=[path])
    return simple.PolyhedralSurface(Input=reader, Overrides=table, ForcedJoins=[0, 1], ForbiddenJoins=[0, 2])


def only_surface(what):
    found = [p for (name, _), p in simple.GetSources().items() if name.startswith("PolyhedralSurface")]
    ct.check(len(found) == 1, f"{what} brings the node back")
    return found[0]


# A state file and a Python trace keep them, the table, too.
simple.ResetSession()
simple = ct.load_plugin()
plain = certificate(simple.PolyhedralSurface(Input=simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))))
simple.ResetSession()
simple = ct.load_plugin()
expected = certificate(pipe_with_overrides())
ct.check(expected["Components"] > plain["Components"], "the pipe falls apart where joins are forbidden")
check_kept(only_surface("the test"), "at first")
state = ct.output("TestPolyhedralJoins.pvsm")
simple.SaveState(state)
simple.ResetSession()
simple = ct.load_plugin()
simple.LoadState(state)
check_kept(only_surface("a state file"), "state file")

simple.ResetSession()
simple = ct.load_plugin()
from paraview import smtrace
smtrace.start_trace()
pipe_with_overrides()
trace = smtrace.stop_trace()
simple.ResetSession()
simple = ct.load_plugin()
exec(trace, {})
check_kept(only_surface("a trace"), "trace")

# Half a slice at both ends: area times slices times spacing (issue of every planning system).
tower = squares((0, 0, 0, 1), (0, 0, 2, 1), (0, 0, 4, 1))
for caps, volume, added in (("Flat", 16, 0), ("HalfSlice", 24, 8)):
    surface = simple.PolyhedralSurface(Input=tower, EndCaps=caps)
    found = expect(surface, 1, f"tower, {caps}")
    ct.check(abs(found - volume) < 1e-9, f"tower, {caps}: volume {found}, not {volume}")
    reported = ct.data(surface).GetFieldData().GetAbstractArray("EndCapVolume").GetTuple1(0)
    ct.check(abs(reported - added) < 1e-9, f"tower, {caps}: the caps add {reported}, not {added}")
tapered = expect(simple.PolyhedralSurface(Input=tower, EndCaps="Tapered"), 1, "tower, tapered")
ct.check(16 < tapered < 24, f"tower, tapered: volume {tapered} lies between flat and half a slice")

# A square with nothing above or below it: left out by name, or kept as a slice of its own.
lonely = squares((0, 0, 0, 1), (9, 0, 1, 1), (0, 0, 1, 1), (0, 0, 2, 1))
dropped = simple.PolyhedralSurface(Input=lonely, IsolatedContours="Drop")
expect(dropped, 1, "lonely square dropped")
report = ct.data(dropped).GetFieldData().GetAbstractArray("Report")
ct.check(report.GetNumberOfValues() == 1 and "left out" in report.GetValue(0), "the lonely square is named")
extruded = simple.PolyhedralSurface(Input=lonely, EndCaps="Flat")
kept = expect(extruded, 2, "lonely square extruded, by default")
report = ct.data(extruded).GetFieldData().GetAbstractArray("Report")
ct.check(report.GetNumberOfValues() == 1 and "1 contour is joined to none" in report.GetValue(0), "the slice is counted")
ct.check(abs(kept - 12) < 1e-9, f"lonely square extruded: volume {kept}, not 12")

# Two stacks of one region of interest far apart: above one another and side by side.
two = squares(*[(0, 0, z, 1) for z in (0, 1, 2, 30, 31, 32)])
for given, parts in (({}, 2), ({"MaximumGap": 28}, 1), ({"MaximumGap": 0}, 1),
                     ({"ForcedJoins": [2, 3]}, 1)):
    for mapping in ("Proximity", "Overlap"):
        expect(simple.PolyhedralSurface(Input=two, Mapping=mapping, **given), parts,
               f"stacks 28 spacings apart, {mapping}, {given}")
report = ct.data(simple.PolyhedralSurface(Input=two)).GetFieldData().GetAbstractArray("Report")
ct.check(report.GetNumberOfValues() == 1 and "28 times as far apart as those beside them and are not joined" in report.GetValue(0),
         "a gap that is not bridged is reported")
beside = squares(*[(x, 0, z, 1) for z in (0, 1, 2) for x in (0, 30)])
expect(simple.PolyhedralSurface(Input=beside), 2, "two stacks side by side")

# A gap of five spacings in one stack is bridged or not.
stack = squares(*[(0, 0, z, 1) for z in (0, 1, 2, 7, 8, 9)])
expect(simple.PolyhedralSurface(Input=stack), 1, "gap bridged")
apart = expect(simple.PolyhedralSurface(Input=stack, MaximumGap=3, EndCaps="Flat"), 2, "gap not bridged")
ct.check(abs(apart - 16) < 1e-9, f"gap not bridged: volume {apart}, not 16")


def report_of(surface):
    lines = ct.data(surface).GetFieldData().GetAbstractArray("Report")
    return [lines.GetValue(i) for i in range(lines.GetNumberOfValues())]


# Pieces and handles by contract: the same fork told to be one piece, and three that are told to be two.
expect(simple.PolyhedralSurface(Input=forked, ExpectedPieces=1, **by_overlap), 1, "one piece by contract")
told = simple.PolyhedralSurface(Input=forked, ExpectedPieces=1, ExpectedHandles=0, **by_overlap)
ct.check(any("ExpectedPieces is 1 and ExpectedHandles is 0: instead of 2 pieces and 0 handles the surface has 1 piece and 0 handles" in line
             for line in report_of(told)), "and the report says what was done")
expect(simple.FairSurface(Input=forked, ExpectedPieces=1, **by_overlap), 1, "one fair piece by contract")
unmet = simple.PolyhedralSurface(Input=towers, ExpectedPieces=9)
ct.check(any("not what was asked for" in line for line in report_of(unmet)), "what cannot be met is said")
mapping = simple.ContourMapping(Input=forked, ExpectedPieces=1)
mapping.UpdatePipeline()
joins = mapping.GetClientSideObject().GetOutputDataObject(1)
rules = {(joins.GetColumnByName("LowerContour").GetValue(r), joins.GetColumnByName("UpperContour").GetValue(r)):
         (joins.GetColumnByName("Rule").GetValue(r), joins.GetColumnByName("Joined").GetValue(r)) for r in range(joins.GetNumberOfRows())}
ct.check(rules[0, 2] == ("Contract", 1), f"the table of joins has the decision by that rule: {rules}")

ct.finish()
