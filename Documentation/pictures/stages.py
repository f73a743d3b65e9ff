# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of the page on the stages: the same contours through the three methods. `./run gallery` renders them.

The contours are a trunk with a hole that becomes two branches, on six slices.
"""

from paraview import simple

INK, RED, BLUE, GREEN, GOLD = (0.08, 0.1, 0.25), (0.75, 0.16, 0.16), (0.27, 0.47, 0.74), (0.35, 0.6, 0.35), (0.85, 0.65, 0.2)
FROM_BESIDE = (0.25, -0.85, 0.42)
SPACING = 0.55


def fork(ring, loops):
    """A trunk, wider from slice to slice, then two branches; its lowest three slices have a hole."""
    rings = []
    for level in range(6):
        z = SPACING * level
        if level < 4:
            width = 0.9 + 0.17 * level
            rings.append(ring(width, z, count=24, squash=0.75 / width))
            if level < 3:
                rings.append(ring(0.32, z, count=16))
        else:
            rings += [ring(0.55, z, side * (0.75 + 0.12 * level - 0.4), count=18) for side in (-1, 1)]
    return loops(rings)


class Stages:
    """The scenes, by name; show, ring and loops are those of the gallery."""

    def __init__(self, show, ring, loops):
        self.show = show
        self.make = lambda: fork(ring, loops)

    def drawn(self, view, width=3):
        source = self.make()
        self.show(view, source, RED, width=width)
        return source

    def contours(self, view):
        self.drawn(view, 4)
        return FROM_BESIDE

    def triangulation(self, view):
        source = self.drawn(view, 4)
        stage = simple.ContourTriangulation(Input=source)
        inside = simple.Threshold(Input=stage, Scalars=["CELLS", "Inside"], LowerThreshold=0.5, UpperThreshold=1.5)
        self.show(view, inside, (0.75, 0.82, 0.92), style="Surface With Edges", width=1)
        return FROM_BESIDE

    def joint_voronoi(self, view):
        """The graph of what is kept: a point a tetrahedron, a line where two share a face."""
        source = self.drawn(view, 2)
        stage = simple.JointVoronoiDiagram(Input=source)
        kept = simple.Threshold(Input=simple.OutputPort(stage, 1), Scalars=["POINTS", "Kept"], LowerThreshold=0.5,
                                UpperThreshold=1.5)
        self.show(view, kept, BLUE, style="Wireframe", width=1.5)
        return FROM_BESIDE

    def tetrahedra(self, view):
        stage = simple.JointVoronoiDiagram(Input=self.drawn(view, 2))
        kept = simple.Threshold(Input=simple.Shrink(Input=stage, ShrinkFactor=0.75), Scalars=["CELLS", "Kept"],
                                LowerThreshold=0.5, UpperThreshold=1.5)
        display = simple.Show(kept, view)
        display.Representation = "Surface"
        simple.ColorBy(display, ("CELLS", "NodeType"))
        colours = simple.GetColorTransferFunction("NodeType")
        colours.ColorSpace = "Step"
        colours.RGBPoints = [1, 0.95, 0.72, 0.4, 1.5, 0.55, 0.7, 0.9, 11, 0.8, 0.45, 0.45, 12, 0.8, 0.45, 0.45]
        display.SetScalarBarVisibility(view, False)
        return FROM_BESIDE

    def polyhedral(self, view):
        source = self.drawn(view, 4)
        self.show(view, simple.PolyhedralSurface(Input=source), BLUE, style="Surface With Edges", width=1)
        return FROM_BESIDE

    def constraints(self, view):
        """Margins: inside gold, outside blue; contour points red."""
        stage = simple.ImplicitConstraints(Input=self.make(), MarginDistance=0.07, ThinOut=0, FillLongEdges=0, FollowDrawnPlanes=0)
        for kind, colour in ((0, RED), (1, GOLD), (-1, BLUE)):
            points = simple.Threshold(Input=stage, Scalars=["POINTS", "Kind"], LowerThreshold=kind, UpperThreshold=kind)
            self.show(view, points, colour, style="Points")
            display = simple.GetDisplayProperties(points, view)
            display.PointSize, display.RenderPointsAsSpheres = 7, 1
        return FROM_BESIDE

    def function(self, view):
        """The function on the plane through both branches: above 0 inside (gold), below 0 outside (blue)."""
        import numpy
        from paraview import numpy_support
        source = self.drawn(view, 3)
        model = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=source))
        model.UpdatePipeline()
        data = model.GetClientSideObject().GetOutputDataObject(0)
        field = [numpy_support.vtk_to_numpy(data.GetFieldData().GetArray(name)).ravel() for name in ("Polynomial", "Origin")]
        centres = numpy_support.vtk_to_numpy(data.GetPoints().GetData())
        weights = numpy_support.vtk_to_numpy(data.GetPointData().GetArray("Weight"))
        plane = simple.Plane(Origin=[-2.1, 0, -0.2], Point1=[2.1, 0, -0.2], Point2=[-2.1, 0, 2.95], XResolution=160, YResolution=120)
        plane.UpdatePipeline()
        grid = plane.GetClientSideObject().GetOutputDataObject(0).NewInstance()
        grid.DeepCopy(plane.GetClientSideObject().GetOutputDataObject(0))
        points = numpy_support.vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        far = numpy.linalg.norm(points[:, None, :] - centres[None, :, :], axis=2)
        values = (far ** 3) @ weights + field[0][0] + (points - field[1]) @ field[0][1:]
        array = numpy_support.numpy_to_vtk(values, deep=1)
        array.SetName("Function")
        grid.GetPointData().AddArray(array)
        shown = simple.PVTrivialProducer()
        shown.GetClientSideObject().SetOutput(grid)
        display = simple.Show(shown, view)
        display.SetRepresentationType("Surface")
        simple.ColorBy(display, ("POINTS", "Function"))
        lut = simple.GetColorTransferFunction("Function")
        lut.RGBPoints = [-1.0, 0.2, 0.4, 0.75, 0.0, 0.96, 0.96, 0.96, 0.5, 0.85, 0.6, 0.1]
        lut.ColorSpace = "RGB"
        display.Ambient, display.Diffuse = 1.0, 0.0
        display.SetScalarBarVisibility(view, False)
        zero = simple.Contour(Input=shown, ContourBy=["POINTS", "Function"], Isosurfaces=[0.0])
        self.show(view, zero, INK, width=3)
        return (0.12, -0.95, 0.25)

    def implicit(self, view):
        source = self.drawn(view, 4)
        self.show(view, simple.ImplicitSurface(Input=source, CellSize=0.16), GREEN, style="Surface With Edges", width=1)
        return FROM_BESIDE

    def even(self, view):
        """Even triangles, where Polyhedral Surface was: full tension moves nothing."""
        source = self.drawn(view, 4)
        self.show(view, simple.FairSurface(Input=source, Tension=1.0), BLUE, style="Surface With Edges", width=1)
        return FROM_BESIDE

    def fair(self, view):
        source = self.drawn(view, 4)
        self.show(view, simple.FairSurface(Input=source), GOLD, style="Surface With Edges", width=1)
        return FROM_BESIDE

    def scenes(self):
        names = ("contours", "triangulation", "joint_voronoi", "tetrahedra", "polyhedral", "constraints", "function", "implicit",
                 "even", "fair")
        return {"stage_" + name: getattr(self, name) for name in names}
