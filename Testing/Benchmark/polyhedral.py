# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of the polyhedral method by stage beside CGAL's 3D Delaunay triangulation; `./run bench` calls it.

    ./run bench polyhedral [--json FILE] [--repeat N] [--only TEXT]
    ./run bench polyhedral --growth [--points N,N,...] [--levels N,N,...] [--json FILE] [--check]

The first is the work of bench_psm, on real contours. The second makes smooth outlines, first of more and more
points on three levels, then of 1000 points on more and more levels, runs each in a process of its own, and tells
how processor seconds and memory grow: the exponent between one size and the next. `--check` ends with 1 where
they grow faster than MOST_TIME and MOST_MEMORY allow.
"""
import argparse
import json
import math
import os
import subprocess
import sys

BIN = os.environ["CONTOUR_BIN_DIR"]
# Exponents over the points a level and over the levels.
MOST_TIME = {"points": 1.6, "levels": 1.1}
MOST_MEMORY = 1.3


def measure(points, levels):
    out = subprocess.run([os.path.join(BIN, "bench_blobs"), str(points), str(levels)], capture_output=True, text=True, check=False)
    if out.returncode != 0:
        sys.exit(f"bench_blobs {points} {levels} ended with {out.returncode}: {out.stderr.strip()}")
    return json.loads(out.stdout)


def exponent(before, after, by, key):
    return math.log(after[key] / before[key]) / math.log(after[by] / before[by])


def grow(by, sizes):
    """Rows by size; complaints about growth."""
    rows, complaints = [], []
    print(f"{'points':>9} {'levels':>7} {'triangles':>10} {'CPU s':>9} {'MB':>8}   exponents of time, memory")
    for size in sizes:
        row = measure(size, 3) if by == "points" else measure(1000, size)
        row["grown"] = row["peak"] - row["before"]
        line = f"{row['points']:>9} {row['levels']:>7} {row['triangles']:>10} {row['cpu']:>9.2f} {row['peak']:>8.0f}"
        if rows:
            time, memory = exponent(rows[-1], row, by, "cpu"), exponent(rows[-1], row, by, "grown")
            row["exponents"] = [time, memory]
            line += f"   {time:.2f}, {memory:.2f}"
            if time > MOST_TIME[by] or memory > MOST_MEMORY:
                complaints.append(f"{size} {by}: time grows with exponent {time:.2f}, memory with {memory:.2f}")
        print(line, flush=True)
        rows.append(row)
    return rows, complaints


def numbers(text):
    return [int(number) for number in text.split(",")]


def main():
    if "--growth" not in sys.argv:
        sys.exit(subprocess.call([os.path.join(BIN, "bench_psm")] + sys.argv[1:]))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--growth", action="store_true")
    parser.add_argument("--points", type=numbers, default=[1000, 10000, 30000, 100000])
    parser.add_argument("--levels", type=numbers, default=[10, 100, 1000, 10000])
    parser.add_argument("--json")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    rows, complaints = grow("points", options.points)
    more, others = grow("levels", options.levels)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows + more, file, indent=1)
    for complaint in complaints + others:
        print(complaint, file=sys.stderr)
    sys.exit(1 if options.check and complaints + others else 0)


if __name__ == "__main__":
    main()
