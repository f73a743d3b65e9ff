# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the implicit surface have, on every drawn plane, the contours that were drawn there?

    ./run bench planes [--half tuned|reported|both] [--most N] [--seconds N] [--plain] [--check] [--from FILE] [--markdown FILE]
      [FILE ...]

Files are structure sets and contour files, also of the shared test data; without any, those of the shared test data: the patients of ibsi/ and the sets of
rtstruct/. Constants are chosen on the patients of odd numbers and on dicomexport_rs.dcm; `reported`, the default, are the
others. --most leaves out ROIs of more points; an ROI that takes more processor seconds than --seconds (600) becomes a
sentence; --plain measures as if only contours told anything; --from reads the lines that bench_planes has written before. With
--check the exit code says whether every row keeps what is promised: as many contours on every plane as were drawn, at most 2%
of the area drawn on it different, and, of ten planes or more, a volume within 1% of the polyhedral one with HalfSlice ends, or,
as that cuts off what is round between planes, one between the planes within 1% of what the drawn areas make smoothly. A row an
ROI:

- contours: drawn on all planes, and traced there in the implicit function, those above 3 mm2; planes: of how many the number
  is another one;
- difference: the symmetric difference of areas on a plane, in per cent of the area drawn there: the largest, with the plane's
  place and area, and that of all planes together; traced at the node's own cell size;
- volume: of the implicit surface with its own ends (EndsBeyond .4), and in per cent beside that of Polyhedral Surface with
  HalfSlice ends: with these ends, with EndsBeyond .5 as half a slice is, and of the part between the first and the last plane;
