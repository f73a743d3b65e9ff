# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs whose drawn planes, or long edges, the implicit method used to get wrong.

A leg that ends came back on the next planes, the hole of a ring closed between its slices, squares of four corners became
a ball, and walls that were missed were not counted.
"""
import contourtesting as ct

simple = ct.load_plugin()


def areas(contours):
    """By plane (z) the signed areas of closed lines, rounded."""
    by_plane = {}
    for i in range(contours.GetNumberOfCells()):
        points = contours.GetCell(i).GetPoints()
        p = [points.GetPoint(k) for k in range(points.GetNumberOfPoints())]
        area = 0.5 * sum(p[k - 1][0] * p[k][1] - p[k][0] * p[k - 1][1] for k in range(len(p)))
        by_plane.setdefault(round(p[0][2], 6), []).append(area)
    return by_plane


def contours_of(path, first, last, spacing):
    reader = simple.DICOMRTStructureSetReader(FileName=ct.shared(path))
    block = ct.data(reader).GetPartitionedDataSet(0).GetPartition(0)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(block)
    model = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=source))
    return areas(ct.data(simple.ImplicitContours(Input=model, UseRange=1, Range=[first, last], Spacing=spacing)))


def report(data):
    lines = data.GetFieldData().GetAbstractArray("Report")
    return [lines.GetValue(i) for i in range(lines.GetNumberOfValues())] if lines else []


def number(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


legs = contours_of("faults/rt/leg/drawn.dcm", 0, 14, 2)
ct.check(sum(len(plane) for plane in legs.values()) == 12, f"a leg that ended came back: {legs}")
for z, plane in legs.items():
    for area in plane:
        ct.check(abs(area / 706 - 1) < 0.02, f"an area of {area} at {z}, where 706 was drawn")

ring = contours_of("faults/rt/ring/drawn.dcm", 18, 36, 3)
for z, right in zip(sorted(ring), (81, 107, 129, 148, 164, 177, 188)):
    ct.check(len(ring[z]) == 2, f"{len(ring[z])} contours at {z}, not a ring")
    hole = -min(ring[z])
    ct.check(abs(hole / right - 1) < 0.15, f"a hole of {hole} at {z}, not about {right}")

for name, volume, part in (("box_4_corners", 1160, 0.015), ("vase", 1669.6, 0.01)):
    source = simple.XMLPolyDataReader(FileName=[ct.shared(f"faults/other/{name}.vtp")])
    surface = simple.ImplicitSurface(Input=source)
    found = number(ct.data(simple.SurfaceCertificate(Input=surface)), "Volume")
    ct.check(abs(found / volume - 1) < part, f"{name}: a volume of {found}, not {volume}")
    ct.check(number(ct.data(surface), "FarContourPoints") == 0, f"{name}: edges are missed")
    ct.check(any("were put on" in line for line in report(ct.data(surface))), f"{name}: {report(ct.data(surface))}")

# As the corners alone tell it.
source = simple.XMLPolyDataReader(FileName=[ct.shared("faults/other/box_4_corners.vtp")])
surface = simple.ImplicitSurface(Input=source, FillLongEdges=0, FollowDrawnPlanes=0)
ct.check(number(ct.data(surface), "FarContourPoints") > 0, "edges that are missed are not counted")
ct.check(any("more than a cell" in line for line in report(ct.data(surface))), f"{report(ct.data(surface))}")

ct.finish()
