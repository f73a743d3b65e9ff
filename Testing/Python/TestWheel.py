# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel on another machine, as nearly as that can be had here: fresh environments, nothing but pip.

    TestWheel.py

Builds the wheel (`./run wheel`), installs it with packages from PyPI, and is skipped where that cannot be reached:
(a) with numpy alone: the script of ten lines that Documentation/python.md shows makes a closed lung (without data of
    others: a brain), in at most a minute from the beginning of pip's work; what the package makes has, array for array, the
    bytes of what the nodes make here;
(b) with the newest PyVista, which finds the accessor without an import;
(c) beside a VTK and a vmtk, which take its surfaces; vmtk wants a newer Python than Debian 12 has: set
    CONTOUR_NEWER_PYTHON to one that is not python3.12 or later on the path; it says where there is none;
(d) with slicer-core, in which the module of 3D Slicer makes the same surfaces into segments.
And ParaView without the compiled plugin has the nodes of Plugin/python/contour_nodes.py, which make the same.
"""
import collections
import os
import shutil
import struct
import subprocess
import time

import contourtesting as ct
import numpy as np
from packagetesting import HERE, SHARED, check_cases, clean_environment, compare, nodes_make, run

simple = ct.load_plugin()

PLACE = os.path.join(os.environ["CONTOUR_BINARY_DIR"], "Testing", "wheel")
LONGEST = 60  # seconds from pip to a surface, on a machine with nothing else to do
LARGEST = 15e6  # bytes


def newer_python():
    """An interpreter that vmtk's wheels are for, or nothing."""
    for name in (os.environ.get("CONTOUR_NEWER_PYTHON", ""), "python3.12", "python3.13", "python3.14"):
        path = shutil.which(name) if name else None
        # A name on the path may be a stand-in for a version that is not installed.
        if path and run(path, "-c", "import sys, venv; sys.exit(sys.version_info < (3, 12))").returncode == 0:
            return path
    return ""


def build(*interpreters):
    """The path of a wheel for each interpreter."""
    done = run(os.path.join(ct.SOURCE, "run"), "wheel", *interpreters, timeout=3600)
    if done.returncode != 0 and "No matching distribution" in done.stderr:
        ct.skip("PyPI is not to be reached: " + done.stderr.strip()[-300:])
    ct.check(done.returncode == 0, "the wheel is built: " + done.stderr[-600:])
    return done.stdout.split() if done.returncode == 0 else []


def environment(name, *packages, interpreter=None):
    """A fresh environment with these packages, and the seconds that it took."""
    folder = os.path.join(PLACE, name)
    shutil.rmtree(folder, ignore_errors=True)
    start = time.monotonic()
    for step in ([interpreter or shutil.which("python3"), "-m", "venv", folder],
                 [os.path.join(folder, "bin/python"), "-m", "pip", "install", "--quiet", *packages]):
        done = run(*step)
        ct.check(done.returncode == 0, f"{' '.join(step)}: {done.stderr[-400:]}")
    return os.path.join(folder, "bin/python"), time.monotonic() - start


def is_closed(stl):
    with open(stl, "rb") as file:
        file.seek(80)
        count = struct.unpack("<I", file.read(4))[0]
        rows = np.frombuffer(file.read(), dtype=[("n", "<f4", 3), ("c", "<f4", (3, 3)), ("a", "<u2")])
    ct.check(len(rows) == count and count > 10000, f"the file has {count} triangles")
    edges = collections.Counter()
    for triangle in rows["c"]:
        corners = [corner.tobytes() for corner in triangle]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edges[a, b] += 1
            edges[b, a] -= 1
    return not any(edges.values())


def check_python_nodes(wheel, nodes):
    """The plugin of one Python file, in a ParaView without the compiled one."""
    folder = os.path.join(PLACE, "target")
    shutil.rmtree(folder, ignore_errors=True)
    done = run(shutil.which("python3"), "-m", "pip", "install", "--quiet", "--no-deps", "--target", folder, wheel)
    ct.check(done.returncode == 0, f"pip install --target: {done.stderr[-400:]}")
    environment = {**clean_environment(), "PYTHONPATH": HERE}
    done = subprocess.run([shutil.which("pvpython"), "--force-offscreen-rendering",
                           os.path.join(HERE, "TestPythonNodes.py"), folder], env=environment, capture_output=True,
                          text=True, timeout=600)
    ct.check(done.returncode == 0, f"TestPythonNodes.py: {done.stdout}{done.stderr}")
    compare(ct.output("python_nodes.npz"), nodes, 6)


def check_ten_lines(python, seconds):
    """The script of the documentation, by somebody who has just begun to install."""
    lung = os.path.join(SHARED, "rtstruct/dicompyler_rtss.dcm")
    stl = os.path.join(PLACE, "surface.stl")
    drawn = [lung, stl, "Lt Lung"] if os.path.exists(lung) else [ct.own("brain.cnt"), stl]
    start = time.monotonic()
    done = run(python, os.path.join(ct.SOURCE, "Documentation/example/lung.py"), *drawn)
    seconds += time.monotonic() - start
    ct.check(done.returncode == 0 and "Sound: closed" in done.stdout, f"the ten lines work: {done.stdout}{done.stderr}")
    ct.check(is_closed(stl), "the surface is closed")
    print(f"from pip install to a closed {drawn[2] if len(drawn) > 2 else 'brain'}: {seconds:.1f} s "
          f"(at most {LONGEST} on a quiet machine)")
    ct.check(seconds <= LONGEST or os.getloadavg()[0] > (os.cpu_count() or 1), f"it takes {seconds:.0f} s")


def main():
    newer = newer_python()
    wheels = build(shutil.which("python3"), *([newer] if newer else []))
    if not wheels:
        return
    for each in wheels:
        size = os.path.getsize(each)
        print(f"{os.path.basename(each)} has {size / 1e6:.1f} MB")
        ct.check(size <= LARGEST, f"the wheel has {size} bytes")
    wheel = wheels[0]
    os.makedirs(PLACE, exist_ok=True)
    nodes = nodes_make(simple)
    has_lung = any(name.startswith("rtss lung/") for name in nodes)

    python, seconds = environment("numpy", wheel)
    check_ten_lines(python, seconds)
    check_cases(python, "wheelcases.py", os.path.join(PLACE, "numpy.npz"), nodes, 100)
    check_python_nodes(wheel, nodes)
    python, _ = environment("pyvista", wheel, "pyvista")
    check_cases(python, "wheelcases.py", os.path.join(PLACE, "pyvista.npz"), nodes, 6, "pyvista")
    python, _ = environment("slicer", wheel, "slicer-core")
    check_cases(python, "slicercases.py", os.path.join(PLACE, "slicer.npz"), nodes, 2 if has_lung else 0)
    if newer:
        python, _ = environment("vmtk", wheels[-1], "vtk", "vmtk", interpreter=newer)
        check_cases(python, "vmtkcases.py", os.path.join(PLACE, "vmtk.npz"), nodes, 2)
    else:
        print("NOT TRIED: vmtk, for which no Python 3.12 or later was found (CONTOUR_NEWER_PYTHON)")


main()
ct.finish()
