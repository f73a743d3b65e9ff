# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a structure set takes on several ranks of an MPI server, a thread each; `./run bench` calls it.

    ./run bench ranks [STRUCTURE_SET.dcm] [--ranks N ...]

Of the slowest rank wall seconds and processor seconds, which are what a free machine would take; processor seconds of all ranks
together, and what of them is more than on one rank, which is reading the file on each; the share of the contour points that the
heaviest rank has. Without a file: dicompyler_rtss.dcm of the
shared test data, and it says so where that is absent.
"""
import argparse
import glob
import json
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Python"))
from mpitesting import find_ranks

SHARED = os.path.join(HERE, "..", "..", "..", "shared", "data", "rtstruct", "dicompyler_rtss.dcm")


def measure(run, ranks, path):
    with tempfile.TemporaryDirectory() as folder:
        code, text = run(ranks, ["--sym", os.path.join(HERE, "ranks", "measure.py")], path, folder)
        found = []
        for name in glob.glob(os.path.join(folder, "rank*.json")):
            with open(name, encoding="utf-8") as file:
                found.append(json.load(file))
    if code or len(found) != ranks:
        sys.exit(f"ranks: {len(found)} of {ranks} ranks came to the end: {text[-800:]}")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", default=SHARED)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2, 4])
    options = parser.parse_args()
    if not os.path.exists(options.file):
        print(f"SKIPPED: {options.file} is not there; name a structure set.")
        return
    run, why = find_ranks(tempfile.gettempdir())
    if run is None:
        print("SKIPPED: " + why)
        return
    print("| ranks | wall s | slowest rank, CPU s | of it reading | all ranks, CPU s | overhead | heaviest rank | triangles |\n"
          "|---|---|---|---|---|---|---|---|")
    alone = None
    for ranks in options.ranks:
        found = measure(run, ranks, options.file)
        wall = max(rank["read"][0] + rank["surfaces"][0] for rank in found)
        slowest = max(found, key=lambda rank: rank["read"][1] + rank["surfaces"][1])
        cpu = sum(rank[stage][1] for rank in found for stage in ("read", "surfaces"))
        alone = alone or cpu
        points = [rank["points"] for rank in found]
        print(f"| {ranks} | {wall:.2f} | {slowest['read'][1] + slowest['surfaces'][1]:.2f} | {slowest['read'][1]:.2f} "
              f"| {cpu:.2f} | {100 * (cpu / alone - 1):+.0f}% "
              f"| {100 * max(points) / sum(points):.0f}% | {sum(rank['triangles'] for rank in found)} |", flush=True)


if __name__ == "__main__":
    main()
