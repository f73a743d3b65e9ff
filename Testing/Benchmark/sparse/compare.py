# SPDX-License-Identifier: GPL-3.0-or-later
"""What sparse.py asks of its virtual environment: interpolate drawn slices with ITK, and compare regions exactly.

    compare.py IN.json OUT.json      (python with itk-morphologicalcontourinterpolation, shapely, contourpy)

IN is a list of cases as sparse.py writes them. A region on a plane is the even-odd interior of closed loops in the two
coordinates of the plane. OUT has for every case and method the figures of `figures`.
"""
import json
import sys

import contourpy
import itk
import numpy
import shapely

itk.MultiThreaderBase.SetGlobalDefaultNumberOfThreads(1)
# Distance of samples on a border, as a part of the region's extent.
SAMPLING = 1e-3


def region(loops):
    """Even-odd interior of closed loops, each a list of (x, y)."""
    inside = shapely.Polygon()
    for loop in loops:
        if len(loop) >= 3:
            inside = inside.symmetric_difference(shapely.make_valid(shapely.Polygon(loop)))
    return inside


def border_samples(shape, step):
    line = shapely.segmentize(shape.boundary, step)
    return shapely.points(shapely.get_coordinates(line))


def hausdorff(a, b, step):
    """Largest distance from a border to the other, both ways; infinite where one is empty."""
    if a.is_empty or b.is_empty:
        return float("inf")
    forth = shapely.distance(border_samples(a, step), b.boundary).max()
    back = shapely.distance(border_samples(b, step), a.boundary).max()
    return float(max(forth, back))


def figures(truths, found):
    """Dice of all planes together, of the worst plane, mean and largest Hausdorff, planes with nothing on them."""
    common = sizes = 0.0
    worst, distances, empty = 1.0, [], 0
    for truth, shape in zip(truths, found):
        both, size = truth.intersection(shape).area, truth.area + shape.area
        common, sizes = common + 2 * both, sizes + size
        worst = min(worst, 2 * both / size)
        low_x, low_y, high_x, high_y = truth.bounds
        distance = hausdorff(truth, shape, SAMPLING * max(high_x - low_x, high_y - low_y))
        if numpy.isinf(distance):
            empty += 1
        else:
            distances.append(distance)
    return {"dice": common / sizes, "worst_dice": worst, "empty": empty,
            "hausdorff": float(numpy.mean(distances)) if distances else None,
            "largest_hausdorff": max(distances) if distances else None}


class Grid:
    """Voxels: origin and spacing by x, y, z; arrays are indexed [z, y, x]."""

    def __init__(self, origin, spacing, size):
        self.origin, self.spacing, self.size = origin, spacing, size

    def centres(self, axis):
        return self.origin[axis] + self.spacing[axis] * numpy.arange(self.size[axis])

    def index(self, axis, offset):
        place = (offset - self.origin[axis]) / self.spacing[axis]
        if abs(place - round(place)) > 1e-3:
            raise ValueError(f"the plane at {offset} does not lie on the grid")
        return int(round(place))

    def slice_of(self, array, axis, k):
        """A view [v, u] of the plane's two coordinates in rising order of their axes."""
        return numpy.moveaxis(array, 2 - axis, 0)[k]


def rasterise(grid, drawn):
    labels = numpy.zeros(grid.size[::-1], numpy.uint8)
    for plane in drawn:
        axis = plane["axis"]
        u, v = [a for a in range(3) if a != axis]
        x, y = numpy.meshgrid(grid.centres(u), grid.centres(v))
        shape = region(plane["loops"])
        shapely.prepare(shape)
        inside = shapely.contains_xy(shape, x, y)
        view = grid.slice_of(labels, axis, grid.index(axis, plane["offset"]))
        view[inside] = 1
    return labels


def outline(grid, mask, axis):
    """The region of a mask, through the midpoints between pixels inside and outside."""
    u, v = [a for a in range(3) if a != axis]
    x, y = grid.centres(u), grid.centres(v)
    # A rim, so that regions at the grid's border are closed.
    x = numpy.concatenate(([x[0] - grid.spacing[u]], x, [x[-1] + grid.spacing[u]]))
    y = numpy.concatenate(([y[0] - grid.spacing[v]], y, [y[-1] + grid.spacing[v]]))
    lines = contourpy.contour_generator(x, y, numpy.pad(mask, 1).astype(float)).lines(0.5)
    return region([line[:-1] for line in lines])


def interpolate(labels, axis):
    """ITK's morphological contour interpolation, along one axis or (-1) along all."""
    image = itk.image_from_array(labels)
    method = itk.MorphologicalContourInterpolator[type(image)].New(image)
    method.SetAxis(axis)
    # With several threads it has been seen to corrupt its heap.
    method.SetNumberOfWorkUnits(1)
    method.Update()
    return itk.array_from_image(method.GetOutput())


def with_itk(case, drawn):
    grid = Grid(**case["grid"])
    orientations = {plane["axis"] for plane in drawn}
    filled = interpolate(rasterise(grid, drawn), case["axis"] if len(orientations) == 1 else -1)
    axis = case["axis"]
    return [outline(grid, grid.slice_of(filled, axis, grid.index(axis, plane["offset"])), axis)
            for plane in case["planes"]]


def compare(case):
    truths = [region(plane["truth"]) for plane in case["planes"]]
    results = {}
    for method in case["planes"][0]["found"]:
        results[method] = figures(truths, [region(plane["found"][method]) for plane in case["planes"]])
    for method, drawn in case["itk"].items():
        results[method] = figures(truths, with_itk(case, drawn))
    return results


def main(source, target):
    with open(source) as file:
        cases = json.load(file)
    results = [compare(case) for case in cases]
    with open(target, "w") as file:
        json.dump(results, file)


main(*sys.argv[1:])
