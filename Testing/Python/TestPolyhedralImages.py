# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of every stage of the polyhedral method, on the thesis's branching pipe, of the brain, and of the fair surface."""
import contourtesting as ct

simple = ct.load_plugin()


def new_view(camera):
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = camera
    view.CameraViewUp = [0, 0, 1]
    return view


def show(source, view, array=None, representation="Surface With Edges", port=0):
    shown = simple.Show(simple.OutputPort(source, port) if port else source, view)
    shown.Representation = representation
    shown.AmbientColor = shown.DiffuseColor = [0.85, 0.75, 0.65]
    shown.LineWidth = 2.0
    if array:
        simple.ColorBy(shown, array)
        shown.RescaleTransferFunctionToDataRange(False, True)
        shown.SetScalarBarVisibility(view, False)
    else:
        shown.ColorArrayName = ["POINTS", ""]
    return shown


def picture(name, view):
    simple.ResetCamera(view)
    simple.Render(view)
    ct.compare_image(view, name)
    # Two views that are alive at the end may bring down their GL contexts in an order that X takes amiss.
    simple.Delete(view)


pipe = simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))
oblique = [-2, -5, 2.5]

view = new_view(oblique)
show(simple.ContourHierarchy(Input=pipe), view, ("CELLS", "Level"), "Wireframe")
picture("ContourHierarchyPipe", view)

triangulation = simple.ContourTriangulation(Input=pipe)
view = new_view(oblique)
show(triangulation, view, ("CELLS", "Inside"))
picture("ContourTriangulationPipe", view)

diagram = simple.JointVoronoiDiagram(Input=pipe)
kept = simple.Threshold(Input=diagram, Scalars=["CELLS", "Kept"], LowerThreshold=1, UpperThreshold=1)
view = new_view(oblique)
show(simple.Shrink(Input=kept, ShrinkFactor=0.8), view, ("CELLS", "NodeType"), "Surface")
picture("JointVoronoiDiagramPipe", view)

view = new_view(oblique)
show(simple.PolyhedralSurface(Input=pipe, EndCaps="Flat"), view, ("CELLS", "FaceKind"))
picture("PolyhedralSurfacePipe", view)

brain = simple.NUAGESContourReader(FileName=ct.own("brain.cnt"))
view = new_view([-4, -3, 2])
show(simple.PolyhedralSurface(Input=brain), view, None, "Surface")
picture("PolyhedralSurfaceBrain", view)

view = new_view(oblique)
show(simple.FairSurface(Input=pipe, EndCaps="Flat"), view)
picture("FairSurfacePipe", view)
ct.finish()
