# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line, from outside: what it writes, prints and returns, and one sentence for every failure."""
import json
import math
import os
import shutil
import subprocess

import contourtesting as ct
import readertesting as rt

SCRIPT = os.path.join(ct.SOURCE, "Plugin", "commandline", "reconstruct.py")
FOLDER = ct.output("command line")
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)
PYTHON = shutil.which("python3")


def reconstruct(*arguments):
    return subprocess.run([PYTHON, SCRIPT, *arguments], cwd=FOLDER, capture_output=True, text=True)


def succeeds(*arguments):
    run = reconstruct(*arguments)
    ct.check(run.returncode == 0, f"{arguments} returns 0: {run.stderr}")
    ct.check("\r" not in run.stderr, f"{arguments} draws no progress bar where there is no terminal")
    return run.stdout


def fails(words, *arguments):
    before = sorted(os.listdir(FOLDER))
    run = reconstruct(*arguments)
    lines = [line for line in run.stderr.splitlines() if line.strip()]
    ct.check(run.returncode != 0, f"{arguments} returns nonzero")
    ct.check(len(lines) == 1 and lines[0].startswith("contour-reconstruct: "),
             f"{arguments} says one sentence, not: {lines}")
    ct.check(words in run.stderr, f"{arguments} says '{words}': {run.stderr}")
    ct.check(sorted(os.listdir(FOLDER)) == before, f"{arguments} leaves no file behind")


brain = ct.own("brain.cnt")
table = succeeds(brain, "brain.vtp", "--certificate", "brain.json")
row = [line for line in table.splitlines() if line.startswith("brain")][0].split()
ct.check(row[1] == "105", f"the table counts the contours: {row}")
ct.check(row[3:5] == ["yes", "yes"], f"the table says closed and manifold: {row}")
for stage in ("read", "clean contours", "extract surface", "certificate", "write"):
    ct.check(any(line.startswith(stage) for line in table.splitlines()), f"the table times '{stage}'")
with open(os.path.join(FOLDER, "brain.json"), encoding="utf-8") as file:
    certificate = json.load(file)
ct.check(certificate["brain"]["Total"]["Closed"] in (True, 1), "the certificate says closed")
ct.check(abs(certificate["brain"]["Total"]["Volume"] - float(row[6])) < 1e-5 * float(row[6]),
         "table and certificate agree on the volume")

from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

pipe = ct.own("branching_pipe.cnt")
counts = {}
for extension, Reader in ((".vtp", vtkXMLPolyDataReader), (".stl", vtkSTLReader), (".ply", vtkPLYReader)):
    succeeds(pipe, "pipe" + extension)
    reader = Reader()
    reader.SetFileName(os.path.join(FOLDER, "pipe" + extension))
    reader.Update()
    counts[extension] = reader.GetOutput().GetNumberOfPolys()
ct.check(counts[".vtp"] > 100, f"pipe.vtp has triangles: {counts}")
ct.check(len(set(counts.values())) == 1, f"every format has all triangles: {counts}")
succeeds(pipe, "pipe.brep")
ct.check(os.path.getsize(os.path.join(FOLDER, "pipe.brep")) > 1000, "pipe.brep is written")
with_points = counts[".vtp"]
succeeds(pipe, "plain.vtp", "--set", "InternalPoints=0")
reader = vtkXMLPolyDataReader()
reader.SetFileName(os.path.join(FOLDER, "plain.vtp"))
reader.Update()
ct.check(reader.GetOutput().GetNumberOfPolys() < with_points, "--set InternalPoints=0 leaves them out")

# Contours as they are, from format to format: through a table nothing is lost.
succeeds(pipe, "copy.cnt")
told = succeeds(pipe, "pipe.csv")
ct.check("pipe.csv" in told, f"the table is named: {told}")
succeeds("pipe.csv", "back.cnt")
with open(os.path.join(FOLDER, "copy.cnt"), "rb") as one, open(os.path.join(FOLDER, "back.cnt"), "rb") as other:
    ct.check(one.read() == other.read(), "by way of a table comes the same file")
fails("not overwritten", "pipe.csv", "pipe.csv")
fails("--set is about surfaces", pipe, "set.csv", "--set", "EndCaps=Flat")

