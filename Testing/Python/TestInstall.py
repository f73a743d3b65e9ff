# SPDX-License-Identifier: GPL-3.0-or-later
"""An installed plugin loads from its new place through PV_PLUGIN_PATH, and brings its command line along."""
import glob
import os
import shutil
import subprocess
import tempfile

import contourtesting as ct

# Outside the build tree, so that a path says where a library comes from.
place = tempfile.TemporaryDirectory()
prefix = os.path.join(place.name, "prefix")
run = subprocess.run(["cmake", "--install", os.environ["CONTOUR_BINARY_DIR"], "--prefix", prefix],
                     capture_output=True, text=True)
ct.check(run.returncode == 0, f"cmake --install: {run.stderr}")
plugins = glob.glob(os.path.join(prefix, "lib*", "**", "ContourReconstruction.so"), recursive=True)
ct.check(len(plugins) == 1, f"one plugin is installed: {plugins}")

# Nothing of the build tree may be needed: ask the loader for what it really opens.
environment = {k: v for k, v in os.environ.items() if k not in ("CONTOUR_PLUGIN", "PYTHONPATH")}
for library in glob.glob(os.path.join(os.path.dirname(plugins[0]), "*.so")):
    needed = subprocess.run(["ldd", library], capture_output=True, text=True, env=environment).stdout
    ct.check("not found" not in needed, f"{library} finds all it needs: {needed}")
    # The prefix itself lies in the build tree.
    elsewhere = needed.replace(os.path.realpath(prefix), "").replace(prefix, "")
    ct.check(os.environ["CONTOUR_BINARY_DIR"] not in elsewhere, f"{library} needs nothing of the build tree")

script = ct.output("use_installed.py")
with open(script, "w", encoding="ascii") as file:
    file.write("""from paraview import simple
node = simple.PolyhedralSurface()
print("MADE", node.GetXMLLabel(), node.InternalPoints)
""")
environment["PV_PLUGIN_PATH"] = os.path.dirname(plugins[0])
run = subprocess.run([shutil.which("pvpython"), "--force-offscreen-rendering", script], capture_output=True,
                     text=True, env=environment)
ct.check("MADE Polyhedral Surface 1" in run.stdout, f"PV_PLUGIN_PATH makes the nodes known: {run.stdout} {run.stderr}")

program = os.path.join(prefix, "bin", "contour-reconstruct")
surface = ct.output("installed.vtp")
if os.path.exists(surface):
    os.remove(surface)
run = subprocess.run([program, ct.own("branching_pipe.cnt"), surface], capture_output=True, text=True,
                     env=environment)
ct.check(run.returncode == 0 and os.path.exists(surface), f"contour-reconstruct works: {run.stdout} {run.stderr}")
ct.finish()
