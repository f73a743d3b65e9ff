# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of contours and the surface made from them. Needs a display, or xvfb-run."""
import pathlib

from paraview.simple import *

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"

contours = NUAGESContourReader(FileName=str(DATA / "brain.cnt"))
surface = PolyhedralSurface(Input=contours)
view = CreateView("RenderView")
view.ViewSize = [900, 600]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
for source, colour, opacity in ((contours, [0.1, 0.1, 0.3], 1.0), (surface, [0.93, 0.74, 0.68], 0.7)):
    display = Show(source, view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour
    display.Opacity = opacity
ResetCamera(view)
view.CameraPosition = [view.CameraFocalPoint[0] - 260, view.CameraFocalPoint[1] - 180, view.CameraFocalPoint[2] + 120]
view.CameraViewUp = [0, 0, 1]
Render(view)
SaveScreenshot("brain.png", view)
Delete(view)
