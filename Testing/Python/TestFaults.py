# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs that once came out wrong, through the command line: the right value or the sentence, a row an input.

The inputs and their values are those of faults/README.md of the shared data. A row: a name of the test's own, the input, the
arguments, {region: (volume, tolerance)}, words that must be said, and files that must be there (None: as many as volumes).
"""
import contextlib
import io
import os
import shutil
import sys

import contourtesting as ct

sys.path.insert(0, os.path.join(ct.SOURCE, "Plugin", "commandline"))
import contourcli as cli
import contouroptions
import contourworker

FOLDER = ct.output("faults")
FLAT = ["--set", "EndCaps=flat"]
ROWS = [
    # names and files
    ("names_slash", "rt/names_slash.dcm", [], {}, ["Written"], 8),
    ("names_cjk", "rt/names_cjk.dcm", [], {}, ["左肺"], 4),
    ("no_extension", "rt/no_extension/RS.1.2.3", [], {"Heart": (9566.5, 1)}, [], None),
    # nothing that can be kept is lost
    ("open", "rt/open/set.dcm", [], {"HR-CTV": (9566.5, 1)}, ["open contours only, nothing to do", "points only, nothing to do"], None),
    ("malformed_nan", "rt/malformed_nan.dcm", FLAT, {"Good": (13549.89, 1), "Other": (18442.91, 1)}, [], 3),
    ("malformed_trail", "rt/malformed_trail.dcm", FLAT, {"Good": (13549.89, 1), "Other": (18442.91, 1)}, [], 3),
    ("dupnum", "rt/dupnum.dcm", FLAT, {"Heart": (13549.89, 1), "New1": (11385.67, 1)}, [], None),
    ("names_jis", "rt/names_jis.dcm", [], {}, ["左肺", "心臓"], 2),
    # twins
    ("twin_12_points", "rt/twin_12_points.dcm", FLAT, {"organ": (1800, 2)}, ["within rounding"], None),
    ("retraced", "other/retraced.vtp", FLAT, {"retraced": (62.65, 0.8)}, [], None),
    # sections that do not overlap
    ("two_circles_apart", "other/two_circles_apart.vtp", FLAT + ["--set", "ForcedJoins=0,1"],
     {"two_circles_apart": (3.1365, 0.01)}, [], None),
    # a block a slice, as ParaView's readers give them: a pyramid frustum of 48 sides, 5012.204 * 40 / .8 * (1 - .2^3) / 3
    ("slices", "other/slices.vtm", FLAT, {"slices": (82868.5, 1)}, ["slices of one object"], None),
    ("lines3d", "other/lines3d.geojson", FLAT, {"lines3d": (82868.5, 1)}, ["slices of one object"], None),
    ("contours", "other/contours.dxf", FLAT, {"contours": (82868.5, 1)}, ["slices of one object"], None),
]
FAILING = [
    ("truncated", "rt/truncated.dcm", ["--roi", "Heart"], "damaged or truncated"),
]


def run(path, output, arguments):
    """(what was printed, the sentence of a failure or "")"""
    said = io.StringIO()
    failure = ""
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        try:
            contourworker.one(contouroptions.parse([path, output, *arguments]))
        except (cli.CommandError, contouroptions.UsageError) as error:
            failure = str(error)
    return said.getvalue(), failure


def volume_of(path):
    from paraview import simple
    reader = simple.XMLPolyDataReader(FileName=[path])
    certificate = simple.SurfaceCertificate(Input=reader)
    figures = ct.data(certificate).GetFieldData()
    got = figures.GetArray("Volume").GetValue(0), figures.GetArray("Sound").GetValue(0)
    simple.Delete(certificate)
    simple.Delete(reader)
    return got


shutil.rmtree(FOLDER, ignore_errors=True)
for name, source, arguments, volumes, words, count in ROWS:
    path = ct.shared("faults/" + source)
    folder = os.path.join(FOLDER, name)
    os.makedirs(folder)
    said, failure = run(path, os.path.join(folder, "out.vtp"), arguments)
    ct.check(failure == "", f"{name}: {failure}")
    for word in words:
        ct.check(word in said, f"{name} says '{word}': {said}")
    files = sorted(os.listdir(folder))
    expected = count if count is not None else len(volumes)
    ct.check(len(files) == expected, f"{name} writes {expected} files: {files}")
    for region, (volume, tolerance) in volumes.items():
        file = "out.vtp" if len(volumes) == 1 and files == ["out.vtp"] else f"out-{region}.vtp"
        if ct.check(file in files, f"{name} writes {file}"):
            got, sound = volume_of(os.path.join(folder, file))
            ct.check(abs(got - volume) <= tolerance, f"{name}, {region}: {got} instead of {volume}")
            ct.check(sound == 1, f"{name}, {region} is sound")
for name, source, arguments, word in FAILING:
    folder = os.path.join(FOLDER, name)
    os.makedirs(folder)
    _, failure = run(ct.shared("faults/" + source), os.path.join(folder, "out.vtp"), arguments)
    ct.check(word in failure, f"{name} fails with '{word}': {failure}")
    ct.check(not os.listdir(folder), f"{name} leaves no file")

# The journey into a structure set leaves nobody behind either, and replaces nothing unasked.
target = os.path.join(FOLDER, "open.dcm")
said, failure = run(ct.shared("faults/rt/open/set.dcm"), target, ["--method", "ism"])
ct.check(failure == "" and os.path.exists(target) and "open contours only" in said, f"open into .dcm: {failure} {said}")
_, failure = run(ct.shared("faults/rt/open/set.dcm"), target, ["--method", "ism"])
ct.check("--force" in failure, f"an existing structure set is kept: {failure}")

# Coordinates too large for single precision: said for STL, with the figure; PLY holds doubles; an offset mends it.
trench = ct.shared("faults/other/trench_utm.vtp")
said, failure = run(trench, os.path.join(FOLDER, "trench.stl"), [])
ct.check(failure == "" and "moves points by up to 0.25" in said, f"STL at large coordinates: {failure} {said}")
said, failure = run(trench, os.path.join(FOLDER, "trench.ply"), [])
with open(os.path.join(FOLDER, "trench.ply"), "rb") as file:
    ct.check(b"property double x" in file.read(200) and "Note" not in said, f"PLY is in double precision: {said}")
said, failure = run(trench, os.path.join(FOLDER, "near.stl"), ["--offset", "auto"])
ct.check(failure == "" and "less (500123, 5412346, 101)" in said and "moves" not in said, f"with an offset: {said}")
ct.finish()
