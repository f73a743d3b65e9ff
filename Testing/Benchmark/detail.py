# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a user of Implicit Surface waits at each level of Detail.

    ./run bench detail [--repeat N] [--no-full] [lung|body|heart ...]

Wall and processor seconds of the node, from contours to surface, with all processors: the median of N runs (default 5) of the
previews, one run of Full. Every surface is examined by the Surface Certificate. Reads the shared test data and says so where it is
absent.
"""
import argparse
import os
import statistics
import sys
import time

SOURCE = os.environ["CONTOUR_SOURCE_DIR"]
sys.path.insert(0, os.path.join(SOURCE, "Plugin", "commandline"))
import contourcli as cli

SETS = {"lung": ("rtstruct/dicompyler_rtss.dcm", "Lt Lung"), "body": ("rtstruct/dicompyler_rtss.dcm", "BODY"),
        "heart": ("rtstruct/dicompyler_rtss.dcm", "Heart")}
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(SOURCE, "..", "shared", "data"))


def measure(contours, detail, runs):
    """Medians of wall and processor seconds of the node alone, its surface and the certificate of that."""
    walls, processors = [], []
    source = cli.as_source(contours.data)
    for _ in range(runs):
        node = cli.simple.ImplicitSurface(Input=source, Detail=detail)
        wall, processor = time.perf_counter(), time.process_time()
        node.UpdatePipeline()
        walls.append(time.perf_counter() - wall)
        processors.append(time.process_time() - processor)
    surface = node.GetClientSideObject().GetOutputDataObject(0)
    return statistics.median(walls), statistics.median(processors), surface, cli.certify(surface, source)[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--no-full", dest="full", action="store_false")
    parser.add_argument("sets", nargs="*", default=list(SETS))
    options = parser.parse_args()
    cli.load_plugin()
    print("| set | contour points | detail | constraints | triangles | wall s | CPU s | sound | crossing pairs |\n" + "|---" * 9 + "|")
    for name in options.sets:
        file, region = SETS[name]
        path = os.path.join(SHARED, file)
        if not os.path.exists(path):
            print(f"SKIPPED {name}: {path} is not there")
            continue
        contours = cli.read_contours(path, [region])[0]
        block = next(b for b in contours if b.name == region)
        for detail in ("Coarse", "Medium") + (("Full",) if options.full else ()):
            wall, cpu, surface, figures = measure(block, detail, 1 if detail == "Full" else options.repeat)
            sound = all(figures[k] for k in ("Closed", "EdgeManifold", "VertexManifold", "Oriented", "Outward"))
            constraints = surface.GetFieldData().GetArray("ConstraintCount").GetTuple1(0)
            print(f"| {name} | {block.data.GetNumberOfPoints()} | {detail} | {constraints:.0f} | {surface.GetNumberOfPolys()} | "
                  f"{wall:.2f} | {cpu:.2f} | {'yes' if sound else 'NO'} | {figures['CrossingPairs']:.0f} |", flush=True)


main()
