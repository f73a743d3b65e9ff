# SPDX-License-Identifier: GPL-3.0-or-later
"""A real head and its brain, from contours to surfaces, files and pictures; run it as `./run demo`.

    demo.py FOLDER      (in pvpython, with the plugin's path in CONTOUR_PLUGIN and a display)

Reads Data/head.cnt and Data/brain.cnt, prints a table, and leaves in FOLDER for each of them .vtp, .stl and .brep
and a picture of contours and surface side by side, and one picture of the brain in the opened head.
"""
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contourcli as cli
from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
SIZE = (1400, 680)
SKIN = [0.91, 0.74, 0.63]
BRAIN = [0.90, 0.66, 0.64]
INK = [0.10, 0.22, 0.42]
RED = [0.80, 0.25, 0.15]


def view_from(direction, centre, half_height):
    """An empty view, white, that looks along a direction at a centre, z up; it is so many mm high."""
    view = simple.CreateView("RenderView")
    view.ViewSize = list(SIZE)
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = half_height
    view.CameraFocalPoint = list(centre)
    view.CameraPosition = [c - 1000.0 * d for c, d in zip(centre, direction)]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view


def smooth(producer):
    """Normals for shading; the filter has another name from ParaView 5.13 on."""
    surface_normals = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals
    return surface_normals(Input=producer, FeatureAngle=50.0, Splitting=1)


def move(shown, position):
    """Puts a representation elsewhere; the property has another name from ParaView 5.13 on."""
    name = "Translation" if shown.GetProperty("Translation") else "Position"
    shown.SetPropertyWithName(name, list(position))


def show_surface(producer, view, colour, position=(0.0, 0.0, 0.0), opacity=1.0):
    """Shaded smoothly, but for edges that are really sharp, such as the flat end at the neck."""
    normals = smooth(producer)
    shown = simple.Show(normals, view)
    shown.Representation = "Surface"
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = colour
    shown.DiffuseColor = colour
    shown.Specular = 0.25
    shown.SpecularPower = 25.0
    shown.Ambient = 0.08
    shown.Opacity = opacity
    move(shown, position)
    return normals


def show_contours(producer, view, position):
    """Outer walls in ink, walls of cavities in red."""
    hierarchy = simple.ContourHierarchy(Input=producer)
    hierarchy.UpdatePipeline()
    nodes = [hierarchy]
    deepest = int(hierarchy.CellData["Depth"].GetRange()[1])
    for depth in range(deepest + 1):
        level = simple.Threshold(Input=hierarchy, Scalars=["CELLS", "Depth"], LowerThreshold=depth - 0.5,
                                 UpperThreshold=depth + 0.5)
        shown = simple.Show(level, view)
        shown.Representation = "Wireframe"
        shown.ColorArrayName = ["POINTS", ""]
        shown.AmbientColor = shown.DiffuseColor = INK if depth % 2 == 0 else RED
        shown.Opacity = 0.55
        shown.LineWidth = 1.0
        move(shown, position)
        nodes.insert(0, level)
    return nodes


def save(view, path):
    simple.SaveScreenshot(path, view, ImageResolution=list(SIZE), TransparentBackground=0, CompressionLevel="9")
    simple.Delete(view)
    if not os.path.exists(path):
        raise cli.CommandError(f"{path} could not be written: is there a display, and room on the disk?")


def side_by_side(result, path, direction, colour):
    """Contours on the left, the surface made from them on the right."""
    low, high = result.surface.GetBounds()[0::2], result.surface.GetBounds()[1::2]
    extent = [b - a for a, b in zip(low, high)]
    centre = [0.5 * (a + b) for a, b in zip(low, high)]
    level = math.hypot(direction[0], direction[1])
    right = (direction[1] / level, -direction[0] / level, 0.0)
    apart = 1.08 * sum(abs(r) * e for r, e in zip(right, extent))
    # Two of them side by side, and some white around.
    view = view_from(direction, centre, 1.02 * apart * SIZE[1] / SIZE[0])
    contours = cli.as_source(result.contours.data)
    surface = cli.as_source(result.surface)
    nodes = show_contours(contours, view, [-0.5 * apart * c for c in right])
    nodes.append(show_surface(surface, view, colour, [0.5 * apart * c for c in right]))
    save(view, path)
    for proxy in nodes + [surface, contours]:
        simple.Delete(proxy)


def opened_head(head, brain, path):
    """The brain in the left half of the head."""
    view = view_from((-0.80, -0.56, -0.22), (0.0, -12.0, 13.0), 102.0)
    skin = cli.as_source(head.surface)
    inner = cli.as_source(brain.surface)
    half = simple.Clip(Input=skin)
    half.ClipType = "Plane"
    half.ClipType.Origin = [0.0, 0.0, 0.0]
    half.ClipType.Normal = [1.0, 0.0, 0.0]
    cut = simple.ExtractSurface(Input=half)
    kept = show_surface(cut, view, SKIN)
    shown = show_surface(inner, view, BRAIN)
    save(view, path)
    for proxy in (kept, shown, cut, half, inner, skin):
        simple.Delete(proxy)


def pictures(head, brain, folder):
    """The names of the files."""
    # Coordinates are those of the MNI space: x to the right, y to the front, z up.
    side_by_side(head, os.path.join(folder, "head.png"), (-0.62, -0.74, -0.24), SKIN)
    side_by_side(brain, os.path.join(folder, "brain.png"), (-0.80, -0.45, -0.40), BRAIN)
    opened_head(head, brain, os.path.join(folder, "brain_in_head.png"))
    return ["head.png", "brain.png", "brain_in_head.png"]


def main(folder):
    cli.load_plugin()
    results, files, reading, writing = [], [], 0.0, 0.0
    for name in ("head", "brain"):
        blocks, seconds = cli.read_contours(os.path.join(DATA, name + ".cnt"))
        reading += seconds
        bar = cli.ProgressBar(name)
        try:
            results.append(cli.reconstruct(blocks[0], bar=bar))
        finally:
            bar.clear()
        for extension in (".vtp", ".stl"):
            files.append(name + extension)
            writing += cli.write_surface(os.path.join(folder, files[-1]), results[-1])
        files.append(name + ".brep")
        exact = cli.reconstruct(blocks[0], settings=cli.settings_for(files[-1], "psm", ()))
        writing += cli.write_surface(os.path.join(folder, files[-1]), exact)
    cli.print_results(results, [("read", reading), ("write", writing)])
    head, brain = results
    files += pictures(head, brain, folder)
    print("\nWritten to " + folder + ": " + ", ".join(files))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("demo: give the folder to write to.")
    try:
        main(sys.argv[1])
    except cli.CommandError as error:
        sys.exit(f"demo: {error}")
