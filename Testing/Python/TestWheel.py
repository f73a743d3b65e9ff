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
from vtkmodules.util.numpy_support import vtk_to_numpy

simple = ct.load_plugin()

SHARED = os.environ["CONTOUR_SHARED_DATA"]
PLACE = os.path.join(os.environ["CONTOUR_BINARY_DIR"], "Testing", "wheel")
LONGEST = 60  # seconds from pip to a surface, on a machine with nothing else to do
LARGEST = 15e6  # bytes
HERE = os.path.dirname(os.path.abspath(__file__))


def clean_environment():
    """The caller's, without what leads Python to ParaView's modules."""
    return {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LD_", "VTK"))}


def run(*command, timeout=1800):
    return subprocess.run(command, env=clean_environment(), capture_output=True, text=True, timeout=timeout)


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


def values(array):
    if array.IsA("vtkStringArray"):
        return np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())])
    return vtk_to_numpy(array)


def named(data):
    return {data.GetAbstractArray(i).GetName(): values(data.GetAbstractArray(i))
            for i in range(data.GetNumberOfArrays())}


def loops(cells):
    """Loops without the repeated first point."""
    found = []
    flat = vtk_to_numpy(cells.GetConnectivityArray())
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    for a, b in zip(offsets[:-1], offsets[1:]):
        cell = flat[a:b]
        found.append(cell[:-1] if len(cell) > 2 and cell[0] == cell[-1] else cell)
    return found


def arrays_of(case, data, result):
    """What a node made, under the names of wheelcases.py."""
    if data.GetNumberOfPoints():
        result[f"{case}/mesh/points"] = vtk_to_numpy(data.GetPoints().GetData())
    if data.GetNumberOfPolys():
        result[f"{case}/mesh/triangles"] = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    else:
        lines = loops(data.GetVerts()) + loops(data.GetLines())
        result[f"{case}/mesh/connectivity"] = np.concatenate(lines) if lines else np.empty(0)
    for kind, source in (("points", data.GetPointData()), ("cells", data.GetCellData()),
                         ("field", data.GetFieldData())):
        for name, array in named(source).items():
            result[f"{case}/{kind}/{name}"] = array


def nodes_make():
    result = {}

    def add(case, proxy):
        arrays_of(case, ct.data(proxy), result)
        return proxy

    readers = {"brain.cnt": simple.NUAGESContourReader, "branching_pipe.cnt": simple.NUAGESContourReader,
               "tamarind.csl": simple.CurveNetworkReader}
    read = {name: add(f"{name} as read", reader(FileName=ct.own(name))) for name, reader in readers.items()}
    for name, contours in read.items():
        add(f"{name} hierarchy", simple.ContourHierarchy(Input=contours))
    brain, pipe, seed = (read[name] for name in readers)
    add("brain.cnt polyhedral", simple.PolyhedralSurface(Input=brain))
    add("brain.cnt told", simple.PolyhedralSurface(Input=brain, ExpectedPieces=1, ExpectedHandles=0))
    add("brain.cnt flat", simple.PolyhedralSurface(Input=brain, EndCaps="Flat", Mapping="Proximity", PinchGap=0))
    mapping = simple.ContourMapping(Input=pipe, OverlapThreshold=0.3)
    add("branching_pipe.cnt mapping", mapping)
    for name, column in named(ct.data(mapping, 1).GetRowData()).items():
        result[f"branching_pipe.cnt joins/rows/{name}"] = column
    add("branching_pipe.cnt mapped", simple.PolyhedralSurface(Input=mapping))
    add("branching_pipe.cnt fair", simple.FairSurface(Input=pipe, EndCaps="Flat"))
    add("branching_pipe.cnt implicit", simple.ImplicitSurface(Input=pipe))
    add("branching_pipe.cnt nodes", simple.PolyhedralSurface(Input=pipe))
    add("branching_pipe.cnt nodes flat", simple.PolyhedralSurface(Input=pipe, EndCaps="Flat"))
    add("tamarind.csl implicit", simple.ImplicitSurface(Input=seed, Detail="Medium"))
    fit = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=pipe))
    add("branching_pipe.cnt traced", simple.ImplicitContours(Input=fit, Spacing=0.7))
    add("branching_pipe.cnt certificate",
        simple.SurfaceCertificate(Input=simple.PolyhedralSurface(Input=pipe), Contours=pipe))
    path = os.path.join(SHARED, "rtstruct/dicompyler_rtss.dcm")
    if os.path.exists(path):
        reader = simple.DICOMRTStructureSetReader(FileName=path)
        regions = ct.data(reader)
        for i in range(regions.GetNumberOfPartitionedDataSets()):
            block = regions.GetPartition(i, 0)
            name = block.GetFieldData().GetAbstractArray("ROIName").GetValue(0)
            arrays_of(f"rtss {name} as read", block, result)
            if name == "Lt Lung":
                lung = simple.TrivialProducer()
                lung.GetClientSideObject().SetOutput(block)
                add("rtss lung", simple.PolyhedralSurface(Input=lung))
    return result


def same(a, b):
    """Texts and whole numbers alike, numbers to the last bit. One tuple of VTK's is one array of numpy's."""
    if a.ndim == 1 and b.ndim == 2 and len(b) == 1:
        b = b[0]
    if a.shape != b.shape:
        return False
    if a.dtype.kind == "f":
        return a.tobytes() == np.ascontiguousarray(b, dtype=a.dtype).tobytes()
    return a.tolist() == b.tolist()


def compare(file, nodes, least):
    with np.load(file) as package:
        names = [name for name in package.files if name in nodes]
        for name in names:
            ct.check(same(package[name], nodes[name]),
                     f"{name}: the package makes {package[name].shape}, the node {nodes[name].shape}")
        ct.check(len(names) >= least, f"{len(names)} arrays are compared")
        print(os.path.basename(file), ":", len(names), "arrays compared, of", len(package.files))
        print("not compared:", ", ".join(sorted(set(package.files) - set(names))[:20]))


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


def check_cases(python, script, name, nodes, least):
    """What a script makes in an environment, against what the nodes make here."""
    result = os.path.join(PLACE, f"{name}.npz")
    done = run(python, os.path.join(HERE, script), result, ct.SOURCE, SHARED, *([name] if name == "pyvista" else []))
    ct.check(done.returncode == 0, f"{script} {name}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    print(done.stdout.strip()[-400:])
    if done.returncode == 0:
        compare(result, nodes, least)


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
    nodes = nodes_make()
    has_lung = any(name.startswith("rtss lung/") for name in nodes)

    python, seconds = environment("numpy", wheel)
    check_ten_lines(python, seconds)
    check_cases(python, "wheelcases.py", "numpy", nodes, 100)
    check_python_nodes(wheel, nodes)
    python, _ = environment("pyvista", wheel, "pyvista")
    check_cases(python, "wheelcases.py", "pyvista", nodes, 6)
    python, _ = environment("slicer", wheel, "slicer-core")
    check_cases(python, "slicercases.py", "slicer", nodes, 2 if has_lung else 0)
    if newer:
        python, _ = environment("vmtk", wheels[-1], "vtk", "vmtk", interpreter=newer)
        check_cases(python, "vmtkcases.py", "vmtk", nodes, 2)
    else:
        print("NOT TRIED: vmtk, for which no Python 3.12 or later was found (CONTOUR_NEWER_PYTHON)")


main()
ct.finish()
