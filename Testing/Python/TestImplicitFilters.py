# SPDX-License-Identifier: GPL-3.0-or-later
"""The implicit method's nodes in a pipeline, on the thesis's examples: counts, data layout, certificate, errors."""
import contourtesting as ct

simple = ct.load_plugin()


def read(name):
    path = ct.own(name)
    kind = simple.NUAGESContourReader if name.endswith(".cnt") else simple.CurveNetworkReader
    return kind(FileName=path)


def text(variant):
    return f"{variant.ToDouble():.17g}" if variant.IsNumeric() else variant.ToString()


def field(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return [text(array.GetVariantValue(i)) for i in range(array.GetNumberOfValues())] if array else None


def certified(surface):
    return ct.data(simple.SurfaceCertificate(Input=surface))


def number(data, name):
    return float(field(data, name)[0])


def check_surface(name, surface, euler):
    out = certified(surface)
    for figure in ("Closed", "Oriented", "Outward", "EdgeManifold", "VertexManifold"):
        values = field(out, figure)
        ct.check(values and all(v == "1" for v in values), f"{name}: {figure} is {values}")
    ct.check(number(out, "CrossingPairs") == 0, f"{name} crosses itself")
    ct.check(number(out, "Euler") == euler, f"{name}: Euler number {field(out, 'Euler')}, not {euler}")
    ct.check(number(ct.data(surface), "SmallestAngle") >= 1, f"{name}: an angle of {field(ct.data(surface), 'SmallestAngle')}")
    normals = ct.data(surface).GetPointData().GetNormals()
    ct.check(normals is not None and normals.GetNumberOfComponents() == 3, f"{name} has no normals")


# The thesis's counts (10.1, 10.2), and the whole chain on its examples.
for name, points, euler in (("branching_pipe.cnt", 92, None), ("tamarind.csl", 57, 2), ("femur_head.csl", 136, 2)):
    contours = read(name)
    constraints = simple.ImplicitConstraints(Input=contours)
    constraints.Normals = "In Plane"
    out = ct.data(constraints)
    ct.check(out.GetNumberOfPoints() == 3 * points, f"{name}: {out.GetNumberOfPoints()} constraints, not {3 * points}")
    values = out.GetPointData().GetArray("Value")
    kinds = out.GetPointData().GetArray("Kind")
    counts = [0, 0, 0]
    for i in range(out.GetNumberOfPoints()):
        counts[int(kinds.GetTuple1(i)) + 1] += 1
        ct.check((values.GetTuple1(i) > 0) == (kinds.GetTuple1(i) > 0), f"{name}: the sign of constraint {i}")
    ct.check(counts == [points, points, points], f"{name}: {counts}")
    constraints.Mode = "Bounding Box Corners"
    ct.check(ct.data(constraints).GetNumberOfPoints() == points + 8, f"{name}: corners mode is not n + 8")

    if euler is not None:
        check_surface(name, simple.ImplicitSurface(Input=contours), euler)

# Stage by stage gives what the one node gives, and a model comes back from a file.
contours = read("tamarind.csl")
constraints = simple.ImplicitConstraints(Input=contours)
model = simple.ImplicitFunction(Input=constraints)
fitted = ct.data(model)
ct.check(number(fitted, "Residual") < 1e-8, f"the residual is {field(fitted, 'Residual')}")
ct.check(number(fitted, "Iterations") == 0, "some hundred constraints are solved for directly")
for name, length in (("Polynomial", 4), ("Origin", 3), ("Kernel", 1), ("SupportRadius", 1)):
    ct.check(len(field(fitted, name) or []) == length, f"{name} is {field(fitted, name)}")
ct.check(field(fitted, "Kernel") == ["Triharmonic"], "the kernel's name")
mesh = simple.ImplicitPolygonizer(Input=model)
check_surface("tamarind in stages", mesh, 2)
path = ct.output("TestImplicitModel.vtp")
iterative = simple.ImplicitFunction(Input=constraints, Solver="Iterative")
stepped = ct.data(iterative)
half = max(abs(v) for v in stepped.GetPointData().GetArray("Value").GetRange())
ct.check(0 < number(stepped, "Iterations") < 100, f"{number(stepped, 'Iterations')} steps")
ct.check(number(stepped, "Residual") <= 1.01e-5 * half, f"the iterative residual is {field(stepped, 'Residual')}")
iterative.Tolerance = 1e-17
ct.check(any("stopped after" in line for line in field(ct.data(iterative), "Report")), "a tolerance out of reach is told")
factorised = simple.ImplicitFunction(Input=constraints, Solver="LU")
ct.check(number(ct.data(factorised), "Residual") < 1e-8, "the original method's LU is there")
# Inline, as data appended behind the XML trips VTK's reader with newer versions of expat.
simple.SaveData(path, proxy=model, DataMode="Binary")
again = simple.ImplicitPolygonizer(Input=simple.XMLPolyDataReader(FileName=[path]))
ct.check(ct.data(again).GetNumberOfPoints() == ct.data(mesh).GetNumberOfPoints(), "the saved model's surface differs")
worst = max(abs(ct.data(again).GetPoint(i)[a] - ct.data(mesh).GetPoint(i)[a])
            for i in range(ct.data(mesh).GetNumberOfPoints()) for a in range(3))
ct.check(worst == 0, f"the saved model's surface is {worst} away")

# Contours on planes by direction and spacing (the thesis's 0.37), on those of contours, on an image's slices.
planes = simple.ImplicitContours(Input=model, Spacing=0.37)
slices = ct.data(planes)
ct.check(slices.GetNumberOfCells() > 5, f"{slices.GetNumberOfCells()} contours at 0.37")
areas = slices.GetCellData().GetArray("SignedArea")
ct.check(all(areas.GetTuple1(i) > 0 for i in range(slices.GetNumberOfCells())), "a contour is turned")
for name in ("Level", "ContourId", "Depth", "Parent"):
    ct.check(slices.GetCellData().HasArray(name), f"no cell array {name}")

closed = certified(simple.PolyhedralSurface(Input=planes))
ct.check(field(closed, "Closed") == ["1"], "Polyhedral Surface of the traced contours is not closed")

pipe = read("branching_pipe.cnt")
pipe_model = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=pipe))
own = ct.data(simple.ImplicitContours(Input=pipe_model, Planes=pipe))
ct.check(own.GetFieldData().GetArray("LevelOffset").GetNumberOfTuples() == 4, "the pipe's own planes are four")
ct.check(own.GetNumberOfCells() == 9, f"{own.GetNumberOfCells()} contours on the pipe's own planes, not 9")
bounds = ct.data(pipe).GetBounds()
image = simple.Wavelet(WholeExtent=[0, 9, 0, 9, 0, 6])
levels = simple.ImplicitContours(Input=pipe_model, Planes=image)
traced = ct.data(levels).GetFieldData().GetArray("LevelOffset")
offsets = [traced.GetTuple1(i) for i in range(traced.GetNumberOfTuples())]
expected = [z for z in range(0, 7) if bounds[4] <= z <= bounds[5]]
ct.check(offsets[:len(expected)] == [float(z) for z in expected], f"an image's slices: {offsets}, not {expected}")

