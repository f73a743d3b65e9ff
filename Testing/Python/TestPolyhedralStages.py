# SPDX-License-Identifier: GPL-3.0-or-later
"""The stages show what the surface is made of, and the surface's groups are those of Contour Mapping.

With the same properties, flat ends, no lifting and no gap at pinches, the boundary of the kept tetrahedra is the surface.
"""
import collections

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.util.numpy_support import vtk_to_numpy

PLAIN = {"EndCaps": "Flat", "LiftInternalPoints": 0}


def reader(path):
    return simple.NUAGESContourReader(FileName=path)


def faces_of_tetrahedra(grid):
    """Faces of one kept tetrahedron only, as sets of places; inner ones are counted twice."""
    points = [tuple(p) for p in vtk_to_numpy(grid.GetPoints().GetData())]
    kept = vtk_to_numpy(grid.GetCellData().GetArray("Kept"))
    count = collections.Counter()
    for cell, is_kept in zip(vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4), kept):
        if is_kept:
            for k in range(4):
                count[frozenset(points[p] for i, p in enumerate(cell) if i != k)] += 1
    return {face for face, number in count.items() if number == 1}


def faces_of_surface(surface):
    points = [tuple(p) for p in vtk_to_numpy(surface.GetPoints().GetData())]
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    count = collections.Counter(frozenset(points[p] for p in triangle) for triangle in triangles)
    # Sheets that touch, face to face, are no boundary of the solid as a set.
    return {face for face, number in count.items() if number % 2 == 1}


def volume(surface):
    import numpy
    points = vtk_to_numpy(surface.GetPoints().GetData())
    a, b, c = (points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)[:, k]] for k in range(3))
    return float(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6)


for name, properties, expected_added in (
        ("branching_pipe.cnt", {}, 0), ("branching_pipe.cnt", {"Mapping": "Proximity"}, 0),
        ("branching_pipe.cnt", {"InternalPoints": 0}, 2), ("brain.cnt", {}, 60)):
    source = reader(ct.own(name))
    case = f"{name} {properties}"
    surface = ct.data(simple.PolyhedralSurface(Input=source, PinchGap=0, **PLAIN, **properties))
    diagram = simple.JointVoronoiDiagram(Input=source, **PLAIN, **properties)
    made = faces_of_tetrahedra(ct.data(diagram))
    shown = faces_of_surface(surface)
    triangulation = ct.data(simple.ContourTriangulation(Input=source, **PLAIN, **properties))
    places = {tuple(p) for p in vtk_to_numpy(triangulation.GetPoints().GetData())}
    added = {tuple(p) for p in vtk_to_numpy(surface.GetPoints().GetData())} - places
    # Later stages cover triangles that no solid touches, and halve edges at which sheets meet: a few faces a point.
    ct.check(len(shown) > 0 and len(made ^ shown) <= 14 * len(added),
             f"{case}: {len(made - shown)} faces of tetrahedra are none of the surface's, {len(shown - made)} the other way "
             f"round, with {len(added)} points of later stages")
    ct.check(len(added) <= expected_added and len(made & shown) >= 0.9 * len(shown), f"{case}: {len(added)} points are added later")

# The properties, their defaults and their values are the same.
nodes = [kind(Input=source) for kind in (simple.PolyhedralSurface, simple.JointVoronoiDiagram, simple.ContourTriangulation)]
for property_name in nodes[0].ListProperties():
    if property_name in ("Input", "Overrides", "Report", "PinchGap"):
        continue  # the gap is drawn in the surface, after the stages
    values = [str(node.GetPropertyValue(property_name)) for node in nodes]
    ct.check(len(set(values)) == 1, f"{property_name} is {values}")


def lines(data):
    array = data.GetFieldData().GetAbstractArray("Report")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


# The stages tell what they left out, as the surface does.
far = ct.closed_polylines([[(x, y, z) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))] for z in (0, 1, 2, 30, 31, 32)])
source = simple.PVTrivialProducer()
source.GetClientSideObject().SetOutput(far)
said = lines(ct.data(simple.PolyhedralSurface(Input=source)))
ct.check(any("apart" in line for line in said), f"the surface tells of the gap: {said}")
for kind in (simple.JointVoronoiDiagram, simple.ContourTriangulation):
    told = lines(ct.data(kind(Input=source)))
    ct.check(any("apart" in line for line in told), f"{kind.__name__} tells of the gap: {told}")

