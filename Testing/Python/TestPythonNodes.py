# SPDX-License-Identifier: GPL-3.0-or-later
"""The nodes over the Python package, in a pvpython that has not loaded the compiled plugin.

    TestPythonNodes.py FOLDER     (FOLDER: where pip has installed the wheel, without what it depends on)

TestWheel.py runs it. Writes the arrays of what the nodes make as an .npz, for TestWheel.py to compare with those of the
compiled nodes.
"""
import inspect
import os
import sys

# Debian 12 has ParaView 5.11 with Python 3.11, which lacks what ParaView's own module for such plugins imports.
inspect.getargspec = getattr(inspect, "getargspec", inspect.getfullargspec)
sys.path.insert(0, sys.argv[1])

import contourtesting as ct
import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import contour_reconstruction as cr

simple.LoadPlugin(os.path.join(ct.SOURCE, "Plugin/python/contour_nodes.py"), remote=False, ns=globals())

pipe = cr.read(ct.own("branching_pipe.cnt"))
source = simple.TrivialProducer()
source.GetClientSideObject().SetOutput(ct.closed_polylines([loop.tolist() for loop in pipe]))
arrays = {}


def keep(case, proxy):
    data = ct.data(proxy)
    ct.check(data.GetNumberOfPolys() > 0, f"{case}: there is a surface")
    if data.GetNumberOfPolys():
        arrays[f"{case}/mesh/points"] = vtk_to_numpy(data.GetPoints().GetData())
        arrays[f"{case}/mesh/triangles"] = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return proxy


surface = keep("branching_pipe.cnt nodes", PolyhedralSurface(Input=source))  # noqa: F821
ct.check(surface.EndCaps == "Tapered" and surface.OverlapThreshold == 0.1, "the defaults are those of the nodes")
flat = keep("branching_pipe.cnt nodes flat", PolyhedralSurface(Input=source, EndCaps="Flat"))  # noqa: F821
fair = keep("branching_pipe.cnt fair", FairSurface(Input=source, EndCaps="Flat"))  # noqa: F821
ct.check(fair.Tolerance == -1 and fair.Tension == -1, "what is automatic is so by default")
keep("branching_pipe.cnt implicit", ImplicitSurface(Input=source))  # noqa: F821
judged = ct.data(SurfaceCertificate(Input=surface, Contours=source))  # noqa: F821
words = judged.GetFieldData().GetAbstractArray("Certificate")
ct.check(words is not None and "Sound" in words.GetValue(0), "the certificate says that it is sound")
volume = judged.GetFieldData().GetArray("Volume").GetValue(0)
ct.check(volume > 0, f"and has a volume, {volume}")
print("The sentence that follows is asked for:")
wrong = ct.data(PolyhedralSurface(Input=simple.Sphere()))  # noqa: F821
ct.check(wrong.GetNumberOfCells() == 0, "a surface for contours gives a sentence and nothing else")
np.savez(ct.output("python_nodes.npz"), **arrays)
ct.finish()
