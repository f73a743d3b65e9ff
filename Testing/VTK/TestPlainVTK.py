# SPDX-License-Identifier: GPL-3.0-or-later
"""The modules in VTK's own Python, without ParaView.

    TestPlainVTK.py SOURCE
"""
import importlib
import os
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkObject, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter

SOURCE = sys.argv[1]
MODULES = ("BRepReaders", "ContourFilters", "CurveNetworkReaders", "DICOMReaders", "ImplicitFilters", "NUAGESReaders",
           "PolyhedralFilters", "STLWriters", "TraceReaders")
LEAST_CLASSES = 26
FLAT = 0  # the choice of EndCaps
SAME_VOLUME = 1e-6  # relative; VTK has a sum of its own
LIKE_VOLUME = 0.1  # relative, of the three methods among each other
modules = {name: importlib.import_module(f"contourreconstruction.{name}") for name in MODULES}
failures = []


def check(condition, sentence):
    if not condition:
        failures.append(sentence)
        print("FAILED:", sentence)


def data(name):
    return os.path.join(SOURCE, "Data", name)


def classes():
    """Every class that a user can make is made, printed, and has a help text."""
    count = 0
    for module in modules.values():
        for name in sorted(vars(module)):
            kind = getattr(module, name)
            if not name.startswith("vtk") or not isinstance(kind, type) or not issubclass(kind, vtkObject):
                continue
            try:
                made = kind()
            except (TypeError, NotImplementedError):  # an abstract base
                continue
            count += 1
            check(made.IsA(name) and name in str(made), f"{name} is made and printed")
            check(not made.IsA("vtkAlgorithm") or isinstance(made, vtkAlgorithm), f"{name} is an algorithm of this VTK")
    check(count >= LEAST_CLASSES, f"{count} classes are made")
    return count


def read(name):
    reader = modules["NUAGESReaders"].vtkNUAGESReader()
    reader.SetFileName(data(name))
    reader.Update()
    check(reader.GetOutput().GetNumberOfCells() > 0, f"{name} has contours")
    return reader


def open_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def volume(surface):
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    return mass.GetVolume()


def certified(contours, surface):
    """The certificate's own figures, by name."""
    judge = modules["ContourFilters"].vtkSurfaceCertificate()
    judge.SetInputData(0, surface)
    judge.SetInputConnection(1, contours.GetOutputPort())
    judge.Update()
    field = judge.GetOutput().GetFieldData()
    return field.GetAbstractArray("Certificate").GetValue(0), field.GetArray("Volume").GetValue(0)


def surface_of(method, contours):
    """What a method makes, closed and sound."""
    method.SetInputConnection(contours.GetOutputPort())
    method.Update()
    name, surface = method.GetClassName(), vtkPolyData()
    surface.DeepCopy(method.GetOutput())
    check(surface.GetNumberOfPolys() > 100, f"{name}: there is a surface")
    check(open_edges(surface) == 0, f"{name}: no edge is open")
    words, sum_of_ours = certified(contours, surface)
    check(words.startswith("Sound: closed"), f"{name}: {words}")
    check(abs(volume(surface) / sum_of_ours - 1) < SAME_VOLUME, f"{name}: {volume(surface)} and {sum_of_ours}")
    return surface


def written(surface):
    """VTK's own writer and reader get it, too."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "surface.stl")
        writer = vtkSTLWriter()
        writer.SetInputData(surface)
        writer.SetFileName(path)
        check(writer.Write() == 1, "VTK writes it")
        reader = vtkSTLReader()
        reader.SetFileName(path)
        reader.Update()
        check(reader.GetOutput().GetNumberOfPolys() == surface.GetNumberOfPolys(), "VTK reads what it has written")


def refuses():
    """A bad input is an error event with a sentence, and an empty output; Python goes on."""
    heard = []
    reader = modules["NUAGESReaders"].vtkNUAGESReader()
    reader.AddObserver("ErrorEvent", lambda caller, event: heard.append(event))
    reader.SetFileName(data("nothing.cnt"))
    reader.Update()
    check(heard == ["ErrorEvent"] and reader.GetOutput().GetNumberOfPoints() == 0, f"a missing file is an error: {heard}")


print("VTK", vtkVersion.GetVTKVersion(), "with", classes(), "classes")
pipe = read("branching_pipe.cnt")
volumes = []
for module, name in (("PolyhedralFilters", "vtkPolyhedralSurface"), ("PolyhedralFilters", "vtkFairSurface"),
                     ("ImplicitFilters", "vtkImplicitSurface")):
    method = getattr(modules[module], name)()
    # All end at the first and the last slice.
    if method.IsA("vtkImplicitSurface"):
        method.SetEndsBeyond(0)
    else:
        method.SetEndCaps(FLAT)
    surface = surface_of(method, pipe)
    volumes.append(volume(surface))
print("volumes of the three methods:", volumes)
check(max(volumes) / min(volumes) - 1 < LIKE_VOLUME, f"the three methods differ: {volumes}")
written(surface_of(modules["PolyhedralFilters"].vtkPolyhedralSurface(), read("brain.cnt")))
refuses()
sys.exit(1 if failures else 0)
