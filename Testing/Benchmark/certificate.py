# SPDX-License-Identifier: GPL-3.0-or-later
"""How long Surface Certificate takes, next to ParaView's own surface normals filter in the same run.

    ./run bench            (or: pvpython certificate.py [million triangles] [--check])

Wall time, the best of three; progress is observed, as it is in ParaView. With --check the exit code says whether
the certificate took less than ten times as long and heard an abort within half a second.
"""
import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource

NUMBERS = [a for a in sys.argv[1:] if not a.startswith("-")]
MILLIONS = float(NUMBERS[0]) if NUMBERS else 1.0


def make_surface():
    """A closed ball of about that many triangles, each side of it some 700 across for a million."""
    side = int((MILLIONS * 1e6 / 2) ** 0.5)
    source = vtkSphereSource()
    source.SetThetaResolution(side)
    source.SetPhiResolution(side + 2)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def seconds_of(algorithm):
    best = float("inf")
    for _ in range(3):
        algorithm.Modified()
        start = time.perf_counter()
        algorithm.Update()
        best = min(best, time.perf_counter() - start)
    return best


def seconds_to_abort(algorithm):
    """From the request, made at the first progress beyond a half, to the return."""
    asked = []

    def ask(caller, _):
        if caller.GetProgress() > 0.5 and not asked:
            asked.append(time.perf_counter())
            caller.SetAbortExecute(1)

    tag = algorithm.AddObserver("ProgressEvent", ask)
    algorithm.Modified()
    algorithm.Update()
    end = time.perf_counter()
    algorithm.RemoveObserver(tag)
    return end - asked[0] if asked else float("inf")


surface = make_surface()
normals = vtkPolyDataNormals()
normals.SetInputData(surface)
producer = simple.TrivialProducer()
producer.GetClientSideObject().SetOutput(surface)
certificate = simple.SurfaceCertificate(Input=producer).GetClientSideObject()
reports = []
certificate.AddObserver("ProgressEvent", lambda caller, _: reports.append(caller.GetProgress()))

normals_time = seconds_of(normals)
certificate_time = seconds_of(certificate)
sound = certificate.GetOutputDataObject(0).GetFieldData().GetArray("Sound").GetTuple1(0)
abort_time = seconds_to_abort(certificate)
ratio = certificate_time / normals_time
print(f"Surface Certificate, {surface.GetNumberOfCells()} triangles: {certificate_time:.2f} s, "
      f"vtkPolyDataNormals: {normals_time:.2f} s, ratio {ratio:.2f} (to be below 10); "
      f"{len(reports) // 3} progress events a run, abort heard after {abort_time:.2f} s")
sys.stdout.flush()
if "--check" in sys.argv:
    sys.exit(0 if sound == 1 and ratio < 10 and abort_time < 0.5 and len(reports) > 30 else 1)
