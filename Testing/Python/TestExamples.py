# SPDX-License-Identifier: GPL-3.0-or-later
"""The example scripts do what they say, as they stand in Documentation/examples."""
import os
import runpy
import shutil
import sys

import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
EXAMPLES = os.path.join(ct.SOURCE, "Documentation", "examples")
FOLDER = ct.output("-".join(["examples", *sys.argv[1:]]))  # the one with a display may run at the same time
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)
os.chdir(FOLDER)
tried = {"picture.py"}  # has a test of its own, with a display


def run(name, *files):
    """The script's names; it wrote these files."""
    tried.add(name)
    names = runpy.run_path(os.path.join(EXAMPLES, name), run_name="__main__")
    for file in files:
        ct.check(os.path.exists(file) and os.path.getsize(file) > 500, f"{name} writes {file}")
    return names


if sys.argv[1:] == ["picture"]:
    run("picture.py", "brain.png")
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName("brain.png")
    reader.Update()
    scalars = reader.GetOutput().GetPointData().GetScalars()
    coloured = sum(scalars.GetTuple(i)[0] - scalars.GetTuple(i)[2] > 20 for i in range(0, scalars.GetNumberOfTuples(), 97))
    ct.check(coloured > 0.1 * scalars.GetNumberOfTuples() / 97, f"the brain is in the picture: {coloured}")
    ct.finish()

names = run("first_surface.py", "brain.vtp")
ct.check(names["closed"] and 1e6 < names["volume"] < 2e6, f"the brain is closed and has {names['volume']} mm3")
names = run("few_contours_to_many.py", "femur_head.cnt")
ct.check(names["count"] > 11, f"contours became {names['count']}")
names = run("traces_of_a_microscope.py", "dendrite.csv")
ct.check(0.1 < names["volume"] < 0.3 and os.path.exists("dendrite.vtpc"), f"the dendrite has {names['volume']} um3")
names = run("cut_a_mesh_and_back.py", "again.ply")
first, second = names["volumes"]
ct.check(abs(first - second) < 0.05 * first, f"the mesh comes back: {names['volumes']}")
names = run("two_methods.py", "pipe_polyhedral.vtp", "pipe_implicit.vtp")
ct.check(abs(names["volumes"]["polyhedral"] - names["volumes"]["implicit"]) < 0.25 * names["volumes"]["implicit"],
         f"both methods agree: {names['volumes']}")
names = run("why_they_are_joined.py")
ct.check(len(names["joins"]) > 2 and len(names["components"]) == 2, f"a join is forbidden: {names['components']}")

square = [x for corner in ((0, 0), (20, 0), (20, 20), (0, 20)) for x in corner]
contours = [("CLOSED_PLANAR", [c for i in range(0, 8, 2) for c in (square[i], square[i + 1], z)]) for z in (0, 5, 10)]
with open("set.dcm", "wb") as file:
    file.write(rt.structure_set([(1, "Lt Lung", "ORGAN", None, contours), (2, "Iso", "", None, [])]))
names = run("regions_of_a_structure_set.py")
names["main"]("set.dcm")
ct.check(os.path.exists("Lt_Lung.stl"), f"a region has a file: {os.listdir('.')}")
found = dict(names["surfaces"]("set.dcm", ["Lt Lung"]))
volume = found["Lt Lung"].GetFieldData().GetArray("Volume").GetValue(0)
ct.check(list(found) == ["Lt Lung"] and abs(volume - 20 * 20 * 15) < 1e-3, f"half a slice is added at both ends: {volume}")
ct.check(tried == {name for name in os.listdir(EXAMPLES) if name.endswith(".py")}, f"all examples were tried: {tried}")
ct.finish()