- between planes: that part in per cent beside what the drawn areas make there, where they change smoothly from plane to plane
  (a parabola through three, Simpson's rule where these are all); and what the polyhedral surface has beside that;
- processor seconds of the whole surface on one thread and without clean-up, and those of them that following the planes took;
- what Report says of planes that still differ.
"""
import argparse
import glob
import os
import re
import subprocess
import sys

SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(os.environ.get("CONTOUR_SOURCE_DIR", "."), "..", "shared", "data"))
# What is promised (per cent), and of how many planes volumes are.
LARGEST_DIFFERENCE = 2
LARGEST_VOLUME_ERROR = 1
FEW_PLANES = 10
HEAD = ("file", "ROI", "half", "points", "planes", "contours drawn", "traced", "planes of another number", "largest difference %",
        "where: plane (area)", "of all planes %", "volume", "beside psm %", "ends .5: beside psm %", "between planes: beside psm %",
        "beside smooth %", "psm beside smooth %", "constraints", "seconds", "of these following", "still differs")

PREFACE = """# The implicit surface on the drawn planes

Made by `./run bench planes --half both --markdown FILE`; its docstring, in `Testing/Benchmark/planes.py`, says what the columns are. Contours of
less than 3 mm2 do not count. Processor seconds, one thread.

Constants are chosen on half A. B is not quite unseen: what small contours get was decided after the CT contours of patients 4 and 6 had been looked
at, before the halves were kept apart.

**Which volume is right?** The polyhedral surface runs straight from plane to plane, and so cuts off what is round between them: of the
spheres of 24 mm among the phantoms, sliced every 3 mm, it has 4.5% less than the truth, the implicit one 1.3% less, and the areas
integrated smoothly 0.0%. Of ten planes or more the two methods agree within 1%; of fewer they do not, and *beside smooth* is the fairer figure.
With three slices of a box, all of the difference is the ends: -6.64% with EndsBeyond .4, +.02% with .5.
Two planes tell neither: of markers that are smaller than the distance of their slices each method makes a shape of its own.

"""


def half_of(path):
    """A: constants are chosen on it. B: they are not."""
    number = re.search(r"STS_(\d+)", path)
    return "A" if "dicomexport" in path or (number and int(number.group(1)) % 2 == 1) else "B"


def files(half):
    found = sorted(glob.glob(os.path.join(SHARED, "ibsi", "*.dcm"))) + sorted(glob.glob(os.path.join(SHARED, "rtstruct", "*.dcm")))
    return [path for path in found if half == "both" or half_of(path) == {"tuned": "A", "reported": "B"}[half]]


def beside(figures, one, other):
    return f"{100 * (float(figures[one]) / float(figures[other]) - 1):+.2f}" if float(figures[other]) else ""


def row(names, line):
    """The cells of a line of bench_planes, or None where it holds an error's sentence."""
    cells = line.rstrip("\n").split("\t")
    if len(cells) < len(names):
        return None
    of = dict(zip(names, cells))
    return [of["file"], of["ROI"], half_of(of["file"]), of["points"], of["planes"], of["drawn"], of["traced"], of["other"], of["worst"],
            f"{of['at']} ({of['area']})", of["mean"], of["volume"], beside(of, "volume", "polyhedral"),
            beside(of, "half slices", "polyhedral"), beside(of, "within", "polyhedral within"), beside(of, "within", "smooth"),
            beside(of, "polyhedral within", "smooth"), of["constraints"], of["seconds"], of["following"],
            "yes" if "still differs" in of["report"] else ""]


def complaints(cells):
    """What a row does not keep of its promises."""
    of = dict(zip(HEAD, cells))
    said = []
    if of["planes of another number"] != "0":
        said.append(f"{of['planes of another number']} planes have another number of contours than was drawn")
    if float(of["largest difference %"]) > LARGEST_DIFFERENCE:
        said.append(f"{of['largest difference %']}% of what was drawn at {of['where: plane (area)']} differ")
    volumes = [float(of[what]) for what in ("beside psm %", "beside smooth %") if of[what]]
    if int(of["planes"]) >= FEW_PLANES and volumes and min(map(abs, volumes)) > LARGEST_VOLUME_ERROR:
        said.append(f"the volume is {volumes[0]:+}% beside the polyhedral one, {volumes[-1]:+}% beside the drawn areas")
    return [f"{of['file']} {of['ROI']}: {sentence}" for sentence in said]


def found(path):
    """A path, or one of the shared test data."""
    return path if os.path.exists(path) else os.path.join(SHARED, path)


def measure(options):
    """Lines of bench_planes, the columns' names first."""
    if options.lines:
        with open(options.lines, encoding="utf-8") as stream:
            yield from stream
        return
    folder = os.environ.get("CONTOUR_BIN_DIR") or os.path.join(os.environ["CONTOUR_BINARY_DIR"], "bin")
    program = os.path.join(folder, "bench_planes")
    extra = ["--seconds", str(options.seconds)] + (["--plain"] if options.plain else [])
    extra += ["--most", str(options.most)] if options.most else []
    alone = dict(os.environ, OPENBLAS_NUM_THREADS="1")
    for path in [found(path) for path in options.files] or files(options.half):
        yield from subprocess.run([program, *extra, path], check=True, capture_output=True, text=True, env=alone).stdout.splitlines()


def markdown(rows, sentences):
    head = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
    return "\n".join(head + ["| " + " | ".join(cells) + " |" for cells in rows] + [""] + [f"- {line}" for line in sentences]) + "\n"


def main():
    parser = argparse.ArgumentParser(prog="./run bench planes", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="*")
    parser.add_argument("--half", choices=("tuned", "reported", "both"), default="reported")
    parser.add_argument("--most", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--plain", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--from", dest="lines", metavar="FILE")
    parser.add_argument("--markdown", metavar="FILE")
    options = parser.parse_args()
    if not options.files and not options.lines and not os.path.isdir(SHARED):
        print(f"SKIPPED: planes: {SHARED} is not there; set CONTOUR_SHARED_DATA to the test data.", flush=True)
        sys.exit(77 if options.check else 0)
    names, rows, sentences = [], [], []
    print(" | ".join(HEAD))
    for line in measure(options):
        if line.startswith("file\t"):
            names = line.rstrip("\n").split("\t")
            continue
        cells = row(names, line)
        print(" | ".join(cells) if cells else line.rstrip(), flush=True)
        if cells:
            rows.append(cells)
        else:
            sentences.append(" ".join(line.split("\t")).strip())
    if options.markdown:
        with open(options.markdown, "w", encoding="utf-8") as stream:
            stream.write(PREFACE + markdown(rows, sentences))
    if options.check:
        said = [sentence for cells in rows for sentence in complaints(cells)]
        said += [line for line in sentences if "not within" in line] + ([] if rows else ["There are no rows."])
        print("\n".join(said) or f"{len(rows)} rows keep what is promised.", flush=True)
        sys.exit(1 if said else 0)


main()
