# SPDX-License-Identifier: GPL-3.0-or-later
"""Does an odd input cost more than its points? Processor time and memory a point, beside those of ordinary sets.

    ./run bench faults [--times N] [FILE ...]

Every input of faults/ and every ordinary set of the shared data goes through Polyhedral Surface with default settings, in a
process of its own that has done a small surface before, so that loading is not counted. A row an input: points, seconds of the
processor, megabytes that the process grew by at most, both a thousand points, and how many times the median of the ordinary
sets that is. An input of fewer than LEAST_POINTS points counts as having so many: what a call costs by itself. The last line
names what is above --times (10) times the median; the exit code is then 1.
"""
import argparse
import glob
import json
import os
import statistics
import sys
import time

SOURCE = os.environ.get("CONTOUR_SOURCE_DIR", ".")
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(SOURCE, "..", "shared", "data"))
SMALL = os.path.join(SOURCE, "Data", "branching_pipe.cnt")
LEAST_POINTS = 1000
ORDINARY = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "cnt/*.cnt", "csl/*.csl", "ibsi/*.dcm")
ODD = ("faults/rt/*.dcm", "faults/rt/*/*.dcm", "faults/rt/no_extension/*", "faults/other/*.*")

sys.path.insert(0, os.path.join(SOURCE, "Plugin", "commandline"))
import contourcli as cli
from paraview import simple


def files(patterns):
    found = [path for pattern in patterns for path in sorted(glob.glob(os.path.join(SHARED, pattern)))]
    return list(dict.fromkeys(path for path in found if os.path.isfile(path)))


def status(name):
    """A line of this process's status in megabytes."""
    with open("/proc/self/status", encoding="ascii") as file:
        for line in file:
            if line.startswith(name + ":"):
                return int(line.split()[1]) / 1024
    return 0.0


def surface(data):
    """Makes the surface; what is said about input that has none is not this program's business."""
    node = simple.PolyhedralSurface(Input=cli.as_source(data))
    try:
        cli.run_proxy(node)
    except cli.CommandError:
        pass
    simple.Delete(node)


def measure(path):
    """(points, seconds, megabytes) of all regions of a file, or the sentence why it has none."""
    try:
        blocks, _ = cli.read_contours(path)
    except cli.CommandError as error:
        return str(error)
    blocks = [block for block in blocks if not block.empty]
    surface(cli.read_contours(SMALL)[0][0].data)
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")  # the largest memory so far is forgotten
    memory, start = status("VmRSS"), time.process_time()
    for block in blocks:
        surface(block.data)
    seconds = time.process_time() - start
    return sum(block.data.GetNumberOfPoints() for block in blocks), seconds, max(0.0, status("VmHWM") - memory)


def in_a_child(path):
    """What measure says, from a process that only does this."""
    receive, send = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(receive)
        with os.fdopen(send, "w", encoding="utf-8") as file:
            json.dump(measure(path), file)
        os._exit(0)
    os.close(send)
    with os.fdopen(receive, encoding="utf-8") as file:
        text = file.read()
    os.waitpid(child, 0)
    return json.loads(text) if text else "the process ended"


def rows(paths):
    """[name, points, seconds, megabytes] of files that have contours; a line for each of the others."""
    found = []
    for path in paths:
        name, got = os.path.relpath(path, SHARED), in_a_child(path)
        if isinstance(got, str):
            print(f"{name}: {got}", flush=True)
        elif got[0] > 0:
            found.append([name, *got])
    return found


def main():
    parser = argparse.ArgumentParser(prog="./run bench faults", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="*")
    parser.add_argument("--times", type=float, default=10)
    options = parser.parse_args()
    if not os.path.isdir(SHARED):
        print(f"faults: {SHARED} is not there; set CONTOUR_SHARED_DATA to the test data.")
        return 0
    cli.load_plugin()
    ordinary = rows(files(ORDINARY))
    odd = rows(options.files or files(ODD))

    def a_thousand(row, column):
        return 1000 * row[column] / max(row[1], LEAST_POINTS)

    medians = [statistics.median(a_thousand(row, column) for row in ordinary) for column in (2, 3)]
    print(f"median of {len(ordinary)} ordinary sets: {medians[0]:.4f} s, {medians[1]:.3f} MB a thousand points")
    print("input | points | s | MB | s a thousand | times | MB a thousand | times")
    above = []
    for row in ordinary + odd:
        each = [a_thousand(row, 2), a_thousand(row, 3)]
        times = [one / median if median else 0.0 for one, median in zip(each, medians)]
        above += [row[0]] if max(times) > options.times else []
        print(f"{row[0]} | {row[1]} | {row[2]:.3f} | {row[3]:.1f} | {each[0]:.4f} | {times[0]:.1f} | {each[1]:.2f} | {times[1]:.1f}")
    print(f"above {options.times:g} times: {', '.join(above) or 'none'}")
    return 1 if above else 0


sys.exit(main())
