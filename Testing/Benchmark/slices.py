# SPDX-License-Identifier: GPL-3.0-or-later
"""How near is each method to slices that it was not shown? Three of four are left out, and laid beside the surface's sections.

    ./run bench slices [NAME ...] [--half tuned|reported|both] [--methods psm,fair,ism] [--set METHOD:PROPERTY=VALUE ...]
                       [--seconds N] [--markdown FILE] [--json FILE] [--check]

NAME is a part of `file ROI`. Files: the structure sets of the shared test data (ibsi/ and rtstruct/). Of every region of nine levels or more every
fourth level is kept, the first one too; those between two kept ones are asked for. Rival: linear shape-based interpolation (Raya and Udupa 1990,
Herman et al. 1992): signed distances to the two kept sections, interpolated by height on a grid of 128 squares along the longer side, and the curve of
value 0. Figures of a plane are taken where the drawn contours and the sections of all methods are there; where one is missing, `missed`
counts it:

- distance: the mean distance to agreement in the units of the file: of points spread evenly along the drawn contours from the section, and of
  those along the section from the drawn contours, half of it from either way;
- Dice: twice the area that both have by the sum of their areas, by 256 rows.

A row a region: the mean of its planes. `ratio` is a method's distance by the interpolation's: of all regions the ratio of the means over
regions (each region counts the same, in millimetres), and the median of the regions' ratios. With --check the exit code says whether the best of
the methods is at most 0.7 of the interpolation by the ratio of means.
"""
import argparse
import glob
import json
import os
import re
import signal
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "truth"))
import numpy
from truedata import SHARED, closed_polylines, corners_of, output, producer, simple, value_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter

KEPT = 4  # one level of so many
FEWEST_LEVELS = 9
SQUARES, ROWS, SAMPLES = 128, 256, 400
ASKED = 0.7
NODES = {"psm": "PolyhedralSurface", "fair": "FairSurface", "ism": "ImplicitSurface"}
PREFACE = """# Beside slices that were left out

Made by `./run bench slices --half both --markdown Data/SLICES.md`, whose docstring, in `Testing/Benchmark/slices.py`, says what rows and columns
are. Three slices of four were left out of every region and compared with the sections of what each method made of the fourth. Nothing was
tuned on half B (patients of even numbers and other files).

"""


def half_of(path):
    number = re.search(r"STS_(\d+)", path)
    return "A" if number and int(number.group(1)) % 2 else "B"


def frame_of(normal):
    """Two directions in the plane, as rows."""
    first = numpy.cross(normal, numpy.eye(3)[numpy.argmin(numpy.abs(normal))])
    first /= numpy.linalg.norm(first)
    return numpy.array([first, numpy.cross(normal, first)])


class Region:
    """Clean contours of parallel planes: loops, a level each, and heights of the levels along the normal."""

    def __init__(self, contours):
        field = contours.GetFieldData()
        self.data = contours
        self.normal = vtk_to_numpy(field.GetArray("LevelNormal")).reshape(-1, 3)[0]
        self.heights = vtk_to_numpy(field.GetArray("LevelOffset")).astype(float)
        self.plane = frame_of(self.normal)
        points = vtk_to_numpy(contours.GetPoints().GetData()).astype(float)
        lines = contours.GetLines()
        corners, starts = vtk_to_numpy(lines.GetConnectivityArray()), vtk_to_numpy(lines.GetOffsetsArray())
        self.loops = [points[corners[a:b]] for a, b in zip(starts, starts[1:])]
        self.levels = vtk_to_numpy(contours.GetCellData().GetArray("Level"))

    def segments(self, level):
        loops = [loop @ self.plane.T for loop, of in zip(self.loops, self.levels) if of == level]
        return numpy.concatenate([numpy.stack((loop[:-1], loop[1:]), 1) for loop in loops])

    def of_levels(self, kept):
        """The contours of some levels, as a proxy."""
        return producer(closed_polylines([loop[:-1] for loop, level in zip(self.loops, self.levels) if level in kept]))