# The branching pipe, bounded and closed, and left open (11.1).
surface = simple.ImplicitSurface(Input=pipe)
out = certified(surface)
ct.check(all(v == "1" for v in field(out, "Closed")), "the bounded pipe is not closed")
surface.ClosedAtBounds = 0
out = certified(surface)
ct.check(number(out, "OpenEdges") > 0, "the pipe that is cut at the bounds has no border")

# Previews: sound as the full surface, smaller, and told; going back to Full gives what was there before.
full = ct.data(simple.ImplicitSurface(Input=contours))
preview = simple.ImplicitSurface(Input=contours)
for detail in ("Coarse", "Medium"):
    preview.Detail = detail
    out = certified(preview)
    for figure in ("Closed", "Oriented", "Outward", "EdgeManifold", "VertexManifold"):
        ct.check(field(out, figure) == ["1"], f"{detail}: {figure} is {field(out, figure)}")
    ct.check(number(out, "CrossingPairs") == 0, f"the {detail} preview crosses itself")
    ct.check(any("preview" in line for line in field(ct.data(preview), "Report")), f"the {detail} preview is not told")
    ct.check(number(ct.data(preview), "CellSize") >= number(full, "CellSize"), f"{detail}: smaller cells")
preview.Detail = "Full"
ct.check(ct.data(preview).GetNumberOfPoints() == full.GetNumberOfPoints(), "Full is another surface after a preview")
quick = simple.ImplicitPolygonizer(Input=model, Detail="Coarse")
ct.check(number(certified(quick), "CrossingPairs") == 0 and field(certified(quick), "Closed") == ["1"], "the model's preview")
ct.check(ct.data(quick).GetNumberOfPoints() != ct.data(mesh).GetNumberOfPoints(), "the model's preview is its surface")

# Each bad input is a sentence and no output.
bad = simple.ImplicitSurface(Input=contours)
for properties, sentence in ((dict(CellSize=-1), "CellSize"), (dict(CellSize=1e-6), "cells"),
                             (dict(CellSize=0, MarginDistance=1e9), "MarginDistance"),
                             (dict(MarginDistance=0, UseBounds=1, Bounds=[1, 0, 0, 1, 0, 1]), "bounds")):
    for key, value in properties.items():
        setattr(bad, key, value)
    said = ct.errors_of(bad.UpdatePipeline)
    ct.check(sentence in said, f"{properties}: VTK said {said!r}")
    ct.check(bad.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints() == 0, f"{properties}: some output")
for kind, given in ((simple.ImplicitFunction, contours), (simple.ImplicitPolygonizer, constraints),
                    (simple.ImplicitContours, constraints)):
    node = kind(Input=given)
    ct.check("give the output of" in ct.errors_of(node.UpdatePipeline), f"{kind.__name__} took a wrong input")
one = simple.ImplicitSurface(Input=simple.Disk(InnerRadius=0, CircumferentialResolution=12))
ct.check("ERR" in ct.errors_of(one.UpdatePipeline), "one plane was taken")
ct.finish()
