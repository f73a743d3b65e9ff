# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Contours traces no plane beyond what was drawn unless it is told to, and no contour smaller than a pixel that
nobody drew; both are in Report."""
import math

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import vtkDoubleArray


def circle(radius, z, x=0.0):
    return [(x + radius * math.cos(i * math.pi / 20), radius * math.sin(i * math.pi / 20), z) for i in range(40)]


def source(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def planes(heights, pixel=None):
    """A rectangle a height, with the area of a pixel as DICOM Slice Planes gives it."""
    data = ct.closed_polylines([[(-30, -30, z), (30, -30, z), (30, 30, z), (-30, 30, z)] for z in heights])
    if pixel is not None:
        pixels = vtkDoubleArray()
        pixels.SetName("PixelArea")
        for _ in heights:
            pixels.InsertNextValue(pixel)
        data.GetCellData().AddArray(pixels)
    return source(data)


def model_of(loops):
    return simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=source(ct.closed_polylines(loops))))


def trace(model, heights, pixel=None, **properties):
    """By height the areas of what is traced, and the lines of Report that tracing adds."""
    data = ct.data(simple.ImplicitContours(Input=model, Planes=planes(heights, pixel), **properties))
    lines = data.GetFieldData().GetAbstractArray("Report")
    cells = data.GetCellData()
    offsets = data.GetFieldData().GetArray("LevelOffset")
    areas = {}
    for i in range(data.GetNumberOfCells()):
        z = offsets.GetValue(int(cells.GetArray("Level").GetTuple1(i)))
        areas.setdefault(round(z, 6), []).append(cells.GetArray("SignedArea").GetTuple1(i))
    return areas, [lines.GetValue(i) for i in range(lines.GetNumberOfValues())] if lines else []


# A ball of radius 20 that is drawn from -12 to 12.
drawn = [circle(math.sqrt(400 - z * z), z) for z in (-12.0, -6.0, 0.0, 6.0, 12.0)]
ball = model_of(drawn)
heights = [3.0 * k for k in range(-7, 8)]
within, report = trace(ball, heights)
ct.check(sorted(within) == [z for z in heights if abs(z) <= 12], f"traced on {sorted(within)}")
ct.check(any("were left out: 6 of 15" in line for line in report), f"Report: {report}")
beyond, report = trace(ball, heights, Extrapolate=1)
ct.check(min(beyond) < -12 and max(beyond) > 12, f"Extrapolate goes on: {sorted(beyond)}")
ct.check(not any("Extrapolate" in line for line in report), f"Report: {report}")
# A plane that the outermost contour lies beside, by less than a twentieth of the planes' distance, is its own.
beside, _ = trace(ball, [z + 0.1 for z in heights])
ct.check(max(beside) == 12.1, f"the last contour's own plane is taken: {sorted(beside)}")
ct.check("lies between the outermost" in ct.errors_of(lambda: trace(ball, [100.0, 103.0])), "planes of somebody else")

# Near its pole the ball's contour is a speck, for pixels that are larger.
pole = max(z for z in (19.9, 19.5, 19.0, 18.0) if z in trace(ball, [0.0, z], Extrapolate=1)[0])
small = trace(ball, [0.0, pole], Extrapolate=1)[0][pole][0]
for pixel, properties, kept in [(2 * small, {}, False), (0.5 * small, {}, True), (None, {}, True),
                                (2 * small, {"SmallestArea": -1}, True), (None, {"SmallestArea": 2 * small}, False)]:
    areas, report = trace(ball, [0.0, pole], pixel, Extrapolate=1, **properties)
    ct.check((pole in areas) == kept, f"pixel {pixel}, {properties}: {areas}")
    ct.check(any("1 computed contour of less" in line for line in report) != kept, f"pixel {pixel}: {report}")
# Not where somebody drew one as small.
tiny = math.sqrt(small / math.pi)
areas, _ = trace(model_of(drawn + [circle(tiny, z, 25.0) for z in (0.0, 6.0)]), [0.0, pole], 2 * small, Extrapolate=1)
ct.check(pole in areas, f"contours as small as drawn ones stay: {areas}")
ct.finish()
