# SPDX-License-Identifier: GPL-3.0-or-later
"""The sets in Data/ are what Data/README.md says, and the scripts there give them again byte for byte.

    TestData.py             counts, read through the plugin's own readers
    TestData.py derive      the scripts again; needs the Debian package mricron-data
"""
import filecmp
import os
import subprocess
import sys
import tempfile

import contourtesting as ct

# planes, contours, points
SETS = {
    "head.cnt": (63, 246, 20647),
    "brain.cnt": (15, 105, 6758),
    "branching_pipe.cnt": (4, 9, 92),
    "tamarind.csl": (5, 5, 57),
    "femur_head.csl": (11, 11, 136),
}


def check_counts():
    simple = ct.load_plugin()
    with open(ct.own("README.md"), encoding="utf-8") as file:
        table = [[cell.strip() for cell in line.split("|")] for line in file if line.startswith("| `")]
    for name, (planes, contours, points) in SETS.items():
        reader = simple.NUAGESContourReader if name.endswith(".cnt") else simple.CurveNetworkReader
        data = ct.data(reader(FileName=ct.own(name)))
        if not data.IsA("vtkPolyData"):
            ct.check(data.GetNumberOfPartitionedDataSets() == 1, f"{name}: one material")
            data = data.GetPartition(0, 0)
        found, vertices = set(), 0
        for i in range(data.GetNumberOfCells()):
            ids = data.GetCell(i).GetPointIds()
            corners = [data.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())]
            ct.check(corners[0] == corners[-1], f"{name}: contour {i} is closed")
            vertices += len(corners) - 1
            # All of a contour's points have one coordinate in common: its plane's.
            axes = [a for a in range(3) if len({p[a] for p in corners}) == 1]
            if ct.check(len(axes) == 1, f"{name}: contour {i} lies in a plane along two axes"):
                found.add((axes[0], corners[0][axes[0]]))
        ct.check(len(found) == planes, f"{name}: {len(found)} planes of {planes}")
        ct.check(data.GetNumberOfCells() == contours, f"{name}: {data.GetNumberOfCells()} contours of {contours}")
        ct.check(vertices == points, f"{name}: {vertices} points of {points}")
        rows = [row for row in table if f"`{name}`" in row]
        if ct.check(len(rows) == 1, f"{name}: the README has a row"):
            said = [row.replace(" ", "") for row in rows[0][3:6]]
            ct.check(said[0].startswith(str(planes)) and said[1].startswith(str(contours)) and said[2] == str(points),
                     f"{name}: the README says so")


def check_scripts():
    source = "/usr/share/mricron/templates/ch2.nii.gz"
    scripts = {"make_small_examples.py": ["branching_pipe.cnt", "tamarind.csl", "femur_head.csl"],
               "derive_head_contours.py": ["head.cnt", "brain.cnt"]}
    if not os.path.exists(source):
        ct.skip(f"{source} is not there; install the Debian package mricron-data.")
    for script, names in scripts.items():
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["/usr/bin/python3", ct.own(os.path.join("derive", script)), folder],
                                  stdout=subprocess.DEVNULL)
            ct.check(done.returncode == 0, f"{script} succeeds")
            for name in names:
                made = os.path.join(folder, name)
                ct.check(os.path.exists(made) and filecmp.cmp(made, ct.own(name), shallow=False),
                         f"{script} gives {name} again")


if "derive" in sys.argv[1:]:
    check_scripts()
else:
    check_counts()
ct.finish()