# Contours on planes of any orientation are the implicit method's.
table = succeeds(pipe, "fair.vtp", "--method", "fair", "--set", "Tension=0.3")
ct.check(os.path.getsize(os.path.join(FOLDER, "fair.vtp")) > 1000, "fair.vtp is written")
fails("no property 'PinchGap'", pipe, "fair.brep", "--method", "fair", "--set", "PinchGap=0")
table = succeeds(ct.own("femur_head.csl"), "femur.vtp", "--method", "ism", "--set", "CellSize=2")
row = [line for line in table.splitlines() if line.startswith("femur_head")][0].split()
ct.check(row[1] == "11" and row[3:5] == ["yes", "yes"], f"11 contours give a closed manifold: {row}")

# A ball drawn on 4 of 21 slices comes back on all that it reaches, beside the other regions of the structure set.
def circle(radius, z):
    return [x for i in range(40) for x in (radius * math.cos(i * math.pi / 20), radius * math.sin(i * math.pi / 20), z)]


body = [("CLOSED_PLANAR", circle(60.0, 3.0 * i - 30), f"1.2.3.{i + 1}") for i in range(21)]
ball = [("CLOSED_PLANAR", circle(math.sqrt(20.0 ** 2 - z ** 2), z)) for z in (-12.0, -6.0, 6.0, 12.0)]
with open(os.path.join(FOLDER, "drawn.dcm"), "wb") as file:
    file.write(rt.structure_set([(1, "Body", "EXTERNAL", "0\\255\\0", body), (2, "Ball", "PTV", None, ball)]))
table = succeeds("drawn.dcm", "all.dcm", "--method", "ism", "--roi", "Ball", "--set", "StructureSetLabel=Balls")
row = [line for line in table.splitlines() if line.startswith("Ball")][0].split()
ct.check(row[1] == "4" and row[2] == row[3] == "9", f"4 contours of the ball become 9, none beyond the drawn: {row}")
simple = ct.load_plugin()
blocks = dict(rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=os.path.join(FOLDER, "all.dcm")))))
ct.check(list(blocks) == ["Body", "Ball", "Ball (2)"], f"the ROIs are {list(blocks)}")
traced = blocks["Ball (2)"]
ct.check(traced.GetNumberOfCells() == int(row[2]), "the file has as many contours as the table")
ct.check(all(abs(traced.GetPoint(i)[2] / 3 - round(traced.GetPoint(i)[2] / 3)) < 1e-9
             for i in range(traced.GetNumberOfPoints())), "the contours lie on the slices")
off = max(abs(math.dist(traced.GetPoint(i), (0, 0, 0)) - 20) for i in range(traced.GetNumberOfPoints()))
ct.check(off < 1.0, f"the contours are the ball's to {off} mm")
ct.check(rt.strings(traced, "ROIType") == ["PTV"], "the type is kept")
table = succeeds("drawn.dcm", "beyond.dcm", "--method", "ism", "--roi", "Ball", "--extrapolate")
row = [line for line in table.splitlines() if line.startswith("Ball")][0].split()
ct.check(int(row[2]) > 9, f"--extrapolate goes on where the ball closes: {row}")
# Contours of any file, on planes that are told instead.
succeeds(ct.own("femur_head.csl"), "femur.dcm", "--method", "ism", "--reference", "drawn.dcm", "--set", "Spacing=5",
         "--set", "ROIName=Femur head", "--set", "CopyReferenceROIs=0")
blocks = rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=os.path.join(FOLDER, "femur.dcm"))))
ct.check([name for name, _ in blocks] == ["Femur head"], f"the ROIs are {[name for name, _ in blocks]}")
fails("add --method ism", "drawn.dcm", "out.dcm")
fails("give the RT structure set", brain, "out.dcm", "--method", "ism")
fails("is read as well", "drawn.dcm", "drawn.dcm", "--method", "ism")
fails("is read as well", brain, "drawn.dcm", "--method", "ism", "--reference", "drawn.dcm")
fails("There is no file", brain, "out.dcm", "--method", "ism", "--reference", "absent.dcm")
fails("--reference and --extrapolate are for", brain, "out.vtp", "--reference", "drawn.dcm")
with open(os.path.join(FOLDER, "elsewhere.dcm"), "wb") as file:
    file.write(rt.structure_set([(1, "Body", "", None, [("CLOSED_PLANAR", circle(60.0, 900.0), "1.2.3.1")])]))
fails("are they of the same patient", "drawn.dcm", "out.dcm", "--method", "ism", "--reference", "elsewhere.dcm",
      "--roi", "Ball")
fails("no property 'Nonsense'", "drawn.dcm", "out.dcm", "--method", "ism", "--set", "Nonsense=1")

