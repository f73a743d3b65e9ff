# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of branchings, left as they are joined by themselves, right after overrides.

One contour into two, one into four, three into three, and a shell (with a hole) around a core that meets the
shell further up.
"""
import math

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def circles(*placed, corners=48):
    """Closed polylines: (x, y, z, radius) each."""
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for x, y, z, radius in placed:
        first = points.GetNumberOfPoints()
        for i in range(corners):
            angle = 2 * math.pi * i / corners
            points.InsertNextPoint(x + radius * math.cos(angle), y + radius * math.sin(angle), z)
        lines.InsertNextCell(corners + 1)
        for i in range(corners + 1):
            lines.InsertCellPoint(first + i % corners)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def figures(surface):
    fields = ct.data(simple.SurfaceCertificate(Input=surface)).GetFieldData()
    return {name: int(fields.GetAbstractArray(name).GetTuple1(0)) for name in ("Components", "Sound", "CrossingPairs")}


def show(surface, view, colour):
    shown = simple.Show(surface, view)
    shown.Representation = "Surface With Edges"
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = colour
    shown.EdgeColor = [0.35, 0.3, 0.25]


def picture(name, contours, aside, components, opened=False, **overrides):
    """Two surfaces side by side, `aside` apart; components: of the left one and of the right one."""
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = [-0.5, -5, 2]
    view.CameraViewUp = [0, 0, 1]
    common = dict(Mapping="Overlap", EndCaps="Flat")
    before = simple.PolyhedralSurface(Input=contours, **common)
    after = simple.PolyhedralSurface(Input=contours, **common, **overrides)
    for surface, count, what in ((before, components[0], "before"), (after, components[1], "after")):
        found = figures(surface)
        ct.check(found == {"Components": count, "Sound": 1, "CrossingPairs": 0}, f"{name} {what}: {found}")
    if opened:  # cut in half, so that the inside is seen
        before, after = (simple.Clip(Input=s, ClipType="Plane") for s in (before, after))
        for half in (before, after):
            half.ClipType.Origin, half.ClipType.Normal, half.Invert = [0, 0.01, 0], [0, 1, 0], 0
    show(before, view, [0.85, 0.75, 0.65])
    moved = simple.Transform(Input=after, Transform="Transform")
    moved.Transform.Translate = [aside, 0, 0]
    show(moved, view, [0.65, 0.75, 0.85])
    simple.ResetCamera(view)
    view.CameraParallelScale *= 0.55
    simple.Render(view)
    ct.compare_image(view, name, size=(900, 500))
    simple.Delete(view)


# 0 below; 1, 2 above; 3, 4 on top.
picture("BranchingOneToTwo",
        circles((0, 0, 0, 2), (-1.3, 0, 1.5, 0.9), (1.3, 0, 1.5, 0.9), (-1.5, 0, 3, 0.9), (1.5, 0, 3, 0.9)),
        6, (1, 2), ForbiddenJoins=[0, 2])
# 0 below; 1 to 4 above; 5 to 8 on top.
corners = ((-1.1, -1.1), (1.1, -1.1), (-1.1, 1.1), (1.1, 1.1))
picture("BranchingOneToFour",
        circles((0, 0, 0, 2.4), *[(x, y, 1.5, 0.8) for x, y in corners], *[(x, y, 3, 0.8) for x, y in corners]),
        7, (1, 3), ForbiddenJoins=[0, 2, 0, 3])
# Three into three that are turned, so that each overlaps two: 0 to 2 below, 3 to 5 above.
low = [(1.6 * math.cos(a), 1.6 * math.sin(a), 0, 1.2) for a in (0, 2 * math.pi / 3, 4 * math.pi / 3)]
high = [(1.6 * math.cos(a), 1.6 * math.sin(a), 2, 1.2) for a in (math.pi / 3, math.pi, 5 * math.pi / 3)]
picture("BranchingThreeToThree", circles(*low, *high), 7, (1, 3), ForbiddenJoins=[0, 5, 1, 3, 2, 4])
# 0 shell, 1 its hole, 2 the core; 3 the same shell, 4, 5; 6 all in one on top.
picture("BranchingNested",
        circles((0, 0, 0, 2), (0.05, 0.1, 0, 1.5), (-0.1, 0.05, 0, 0.8), (0.03, 0, 1.5, 2), (0.1, 0.05, 1.5, 1.5),
                (-0.15, 0.1, 1.5, 0.8), (0, 0.02, 3, 1.8)),
        6, (1, 2), opened=True, ForbiddenJoins=[5, 6])
ct.finish()
