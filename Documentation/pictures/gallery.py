# SPDX-License-Identifier: GPL-3.0-or-later
"""Render the gallery, twelve pictures of what the plugin makes, and the stages of the methods (stages.py).

    ./run gallery [FOLDER [NAME ...]]     (default: Documentation/pictures/gallery)
"""
import math
import os
import pathlib
import sys

from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from stages import Stages

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "Data"
SIZE, STAGE_SIZE = (720, 540), (480, 420)
INK, BONE, SKIN, RED, BLUE, GREEN, GOLD = ((0.08, 0.1, 0.25), (0.93, 0.88, 0.76), (0.93, 0.74, 0.68), (0.75, 0.16, 0.16),
                                           (0.27, 0.47, 0.74), (0.35, 0.6, 0.35), (0.85, 0.65, 0.2))


def show(view, source, colour, shift=(0, 0, 0), opacity=1.0, style="Surface", width=1.5):
    display = simple.Show(source, view)
    display.Representation = style
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = list(colour)
    display.EdgeColor = [0.3, 0.3, 0.35]
    display.Opacity = opacity
    display.LineWidth = width
    # The property's name since ParaView 5.13, and before.
    name = "Translation" if display.GetProperty("Translation") else "Position"
    display.SetPropertyWithName(name, list(shift))


def contours(name):
    if name.endswith(".cnt"):
        return simple.NUAGESContourReader(FileName=str(DATA / name))
    return simple.CurveNetworkReader(FileName=str(DATA / name))