fails("There is no file", "nothing.cnt", "out.vtp")
fails("cannot read '.xyz'", shutil.copy(brain, ct.output("brain.xyz")), "out.vtp")
fails("cannot write '.obj'", brain, "out.obj")
fails("There is no folder", brain, os.path.join("nowhere", "out.vtp"))
fails("no property 'Nonsense'", brain, "out.vtp", "--set", "Nonsense=1")
fails("PROPERTY=VALUE", brain, "out.vtp", "--set", "InternalPoints")
plain = succeeds(pipe, "unexamined.vtp", "--certificate", "none", "--unit", "cm")
row = [line for line in plain.splitlines() if line.startswith("branching_pipe")][0].split()
ct.check(row[3:7] == ["-"] * 4 and "volume/cm3" in plain and "\ncertificate" not in plain,
         f"--certificate none examines nothing, and --unit names the unit: {plain}")
ct.check("\x1b" not in plain, "no colours where there is no terminal")
fails("are in mm", "drawn.dcm", "out.vtp", "--unit", "cm")
fails("--roi needs a DICOM RT structure set, or a file of a tracing program", brain, "out.vtp", "--roi", "Heart")
listed = succeeds("drawn.dcm", "--list")
ct.check("Body" in listed and "Ball" in listed and "EndCaps = Tapered: Flat, HalfSlice, Tapered, Extrapolated, None" in listed,
         f"--list tells regions and properties: {listed}")
ct.check("EndCaps = Tapered" in succeeds("--list"), "--list without a file tells the properties")
ct.check("volume/cm3" in succeeds("drawn.dcm", "unit.vtp", "--roi", "Body"), "volumes of structure sets are in cm3")
# Drawings of one object, a slice each.
for radius in (3, 4, 4, 3):
    with open(os.path.join(FOLDER, f"{len(os.listdir(FOLDER))}.svg"), "w", encoding="ascii") as file:
        file.write('<svg xmlns="http://www.w3.org/2000/svg" width="20mm" viewBox="0 0 20 20">'
                   f'<circle cx="9" cy="9" r="{radius}"/></svg>')
drawings = sorted(name for name in os.listdir(FOLDER) if name.endswith(".svg"))
table = succeeds(*drawings, "drawn.stl", "--stack", "--spacing", "2", "--set", "EndCaps=Flat")
row = [line for line in table.splitlines() if line.startswith(drawings[0][:2])][0].split()
ct.check(row[1] == "4" and abs(float(row[6]) - 0.256) < 0.02, f"four drawings are one solid of 0.256 cm3: {row}")
fails("--spacing is for files that do not tell", "drawn.dcm", "out.vtp", "--spacing", "2")
# Settings are checked against what the nodes say of them, names in any case.
for setting, words in (("EndCaps=Round", "one of Flat, HalfSlice, Tapered, Extrapolated, None"), ("OverlapThreshold=7", "from 0 to 0.99"),
                       ("InternalPoints=maybe", "on or off"), ("Threads=1.5", "no whole number"),
                       ("ForcedJoins=1,2,3", "by 2, and here are 3"), ("Overrides=absent.csv", "no file absent.csv")):
    fails(words, pipe, "out.vtp", "--set", setting)
fails("give X,Y,Z", pipe, "out.vtp", "--offset", "1,2")
fails("--offset is for surfaces", "drawn.dcm", "out.dcm", "--method", "ism", "--offset", "auto")
fails("--force to replace it", "drawn.dcm", "all.dcm", "--method", "ism")
fails("has no ROI 'Bal'; it has: Body, Ball", "drawn.dcm", "out.vtp", "--roi", "Bal")
succeeds(pipe, "flat.vtp", "--set", "endcaps=FLAT", "--set", "hole_rule=even odd", "--set", "weld=off")
succeeds("drawn.dcm", "ball.stl", "--roi", "bALL", "--force")

with open(ct.output("broken.cnt"), "w", encoding="ascii") as file:
    file.write("S 2\nv 3 z 0\n{\n0 0\n1 0\n")
fails("broken.cnt", ct.output("broken.cnt"), "out.vtp")
with open(ct.output("one.cnt"), "w", encoding="ascii") as file:
    file.write("S 1\nv 3 z 0\n{\n0 0\n1 0\n0 1\n}\n")
fails("plane", ct.output("one.cnt"), "out.vtp")
ct.finish()
