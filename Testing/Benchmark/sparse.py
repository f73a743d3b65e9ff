# SPDX-License-Identifier: GPL-3.0-or-later
"""A few drawn contours, and how near the slices that were not drawn come out.

    ./run bench sparse [--json FILE] [--markdown FILE] [--set PROPERTY=VALUE ...] [NAME ...]

Heart and BrainStem with every 3rd and every 5th slice drawn, kitten and femur with contours on four planes of three
directions: two parallel ones, and one across each other axis, placed where it passes through most parts of the object. Each is reconstructed by Implicit Surface with its defaults, and its contours on the slices that were left
out (those between the first and the last drawn one, as nothing is known beyond) are compared with the true ones. Beside it:

  PSM   Polyhedral Surface, cut at the same planes: linear interpolation between drawn slices. It takes parallel contours
        only: of the four contours those on the two parallel planes.
  ITK   morphological contour interpolation (Zukic et al. 2016), 256 voxels along the largest extent of the contours.

"4 parallel" gives each method four planes again, now all parallel, from the first drawn slice to the last.

Regions are compared exactly (Dice: of all slices together), borders on samples a thousandth of the extent apart (Hausdorff, in
the units of the data). ITK and shapely come from PyPI into a virtual environment in the build folder. Reads the shared test data
and says so where it is absent.
"""
import argparse
import itertools
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "truth"))
from truedata import SHARED, closed_polylines, output, producer, read_mesh, simple
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter

VOXELS = 256  # along the largest extent in the planes, for slices
CUBE = 160  # along the longest extent, for three directions
LEFT_OUT = 16  # slices to compare, of four contours
AXES = "xyz"


def loops_of(data):
    """The closed polylines of a data set, each a list of points, the first not repeated."""
    loops = []
    for c in range(data.GetNumberOfCells()):
        points = data.GetCell(c).GetPoints()
        loop = [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]
        loops.append(loop[:-1] if loop[0] == loop[-1] else loop)
    return loops


def clean(data):
    return output(simple.ContourHierarchy(Input=producer(data)))


def cut(surface, axis, offset):
    """Closed loops of a surface on the plane where the axis' coordinate is the offset."""
    plane = vtkPlane()
    plane.SetNormal([float(a == axis) for a in range(3)])
    plane.SetOrigin([offset if a == axis else 0.0 for a in range(3)])
    cutter = vtkCutter()
    cutter.SetInputData(surface)
    cutter.SetCutFunction(plane)
    cutter.Update()
    if cutter.GetOutput().GetNumberOfCells() == 0:
        return []
    return loops_of(clean(cutter.GetOutput()))


def by_offset(loops, axis, offsets):
    """Loops sorted by the plane they lie on."""
    planes = {offset: [] for offset in offsets}
    for loop in loops:
        nearest = min(offsets, key=lambda offset: abs(offset - loop[0][axis]))
        planes[nearest].append(loop)
    return [planes[offset] for offset in offsets]


class Case:
    """Drawn contours: (axis, offset, loops) each; and the left-out ones across one axis: (offset, loops)."""

    def __init__(self, name, axis, drawn, left_out, grid, parallel=None):
        self.name, self.axis, self.drawn, self.left_out = name, axis, drawn, left_out
        self.grid = grid  # voxels whose centres lie on all these planes
        self.parallel = parallel  # as many contours drawn on parallel planes, where drawn ones are not

    def offsets(self):
        return [offset for offset, _ in self.left_out]


def slice_grid(bounds, offsets):
    """A voxel a slice, and a rim in the slices."""
    gap = (offsets[-1] - offsets[0]) / (len(offsets) - 1)
    fine = max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / VOXELS
    size = [int((bounds[2 * a + 1] - bounds[2 * a]) / fine) + 5 for a in (0, 1)]
    return {"origin": [bounds[0] - 2 * fine, bounds[2] - 2 * fine, offsets[0]], "spacing": [fine, fine, gap],
            "size": size + [len(offsets)]}


def structure_case(name, file, roi, every):
    reader = simple.DICOMRTStructureSetReader(FileName=os.path.join(SHARED, "rtstruct", file))
    reader.UpdatePipelineInformation()
    reader.ROIs = [roi]
    hierarchy = clean(output(reader).GetPartition(0, 0))
    heights = hierarchy.GetFieldData().GetArray("LevelOffset")
    offsets = [heights.GetTuple1(i) for i in range(heights.GetNumberOfTuples())]
    planes = by_offset(loops_of(hierarchy), 2, offsets)
    last = (len(offsets) - 1) // every * every
    drawn = [(2, offsets[i], planes[i]) for i in range(0, last + 1, every)]
    left_out = [(offsets[i], planes[i]) for i in range(last) if i % every]
    return Case(name, 2, drawn, left_out, slice_grid(hierarchy.GetBounds(), offsets))


