# SPDX-License-Identifier: GPL-3.0-or-later
"""A broken surface with its defects in colour: what a user sees who asks the certificate where it is wrong."""
import contourtesting as ct
from certificateshapes import box_corners, box_triangles, surface

simple = ct.load_plugin()

# Six boxes in two rows, each broken in a way of its own (the last but by nothing).
points, cells = [], []


def add_box(low, high, skip=(), flip=()):
    first = len(points)
    points.extend(box_corners(low, high))
    for i, t in enumerate(box_triangles(first)):
        if i not in skip:
            cells.append(t[::-1] if i in flip else t)
    return first


add_box((0, 0, 0), (1, 1, 1), skip=(3,))                      # open
add_box((2, 0, 0), (3, 1, 1), flip=(3,))                      # one triangle flipped
add_box((4, 0, 0), (5, 1, 1))                                 # two that cross
add_box((4.5, 0.25, 0.6), (5.5, 0.75, 1.4))
add_box((0, 2, 0), (1, 3, 1), flip=range(12))                 # inside out
first = add_box((2, 2, 0), (3, 3, 1))                         # a fin on an edge: three faces
points.append((2.5, 2.0, 1.8))
cells.append((first + 4, first + 5, len(points) - 1))
add_box((4, 2, 0), (5, 3, 1))                                 # sound

producer = simple.TrivialProducer()
producer.GetClientSideObject().SetOutput(surface(points, cells))
certificate = simple.SurfaceCertificate(Input=producer)
defects = set()
array = ct.data(certificate).GetCellData().GetArray("Defect")
for i in range(array.GetNumberOfTuples()):
    defects.add(int(array.GetTuple1(i)))
union = 0
for defect in defects:
    union |= defect
ct.check(0 in defects and union & (1 | 2 | 4 | 64 | 256) == (1 | 2 | 4 | 64 | 256), f"all kinds are there: {defects}")

# The highest bit of a cell decides its colour.
kinds = simple.Calculator(Input=simple.OutputPort(certificate, 0), AttributeType="Cell Data", ResultArrayName="Kind",
                          Function="if(Defect<1,0,floor(ln(Defect)/ln(2)+1.000001))")
view = simple.CreateRenderView()
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
display = simple.Show(kinds, view)
display.Representation = "Surface With Edges"
display.EdgeColor = [0, 0, 0]
simple.ColorBy(display, ("CELLS", "Kind"))
colors = simple.GetColorTransferFunction("Kind")
colors.InterpretValuesAsCategories = 0
colors.RGBPoints = [0, 0.85, 0.85, 0.85, 1, 0.9, 0.1, 0.1, 2, 0.95, 0.6, 0.1, 3, 0.2, 0.4, 0.9,
                    7, 0.6, 0.1, 0.7, 9, 0.1, 0.6, 0.3]
colors.ColorSpace = "RGB"
display.SetScalarBarVisibility(view, False)
view.CameraPosition = [-3, -7, 8]
view.CameraFocalPoint = [2.75, 1.5, 0.5]
view.CameraViewUp = [0, 0, 1]
view.CameraViewAngle = 30
ct.compare_image(view, "SurfaceCertificateDefects")
simple.Delete(view)
ct.finish()
