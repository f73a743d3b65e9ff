# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of the implicit method at growing size, beside scipy and ferreus_rbf.

    ./run bench ism [--sizes 3000,10020,29700] [--distances 0.01] [--shapes ball,branching,thin] [--real lung,body,vetebrae]
                    [--no-rivals] [--evaluate N] [--surface] [--limit SECONDS] [--json FILE] [--plot FILE] [--check]

Every fit is a process of its own; times are processor and wall seconds, memory is the process's largest. The rivals, and
matplotlib for the plot, are installed into an environment in the build folder (PyPI, through pip). The quick run above takes a few
minutes; real sets alone are --shapes= --real ..., and the full run is --sizes 3000,10020,29700,100800,300000,1000000 --distances 0.01,0.003 --real lung,body,vetebrae
--evaluate 1000000 --surface.

Lines between tell how the figures compare: Automatic's choice with the faster solver, two threads with one, this plugin with ferreus_rbf,
the largest fit of a kind with the least. --check fails where one of these is worse than the limits at the head of this file.

Generated shapes have values 0, +1, -1 at a point of the surface and d inside and outside of it in its slice's plane:
ball       r = R (1 + 0.12 R sin(3t + 2z) + 0.05 R cos(5t - 4z)), R = sqrt(1 - z^2), on parallel slices
branching  a torus of 0.7 and 0.25 across its hole: one contour, two, one
thin       two faces, 0.02 apart, of z = 0.1 sin(6x) cos(5y)
Real sets have the constraints of Implicit Constraints with its defaults; their misfit is told as a part of their largest value.
"""
import argparse
import json
import os
import subprocess
import sys

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(os.environ["CONTOUR_SOURCE_DIR"], "..", "shared", "data"))
FOLDER = os.path.join(os.environ["CONTOUR_BIN_DIR"], "..", "bench-ism")
DENSE_LIMIT = 10100  # above, a dense solver takes minutes and gigabytes
TOLERANCE = 1e-5  # that fits are asked for, as a part of the largest value

# What --check holds the figures against. Times are processor seconds.
WORST_CHOICE = 1.5  # automatic : the faster solver
MISFIT_OF_REAL = 1e-4  # of the largest value
CONVERGED_RIVAL = 1e-3  # a rival that misses more has not done the work
SCALES_FROM = 25000  # constraints, above which the limits below are meant
LEAST_SPEEDUP = 1.7  # 1 thread : 2 threads, wall, of fit and evaluation
MOST_OF_RIVAL = {"fit_cpu": 0.5, "megabytes": 0.5, "evaluate_cpu": 0.33, "surface_cpu": 0.5}  # ours : ferreus_rbf, 2 threads
GROWTH_OVER = 8  # times as many constraints, from which on growth is told
WORST_GROWTH = 1.2  # exponent of the fit's time


def triples(points, normals, d):
    rows = numpy.empty((len(points), 3, 4))
    for k, (side, value) in enumerate(((0, 0.0), (-1, 1.0), (1, -1.0))):
        rows[:, k, :3] = points + side * d * normals
        rows[:, k, 3] = value
    return rows.reshape(-1, 4)


def ball(count, d):
    around = round((1.2 * count) ** 0.5)
    slices = round(count / around)
    s, k = (a.ravel() for a in numpy.meshgrid(numpy.arange(slices), numpy.arange(around), indexing="ij"))
    z, t = -0.97 + 1.94 * (s + 0.5) / slices, 2 * numpy.pi * (k + 0.5 * (s % 2)) / around
    big = numpy.sqrt(1 - z * z)
    r = big * (1 + 0.12 * big * numpy.sin(3 * t + 2 * z) + 0.05 * big * numpy.cos(5 * t - 4 * z))
    slope = big * big * (0.36 * numpy.cos(3 * t + 2 * z) - 0.25 * numpy.sin(5 * t - 4 * z))
    normal = numpy.stack([r * numpy.cos(t) + slope * numpy.sin(t), r * numpy.sin(t) - slope * numpy.cos(t), 0 * z], axis=1)
    normal /= numpy.linalg.norm(normal, axis=1)[:, None]
    return triples(numpy.stack([r * numpy.cos(t), r * numpy.sin(t), z], axis=1), normal, d)


def branching(count, d):
    ring, tube = 0.7, 0.25
    around = round((0.7 * count) ** 0.5)
    slices = round(0.62 * count / around)
    s, k = (a.ravel() for a in numpy.meshgrid(numpy.arange(slices), numpy.arange(around), indexing="ij"))
    z, a = 0.97 * (ring + tube) * (2 * (s + 0.5) / slices - 1), 2 * numpy.pi * (k + 0.5) / around
    rho, y = ring + tube * numpy.cos(a), tube * numpy.sin(a)
    keep = rho > abs(z) + 0.02
    rho, y, z = rho[keep], y[keep], z[keep]
    x = numpy.sqrt(rho ** 2 - z ** 2)
    rows = []
    for sign in (-1, 1):
        normal = numpy.stack([sign * (rho - ring) * x / rho, y, 0 * z], axis=1)
        normal /= numpy.linalg.norm(normal, axis=1)[:, None]
        rows.append(triples(numpy.stack([sign * x, y, z], axis=1), normal, d))
    return numpy.concatenate(rows)


def thin(count, d):
    side = round((count / 2) ** 0.5)
    x, y = (a.ravel() / side for a in numpy.meshgrid(numpy.arange(side), numpy.arange(side), indexing="ij"))
    z = 0.1 * numpy.sin(6 * x) * numpy.cos(5 * y)
    up = numpy.zeros((len(x), 3))
    up[:, 2] = 1
    return numpy.concatenate([triples(numpy.stack([x, y, z + h], axis=1), numpy.sign(h) * up, d) for h in (0.01, -0.01)])


SHAPES = {"ball": ball, "branching": branching, "thin": thin}
REAL = {"lung": ("rtstruct/dicompyler_rtss.dcm", "Lt Lung"), "body": ("rtstruct/dicompyler_rtss.dcm", "BODY"),
        "vetebrae": ("csl/Vetebrae.csl", None)}


def real(name):
    """Constraints with the automatic margin, or None where the data is not there."""
    from paraview import simple
    simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
    from vtkmodules.util.numpy_support import vtk_to_numpy
    file, roi = REAL[name]
    path = os.path.join(SHARED, file)
    if not os.path.exists(path):
        print(f"SKIPPED {name}: {path} is not there")
        return None
    if roi:
        reader = simple.DICOMRTStructureSetReader(FileName=path)
        reader.ROIs = [roi]
    else:
        reader = simple.CurveNetworkReader(FileName=path)
    made = simple.ImplicitConstraints(Input=reader)
    made.UpdatePipeline()
    data = made.GetClientSideObject().GetOutputDataObject(0)
    while not data.IsA("vtkPolyData"):
        data = next(data.GetPartition(i, 0) for i in range(data.GetNumberOfPartitionedDataSets())
                    if data.GetPartition(i, 0) and data.GetPartition(i, 0).GetNumberOfPoints())
    return numpy.column_stack([vtk_to_numpy(data.GetPoints().GetData()), vtk_to_numpy(data.GetPointData().GetArray("Value"))])


def environment():
    """The python of the rivals' own environment."""
    python = os.path.join(FOLDER, "venv", "bin", "python")
    if not os.path.exists(python):
        subprocess.run(["python3", "-m", "venv", os.path.join(FOLDER, "venv")], check=True)
        subprocess.run([python, "-m", "pip", "install", "-q", "scipy", "ferreus_rbf==0.3.0", "matplotlib"], check=True)
    return python