def regions(path):
    """(name, Region) of a structure set, those of parallel planes."""
    reader = simple.DICOMRTStructureSetReader(FileName=path)
    output(reader)
    made = output(simple.ContourHierarchy(Input=reader, ParallelPlanesOnly=1))
    for block in leaves(made):
        if block.GetNumberOfCells() and block.GetFieldData().GetArray("LevelOffset") is not None:
            name = block.GetFieldData().GetAbstractArray("ROIName")
            yield (name.GetValue(0) if name else "?"), Region(block)


def leaves(data):
    if isinstance(data, vtkDataSet):
        return [data]
    iterator = data.NewIterator()
    found = []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return [block for block in found if isinstance(block, vtkPolyData)]


def section(surface, normal, plane, height):
    """Segments of a triangle mesh in a plane, shape (n, 2, 2); corners on the plane count as above it."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = corners_of(surface)
    above = points @ normal - height
    signs = above[triangles] >= 0
    cut = triangles[(signs.sum(1) % 3) != 0]
    pairs = numpy.empty((len(cut), 2, 3))
    filled = numpy.zeros(len(cut), dtype=int)
    for a, b in ((0, 1), (1, 2), (2, 0)):
        at = numpy.nonzero((above[cut[:, a]] >= 0) != (above[cut[:, b]] >= 0))[0]
        one, other = cut[at, a], cut[at, b]
        share = (above[one] / (above[one] - above[other]))[:, None]
        pairs[at, filled[at]] = points[one] + share * (points[other] - points[one])
        filled[at] += 1
    return pairs @ plane.T


def distances(points, segments):
    """Of points from the nearest of the segments."""
    start, way = segments[:, 0], segments[:, 1] - segments[:, 0]
    square = numpy.maximum((way ** 2).sum(1), 1e-300)
    found = numpy.empty(len(points))
    step = max(1, 4_000_000 // len(segments))
    for i in range(0, len(points), step):
        apart = points[i:i + step, None] - start
        share = numpy.clip((apart * way).sum(2) / square, 0, 1)
        found[i:i + step] = numpy.sqrt((((apart - share[:, :, None] * way) ** 2).sum(2)).min(1))
    return found


def evenly(segments):
    lengths = numpy.linalg.norm(segments[:, 1] - segments[:, 0], axis=1)
    reach = numpy.cumsum(lengths)
    wanted = (numpy.arange(SAMPLES) + 0.5) * reach[-1] / SAMPLES
    chosen = numpy.minimum(numpy.searchsorted(reach, wanted), len(segments) - 1)
    share = 1 - (reach[chosen] - wanted) / numpy.maximum(lengths[chosen], 1e-300)
    return segments[chosen, 0] + numpy.clip(share, 0, 1)[:, None] * (segments[chosen, 1] - segments[chosen, 0])


def agreement(one, other):
    return (distances(evenly(one), other).mean() + distances(evenly(other), one).mean()) / 2


def crossings(segments, y):
    """Where a horizontal line crosses, by x; and what is inside between the first and the second, third and fourth ..."""
    low, high = segments[:, :, 1].min(1), segments[:, :, 1].max(1)
    hit = segments[(low <= y) & (high > y)]
    share = (y - hit[:, 0, 1]) / (hit[:, 1, 1] - hit[:, 0, 1])
    return numpy.sort(hit[:, 0, 0] + share * (hit[:, 1, 0] - hit[:, 0, 0]))


def dice(one, other):
    low = min(one[:, :, 1].min(), other[:, :, 1].min())
    high = max(one[:, :, 1].max(), other[:, :, 1].max())
    both = total = 0.0
    for row in range(ROWS):
        a, b = (crossings(s, low + (row + 0.5) * (high - low) / ROWS) for s in (one, other))
        a, b = a[:len(a) // 2 * 2], b[:len(b) // 2 * 2]
        total += (a[1::2] - a[::2]).sum() + (b[1::2] - b[::2]).sum()
        cuts = numpy.sort(numpy.concatenate((a, b)))
        middles = (cuts[1:] + cuts[:-1]) / 2
        inside = (numpy.searchsorted(a, middles) % 2 == 1) & (numpy.searchsorted(b, middles) % 2 == 1)
        both += numpy.diff(cuts)[inside].sum()
    return 2 * both / total if total else 0.0


def inside(points, segments):
    """By even-odd, along horizontal lines; points by rows of equal y, shape (rows, columns, 2)."""
    made = numpy.empty(points.shape[:2], dtype=bool)
    for row, line in enumerate(points):
        made[row] = numpy.searchsorted(crossings(segments, line[0, 1]), line[:, 0]) % 2 == 1
    return made


class Interpolation:
    """Linear shape-based interpolation between the kept levels of a region."""

    def __init__(self, region, kept):
        self.region, self.fields = region, {}
        points = numpy.concatenate([region.segments(k).reshape(-1, 2) for k in kept])
        low, high = points.min(0), points.max(0)
        size = (high - low).max() / (SQUARES - 8)
        self.origin, self.size = low - 4.37 * size, size
        self.shape = tuple(int(n) for n in numpy.ceil((high - low) / size).astype(int) + 9)
        columns, rows = (self.origin[a] + size * numpy.arange(self.shape[a]) for a in (0, 1))
        self.nodes = numpy.stack(numpy.meshgrid(columns, rows), 2)

    def field(self, level):
        if level not in self.fields:
            segments = self.region.segments(level)
            away = distances(self.nodes.reshape(-1, 2), segments).reshape(self.nodes.shape[:2])
            self.fields[level] = numpy.where(inside(self.nodes, segments), away, -away)
        return self.fields[level]

    def section(self, level, below, above):
        heights = self.region.heights
        share = (heights[level] - heights[below]) / (heights[above] - heights[below])
        image = vtkImageData()
        image.SetDimensions(self.shape[0], self.shape[1], 1)
        image.SetOrigin(*self.origin, 0)
        image.SetSpacing(self.size, self.size, 1)
        values = (1 - share) * self.field(below) + share * self.field(above)
        image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
        tracer = vtkContourFilter()
        tracer.SetInputData(image)
        tracer.SetValue(0, 0)
        tracer.Update()
        made = tracer.GetOutput()
        if not made.GetNumberOfLines():
            return numpy.empty((0, 2, 2))
        ends = vtk_to_numpy(made.GetLines().GetConnectivityArray()).reshape(-1, 2)
        return vtk_to_numpy(made.GetPoints().GetData()).astype(float)[ends][:, :, :2]


def made_by(method, contours, properties):
    return output(getattr(simple, NODES[method])(Input=contours, **properties))


def measure(region, methods, properties):
    """Figures of a region: the interpolation's first."""
    levels = sorted(set(region.levels.tolist()))
    kept = levels[::KEPT]
    surfaces = {m: made_by(m, region.of_levels(set(kept)), properties.get(m, {})) for m in methods}
    linear = Interpolation(region, kept)
    names = ["linear", *methods]
    missed, found = dict.fromkeys(names, 0), {name: [] for name in names}
    planes = 0
    for below, above in zip(kept, kept[1:]):
        for level in levels[levels.index(below) + 1:levels.index(above)]:
            drawn = region.segments(level)
            sections = {"linear": linear.section(level, below, above)}
            for method, surface in surfaces.items():
                sections[method] = section(surface, region.normal, region.plane, region.heights[level])
            planes += 1
            for name in names:
                missed[name] += not len(sections[name])
            if all(len(s) for s in sections.values()):
                for name in names:
                    found[name].append((agreement(drawn, sections[name]), dice(drawn, sections[name])))
    return planes, missed, {name: numpy.mean(rows, 0) for name, rows in found.items() if rows}


