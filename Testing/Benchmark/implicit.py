# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Surface against the truth, its defaults beside the thesis's own settings.

    ./run bench implicit [name ...]

Phantoms of 1, 2 and 3 mm slices, cells of 0.5 mm: error of the volume. Sets with a reference surface (femur z: 24 cuts along z):
error of the volume, mean and largest distance as in `./run bench truth`. Of all, Euler numbers, crossing triangle pairs and the
least angle. "refined" is what Implicit Surface does by default. Reads the shared test data and says so where it is absent.
"""
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "truth"))
from truedata import SHARED, cases, certificate, distance, output, producer, simple, volume

SETTINGS = (("thesis", dict(Values="Unit", Normals="In Plane")),
            ("in plane, distance", dict(Values="Distance", Normals="In Plane")),
            ("refined", dict()))
PHANTOMS = {"Sphere": 7238.23, "RtCylinder": 10857.34, "RtCone": 3619.11}
CELL = 0.5  # mm, of phantoms
REFERENCES = ("eight_15", "hand_ok", "balloondog", "femur z")


def first_block(collection):
    """The block with the most contours: the phantom, not its point of interest."""
    best = None
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        block = collection.GetPartition(i, 0)
        if block and (best is None or block.GetNumberOfCells() > best.GetNumberOfCells()):
            best = block
    return best


def surface(contours, properties):
    start = time.perf_counter()
    made = output(simple.ImplicitSurface(Input=contours, **properties))
    return made, time.perf_counter() - start


def figures(data):
    """Euler number, crossing triangle pairs and least angle in degrees."""
    total = certificate(data)
    angle = data.GetFieldData().GetArray("SmallestAngle")
    return total["Euler"], total["CrossingPairs"], angle.GetTuple1(0) if angle else float("nan")


def bench_phantoms(wanted):
    for shape, truth in PHANTOMS.items():
        for slices in (10, 20, 30):
            name = f"{shape}_{slices}_0"
            if wanted and name not in wanted:
                continue
            reader = simple.DICOMRTStructureSetReader(FileName=os.path.join(SHARED, "rtstruct", "phantoms", name + ".dcm"))
            contours = producer(first_block(output(reader)))
            for label, properties in SETTINGS:
                made, seconds = surface(contours, dict(properties, CellSize=CELL))
                error = 100 * (volume(made) / truth - 1)
                number, crossing, angle = figures(made)
                print(f"{name:18s} {label:20s} volume {error:+8.3f} % Euler {number:3d} crossing {crossing} "
                      f"angle {angle:5.2f}   {seconds:6.1f} s", flush=True)


def bench_references(wanted):
    names = [name for name in REFERENCES if not wanted or name in wanted]
    for name, contours, truth in cases(names) if names else ():
        print(f"{name:18s} {'truth':20s} Euler {figures(truth)[0]:3d}")
        for label, properties in SETTINGS:
            made, seconds = surface(contours, properties)
            mean, largest, _ = distance(made, truth)
            number, crossing, angle = figures(made)
            error = 100 * (volume(made) / volume(truth) - 1)
            print(f"{name:18s} {label:20s} mean {mean:.5f} largest {largest:.4f} volume {error:+7.3f} % Euler {number:3d} "
                  f"crossing {crossing} angle {angle:5.2f}   {seconds:6.1f} s", flush=True)


if not os.path.isdir(SHARED):
    print(f"SKIPPED: {SHARED} is not there")
    sys.exit(77)
bench_phantoms(sys.argv[1:])
bench_references(sys.argv[1:])
