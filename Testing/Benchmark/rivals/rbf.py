# SPDX-License-Identifier: GPL-3.0-or-later
"""One fit by another library, in a process of its own: rbf.py FILE scipy|ferreus [TOLERANCE EVALUATIONS CELLSIZE].

FILE as for bench_ism; the answer is a line of JSON with the same names. ism.py runs it in an environment of the bench's own.
ferreus_rbf is tuned: with its defaults it does not converge on contours.
"""
import json
import sys
import time

import numpy


class Watch:
    def __init__(self):
        self.wall, self.cpu = time.perf_counter(), time.process_time()

    def read(self, name):
        return {name + "_wall": time.perf_counter() - self.wall, name + "_cpu": time.process_time() - self.cpu}


def megabytes():
    """The largest memory of this program alone; resource's figure is also that of whoever started it."""
    with open("/proc/self/status", encoding="ascii") as file:
        return next(int(line.split()[1]) / 1024 for line in file if line.startswith("VmHWM"))


def spread(points, count):
    """The same points as bench_ism's: Halton's sequence in the bounding box."""
    columns = []
    for base in (2, 3, 5):
        k, place, part = numpy.arange(1, count + 1), numpy.zeros(count), 1.0
        while k.any():
            part /= base
            place += part * (k % base)
            k //= base
        columns.append(place)
    low, high = points.min(axis=0), points.max(axis=0)
    return low + (high - low) * numpy.stack(columns, axis=1)


def fit_scipy(points, values):
    from scipy.interpolate import RBFInterpolator
    watch = Watch()
    made = RBFInterpolator(points, values, kernel="cubic", degree=1)
    result = watch.read("fit")
    result["megabytes"] = megabytes()
    result["misfit"] = float(abs(made(points) - values).max())
    return result


def fit_ferreus(points, values, tolerance, evaluations, cell):
    from ferreus_rbf import RBFInterpolator
    from ferreus_rbf.config import DDMParams, Params, SizePolicy, Solvers
    from ferreus_rbf.interpolant_config import (Drift, FittingAccuracy, FittingAccuracyType, InterpolantSettings,
                                                RBFKernelType)
    settings = InterpolantSettings(RBFKernelType.Cubic, drift=Drift.Linear,
                                   fitting_accuracy=FittingAccuracy(tolerance, FittingAccuracyType.Relative))
    params = Params(RBFKernelType.Cubic, solver_type=Solvers.FGMRES,
                    ddm_params=DDMParams(1024, 64, 128, SizePolicy.Fixed(4096)))
    watch = Watch()
    made = RBFInterpolator(points, values[:, None], settings, params=params)
    result = watch.read("fit")
    result["megabytes"] = megabytes()
    result["misfit"] = float(abs(made.evaluate_at_source().ravel() - values).max())
    if evaluations:
        targets = spread(points, evaluations)
        watch = Watch()
        made.evaluate(targets)
        result.update(watch.read("evaluate"))
    if cell:
        low, high = points.min(axis=0), points.max(axis=0)
        margin = 0.1 * numpy.linalg.norm(high - low)
        watch = Watch()
        mesh = made.build_isosurface(numpy.concatenate([low - margin, high + margin]), cell, 0.0)
        result.update(watch.read("surface"))
        result["triangles"] = len(mesh.facets)
    return result


def main():
    data = numpy.fromfile(sys.argv[1]).reshape(-1, 4)
    # Of constraints in one place ferreus_rbf keeps one, and answers for that alone.
    first = numpy.sort(numpy.unique(data[:, :3], axis=0, return_index=True)[1])
    data = data[first]
    points, values = numpy.ascontiguousarray(data[:, :3]), numpy.ascontiguousarray(data[:, 3])
    if sys.argv[2] == "scipy":
        result = fit_scipy(points, values)
    else:
        tolerance, evaluations, cell = float(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5])
        result = fit_ferreus(points, values, tolerance, evaluations, cell)
    print(json.dumps(dict(constraints=len(values), **result)))


main()
