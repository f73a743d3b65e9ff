# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python package have in common: what the nodes make of the cases of wheelcases.py, and a comparison.

Arrays have the names that wheelcases.py gives them, "case/kind/array".
"""
import os
import subprocess

import contourtesting as ct
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

SHARED = os.environ["CONTOUR_SHARED_DATA"]
HERE = os.path.dirname(os.path.abspath(__file__))


def clean_environment(**more):
    """The caller's, without what leads Python to ParaView's modules, and with some more."""
    return {**{k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LD_", "VTK"))}, **more}


def run(*command, timeout=1800, **more):
    return subprocess.run(command, env=clean_environment(**more), capture_output=True, text=True, timeout=timeout)


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


def nodes_make(simple, shared=SHARED):
    """Every array by its name; without a folder of shared data, those of the project's own."""
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
    add("branching_pipe.cnt told", simple.PolyhedralSurface(Input=pipe, ExpectedPieces=1, ExpectedHandles=0))
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
    path = os.path.join(shared, "rtstruct/dicompyler_rtss.dcm")
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


def check_cases(python, script, result, nodes, least, *arguments, shared=SHARED, **more):
    """What a script makes by an interpreter, in an environment with some more, against what the nodes make here."""
    done = run(python, os.path.join(HERE, script), result, ct.SOURCE, shared, *arguments, **more)
    ct.check(done.returncode == 0, f"{script}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    print(done.stdout.strip()[-400:])
    if done.returncode == 0:
        compare(result, nodes, least)
