# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the implicit surface have, on every drawn plane, the contours that were drawn there?

    ./run bench planes [--half tuned|reported|both] [--points N] [--plain] [--from FILE] [--markdown FILE] [FILE ...]

Files are structure sets and contour files; without any, those of the shared test data: the patients of ibsi/ and the sets of
rtstruct/. What the method's constants were tuned on are the patients of odd numbers; `reported`, the default, are the others.
--points leaves out ROIs of more points; --plain measures as if only contours told anything; --from reads the lines that
bench_planes has written before. A row an ROI:

- contours: drawn on all planes, and traced there in the implicit function, those above 3 mm2; planes: of how many the number
  is another one;
- difference: the largest symmetric difference of areas on a plane, in per cent of the area drawn there, with the plane's
  place and area, traced at the node's own cell size;
- volume: of the implicit surface, in per cent beside that of Polyhedral Surface with HalfSlice ends;
- constraints, processor seconds of the whole surface without clean-up, and what Report says of the drawn planes.
"""
import argparse
import glob
import os
import re
import subprocess

SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(os.environ.get("CONTOUR_SOURCE_DIR", "."), "..", "shared", "data"))
HEAD = ("file", "ROI", "planes", "contours drawn", "traced", "planes of another number", "largest difference %",
        "where: plane (area)", "volume", "beside psm %", "constraints", "seconds", "still differs")


def patient_is_odd(path):
    number = re.search(r"STS_(\d+)", path)
    return number is not None and int(number.group(1)) % 2 == 1


def files(half):
    found = sorted(glob.glob(os.path.join(SHARED, "ibsi", "*.dcm"))) + sorted(glob.glob(os.path.join(SHARED, "rtstruct", "*.dcm")))
    return [path for path in found if half == "both" or patient_is_odd(path) == (half == "tuned")]


def row(line):
    """The cells of a line of bench_planes, or None where it holds an error's sentence."""
    cells = line.rstrip("\n").split("\t")
    if len(cells) < 12:
        return None
    worst = re.match(r"(\S+) \((.*), (.*)\)", cells[6])
    psm = float(cells[8])
    beside = f"{100 * (float(cells[7]) / psm - 1):+.2f}" if psm else ""
    return cells[:6] + [worst.group(1), f"{worst.group(2)} ({worst.group(3)})", cells[7], beside, cells[10], cells[9],
                        "yes" if "still differs" in cells[11] else ""]


def measure(options):
    if options.lines:
        with open(options.lines, encoding="utf-8") as stream:
            yield from stream
        return
    program = os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_planes")
    extra = (["--plain"] if options.plain else []) + (["--points", str(options.points)] if options.points else [])
    for path in options.files or files(options.half):
        yield from subprocess.run([program, *extra, path], check=True, capture_output=True, text=True).stdout.splitlines()


def main():
    parser = argparse.ArgumentParser(prog="./run bench planes", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="*")
    parser.add_argument("--half", choices=("tuned", "reported", "both"), default="reported")
    parser.add_argument("--points", type=int, default=0)
    parser.add_argument("--plain", action="store_true")
    parser.add_argument("--from", dest="lines", metavar="FILE")
    parser.add_argument("--markdown", metavar="FILE")
    options = parser.parse_args()
    if not options.files and not options.lines and not os.path.isdir(SHARED):
        print(f"planes: {SHARED} is not there; set CONTOUR_SHARED_DATA to the test data.")
        return
    rows = []
    print(" | ".join(HEAD))
    for line in measure(options):
        cells = row(line)
        print(" | ".join(cells) if cells else line.rstrip(), flush=True)
        rows += [cells] if cells else []
    if options.markdown:
        table = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)] + ["| " + " | ".join(cells) + " |" for cells in rows]
        with open(options.markdown, "w", encoding="utf-8") as stream:
            stream.write("# The implicit surface on the drawn planes\n\nMade by `./run bench planes --markdown`; its docstring, in "
                         "`Testing/Benchmark/planes.py`, says what the columns are.\n\n" + "\n".join(table) + "\n")


main()