def loops(rings):
    """Contours of lists of points."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points, lines, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    for ring in rings:
        ids = [points.InsertNextPoint(p) for p in ring]
        lines.InsertNextCell(len(ids) + 1, ids + ids[:1])
    data.SetPoints(points)
    data.SetLines(lines)
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def ring(radius, z, x=0.0, y=0.0, count=28, squash=1.0):
    return [(x + radius * math.cos(2 * math.pi * i / count), y + squash * radius * math.sin(2 * math.pi * i / count), z)
            for i in range(count)]


def fork():
    """A trunk that becomes two branches, with a hole along the trunk."""
    rings = []
    for i in range(13):
        apart = max(0.0, 0.22 * (i - 5))
        for side in (-1, 1) if apart > 0.7 else (0,):
            radius = 0.75 if side else 0.9 + 0.55 * apart
            rings.append(ring(radius, 0.45 * i, side * apart, squash=1.0 if side else 0.9 / radius))
            if not side and i < 4:
                rings.append(ring(0.4, 0.45 * i))
    return loops(rings)


def brain(view):
    source = contours("brain.cnt")
    show(view, source, INK, (-75, 0, 0))
    show(view, simple.PolyhedralSurface(Input=source), SKIN, (75, 0, 0))
    return (0.3, -0.9, 0.35)


def head(view):
    show(view, simple.PolyhedralSurface(Input=contours("head.cnt")), SKIN, opacity=0.35)
    show(view, simple.PolyhedralSurface(Input=contours("brain.cnt")), (0.85, 0.5, 0.5))
    return (-0.7, 0.6, 0.25)


def femur(view):
    source = contours("femur_head.csl")
    show(view, source, RED, width=3)
    show(view, simple.ImplicitSurface(Input=source), BONE, opacity=0.85)
    return (0.7, -0.6, 0.3)


def tamarind(view):
    source = contours("tamarind.csl")
    show(view, source, RED, width=3)
    show(view, simple.ImplicitSurface(Input=source), (0.6, 0.42, 0.26), opacity=0.85)
    return (0.3, -0.8, 0.5)


def methods(view):
    source = fork()
    show(view, source, INK, (-4.5, 0, 0), width=2)
    show(view, simple.PolyhedralSurface(Input=source), BLUE, style="Surface With Edges")
    show(view, simple.ImplicitSurface(Input=source), GREEN, (4.5, 0, 0))
    return (0.1, -0.9, 0.4)


def caps(view):
    for number, cap in enumerate(("Flat", "HalfSlice", "Tapered", "Extrapolated", "None")):
        source = loops([ring(1.5 - 0.12 * (i - 2) ** 2, 0.6 * i) for i in range(5)])
        surface = simple.PolyhedralSurface(Input=source, EndCaps=cap)
        show(view, surface, GOLD, (3.6 * (number - 2), 0, 0), style="Surface With Edges")
        show(view, source, RED, (3.6 * (number - 2), 0, 0), width=4)
    return (0.0, -0.85, 0.5)


def joins(view):
    source = fork()
    show(view, simple.PolyhedralSurface(Input=source), BLUE, (-2.4, 0, 0))
    apart = simple.PolyhedralSurface(Input=source, Mapping="Overlap", OverlapThreshold=0.95)
    show(view, apart, RED, (2.4, 0, 0))
    return (0.1, -0.9, 0.3)


def tetrahedra(view):
    source = fork()
    solid = simple.JointVoronoiDiagram(Input=source)
    kept = simple.Threshold(Input=simple.Shrink(Input=solid, ShrinkFactor=0.8), Scalars=["CELLS", "Kept"], LowerThreshold=0.5,
                            UpperThreshold=1.5)
    display = simple.Show(kept, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("CELLS", "NodeType"))
    display.SetScalarBarVisibility(view, False)
    return (0.1, -0.9, 0.3)


def terrain(view):
    plane = simple.Plane(XResolution=90, YResolution=90)
    hills = simple.Calculator(Input=plane, ResultArrayName="Height", Function=(
        "3*exp(-25*(coordsX-0.15)^2-25*(coordsY-0.05)^2)+2*exp(-40*(coordsX+0.25)^2-30*(coordsY+0.15)^2)+1.3*exp(-30*(coordsX+0.1)^2"
        "-40*(coordsY-0.35)^2)"))
    lines = simple.Contour(Input=hills, ContourBy=["POINTS", "Height"], Isosurfaces=[0.25 * i for i in range(1, 12)])
    lifted = simple.WarpByScalar(Input=lines, Scalars=["POINTS", "Height"], ScaleFactor=0.12)
    show(view, lifted, INK, width=2)
    show(view, simple.PolyhedralSurface(Input=lifted, OpenLines="Border"), GREEN, opacity=0.95)
    return (-0.4, -0.8, 0.6)


def cut_and_back(view):
    mesh = simple.Superquadric(ThetaResolution=64, PhiResolution=64, Toroidal=1, Thickness=0.35)
    slices = simple.Slice(Input=mesh)
    slices.SliceType.Normal = [0.0, 1.0, 0.3]
    slices.SliceOffsetValues = [-0.6 + 0.06 * i for i in range(21)]
    show(view, mesh, (0.8, 0.8, 0.82), (-1.1, 0, 0))
    show(view, slices, INK, width=2)
    show(view, simple.PolyhedralSurface(Input=slices), GOLD, (1.1, 0, 0))
    return (0.3, -0.8, 0.6)


def regions(view):
    """What one structure set, or one model of a tracing program, becomes."""
    for x, y, radius, colour in ((0, 0, 2.0, BONE), (-0.8, 0.2, 0.6, RED), (0.7, 0.4, 0.5, BLUE), (0.3, -0.8, 0.45, GREEN)):
        levels = range(-6, 7)
        source = loops([ring(radius * math.sqrt(1 - (i / 7.0) ** 2), 0.28 * radius * i / 1.4, x, y) for i in levels])
        show(view, simple.PolyhedralSurface(Input=source), colour, opacity=0.25 if colour is BONE else 1.0)
    return (0.3, -0.9, 0.35)


def pipe(view):
    source = contours("branching_pipe.cnt")
    show(view, source, INK, (-18, 0, 0), width=2)
    show(view, simple.PolyhedralSurface(Input=source), BLUE, style="Surface With Edges")
    show(view, simple.ImplicitSurface(Input=source), GREEN, (18, 0, 0))
    return (0.2, -0.9, 0.4)


SCENES = {"brain": brain, "head": head, "femur": femur, "tamarind": tamarind, "methods": methods, "caps": caps, "joins": joins,
          "tetrahedra": tetrahedra, "terrain": terrain, "cut_and_back": cut_and_back, "regions": regions, "pipe": pipe}
SCENES.update(Stages(show, ring, loops).scenes())
# Pictures that are wider than high have room above and below.
ZOOM = {"brain": 1.25, "methods": 1.25, "caps": 1.38, "joins": 1.1, "cut_and_back": 1.25, "pipe": 1.2, "terrain": 1.2}


def render(name, folder):
    view = simple.CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.UseFXAA = 1
    size = STAGE_SIZE if name.startswith("stage_") else SIZE
    view.ViewSize = list(size)
    direction = SCENES[name](view)
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = list(direction)
    view.CameraViewUp = [0, 0, 1]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(ZOOM.get(name, 1.3 if name.startswith("stage_") else 0.95))
    simple.Render(view)
    path = os.path.join(folder, name + ".png")
    simple.SaveScreenshot(path, view, ImageResolution=list(size), CompressionLevel="9")
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)
    simple.Delete(view)
    print(path, flush=True)


def main(folder, names):
    simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
    os.makedirs(folder, exist_ok=True)
    for name in names or SCENES:
        render(name, folder)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "Documentation" / "pictures" / "gallery"), sys.argv[2:])
