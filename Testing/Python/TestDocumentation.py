# SPDX-License-Identifier: GPL-3.0-or-later
"""Every block of code of the recipes does what it should, in a folder with the files that the page names.

Blocks marked sh are lines for a shell in which `./run reconstruct` is the command line of this build; blocks marked python
are run in pvpython, each page in one go.
"""
import math
import os
import re
import shlex
import shutil
import subprocess
import sys

import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
PAGES = ("recipes.md", "structure-sets.md")
FOLDER = ct.output("documentation")
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(os.path.join(FOLDER, "cohort"))
os.chdir(FOLDER)
COMMAND = [shutil.which("python3"), os.path.join(ct.SOURCE, "Plugin", "commandline", "reconstruct.py")]


def circle(radius, z, x=0.0):
    return [c for i in range(32) for c in (x + radius * math.cos(i * math.pi / 16), radius * math.sin(i * math.pi / 16), z)]


def structure_set(path, slices):
    """A body, a lung, and a prostate that is drawn on some slices only."""
    rois = [(number, name, "ORGAN", None, [("CLOSED_PLANAR", circle(radius, 3.0 * i), f"1.2.3.{i}") for i in drawn])
            for number, name, radius, drawn in ((1, "Body", 60, range(20)), (2, "Lt Lung", 25, range(2, 15)),
                                                (3, "Prostate", 15, slices))]
    with open(path, "wb") as file:
        file.write(rt.structure_set(rois))


structure_set("rtss.dcm", range(5, 10))
structure_set("drawn.dcm", (4, 7, 10, 13))
for patient in ("anna", "bert"):
    structure_set(f"cohort/{patient}.dcm", range(5, 10))
rows = [f"axon,{z},{0.1 * math.cos(a * math.pi / 8)},{0.1 * math.sin(a * math.pi / 8)}" for z in range(5) for a in range(16)]
with open("cell.csv", "w", encoding="ascii") as file:
    file.write("object,slice,x,y\n" + "\n".join(rows) + "\n")
os.symlink(os.path.join(ct.SOURCE, "Data"), "Data")


def shell(block, page):
    """The lines of a block, one by one; those of `./run reconstruct` by this build."""
    for line in block.replace("\\\n", " ").splitlines():
        line = line.strip()
        if line.startswith("./run reconstruct "):
            words = COMMAND + shlex.split(line)[2:]
            run = subprocess.run(words, capture_output=True, text=True)
        elif line and not line.startswith("#"):
            run = subprocess.run(line, shell=True, capture_output=True, text=True)
        else:
            continue
        ct.check(run.returncode == 0, f"{page}: {line} returns {run.returncode}: {run.stderr}")


def python(block, page, names):
    def work():
        exec(compile(block, page, "exec"), names)
    try:
        said = ct.errors_of(work)
    except Exception as error:
        ct.check(False, f"{page}: {error!r} in:\n{block}")
        return
    ct.check("ERR" not in said, f"{page}: {said} in:\n{block}")


def data_of(names, name):
    """The output of a node that a block has made."""
    return names[name].GetClientSideObject().GetOutputDataObject(0)


blocks = 0
for page in PAGES:
    names = dict(simple.__dict__)
    with open(os.path.join(ct.SOURCE, "Documentation", page), encoding="utf-8") as file:
        text = file.read()
    for language, block in re.findall(r"^```(\w+)\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE):
        blocks += 1
        ct.check(language in ("sh", "python"), f"{page}: blocks of {language} are not tried")
        print(f"{page}: {block.splitlines()[0]}", file=sys.stderr, flush=True)
        shell(block, page) if language == "sh" else python(block, page, names)
    if page == "recipes.md":
        ct.check(data_of(names, "solid").GetNumberOfCells() > 100, "terrain becomes a solid")
        volume = data_of(names, "again").GetFieldData().GetArray("Volume").GetValue(0)
        ct.check(abs(volume - math.pi / 6) < 0.02, f"the ball comes back: {volume}")
        ct.check(len(names["volumes"]) == 6, f"the loop knows {names['volumes']}")
        boundary = simple.SurfaceCertificate(Input=simple.PolyhedralSurface(
            Input=names["tetrahedra"].Input, EndCaps="Flat", LiftInternalPoints=0))
        boundary.UpdatePipeline()
        inside = simple.IntegrateVariables(Input=names["solid"], DivideCellDataByVolume=0)
        inside.UpdatePipeline()
        tetrahedra = inside.GetClientSideObject().GetOutputDataObject(0).GetCellData().GetArray("Volume").GetValue(0)
        solid = boundary.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("Volume").GetValue(0)
        ct.check(abs(tetrahedra - solid) < 1e-3 * solid, f"tetrahedra of {tetrahedra} within a surface of {solid}")
        regions = data_of(names, "by_slice").GetNumberOfPartitionedDataSets()
        ct.check(regions == 5, f"there are {regions} regions")
for file in ("organs-Body.stl", "organs-Lt_Lung.stl", "lung.stl", "surfaces/anna-Body.stl", "cohort.json", "all.dcm", "cell.vtp",
             "brain.stl", "head.vtp", "solid.vtu"):
    ct.check(os.path.exists(file), f"{file} is written")
ct.check(blocks >= 12, f"only {blocks} blocks were found")
ct.finish()