class TooLong(Exception):
    pass


def ended(*_):
    raise TooLong


def summary(rows, methods):
    """A line a method over regions: mean distance, ratio of means, median of ratios, mean Dice, planes missed."""
    linear = numpy.array([row["linear"] for row in rows])
    for name in ["linear", *methods]:
        own = numpy.array([row[name] for row in rows])
        yield (name, own[:, 0].mean(), own[:, 0].mean() / linear[:, 0].mean(), float(numpy.median(own[:, 0] / linear[:, 0])), own[:, 1].mean(),
               sum(row["missed"][name] for row in rows))


def tables(rows, methods):
    for half in ("A", "B", "A and B"):
        chosen = [row for row in rows if row["half"] in half]
        if not chosen:
            continue
        yield f"\n## Half {half}: {len(chosen)} regions, {sum(row['planes'] for row in chosen)} planes\n"
        yield "| method | distance | ratio of means | median of ratios | Dice | planes missed |\n|---|---|---|---|---|---|"
        for name, distance, ratio, median, overlap, missed in summary(chosen, methods):
            yield f"| {name} | {distance:.3f} | {ratio:.3f} | {median:.3f} | {overlap:.4f} | {missed} |"
    yield "\n## Regions\n"
    yield "| file | ROI | half | planes | " + " | ".join(f"{name}: distance / Dice" for name in ["linear", *methods]) + " |"
    yield "|---" * (5 + len(methods)) + "|"
    for row in rows:
        yield f"| {row['file']} | {row['ROI']} | {row['half']} | {row['planes']} | " + " | ".join(
            f"{row[name][0]:.3f} / {row[name][1]:.4f}" for name in ["linear", *methods]) + " |"


