#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours of a real head and of its brain, from the MR volumes of Debian's package mricron-data.

    /usr/bin/python3 Data/derive/derive_head_contours.py [FOLDER]

writes head.cnt and brain.cnt (NUAGES text) into FOLDER, by default the folder above this one. Needs
the Debian packages mricron-data and python3-paraview (or any Python 3 that has vtk and numpy). The
result is the same on every run.

What is done, for each of the two sets (their numbers are in SETS below):
1. The volume (1 mm voxels) is smoothed by a Gaussian, which takes the noise and the steps of the
   brain mask out.
2. It is sampled on horizontal planes, linearly between two slices, and framed with zeros, so that
   contours close where the head touches the border of the volume (ears, nose, back).
3. Marching squares at the threshold: contours that are simple and nested by construction.
4. Contours of less than a stated area are left out, together with what lies in them (speckle of fat,
   vessels and noise that no one would draw).
5. Douglas and Peucker's simplification, then points of the original contour are put back where an
   edge became longer than a stated length.
6. Coordinates in mm of the MNI space, rounded to 0.01 mm. From here on they are integers, and a test
   in integer arithmetic makes sure that no contour crosses or touches itself or another one; where
   simplification brought that about, the contours concerned are simplified less.
7. Outer walls are written clockwise and walls of holes counterclockwise, as the manual of NUAGES asks.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkMarchingSquares, vtkStripper
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from vtkmodules.vtkIOImage import vtkNIFTIImageReader

TEMPLATES = "/usr/share/mricron/templates"
# Voxel (0, 0, 0) in the MNI space, from the sform of both volumes.
ORIGIN = np.array([-90.0, -125.0, -71.0])
UNIT = 0.01  # mm, of the written coordinates

SETS = {
    "head": dict(volume="ch2.nii.gz", sigma=1.2, threshold=25.5, first=-70.5, step=2.75,
                 levels=63, min_area=60.0, tolerance=0.2, longest=5.0),
    "brain": dict(volume="ch2bet.nii.gz", sigma=0.8, threshold=70.5, first=-50.0, step=9.0,
                  levels=15, min_area=15.0, tolerance=0.2, longest=5.0),
}


def read_volume(name, sigma):
    """The smoothed volume as an array indexed [z, y, x]."""
    reader = vtkNIFTIImageReader()
    reader.SetFileName(os.path.join(TEMPLATES, name))
    smooth = vtkImageGaussianSmooth()
    smooth.SetInputConnection(reader.GetOutputPort())
    smooth.SetDimensionality(3)
    smooth.SetStandardDeviation(sigma)
    smooth.SetRadiusFactor(3.0)
    reader.Update()
    # Smooth in floating point: the volume's own type is a byte.
    image = vtkImageData()
    image.CopyStructure(reader.GetOutput())
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(np.float64)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=1))
    smooth.SetInputData(image)
    smooth.Update()
    nx, ny, nz = image.GetDimensions()
    return vtk_to_numpy(smooth.GetOutput().GetPointData().GetScalars()).reshape(nz, ny, nx)


def sample(volume, z):
    """The horizontal plane at height z (mm), framed with zeros."""
    k = z - ORIGIN[2]
    low = min(int(np.floor(k)), volume.shape[0] - 2)
    part = k - low
    return np.pad((1 - part) * volume[low] + part * volume[low + 1], 1)


def trace(plane, threshold):
    """Closed contours of a plane, each an array of points (mm), the first not repeated."""
    image = vtkImageData()
    image.SetDimensions(plane.shape[1], plane.shape[0], 1)
    image.SetOrigin(ORIGIN[0] - 1, ORIGIN[1] - 1, 0)
    image.GetPointData().SetScalars(numpy_to_vtk(plane.ravel(), deep=1))
    squares = vtkMarchingSquares()
    squares.SetInputData(image)
    squares.SetValue(0, threshold)
    strips = vtkStripper()
    strips.SetInputConnection(squares.GetOutputPort())
    strips.SetMaximumLength(1000000)
    strips.JoinContiguousSegmentsOn()
    strips.Update()
    lines = strips.GetOutput()
    points = vtk_to_numpy(lines.GetPoints().GetData())[:, :2].astype(np.float64)
    loops = []
    for cell in range(lines.GetNumberOfCells()):
        ids = lines.GetCell(cell).GetPointIds()
        ids = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        assert ids[0] == ids[-1], "a contour is open"
        loops.append(points[ids[:-1]])
    return loops


def signed_area(loop):
    x, y = loop[:, 0], loop[:, 1]
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def inside(point, loop):
    """Even-odd test of one point, which must not lie on the loop."""
    x, y = point
    ax, ay = loop[:, 0], loop[:, 1]
    bx, by = np.roll(ax, -1), np.roll(ay, -1)
    spans = (ay > y) != (by > y)
    crossing = ax[spans] + (y - ay[spans]) * (bx[spans] - ax[spans]) / (by[spans] - ay[spans])
    return bool(np.count_nonzero(crossing > x) % 2)


def ancestors(loops):
    """For each loop the indices of the loops around it."""
    return [[j for j, outer in enumerate(loops) if j != i and inside(loop[0], outer)]
            for i, loop in enumerate(loops)]