# A triangle's group is that of the contours whose points it has.
for name in ("branching_pipe.cnt", "brain.cnt"):
    source = reader(ct.own(name))
    mapping = ct.data(simple.ContourMapping(Input=source))
    group = {}  # of a point, by slab
    below = vtk_to_numpy(mapping.GetCellData().GetArray("MappingGroupBelow"))
    above = vtk_to_numpy(mapping.GetCellData().GetArray("MappingGroupAbove"))
    level = vtk_to_numpy(mapping.GetCellData().GetArray("Level"))
    for c in range(mapping.GetNumberOfCells()):
        cell = mapping.GetCell(c)
        for p in range(cell.GetNumberOfPoints()):
            place = cell.GetPoints().GetPoint(p)
            group.setdefault((place, int(level[c]) - 1), set()).add(int(below[c]))
            group.setdefault((place, int(level[c])), set()).add(int(above[c]))
    surface = ct.data(simple.PolyhedralSurface(Input=source, EndCaps="Flat"))
    data = surface.GetCellData()
    groups, slabs = vtk_to_numpy(data.GetArray("MappingGroup")), vtk_to_numpy(data.GetArray("Slab"))
    wrong, checked = 0, 0
    for t in range(surface.GetNumberOfCells()):
        cell = surface.GetCell(t)
        for p in range(3):
            of_point = group.get((cell.GetPoints().GetPoint(p), int(slabs[t])))
            if of_point and len(of_point) == 1:
                checked += 1
                wrong += of_point != {int(groups[t])}
    ct.check(checked > 100 and wrong == 0, f"{name}: {wrong} of {checked} corners are of another group than their triangle")
    pieces = vtk_to_numpy(data.GetArray("Piece"))
    ct.check(min(pieces) == 0 and set(pieces) == set(range(max(pieces) + 1)), f"{name}: pieces are numbered from 0")

# What Contour Mapping decided is followed, or said not to be.
def square(z, x):
    return [(x + a, b, z) for a, b in ((0, 0), (2, 0), (2, 2), (0, 2))]


two = ct.closed_polylines([square(0, 0), square(1, 0), square(2, 0), square(3, 0)])
source = simple.PVTrivialProducer()
source.GetClientSideObject().SetOutput(two)
forbidding = simple.ContourMapping(Input=source, ForbiddenJoins=[1, 2])
free = ct.data(simple.PolyhedralSurface(Input=source, EndCaps="Flat"))
followed = ct.data(simple.PolyhedralSurface(Input=forbidding, EndCaps="Flat"))
ct.check(any("mapping that came with the contours is followed: 2 joins, and 1 pair" in line for line in lines(followed)),
         f"the mapping is followed: {lines(followed)}")
ct.check(abs(volume(free) - 12) < 1e-9 and abs(volume(followed) - 8) < 1e-9,
         f"two boxes instead of one: {volume(followed)} and {volume(free)}")
back = ct.data(simple.PolyhedralSurface(Input=forbidding, EndCaps="Flat", ForcedJoins=[1, 2]))
ct.check(abs(volume(back) - volume(free)) < 1e-9, "what the node itself says goes first")
nameless = followed.NewInstance()
nameless.DeepCopy(ct.data(forbidding))
nameless.GetCellData().RemoveArray("ContourId")
without = simple.PVTrivialProducer()
without.GetClientSideObject().SetOutput(nameless)
said = lines(ct.data(simple.PolyhedralSurface(Input=without, EndCaps="Flat")))
ct.check(any("is not followed" in line for line in said), f"without ContourId that is said: {said}")

# The table of joins is a table of overrides as it is.
table = simple.PVTrivialProducer()
table.GetClientSideObject().SetOutput(forbidding.GetClientSideObject().GetOutputDataObject(1))
overridden = simple.PolyhedralSurface(Input=source, EndCaps="Flat", Overrides=table)
ct.check(abs(volume(ct.data(overridden)) - volume(followed)) < 1e-9, "the column Joined is as good as Join")
ct.finish()
