# SPDX-License-Identifier: GPL-3.0-or-later
"""Is the truth within the bounds that Surface Certificate gives for the volume by the contours?

    ./run bench volumes [NAME ...] [--markdown FILE] [--check]

NAME is a part of a row's name. Rows: fifty balls of each of six sizes, their slices one apart from a random place on; sixty cylinders
that lie across such slices, whose ends are steeper than a ball's, fifty columns and fifty cones that stand on them and end anywhere between two;
the phantoms of the shared test data, of which 24 mm are known; the meshes of `./run bench truth`. Columns: how many there are, of how many the
truth is within the bounds; the estimate's error in per cent, mean of the sizes and worst; the same of Polyhedral Surface and its default ends; the
mean distance of the bounds in per cent of the truth. With --check the exit code says whether the truth is within all bounds.
"""
import argparse
import collections
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "truth"))
import numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
from truedata import SHARED, cases, output, poly_data, producer, simple, volume

HEAD = ("what", "how many", "truth within", "estimate: mean error %", "worst", "polyhedral: mean error %", "worst", "width of the bounds %")
PHANTOM = {"Sphere": 4 / 3 * math.pi * 12 ** 3, "Cylinder": math.pi * 12 ** 2 * 24, "Cone": math.pi * 12 ** 2 * 24 / 3}
PREFACE = """# The volume that contours tell

What Surface Certificate says of the volume by the contours, beside the truth: `./run bench volumes --markdown Data/VOLUMES.md`, whose
docstring, in `Testing/Benchmark/volumes.py`, says what rows and columns are. The estimate takes sections as a parabola along the stack; the bounds are
what is possible where shapes end anywhere between two slices ([VolumeInterval.h](../Filters/Core/Contours/VolumeInterval.h)). Its constants were
written down before any of this was measured; what a section may do that all but vanishes was added for three phantoms, cylinders across the slices
with a contour of no width on their very sides. The balls' estimate is exact because sections of a ball are a parabola. Columns and cones end on a flat face
anywhere between two slices, which no slice tells; phantoms of that kind end on their first and last slice.

"""


def loops(sections):
    """Closed loops of points of shape (n, 2) at heights, as a proxy; the polygon is the face of a poly data."""
    points, faces = [], []
    for outline, z in sections:
        faces.append(range(len(points), len(points) + len(outline)))
        points += [(x, y, z) for x, y in outline]
    data = poly_data(numpy.array(points), numpy.zeros((0, 3)))
    cells = vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), list(face))
    data.SetPolys(cells)
    return producer(data)


def disk(radius, corners=96):
    """Of the area of a circle."""
    r = radius * math.sqrt(2 * math.pi / corners / math.sin(2 * math.pi / corners))
    angles = 2 * math.pi * numpy.arange(corners) / corners
    return numpy.column_stack((r * numpy.cos(angles), r * numpy.sin(angles)))


def heights(low, high, random):
    """One apart, in the open interval; two at least."""
    made = numpy.arange(low + random.random() * min(1, (high - low) / 2), high - 1e-6, 1.0)
    return made if len(made) > 1 else heights(low, high, random)


def made_up():
    random = numpy.random.default_rng(2026)
    for diameter in (3, 5, 7, 10, 15, 20):
        r = diameter / 2
        for _ in range(50):
            yield (f"balls of {diameter}", 4 / 3 * math.pi * r ** 3,
                   loops([(disk(math.sqrt(r * r - z * z)), z) for z in heights(-r, r, random)]))
    for _ in range(60):
        r, length = random.uniform(2, 12), random.uniform(3, 30)
        yield ("cylinders that lie across", math.pi * r * r * length,
               loops([(numpy.array([(-1, 0), (1, 0), (1, 1), (-1, 1)]) * (math.sqrt(r * r - z * z), length), z)
                      for z in heights(-r, r, random)]))
    for _ in range(50):
        r, height = random.uniform(2, 12), random.uniform(3, 30)
        yield "columns", math.pi * r * r * height, loops([(disk(r), z) for z in heights(0, height, random)])
        yield ("cones", math.pi * r * r * height / 3,
               loops([(disk(r * (1 - z / height)), z) for z in heights(0, height, random)]))


def phantoms():
    folder = os.path.join(SHARED, "rtstruct", "phantoms")
    for file in sorted(os.listdir(folder)):
        reader = simple.DICOMRTStructureSetReader(FileName=os.path.join(folder, file))
        yield "phantoms", PHANTOM[file.split("_")[0].replace("Rt", "")], reader


def rows(wanted):
    for source in (made_up(), phantoms(), cases([])):
        for name, truth, contours in source:
            if source.__name__ == "cases":
                name, truth, contours = f"meshes ({name})", volume(contours), truth
            if not wanted or any(word in name for word in wanted):
                yield name, truth, contours


def measure(truth, contours):
    made = simple.SurfaceCertificate(Input=simple.PolyhedralSurface(Input=contours), Contours=contours)
    data = output(made)
    if not data.IsA("vtkPolyData"):  # a structure set of one region
        leaf = data.NewIterator()
        leaf.InitTraversal()
        while not leaf.GetCurrentDataObject().GetNumberOfCells():
            leaf.GoToNextItem()
        data = leaf.GetCurrentDataObject()
    return [100 * (data.GetFieldData().GetArray(name).GetValue(0) / truth - 1)
            for name in ("VolumeByContours", "LowestVolume", "HighestVolume", "Volume")]


def worst(errors):
    return f"{errors[numpy.abs(errors).argmax()]:+.2f}"


def main():
    parser = argparse.ArgumentParser(prog="./run bench volumes")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--markdown", metavar="FILE")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if not os.path.isdir(SHARED):
        print(f"SKIPPED: {SHARED} is not there")
        return 77
    found = collections.defaultdict(list)
    for name, truth, contours in rows(options.names):
        found[name].append(measure(truth, contours))
    lines = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
    missed = 0
    for name, figures in found.items():
        estimate, lowest, highest, polyhedral = numpy.array(figures).T
        within = int(((lowest <= 1e-9) & (highest >= -1e-9)).sum())
        missed += len(figures) - within
        lines.append(f"| {name} | {len(figures)} | {within} | {numpy.abs(estimate).mean():.2f} | {worst(estimate)} | "
                     f"{numpy.abs(polyhedral).mean():.2f} | {worst(polyhedral)} | {(highest - lowest).mean():.2f} |")
    print("\n".join(lines))
    print(f"The truth is outside the bounds of {missed} of {sum(map(len, found.values()))}.")
    if options.markdown:
        with open(options.markdown, "w", encoding="utf-8") as stream:
            stream.write(PREFACE + "\n".join(lines) + "\n")
    return 1 if options.check and missed else 0


sys.exit(main())
