# SPDX-License-Identifier: GPL-3.0-or-later
"""The states that `./run states` makes of the example scripts load again, with their nodes, and show something."""
import os
import runpy
import shutil

import contourtesting as ct

SCRIPT = os.path.join(ct.SOURCE, "Plugin", "commandline", "states.py")
FOLDER = ct.output("states")
NODES = {"two_methods": {"PolyhedralSurface", "ImplicitSurface", "SurfaceCertificate"}, "traces_of_a_microscope": {"ContourTableReader"},
         "why_they_are_joined": {"ContourMapping", "PolyhedralSurface"}}

simple = ct.load_plugin()
shutil.rmtree(FOLDER, ignore_errors=True)
states = runpy.run_path(SCRIPT)
ct.check(states["main"](FOLDER, ["no_such_example"]) == 1, "a name that is no example is refused")
ct.check(states["main"](FOLDER, sorted(NODES)) == 0, "states are made")
for name, wanted in NODES.items():
    simple.ResetSession()
    simple = ct.load_plugin()
    simple.LoadState(os.path.join(FOLDER, name + ".pvsm"))
    made = {source.GetXMLName() for source in simple.GetSources().values()}
    ct.check(wanted <= made, f"{name} has its nodes: {made}")
    view = simple.GetRenderViews()[0]
    shown = [r for r in view.Representations if r.Visibility]
    simple.Render(view)
    extents = [r.Input.GetDataInformation().GetNumberOfPoints() for r in shown]
    simple.Delete(view)
    ct.check(bool(extents) and min(extents) > 3, f"{name} shows its surfaces: {extents}")
ct.finish()
