# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Surface on every set of contours there is: closed, manifold, oriented outward, no crossing pair, no angle under a degree.

    TestImplicitSweep.py [all] [NAME ...]

All regions of all structure sets, NUAGES files, cross-section sets and curve networks of the shared test data and of Data/, with
the node's defaults. Without `all`, sets of more points than FEW are taken as the Coarse preview (sound, too, but as the cells cut
it: any angle) and the others in full. NAME: only sets in whose name it is. Sets that are no solid must be refused for that reason.
Prints a row of Markdown a set.
"""
import glob
import os
import sys
import time

import contourtesting as ct

ct.shared("csl")
sys.path.insert(0, os.path.join(ct.SOURCE, "Plugin", "commandline"))
import contourcli as cli

cli.load_plugin()
FEW = 150
SOUND = ("Closed", "EdgeManifold", "VertexManifold", "Oriented", "Outward")
PATTERNS = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "cnt/*.cnt", "csl/*.csl", "contour/*.contour")
NO_SOLID = ("All contours lie in one plane", "No usable contour", "points only")


def sets():
    """(name, contours)"""
    files = sorted(glob.glob(ct.own("") + "*.cnt") + glob.glob(ct.own("") + "*.csl"))
    for pattern in PATTERNS:
        files += sorted(glob.glob(os.path.join(os.environ["CONTOUR_SHARED_DATA"], pattern)))
    for path in files:
        for block in cli.read_contours(path)[0]:
            if not block.empty:
                yield f"{os.path.basename(path)} {block.name}", block


def check_set(name, contours, full):
    start = time.process_time()
    try:
        result = cli.reconstruct(contours, "ism", [] if full else ["Detail=Coarse"])
    except cli.CommandError as error:
        ct.check(any(reason in str(error) for reason in NO_SOLID), f"{name}: {error}")
        print(f"| {name} | no solid |", flush=True)
        return 0
    figures = result.certificate
    for kind in SOUND:
        ct.check(figures[kind] == 1, f"{name}: {kind} is {figures[kind]}")
    for kind in ("CrossingPairs", "OverlappingPairs"):
        ct.check(figures[kind] == 0, f"{name}: {kind} is {figures[kind]}")
    angle = result.surface.GetFieldData().GetArray("SmallestAngle").GetTuple1(0)
    ct.check(not full or angle >= 1, f"{name}: an angle of {angle} degrees")
    size = result.surface.GetFieldData().GetArray("CellSize").GetTuple1(0)
    farthest = max(figures["FarthestContourVertex"], figures["FarthestContourEdge"])
    row = [name, "full" if full else "coarse", result.triangles, f"{figures['Components']:.0f}", f"{figures['Euler']:.0f}",
           f"{figures['CrossingPairs']:.0f}", f"{angle:.2g}", f"{farthest / size:.2f}", f"{time.process_time() - start:.1f}"]
    print("| " + " | ".join(map(str, row)) + " |", flush=True)
    return 1


every = "all" in sys.argv[1:]
names = [name for name in sys.argv[1:] if name != "all"]
print("| set | detail | triangles | components | Euler | crossing pairs | least angle | farthest contour in cells | CPU s |\n"
      + "|---" * 9 + "|")
solids = sum(check_set(name, contours, every or contours.data.GetNumberOfPoints() <= FEW) for name, contours in sets()
             if not names or any(part in name for part in names))
ct.check(names or solids > 80, f"only {solids} solids were found")
ct.finish()