def telling_offsets(left_out, axis, candidates):
    """An offset for each of the other two axes: planes that pass through as many parts of the left-out slices as any do.

    One who draws sees all of the image and draws where there is something to see. A plane passes through a part where it
    meets the middle half of its box; of equally good planes those nearest to the middle of the candidates count.
    """
    a, b = sorted(candidates)
    boxes = [[(min(p[k] for p in loop), max(p[k] for p in loop)) for k in (a, b)]
             for _, loops in left_out for loop in loops]

    def through(offset, box):
        return abs(offset - 0.5 * (box[0] + box[1])) <= 0.25 * (box[1] - box[0])

    def merit(pair):
        met = sum(any(through(offset, box) for offset, box in zip(pair, both)) for both in boxes)
        return met, -sum(abs(offset - candidates[k][len(candidates[k]) // 2]) for offset, k in zip(pair, (a, b)))

    best = max(itertools.product(candidates[a], candidates[b]), key=merit)
    return {a: best[0], b: best[1]}


def mesh_case(name, file):
    """Two planes across the longest axis, a fifth of it from its ends, and a telling one across each of the others."""
    mesh = read_mesh(os.path.join(SHARED, "mesh", file))
    bounds = mesh.GetBounds()
    low, extent = bounds[0::2], [bounds[2 * a + 1] - bounds[2 * a] for a in range(3)]
    axis = max(range(3), key=lambda a: extent[a])
    step = extent[axis] / CUBE

    def at(a, part):
        """The plane through the centres of the voxels at a part of the extent."""
        return low[a] + step * (0.5 + round(part * extent[a] / step))

    def planes(count):
        return [at(axis, 0.2 + 0.6 * k / (count - 1)) for k in range(count)]

    parallel = [(axis, offset, cut(mesh, axis, offset)) for offset in planes(4)]
    taken = {offset for _, offset, _ in parallel}
    left_out = [(offset, cut(mesh, axis, offset)) for offset in planes(LEFT_OUT + 2) if offset not in taken]
    candidates = {a: [at(a, k / 16) for k in range(1, 16)] for a in range(3) if a != axis}
    drawn = [parallel[0], parallel[-1]]
    drawn += [(a, offset, cut(mesh, a, offset))
              for a, offset in telling_offsets(left_out, axis, candidates).items()]
    grid = {"origin": [low[a] - 1.5 * step for a in range(3)], "spacing": [step] * 3,
            "size": [int(extent[a] / step) + 5 for a in range(3)]}
    return Case(name, axis, drawn, left_out, grid, parallel)


CASES = {
    "Heart, every 3rd": lambda name: structure_case(name, "dicompyler_rtss.dcm", "Heart", 3),
    "Heart, every 5th": lambda name: structure_case(name, "dicompyler_rtss.dcm", "Heart", 5),
    "BrainStem, every 3rd": lambda name: structure_case(name, "dicomexport_rs.dcm", "BrainStem", 3),
    "BrainStem, every 5th": lambda name: structure_case(name, "dicomexport_rs.dcm", "BrainStem", 5),
    "kitten, 4 contours": lambda name: mesh_case(name, "kitten.obj"),
    "femur, 4 contours": lambda name: mesh_case(name, "femur.off"),
}


def with_ism(case, drawn, properties):
    """The implicit method's own contours on the left-out planes."""
    contours = producer(closed_polylines([loop for _, _, loops in drawn for loop in loops]))
    constraints = simple.ImplicitConstraints(Input=contours, **properties)
    model = simple.ImplicitFunction(Input=constraints)
    planes = producer(closed_polylines([loop for _, loops in case.left_out for loop in loops]))
    slices = output(simple.ImplicitContours(Input=model, Planes=planes))
    return by_offset(loops_of(slices), case.axis, case.offsets())


def with_psm(case, drawn):
    parallel = [loop for axis, _, loops in drawn if axis == case.axis for loop in loops]
    surface = output(simple.PolyhedralSurface(Input=producer(closed_polylines(parallel))))
    return [cut(surface, case.axis, offset) for offset in case.offsets()]


def reconstruct(case, properties):
    """The case as compare.py reads it, with the contours of each of our methods on the left-out planes."""
    def flat(loops):
        return [[[p[a] for a in range(3) if a != case.axis] for p in loop] for loop in loops]

    def drawing(drawn):
        kept = {axis: [a for a in range(3) if a != axis] for axis in range(3)}
        return [{"axis": axis, "offset": offset, "loops": [[[p[a] for a in kept[axis]] for p in loop] for loop in loops]}
                for axis, offset, loops in drawn]

    found = {"ISM": with_ism(case, case.drawn, properties), "PSM": with_psm(case, case.drawn)}
    itk = {"ITK": drawing(case.drawn)}
    if case.parallel:
        found["ISM, 4 parallel"] = with_ism(case, case.parallel, properties)
        found["PSM, 4 parallel"] = with_psm(case, case.parallel)
        itk["ITK, 4 parallel"] = drawing(case.parallel)
    else:
        found["ISM, ReachAcrossSteps"] = with_ism(case, case.drawn, dict(properties, ReachAcrossSteps=1))
    planes = [{"offset": offset, "truth": flat(loops), "found": {m: flat(found[m][i]) for m in found}}
              for i, (offset, loops) in enumerate(case.left_out)]
    return {"name": case.name, "axis": case.axis, "grid": case.grid, "planes": planes, "itk": itk}


def environment():
    """The python of a virtual environment that has what compare.py needs; the bench ends where there can be none."""
    folder = os.path.join(os.path.dirname(os.environ["CONTOUR_BIN_DIR"]), "Testing", "sparse-environment")
    python, stamp = os.path.join(folder, "bin", "python"), os.path.join(folder, "complete")
    if os.path.exists(stamp):
        return python
    shutil.rmtree(folder, ignore_errors=True)
    for step in ([shutil.which("python3") or "python3", "-m", "venv", folder],
                 [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check",
                  "itk-morphologicalcontourinterpolation", "shapely", "contourpy"]):
        subprocess.run(step, env=own_variables(), check=True)
    open(stamp, "w").close()
    return python


def own_variables():
    """The environment without what leads Python to ParaView's modules."""
    return {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LD_", "VTK"))}


def compared(cases):
    with tempfile.TemporaryDirectory() as folder:
        source, target = os.path.join(folder, "cases.json"), os.path.join(folder, "figures.json")
        with open(source, "w") as file:
            json.dump(cases, file)
        subprocess.run([environment(), os.path.join(HERE, "sparse", "compare.py"), source, target],
                       env=own_variables(), check=True)
        with open(target) as file:
            return json.load(file)


def number(value, digits):
    return "-" if value is None else f"{value:.{digits}g}"


def markdown(results):
    lines = ["| case | method | Dice | worst slice | Hausdorff mean | largest | slices with nothing |",
             "|---|---|---|---|---|---|---|"]
    for result in results:
        for method, f in result["figures"].items():
            lines.append(f"| {result['name']} | {method} | {f['dice']:.4f} | {f['worst_dice']:.4f} | "
                         f"{number(f['hausdorff'], 3)} | {number(f['largest_hausdorff'], 3)} | {f['empty']} |")
    return "\n".join(lines) + "\n"


def arguments():
    parser = argparse.ArgumentParser(prog="run bench sparse", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="parts of the cases' names; all of them without")
    parser.add_argument("--json", help="file to write the figures to")
    parser.add_argument("--markdown", help="file to write the table to")
    parser.add_argument("--set", action="append", default=[], metavar="PROPERTY=VALUE", help="of Implicit Constraints")
    return parser.parse_args()


def value_of(setting):
    """The name and the value, a number where it is one."""
    name, _, word = setting.partition("=")
    for number in (int, float):
        try:
            return name, number(word)
        except ValueError:
            pass
    return name, word


def main():
    given = arguments()
    if not os.path.isdir(SHARED):
        print(f"SKIPPED: {SHARED} is not there")
        sys.exit(77)
    properties = dict(value_of(setting) for setting in given.set)
    names = [name for name in CASES if not given.names or any(part in name for part in given.names)]
    cases = [reconstruct(CASES[name](name), properties) for name in names]
    results = [{"name": case["name"], "slices": len(case["planes"]), "figures": figures}
               for case, figures in zip(cases, compared(cases))]
    if given.json:
        with open(given.json, "w") as file:
            json.dump(results, file, indent=1)
    if given.markdown:
        with open(given.markdown, "w") as file:
            file.write(markdown(results))
    print(markdown(results))


main()
