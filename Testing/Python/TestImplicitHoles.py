# SPDX-License-Identifier: GPL-3.0-or-later
"""Holes and nested objects in the implicit method (thesis 12.2): a ball with a cavity, and in the cavity another ball.

Slices in; three nested surfaces out, the cavity's turned inward.
"""
import math

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

RADII = (10.0, 6.5, 3.0)  # of ball, cavity, ball in it
LEVELS = [-9.5 + 19 * k / 19 for k in range(20)]


def slices():
    """Circles of all three spheres, every one counterclockwise: that holes are holes is found by their nesting."""
    points, lines = vtkPoints(), vtkCellArray()
    for z in LEVELS:
        for radius in RADII:
            if abs(z) >= radius:
                continue
            circle, count = math.sqrt(radius * radius - z * z), int(12 + 2 * radius)
            ids = [points.InsertNextPoint(circle * math.cos(2 * math.pi * k / count),
                                          circle * math.sin(2 * math.pi * k / count), z) for k in range(count)]
            lines.InsertNextCell(count + 1)
            for i in ids + ids[:1]:
                lines.InsertCellPoint(i)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def ball(radius):
    return 4 / 3 * math.pi * radius ** 3


contours = slices()
surface = simple.ImplicitSurface(Input=contours)
node = simple.SurfaceCertificate(Input=surface, Contours=contours)
fields = ct.data(node).GetFieldData()
figures = {name: fields.GetArray(name).GetTuple1(0) for name in
           ("Components", "Euler", "Closed", "EdgeManifold", "VertexManifold", "Oriented", "Outward", "CrossingPairs",
            "Volume", "FarthestContourVertex")}
ct.check(figures["Components"] == 3 and figures["Euler"] == 6, f"not three spheres: {figures}")
for name in ("Closed", "EdgeManifold", "VertexManifold", "Oriented", "Outward"):
    ct.check(figures[name] == 1, f"{name} is {figures[name]}")
ct.check(figures["CrossingPairs"] == 0, f"{figures['CrossingPairs']} pairs of triangles cross")
truth = ball(RADII[0]) - ball(RADII[1]) + ball(RADII[2])
ct.check(abs(figures["Volume"] / truth - 1) < 0.02, f"a volume of {figures['Volume']}, not {truth}")
cell = ct.data(surface).GetFieldData().GetArray("CellSize").GetTuple1(0)
ct.check(figures["FarthestContourVertex"] < cell, f"a contour is {figures['FarthestContourVertex']} away, cells are {cell}")

# A row a component: the ball in the cavity and the ball around it enclose solid, the cavity takes from it.
table = ct.data(node, 2)
volumes = sorted(table.GetColumnByName("Volume").GetTuple1(row) for row in range(3))
for volume, expected in zip(volumes, sorted((-ball(RADII[1]), ball(RADII[2]), ball(RADII[0])))):
    ct.check(abs(volume / expected - 1) < 0.05, f"a component's volume of {volume}, not {expected}")

# The cavity is there on planes between the drawn ones too.
model = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=contours))
middle = ct.data(simple.ImplicitContours(Input=model, UseRange=1, Range=[0.25, 0.25], Spacing=1))
depths = sorted(int(middle.GetCellData().GetArray("Depth").GetTuple1(c)) for c in range(middle.GetNumberOfCells()))
ct.check(depths == [0, 1, 2], f"contours of depths {depths} through the middle")

view = simple.CreateView("RenderView")
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0


def rear_half(source):
    half = simple.Clip(Input=source)
    half.ClipType.Origin = [0, 0, 0]
    half.ClipType.Normal = [0, -1, 0]
    return half


shown = simple.Show(rear_half(surface), view)
shown.ColorArrayName = ["POINTS", ""]
shown.DiffuseColor = [0.85, 0.72, 0.55]
shown.BackfaceRepresentation = "Surface"
shown.BackfaceDiffuseColor = [0.45, 0.55, 0.75]
lines = simple.Show(rear_half(contours), view)
lines.ColorArrayName = ["POINTS", ""]
lines.AmbientColor = lines.DiffuseColor = [0.7, 0.05, 0.05]
lines.LineWidth = 2
view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition = [10, -40, 14]
view.CameraViewUp = [0, 0, 1]
simple.ResetCamera(view)
view.CameraViewAngle = 27
ct.compare_image(view, "ImplicitSurfaceNested")
simple.Delete(view)
ct.finish()
