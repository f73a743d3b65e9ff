# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's figures of the implicit method again: 10.1 to 10.5 and 11.1, each with its contours in it."""
import contourtesting as ct

simple = ct.load_plugin()


def read(name):
    path = ct.own(name)
    kind = simple.NUAGESContourReader if name.endswith(".cnt") else simple.CurveNetworkReader
    return kind(FileName=path)


def picture(name, contours, shown, direction, up):
    view = simple.CreateView("RenderView")
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    surface = simple.Show(shown, view)
    surface.ColorArrayName = ["POINTS", ""]
    surface.DiffuseColor = [0.85, 0.72, 0.55]
    surface.AmbientColor = [0.1, 0.3, 0.1]
    lines = simple.Show(contours, view)
    lines.ColorArrayName = ["POINTS", ""]
    lines.AmbientColor = lines.DiffuseColor = [0.7, 0.05, 0.05]
    lines.LineWidth = 4
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = direction
    view.CameraViewUp = up
    simple.ResetCamera(view)
    ct.compare_image(view, name)
    simple.Delete(view)


pipe = read("branching_pipe.cnt")
tamarind = read("tamarind.csl")
femur = read("femur_head.csl")
aslant = [1.0, -1.6, 0.7]

bounded = simple.ImplicitSurface(Input=pipe)
picture("ImplicitSurfacePipe", pipe, bounded, aslant, [0, 0, 1])

box = ct.data(pipe).GetBounds()
reach = max(box[2 * a + 1] - box[2 * a] for a in range(3))
unbounded = simple.ImplicitSurface(Input=pipe, UseBounds=1, ClosedAtBounds=0,
                                   Bounds=[box[i] + (-0.4 if i % 2 == 0 else 0.4) * reach for i in range(6)])
picture("ImplicitSurfacePipeUnbounded", pipe, unbounded, aslant, [0, 0, 1])

for name, contours, spacing in (("Pipe", pipe, 0.48), ("Tamarind", tamarind, 0.37), ("Femur", femur, 3.13)):
    model = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=contours))
    slices = simple.ImplicitContours(Input=model, Spacing=spacing)
    ct.check(ct.data(slices).GetNumberOfCells() > 3, f"{name}: contours at {spacing}")
    picture("ImplicitContours" + name, contours, slices, aslant, [0, 0, 1])

for name, contours, properties in (
        ("Tamarind", tamarind, dict(MergeBox=0.05)),
        ("TamarindCorners", tamarind, dict(Mode="Bounding Box Corners")),
        ("Femur", femur, {}),
        ("FemurMerged", femur, dict(MergeBox=0.05)),
        ("FemurCorners", femur, dict(Mode="Bounding Box Corners"))):
    surface = simple.ImplicitSurface(Input=contours, **properties)
    ct.check(ct.data(surface).GetNumberOfCells() > 100, f"{name} has no surface")
    picture("ImplicitSurface" + name, contours, surface, aslant, [0, 0, 1])

ct.finish()
