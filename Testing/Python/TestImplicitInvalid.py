# SPDX-License-Identifier: GPL-3.0-or-later
"""Every node of the implicit method with every kind of bad input: one sentence that says what is wrong, no output, no crash.

Bad contours, constraints, models and properties, one at a time; what is merely odd (a wall of one bad contour among good ones, a
support radius of next to nothing) goes through and is told in Report. The test's timeout is what tells a hang.
"""
import math

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

NAN, INF = math.nan, math.inf


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def ring(z, radius=5.0, count=12, x=0.0):
    return [(x + radius * math.cos(2 * math.pi * k / count), radius * math.sin(2 * math.pi * k / count), z)
            for k in range(count)]


def with_points(places, **arrays):
    """Points and point arrays: name=values, tuples for several components, strings for a string array."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for p in places:
        points.InsertNextPoint(p)
    data = vtkPolyData()
    data.SetPoints(points)
    for name, values in arrays.items():
        array = vtkStringArray() if isinstance(values[0], str) else vtkDoubleArray()
        array.SetName(name)
        if isinstance(values[0], tuple):
            array.SetNumberOfComponents(len(values[0]))
        for value in values:
            array.InsertNextTuple(value) if isinstance(value, tuple) else array.InsertNextValue(value)
        data.GetPointData().AddArray(array)
    return data


def changed(data, change):
    """A deep copy on which change(copy) was called."""
    copy = data.NewInstance()
    copy.DeepCopy(data)
    change(copy)
    return copy


def outputs_nothing(node):
    out = node.GetClientSideObject().GetOutputDataObject(0)
    return out is None or out.GetNumberOfPoints() == 0


def refused(kind, data, fragment, **properties):
    """The node says one sentence that holds the fragment, and gives nothing."""
    node = kind(Input=producer(data))
    case = f"{kind.__name__} {properties or fragment}"
    for name, value in properties.items():
        setattr(node, name, value)
    said = ct.errors_of(node.UpdatePipeline)
    own = [line for line in said.splitlines() if "(0x" in line and "Algorithm " not in line and "Executive" not in line]
    ct.check(fragment in said, f"{case}: VTK said {said!r}")
    ct.check(len(own) == 1, f"{case}: {len(own)} sentences: {said!r}")
    ct.check(outputs_nothing(node), f"{case}: there is some output")
    simple.Delete(node)


def told(kind, data, fragment, **properties):
    """The node works, without an error, and says so in Report (fragment None: with nothing to say)."""
    node = kind(Input=producer(data))
    case = f"{kind.__name__} {properties or fragment}"
    for name, value in properties.items():
        setattr(node, name, value)
    said = ct.errors_of(node.UpdatePipeline)
    out = node.GetClientSideObject().GetOutputDataObject(0)
    report = out.GetFieldData().GetAbstractArray("Report")
    lines = [report.GetValue(i) for i in range(report.GetNumberOfValues())] if report else []
    ct.check(said == "", f"{case}: VTK said {said!r}")
    ct.check(fragment is None or any(fragment in line for line in lines), f"{case}: the report is {lines}")
    simple.Delete(node)
    return out


GOOD = ct.closed_polylines([ring(z, 5 - abs(z) / 4) for z in (-4, -2, 0, 2, 4)])
CONSTRAINTS = ct.data(simple.ImplicitConstraints(Input=producer(GOOD)))
MODEL = ct.data(simple.ImplicitFunction(Input=producer(CONSTRAINTS)))
FROM_CONTOURS = (simple.ImplicitConstraints, simple.ImplicitSurface)
FROM_MODEL = (simple.ImplicitPolygonizer, simple.ImplicitContours)
EVERY = FROM_CONTOURS + (simple.ImplicitFunction,) + FROM_MODEL
ct.check(MODEL.GetNumberOfPoints() > 0, "the good contours make no model")

# Contours.
for kind in FROM_CONTOURS:
    refused(kind, ct.closed_polylines([ring(0)]), "All contours lie in one plane")
    refused(kind, ct.closed_polylines([ring(0), ring(0, x=20)]), "All contours lie in one plane")
    refused(kind, with_points(ring(0)), "points but no cells")
    for bad in (NAN, INF, -INF):
        broken = ring(4)
        broken[3] = (bad, 0, 4)
        told(kind, ct.closed_polylines([ring(0), ring(2), broken]), "not a finite number; left out")
        refused(kind, ct.closed_polylines([ring(0), broken]), "All contours lie in one plane")
        refused(kind, ct.closed_polylines([broken]), "not a finite number")
    refused(kind, ct.closed_polylines([[(0, 0, z), (1, 0, z)] for z in (0, 1)]), "No usable contour")
    for value in (-1.0, NAN, INF):
        refused(kind, GOOD, "MarginDistance must be positive", MarginDistance=value)
        refused(kind, GOOD, "ResampleSpacing must be positive", ResampleSpacing=value)
        refused(kind, GOOD, "ResampleTolerance must be positive", ResampleTolerance=value)
    refused(kind, GOOD, "MarginDistance is larger than", MarginDistance=1e9)
    refused(kind, GOOD, "would make about", ResampleSpacing=1e-9)
    refused(kind, GOOD, "would make about", ResampleSpacing=1e-300)
    for value in (-1.0, 1.0, NAN):
        refused(kind, GOOD, "MergeBox must be a part", MergeBox=value)
    # Larger than everything: the fewest points that keep a contour.
    told(kind, GOOD, None, ResampleSpacing=1e12)
    told(kind, GOOD, None, ResampleTolerance=1e12)
    refused(kind, GOOD, "MarginDistance is less than", MarginDistance=1e-9)
    told(kind, GOOD, None, MarginDistance=1e-3)

# What is no contour at all: ParaView's own pipeline says so in its sentence.
for kind in EVERY:
    node = kind(Input=producer(GOOD))
    algorithm = node.GetClientSideObject()
    algorithm.SetInputDataObject(0, vtkUnstructuredGrid())
    said = ct.errors_of(lambda: algorithm.Update())
    ct.check("is of type vtkUnstructuredGrid" in said, f"{kind.__name__} took a grid: {said!r}")
    # An empty region of interest must not stop the others.
    empty = told(kind, vtkPolyData(), "The input is empty")
    ct.check(empty.GetNumberOfPoints() == 0, f"{kind.__name__} made something of nothing")

# Constraints.
refused(simple.ImplicitFunction, GOOD, "no point array Value")
corners = [(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)]
signs = [1.0, -1.0] * 4
refused(simple.ImplicitFunction, with_points(corners, Value=[(1.0, 2.0, 3.0)] * 8), "of one number a point")
refused(simple.ImplicitFunction, with_points(corners, Value=["inside"] * 8), "no point array Value")
refused(simple.ImplicitFunction, with_points(corners, Value=[1.0] * 8), "All constraints have the value")
refused(simple.ImplicitFunction, with_points(corners[:3], Value=signs[:3]), "at least four constraints")
refused(simple.ImplicitFunction, with_points([(k, k * k, 0) for k in range(8)], Value=signs), "lie in one plane")
for bad in (NAN, INF, -INF):
    refused(simple.ImplicitFunction, with_points(corners, Value=signs[:7] + [bad]), "Constraint 7 has")
    refused(simple.ImplicitFunction, with_points(corners[:7] + [(0, bad, 0)], Value=signs), "Constraint 7 has")
for kind, data in ((simple.ImplicitFunction, CONSTRAINTS), (simple.ImplicitSurface, GOOD)):
    for value in (-1.0, NAN, INF):
        refused(kind, data, "Smoothing must be", Smoothing=value)
        refused(kind, data, "Tolerance must be", Tolerance=value)
        refused(kind, data, "CentreReduction must be", CentreReduction=value)
        refused(kind, data, "SupportRadius must be", SupportRadius=value)
    told(kind, data, None, Smoothing=1e-3)
told(simple.ImplicitFunction, CONSTRAINTS, None, Smoothing=1e300)
told(simple.ImplicitFunction, CONSTRAINTS, None, Tolerance=1e300, Solver="Iterative")
told(simple.ImplicitFunction, CONSTRAINTS, None, CentreReduction=1e300)
for radius in (1e9, 1e300):
    refused(simple.ImplicitFunction, CONSTRAINTS, "SupportRadius is more than", Kernel="Wendland", SupportRadius=radius)
for radius in (1e-300, 1e-9):
    told(simple.ImplicitFunction, CONSTRAINTS, None, Kernel="Wendland", SupportRadius=radius)

# Models: also those that a file holds.
path = ct.output("TestImplicitInvalidModel.vtp")
simple.SaveData(path, proxy=producer(with_points(corners)), DataMode="Binary")
saved = ct.data(simple.XMLPolyDataReader(FileName=[path]))
for kind in FROM_MODEL:
    refused(kind, saved, "no point array Weight")
    refused(kind, CONSTRAINTS, "no point array Weight")
    for name in ("Polynomial", "Origin", "SupportRadius", "Residual"):
        refused(kind, changed(MODEL, lambda m: m.GetFieldData().RemoveArray(name)), f"no array {name}")
    refused(kind, changed(MODEL, lambda m: m.GetFieldData().RemoveArray("Kernel")), "Kernel does not say")
    refused(kind, changed(MODEL, lambda m: m.GetPointData().RemoveArray("Value")), "no point array Value")
    for bad in (NAN, INF):
        refused(kind, changed(MODEL, lambda m: m.GetPointData().GetArray("Weight").SetValue(5, bad)), "not finite")
        refused(kind, changed(MODEL, lambda m: m.GetPointData().GetArray("Value").SetValue(5, bad)), "not finite")
        refused(kind, changed(MODEL, lambda m: m.GetPoints().SetPoint(5, 0, bad, 0)), "not finite")
        refused(kind, changed(MODEL, lambda m: m.GetFieldData().GetArray("Polynomial").SetValue(0, bad)), "not finite")
    refused(kind, changed(MODEL, lambda m: m.GetPointData().GetArray("Value").Fill(1)), "no constraint of value 0")
    refused(kind, changed(MODEL, lambda m: m.GetPointData().GetArray("Weight").Fill(0) or
                          m.GetFieldData().GetArray("Polynomial").Fill(0)), "No surface passes near")

# Cells and bounds.
for kind, data in ((simple.ImplicitPolygonizer, MODEL), (simple.ImplicitContours, MODEL), (simple.ImplicitSurface, GOOD)):
    for value in (-1.0, NAN, INF):
        refused(kind, data, "CellSize must be positive", CellSize=value)
    for value, cells in ((1e-4, "e+10 cells"), (1e-9, "e+20 cells"), (1e-300, "cells")):
        refused(kind, data, cells, CellSize=value)
    refused(kind, data, "larger than the bounds", CellSize=1e9)
    refused(kind, data, "cells", MaximumCells=10.0)
    for value in (0.0, -1.0, NAN):
        refused(kind, data, "MaximumCells must be", MaximumCells=value)
    for bounds, fragment in (((1, 0, 0, 1, 0, 1), "bounds are empty"), ((0, 0, 0, 0, 0, 0), "bounds are empty"),
                             ((NAN, 1, 0, 1, 0, 1), "bounds are empty"), ((-INF, INF, -9, 9, -9, 9), "bounds are empty"),
                             ((-1e300, 1e300, -9, 9, -9, 9), "cells"), ((100, 101, 100, 101, 100, 101), "bounds")):
        refused(kind, data, fragment, UseBounds=1, Bounds=tuple(map(float, bounds)))

# Planes.
for value in (-1.0, NAN, INF):
    refused(simple.ImplicitContours, MODEL, "spacing", Spacing=value)
refused(simple.ImplicitContours, MODEL, "more than a million planes", Spacing=1e-9)
for normal in ((0.0, 0.0, 0.0), (NAN, 0.0, 1.0), (INF, 0.0, 1.0)):
    refused(simple.ImplicitContours, MODEL, "direction of the planes", PlaneNormal=normal)
for limits in ((1.0, -1.0), (NAN, 1.0), (-INF, INF)):
    refused(simple.ImplicitContours, MODEL, "range", UseRange=1, Range=limits)
refused(simple.ImplicitContours, MODEL, "No plane meets", UseRange=1, Range=(1e6, 2e6))
ct.finish()
