# SPDX-License-Identifier: GPL-3.0-or-later
"""On 1, 2 and 4 ranks of ParaView's MPI server: every stage gives, all ranks together, what it gives on one."""
import filecmp
import glob
import json
import math
import os
import shutil
import sys

import contourtesting as ct
import readertesting as rt
from mpitesting import find_ranks

HERE = os.path.dirname(os.path.abspath(__file__))


def tube(corners, radius, levels, x=0.0):
    """Polygons around an axis, one a level."""
    return [[[x + (radius + 0.2 * z) * math.cos(2 * math.pi * i / corners), (radius + 0.2 * z) * math.sin(2 * math.pi * i / corners), z]
             for i in range(corners)] for z in levels]


def structure_set(path):
    """Six regions of very different sizes, one without contours and one that is a point."""
    def roi(number, name, polygons):
        return (number, name, "ORGAN", f"{number * 20}\\0\\200",
                [("CLOSED_PLANAR", [c for point in polygon for c in point]) for polygon in polygons])
    regions = [roi(1, "small", tube(6, 3, (0, 2, 4))), roi(2, "big", tube(60, 9, (0, 2, 4, 6, 8), 30)),
               roi(3, "none", []), roi(4, "branching", tube(12, 3, (0, 2), 60) + tube(12, 1, (4, 6), 58) + tube(12, 1, (4, 6), 62)),
               (5, "marker", "MARKER", "0\\0\\9", [("POINT", [1.0, 2.0, 3.0])]), roi(6, "middle", tube(24, 5, (1, 3, 5, 7), 90))]
    return rt.write(path, rt.structure_set(regions))


def nuages(path, polygons):
    lines = [f"S {len(polygons)}\n"]
    for polygon in polygons:
        lines.append(f"v {len(polygon)} z {polygon[0][2]}\n{{\n" + "".join(f"{x!r} {y!r}\n" for x, y, _ in polygon) + "}\n")
    return rt.write(path, "".join(lines))


def folder(name):
    path = ct.output(name)
    shutil.rmtree(path, ignore_errors=True)
    os.makedirs(path)
    return path


def stages_on(run, ranks, files):
    """What each of the ranks has, by stage."""
    made = folder(f"ranks{ranks}")
    code, text = run(ranks, ["--sym", os.path.join(HERE, "ranksjob.py")], *files, made)
    ct.check(code == 0 and "ERR|" not in text, f"{ranks} ranks: {text[-1500:]}")
    found = []
    for path in sorted(glob.glob(os.path.join(made, "rank*.json"))):
        with open(path, encoding="utf-8") as file:
            found.append(json.load(file))
    ct.check(len(found) == ranks, f"{len(found)} of {ranks} ranks came to the end")
    return found


def united(parts):
    """Of each block the one rank that has something of it; the same blocks on all ranks."""
    ct.check(all([name for name, *_ in part] == [name for name, *_ in parts[0]] for part in parts), "other blocks on other ranks")
    blocks = []
    for same in zip(*parts):
        having = [block for block in same if block[1]]
        ct.check(len(having) <= 1, f"block {same[0][0]} is on {len(having)} ranks")
        blocks.append(having[0] if having else [same[0][0], 0, None])
    return blocks


def check_stages(alone, together, ranks):
    for stage, ports in alone[0].items():
        for port, expected in enumerate(ports):
            blocks = united([rank[stage][port] for rank in together])
            ct.check(blocks == expected, f"{stage}, output {port}: {ranks} ranks have {blocks} instead of {expected}")
    ct.check(sum(block[1] for block in alone[0]["regions: surface"][0]) > 500, "there are next to no triangles")
    busy = [rank for rank in together if any(block[1] for block in rank["regions: surface"][0])]
    ct.check(len(busy) == min(ranks, 4), f"{len(busy)} of {ranks} ranks have a surface")


def commands_on(run, ranks, files):
    """What a script on the first rank is told, and its files; the output."""
    made = folder(f"commands{ranks}")
    _, text = run(ranks, [os.path.join(HERE, "rankscommands.py")], *files, made)
    path = os.path.join(made, "said.json")
    if not ct.check(os.path.exists(path), f"{ranks} ranks: {text[-1500:]}"):
        ct.finish()
    with open(path, encoding="utf-8") as file:
        return made, json.load(file), text


def check_commands(run, files):
    alone, serial, text = commands_on(run, 1, files)
    ct.check("ERR|" not in text, f"one rank: {text[-1500:]}")
    written = sorted(os.listdir(alone))
    ct.check(len(written) == 12, f"one rank wrote {written}")
    for ranks in (2, 4):
        made, said, text = commands_on(run, ranks, files)
        for what in ("verdict", "tables", "cells", "ball"):
            ct.check(said[what] == serial[what], f"{what} of {ranks} ranks: {said[what]} instead of {serial[what]}")
        ct.check("On rank 1, with their Report: " in said["report"], f"report of {ranks} ranks: {said['report']}")
        ct.check("ranks have a part of the input" in text and "put Contour Regions before this" in text
                 and "cells of slices in pieces: 0" in text, f"slices in pieces: {text[-1500:]}")
        ct.check(sorted(os.listdir(made)) == written, f"{ranks} ranks wrote {sorted(os.listdir(made))} instead of {written}")
        for name in written:
            # What is unique of a structure set is drawn anew every time.
            if not name.endswith((".json", ".dcm")):
                ct.check(filecmp.cmp(os.path.join(alone, name), os.path.join(made, name), shallow=False), f"{ranks} ranks: another {name}")
        ct.check(abs(os.path.getsize(os.path.join(made, "regions.dcm")) - os.path.getsize(os.path.join(alone, "regions.dcm"))) < 64,
                 f"{ranks} ranks: another structure set")


def main():
    run, why = find_ranks(ct.OUTPUT)
    if run is None:
        ct.skip(why)
    regions = structure_set("ranks.dcm")
    first = nuages("ranks.cnt", tube(16, 4, (0.5, 2.5, 4.5)))
    second = nuages("ranksother.cnt", tube(20, 5, (0.5, 2.5, 4.5, 6.5)))
    alone = stages_on(run, 1, (regions, first, second))
    for ranks in (2, 4):
        check_stages(alone, stages_on(run, ranks, (regions, first, second)), ranks)
    check_commands(run, (regions, first))
    ct.finish()


if __name__ == "__main__":
    sys.exit(main())