def without_speckle(loops, min_area):
    small = {i for i, loop in enumerate(loops) if abs(signed_area(loop)) < min_area}
    around = ancestors(loops)
    return [loop for i, loop in enumerate(loops) if i not in small and not small & set(around[i])]


def simplify(loop, tolerance, longest):
    """Douglas and Peucker on a closed loop, with no edge longer than `longest` where avoidable."""
    n = len(loop)
    # Two points that stay for certain: the first in lexicographic order and the farthest from it.
    start = int(np.lexsort((loop[:, 1], loop[:, 0]))[0])
    loop = np.roll(loop, -start, axis=0)
    far = int(np.argmax(np.sum((loop - loop[0]) ** 2, axis=1)))
    ring = np.vstack([loop, loop[:1]])
    keep = np.zeros(n + 1, bool)
    keep[[0, far, n]] = True
    stack = [(0, far), (far, n)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        chord = ring[b] - ring[a]
        length = float(np.hypot(*chord))
        away = ring[a + 1:b] - ring[a]
        distance = np.abs(chord[0] * away[:, 1] - chord[1] * away[:, 0]) / length
        middle = a + 1 + int(np.argmax(distance))
        if distance.max() <= tolerance:
            if length <= longest:
                continue
            middle = (a + b) // 2
        keep[middle] = True
        stack += [(a, middle), (middle, b)]
    return ring[:-1][keep[:-1]]


def rounded(loop):
    """Integer coordinates in UNIT, consecutive equal points merged."""
    grid = np.round(loop / UNIT).astype(np.int64)
    return grid[np.any(grid != np.roll(grid, 1, axis=0), axis=1)]


def offenders(loops):
    """Loops of integers that touch or cross themselves or another loop."""
    a = np.vstack(loops)
    b = np.vstack([np.roll(loop, -1, axis=0) for loop in loops])
    owner = np.repeat(np.arange(len(loops)), [len(loop) for loop in loops])
    place = np.concatenate([np.arange(len(loop)) for loop in loops])
    size = np.array([len(loop) for loop in loops])[owner]

    def side(p, q, r):
        cross = (q[:, None, 0] - p[:, None, 0]) * (r[None, :, 1] - p[:, None, 1]) - (
            q[:, None, 1] - p[:, None, 1]) * (r[None, :, 0] - p[:, None, 0])
        return np.sign(cross)

    low, high = np.minimum(a, b), np.maximum(a, b)
    boxes = np.all((low[:, None] <= high[None]) & (low[None] <= high[:, None]), axis=2)
    straddle = side(a, b, a) * side(a, b, b) <= 0
    hit = boxes & straddle & straddle.T
    step = (place[None, :] - place[:, None]) % size[:, None]
    same = owner[None, :] == owner[:, None]
    neighbours = same & ((step <= 1) | (step == size[:, None] - 1))
    bad = set(owner[np.any(hit & ~neighbours, axis=1)].tolist())
    # Neighbouring edges may share their common point only: no turn back on itself.
    for i, loop in enumerate(loops):
        back, ahead = loop - np.roll(loop, 1, axis=0), np.roll(loop, -1, axis=0) - loop
        cross = back[:, 0] * ahead[:, 1] - back[:, 1] * ahead[:, 0]
        if len(loop) < 3 or np.any((cross == 0) & (np.sum(back * ahead, axis=1) < 0)):
            bad.add(i)
    return bad


def clean_level(loops, tolerance, longest):
    """Simplified loops of integers, none of which touches itself or another."""
    tolerances = [tolerance] * len(loops)
    while True:
        result = [rounded(simplify(loop, t, longest)) for loop, t in zip(loops, tolerances)]
        bad = offenders(result) if result else set()
        if not bad:
            return result
        assert min(tolerances) > 1e-3, "contours touch at the resolution of the file"
        for i in bad:
            tolerances[i] /= 2


def derive(volume, sigma, threshold, first, step, levels, min_area, tolerance, longest):
    """[(z, [loops of integers, oriented as NUAGES wants])], from bottom to top."""
    field = read_volume(volume, sigma)
    result = []
    for level in range(levels):
        z = first + step * level
        loops = without_speckle(trace(sample(field, z), threshold), min_area)
        loops = clean_level(loops, tolerance, longest)
        depths = [len(around) for around in ancestors(loops)]
        oriented = [loop if (signed_area(loop) < 0) == (depth % 2 == 0) else loop[::-1]
                    for loop, depth in zip(loops, depths)]
        result.append((z, sorted(oriented, key=lambda loop: (-abs(signed_area(loop)), loop.tolist()))))
    return result


def write_nuages(path, sections):
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("S %d\n" % len(sections))
        for z, loops in sections:
            out.write("v %d z %.2f\n" % (sum(len(loop) for loop in loops), z))
            for loop in loops:
                out.write("{\n")
                out.writelines("%.2f %.2f\n" % (x * UNIT, y * UNIT) for x, y in loop)
                out.write("}\n")


def main(folder):
    for name, settings in SETS.items():
        sections = derive(**settings)
        write_nuages(os.path.join(folder, name + ".cnt"), sections)
        loops = [loop for _, level in sections for loop in level]
        print("%s: %d levels, %d contours, %d points, most in a level %d, empty levels %d" % (
            name, len(sections), len(loops), sum(map(len, loops)),
            max(len(level) for _, level in sections), sum(not level for _, level in sections)))


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(here))
