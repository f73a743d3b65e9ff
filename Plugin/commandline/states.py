# SPDX-License-Identifier: GPL-3.0-or-later
"""The example scripts' pipelines as states for File > Load State; run it as `./run states`.

    states.py FOLDER [NAME ...]      (in pvpython, with the plugin's path in CONTOUR_PLUGIN and a display)

Runs each script of Documentation/examples (those named, or all that need no file) in FOLDER, shows the ends of its pipeline in a render
view and leaves FOLDER/NAME.pvsm. A state holds the absolute paths of its files and the properties of the ParaView that saved it, so it is made
where it is used. Exit code 1: a name that is no example.
"""
import os
import runpy
import sys

from paraview import simple

EXAMPLES = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "examples"))
NEEDS_A_FILE = {"regions_of_a_structure_set"}
COLOURS = ([0.93, 0.74, 0.68], [0.62, 0.74, 0.90], [0.75, 0.86, 0.66])


def ends(sources):
    """What no other node takes in."""
    taken = set()
    for source in sources:
        for name in ("Input", "Contours"):
            if name in source.ListProperties() and source.GetProperty(name):
                taken.add(source.GetProperty(name)[0].GetGlobalIDAsString())
    return [source for source in sources if source.GetGlobalIDAsString() not in taken]


def shown_in(view, sources):
    for i, source in enumerate(sources):
        display = simple.Show(source, view)
        display.ColorArrayName = ["POINTS", ""]
        display.AmbientColor = display.DiffuseColor = COLOURS[i % len(COLOURS)]
    simple.ResetCamera(view)
    simple.Render(view)


def save(name, folder):
    simple.ResetSession()
    simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
    runpy.run_path(os.path.join(EXAMPLES, name + ".py"), run_name="__main__")
    view = simple.CreateView("RenderView")
    view.ViewSize = [900, 600]
    shown_in(view, ends(list(simple.GetSources().values())))
    path = os.path.join(folder, name + ".pvsm")
    simple.SaveState(path)
    simple.Delete(view)  # or its window outlives the session, and ends the process in an X error
    return path


def main(folder, names):
    known = sorted(os.path.splitext(file)[0] for file in os.listdir(EXAMPLES) if file.endswith(".py"))
    unknown = [name for name in names if name not in known]
    if unknown:
        print(f"There is no example {unknown[0]}; there are {', '.join(known)}.", file=sys.stderr)
        return 1
    folder = os.path.abspath(folder)
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)  # what the scripts write
    for name in names or [name for name in known if name not in NEEDS_A_FILE]:
        print(save(name, folder), flush=True)
    if not names:
        print(f"Without a state, as they need a file of yours: {', '.join(sorted(NEEDS_A_FILE))}.", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