def main():
    parser = argparse.ArgumentParser(prog="./run bench slices", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--half", choices=("tuned", "reported", "both"), default="both")
    parser.add_argument("--methods", default="psm,fair")
    parser.add_argument("--set", action="append", default=[], metavar="METHOD:PROPERTY=VALUE")
    parser.add_argument("--seconds", type=int, default=300, help="of a region; one that takes longer becomes a sentence")
    parser.add_argument("--markdown", metavar="FILE")
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if not os.path.isdir(SHARED):
        print(f"SKIPPED: slices: {SHARED} is not there; set CONTOUR_SHARED_DATA to the test data.", flush=True)
        return 77
    methods = options.methods.split(",")
    properties = {}
    for text in options.set:
        method, rest = text.split(":", 1)
        name, value = rest.split("=", 1)
        properties.setdefault(method, {})[name] = value_of(value)
    signal.signal(signal.SIGVTALRM, ended)
    rows, sentences = [], []
    wanted = {"tuned": "A", "reported": "B"}.get(options.half, "AB")
    for path in sorted(glob.glob(os.path.join(SHARED, "ibsi", "*.dcm")) + glob.glob(os.path.join(SHARED, "rtstruct", "*.dcm"))):
        file = os.path.basename(path)
        if half_of(path) not in wanted:
            continue
        for name, region in regions(path):
            levels = len(set(region.levels.tolist()))
            if levels < FEWEST_LEVELS or (options.names and not any(n in f"{file} {name}" for n in options.names)):
                continue
            signal.setitimer(signal.ITIMER_VIRTUAL, options.seconds)
            try:
                planes, missed, figures = measure(region, methods, properties)
            except TooLong:
                sentences.append(f"{file} {name}: not within {options.seconds} s")
                print(sentences[-1], flush=True)
                continue
            finally:
                signal.setitimer(signal.ITIMER_VIRTUAL, 0)
            if figures:
                rows.append({"file": file, "ROI": name, "half": half_of(path), "planes": planes, "missed": missed,
                             **{key: tuple(map(float, value)) for key, value in figures.items()}})
                print(file, name, planes, *(f"{key} {value[0]:.3f} {value[1]:.4f}" for key, value in figures.items()), flush=True)
    if not rows:
        print("No region has nine levels.")
        return 1
    text = "\n".join([*tables(rows, methods), *("\n- " + line for line in sentences)])
    print(text)
    if options.markdown:
        with open(options.markdown, "w", encoding="utf-8") as stream:
            stream.write(PREFACE + text.lstrip("\n") + "\n")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as stream:
            json.dump(rows, stream, indent=1)
    best = min(ratio for name, _, ratio, *_ in summary(rows, methods) if name != "linear")
    return 1 if options.check and best > ASKED else 0


sys.exit(main())
