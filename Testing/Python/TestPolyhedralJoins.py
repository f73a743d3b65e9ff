# SPDX-License-Identifier: GPL-3.0-or-later
"""Joins of Polyhedral Surface that the user forces or forbids, by property and by table, and its end caps.

Three levels of the branching pipe's kind, made here: one square below two squares, a small one aside above.
"""
import contourtesting as ct

simple = ct.load_plugin()

from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkTable


def squares(*placed):
    """Closed polylines: (x, y, z, half side) each."""
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for x, y, z, half in placed:
        first = points.GetNumberOfPoints()
        for dx, dy in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            points.InsertNextPoint(x + dx * half, y + dy * half, z)
        lines.InsertNextCell(5)
        for i in (0, 1, 2, 3, 0):
            lines.InsertCellPoint(first + i)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


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
both = expect(simple.PolyhedralSurface(Input=towers), 2, "two towers")
ct.check(abs(both - 8) < 1e-9, f"two towers: volume {both}, not 8")
one = expect(simple.PolyhedralSurface(Input=towers, ForbiddenJoins=[1, 3]), 1, "one join forbidden")
ct.check(abs(one - 4) < 1e-9, f"one join forbidden: volume {one}, not 4")
expect(simple.PolyhedralSurface(Input=towers, Overrides=overrides((1, 3, 0))), 1, "one join forbidden by table")
expect(simple.PolyhedralSurface(Input=towers, Overrides=overrides((1, 3, 1)), ForbiddenJoins=[1, 3]), 1,
       "forbidding wins over forcing")

# Squares that do not overlap: joined by proximity, apart by overlap, joined again where that is forced.
aside = squares((0, 0, 0, 1), (2.5, 0, 1, 1), (2.5, 0, 2, 1))
expect(simple.PolyhedralSurface(Input=aside, Mapping="Overlap"), 1, "the upper two by overlap")
ct.check(abs(expect(simple.PolyhedralSurface(Input=aside, Mapping="Overlap"), 1, "again") - 4) < 1e-9,
         "by overlap the lowest square is no part of the solid")
forced = simple.PolyhedralSurface(Input=aside, Mapping="Overlap", ForcedJoins=[0, 1])
report = ct.data(forced).GetFieldData().GetAbstractArray("Report")
lines = [report.GetValue(i) for i in range(report.GetNumberOfValues())] if report else []
ct.check(certificate(forced)["Volume"] > 4 or any("cannot be made" in line for line in lines),
         "a forced join is made, or the report says why not")

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
dropped = simple.PolyhedralSurface(Input=lonely)
expect(dropped, 1, "lonely square dropped")
report = ct.data(dropped).GetFieldData().GetAbstractArray("Report")
ct.check(report.GetNumberOfValues() == 1 and "left out" in report.GetValue(0), "the lonely square is named")
kept = expect(simple.PolyhedralSurface(Input=lonely, IsolatedContours="Extrude"), 2, "lonely square extruded")
ct.check(abs(kept - 12) < 1e-9, f"lonely square extruded: volume {kept}, not 12")

# A gap of five spacings in one stack is bridged or not.
stack = squares(*[(0, 0, z, 1) for z in (0, 1, 2, 7, 8, 9)])
expect(simple.PolyhedralSurface(Input=stack), 1, "gap bridged")
apart = expect(simple.PolyhedralSurface(Input=stack, MaximumGap=3), 2, "gap not bridged")
ct.check(abs(apart - 16) < 1e-9, f"gap not bridged: volume {apart}, not 16")
ct.finish()
