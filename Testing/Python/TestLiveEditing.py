# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours that change one at a time in the pipeline: the same surface as from a node that has seen no other."""
import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.util.numpy_support import vtk_to_numpy

contours = ct.data(simple.NUAGESContourReader(FileName=ct.own("head.cnt")))
points = vtk_to_numpy(contours.GetPoints().GetData()).astype(float)


def polygon(cell):
    ids = [contours.GetCell(cell).GetPointId(i) for i in range(contours.GetCell(cell).GetNumberOfPoints())]
    return [tuple(points[i]) for i in (ids[:-1] if ids[0] == ids[-1] else ids)]


def arrays(surface):
    """All there is of a surface but the seconds it took, as bytes by name."""
    found = {"points": vtk_to_numpy(surface.GetPoints().GetData()).tobytes(),
             "triangles": vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).tobytes()}
    for attributes in (surface.GetPointData(), surface.GetCellData(), surface.GetFieldData()):
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            if array.GetName() == "StageSeconds":
                continue
            values = [array.GetValue(v) for v in range(array.GetNumberOfValues())]
            found[array.GetName()] = repr(values)
    return found


def moved(polygons, which, by):
    x, y, z = polygons[which][0]
    polygons[which][0] = (x + by, y, z)


def halved(polygons, which):
    a, b = polygons[which][:2]
    polygons[which].insert(1, tuple((p + q) / 2 for p, q in zip(a, b)))


def on_top(polygons):
    rise = max(z for p in polygons for _, _, z in p) - sorted({z for p in polygons for _, _, z in p})[-2]
    polygons.append([(x, y, z + rise) for x, y, z in polygons[-1]])


gone = []
polygons = [polygon(c) for c in range(contours.GetNumberOfCells())]
middle = len(polygons) // 2
producer = simple.TrivialProducer()
producer.GetClientSideObject().SetOutput(ct.closed_polylines(polygons))
edited = simple.PolyhedralSurface(Input=producer)
before = arrays(ct.data(edited))
edits = [("a point moves", lambda: moved(polygons, middle, 0.25)), ("a point comes", lambda: halved(polygons, middle + 5)),
         ("a contour goes", lambda: gone.append(polygons.pop(middle - 9))), ("the first moves", lambda: moved(polygons, 0, 0.25)),
         ("nothing changes", lambda: None), ("the last moves", lambda: moved(polygons, -1, 0.25)),
         ("a contour comes back", lambda: polygons.insert(middle - 9, gone.pop())), ("a slice comes on top", lambda: on_top(polygons)),
         ("two change", lambda: (moved(polygons, 20, 0.25), moved(polygons, -20, -0.25)))]
for what, edit in edits:
    edit()
    producer.GetClientSideObject().SetOutput(ct.closed_polylines(polygons))
    producer.MarkModified(producer)
    now = arrays(ct.data(edited))
    fresh = arrays(ct.data(simple.PolyhedralSurface(Input=producer)))
    ct.check(now.keys() == fresh.keys(), f"{what}: arrays {sorted(now.keys() ^ fresh.keys())} are in one only")
    for name in fresh:
        ct.check(now[name] == fresh[name], f"{what}: {name} is that of a new node")
    ct.check((now["points"] == before["points"]) == (what == "nothing changes"), f"{what}: the surface follows")
    before = now
for name, value in (("EndCaps", "Flat"), ("PinchGap", 0.0), ("Mapping", "Proximity"), ("EndCaps", "Extrapolated")):
    setattr(edited, name, value)
    fresh = simple.PolyhedralSurface(Input=producer)
    for known in ("EndCaps", "PinchGap", "Mapping"):
        setattr(fresh, known, getattr(edited, known))
    ct.check(arrays(ct.data(edited)) == arrays(ct.data(fresh)), f"{name} = {value}: all of it is that of a new node")
ct.finish()