def run(command, threads, limit):
    variables = dict(os.environ, OPENBLAS_NUM_THREADS=str(threads), OMP_NUM_THREADS=str(threads),
                     RAYON_NUM_THREADS=str(threads))
    variables.pop("PYTHONPATH", None)
    try:
        done = subprocess.run(command, env=variables, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return {"failed": f"not done in {limit:.0f} s"}
    if done.returncode:
        return {"failed": (done.stderr.strip().splitlines() or ["no word"])[-1]}
    return json.loads(done.stdout.strip().splitlines()[-1])


class Bench:
    def __init__(self, options):
        self.options, self.rows, self.faults = options, [], []

    def add(self, label, scale, solver, threads, command):
        row = run(command, threads, self.options.limit)
        row.update(set=label, solver=solver, threads=threads)
        self.rows.append(row)
        if "failed" in row:
            print(f"{label:22s} {solver:10s} {threads} threads: {row['failed']}", flush=True)
            return
        row["misfit"] /= scale
        text = (f"{label:22s} {row['constraints']:8d} {solver:10s} {threads} threads  fit {row['fit_cpu']:8.2f} s cpu {row['fit_wall']:8.2f} s wall"
                f"  misfit {row['misfit']:.1e}  {row['megabytes']:6.0f} MB")
        if row.get("iterations"):
            text += f"  {row['iterations']} steps"
        if "evaluate_cpu" in row:
            text += f"  {self.options.evaluate} evaluations {row['evaluate_cpu']:.2f} s"
            text += f" (error {row['evaluate_error']:.0e})" if "evaluate_error" in row else ""
        if "surface_cpu" in row:
            text += f"  surface of {row['triangles']} triangles {row['surface_cpu']:.2f} s"
        print(text, flush=True)

    def measure(self, label, constraints):
        file = os.path.join(FOLDER, f"constraints-{os.getpid()}.bin")
        constraints.tofile(file)
        n, scale, first = len(constraints), abs(constraints[:, 3]).max(), len(self.rows)
        size = numpy.linalg.norm(constraints[:, :3].max(axis=0) - constraints[:, :3].min(axis=0))
        cell = 0.004 * size if self.options.surface else 0
        ours = [os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_ism"), file]
        extra = ["--evaluate", str(self.options.evaluate), "--surface", str(cell)]
        rival = [environment(), os.path.join(HERE, "rivals", "rbf.py"), file] if self.options.rivals else None
        if n <= DENSE_LIMIT:
            for solver in ("direct", "lu"):
                self.add(label, scale, solver, 2, ours + ["--solver", solver, "--threads", "2"])
            if rival:
                self.add(label, scale, "scipy", 2, rival + ["scipy"])
        for threads in (1, 2):
            self.add(label, scale, "iterative", threads, ours + ["--solver", "iterative", "--threads", str(threads)] + extra)
        if n <= DENSE_LIMIT:
            self.add(label, scale, "automatic", 2, ours + ["--threads", "2"])
            self.judge_choice(label, n, self.rows[first:])
        if rival:
            self.add(label, scale, "ferreus", 2, rival + ["ferreus", str(TOLERANCE * scale), str(self.options.evaluate), str(cell)])
        os.remove(file)
        if n >= SCALES_FROM:
            self.judge_scale(label, n, self.rows[first:])

    def judge_scale(self, label, n, rows):
        """The rows of one measure()."""
        one, two, rival = (next((r for r in rows if (r["solver"], r["threads"]) == key and "fit_cpu" in r), None)
                           for key in (("iterative", 1), ("iterative", 2), ("ferreus", 2)))
        if not two:
            self.faults.append(f"{label} {n}: no fit")
            return
        for what in ("fit_wall", "evaluate_wall", "surface_wall"):
            if one and what in two:
                speedup = one[what] / two[what]
                print(f"{label:22s} {n:8d} {what}: 2 threads are {speedup:.2f} times as fast as 1", flush=True)
                if speedup < LEAST_SPEEDUP and what != "surface_wall":
                    self.faults.append(f"{label} {n}: 2 threads are only {speedup:.2f} times as fast as 1 ({what})")
        converged = rival and rival["misfit"] <= CONVERGED_RIVAL
        if rival and not converged:
            print(f"{label:22s} {n:8d} ferreus has not converged: misfit {rival['misfit']:.1e}, asked for {TOLERANCE:g}", flush=True)
        for what, most in MOST_OF_RIVAL.items():
            if rival and what in two and what in rival:
                ratio = two[what] / rival[what]
                print(f"{label:22s} {n:8d} {what}: {ratio:.2f} of ferreus", flush=True)
                if converged and ratio > most:
                    self.faults.append(f"{label} {n}: {what} is {ratio:.2f} of ferreus")

    def judge_generated(self, label):
        """Fits of one kind of growing size: all converge, and time hardly grows faster than they do."""
        mine = [r for r in self.rows if (r["set"], r["solver"], r["threads"]) == (label, "iterative", 2) and "fit_cpu" in r]
        self.faults += [f"{label} {r['constraints']}: misfit {r['misfit']:.1e}" for r in mine if not r["misfit"] <= TOLERANCE]
        large = [r for r in mine if r["constraints"] >= SCALES_FROM]
        if len(large) < 2 or large[-1]["constraints"] < GROWTH_OVER * large[0]["constraints"]:
            return
        exponent = numpy.log(large[-1]["fit_cpu"] / large[0]["fit_cpu"]) / numpy.log(large[-1]["constraints"] / large[0]["constraints"])
        print(f"{label:22s} growth exponent from {large[0]['constraints']} to {large[-1]['constraints']}: {exponent:.2f}", flush=True)
        if exponent > WORST_GROWTH:
            self.faults.append(f"{label}: time grows with the power of {exponent:.2f}")

    def judge_choice(self, label, n, rows):
        """Automatic takes one of both: judged by that one's own time, so that noise between two runs of it does not count."""
        mine = {r["solver"]: r for r in rows if r["threads"] == 2 and "fit_cpu" in r}
        if not {"direct", "iterative", "automatic"} <= mine.keys():
            return
        chosen = "iterative" if mine["automatic"]["iterations"] else "direct"
        ratio = mine[chosen]["fit_cpu"] / min(mine["direct"]["fit_cpu"], mine["iterative"]["fit_cpu"])
        print(f"{label:22s} {n:8d} automatic is {chosen}: {ratio:.2f} of the faster one", flush=True)
        if ratio > WORST_CHOICE:
            self.faults.append(f"{label} {n}: automatic takes {ratio:.2f} of the faster solver's time")


def plot(rows, file):
    script = """
import json, sys
import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot
rows = json.load(sys.stdin)
names = {"iterative": "this plugin, iterative", "direct": "this plugin, direct", "lu": "LAPACK's LU", "scipy": "scipy",
         "ferreus": "ferreus_rbf 0.3.0, tuned"}
figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8))
for solver, name in names.items():
    mine = sorted((r["constraints"], r["fit_cpu"], r["megabytes"]) for r in rows
                  if r["solver"] == solver and r["threads"] == 2 and "fit_cpu" in r and r["set"].startswith("ball d=0.01"))
    if mine:
        n, cpu, memory = zip(*mine)
        axes[0].loglog(n, cpu, "o-", label=name)
        axes[1].loglog(n, memory, "o-", label=name)
axes[0].set_ylabel("processor seconds of the fit")
axes[1].set_ylabel("largest memory, MB")
for a in axes:
    a.set_xlabel("constraints")
    a.grid(True, which="both", alpha=0.3)
axes[0].legend(fontsize=8)
figure.tight_layout()
figure.savefig(sys.argv[1], dpi=110)
"""
    variables = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    subprocess.run([environment(), "-c", script, file], input=json.dumps(rows), text=True, check=True, env=variables)
    print("plot:", file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", default="3000,10020,29700")
    parser.add_argument("--distances", default="0.01")
    parser.add_argument("--shapes", default="ball,branching,thin")
    parser.add_argument("--real", default="")
    parser.add_argument("--no-rivals", dest="rivals", action="store_false")
    parser.add_argument("--evaluate", type=int, default=0)
    parser.add_argument("--surface", action="store_true")
    parser.add_argument("--limit", type=float, default=1800)
    parser.add_argument("--json")
    parser.add_argument("--plot")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    os.makedirs(FOLDER, exist_ok=True)
    bench = Bench(options)
    for shape in filter(None, options.shapes.split(",")):
        for d in map(float, options.distances.split(",")):
            for size in map(int, filter(None, options.sizes.split(","))):
                # A margin of more than half the plate would lie outside of its other face.
                margin = min(d, 0.004) if shape == "thin" else d
                bench.measure(f"{shape} d={margin:g}", SHAPES[shape](size // 3, margin))
            bench.judge_generated(f"{shape} d={margin:g}")
    for name in filter(None, options.real.split(",")):
        constraints = real(name)
        if constraints is not None:
            bench.measure(name, constraints)
            bench.faults += [f"{name}: misfit {r['misfit']:.1e} of the largest value" for r in bench.rows
                             if r["set"] == name and r["solver"] == "iterative" and not r.get("misfit", 1) <= MISFIT_OF_REAL]
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(bench.rows, file, indent=1)
    if options.plot:
        plot(bench.rows, options.plot)
    for fault in bench.faults:
        print("FAULT", fault)
    if options.check and bench.faults:
        sys.exit(1)


if __name__ == "__main__":
    main()
