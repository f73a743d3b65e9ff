# SPDX-License-Identifier: GPL-3.0-or-later
"""Ranks of ParaView's MPI server for tests and benchmarks, where there are any."""
import os
import shutil
import subprocess

# Without paraview.simple the other ranks wait for ever.
PROBE = """from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
print("ranks", vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses(), flush=True)
"""


def find_ranks(folder):
    """(run, None), or (None, why there are no ranks here); run(ranks, script and options of pvbatch, arguments) -> code, text.

    As root, and with more ranks than processors; folder is for a script that tries it.
    """
    mpiexec, pvbatch = shutil.which("mpiexec"), shutil.which("pvbatch")
    if not mpiexec or not pvbatch:
        return None, f"{'pvbatch' if mpiexec else 'mpiexec'} is not installed (Debian: openmpi-bin, paraview)."
    # pvpython itself is a rank of one, which a launcher within it must not take itself for.
    outer = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment = dict(outer, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1",
                       # The sums of this library go by its threads, which are as many as the cores that a rank may use.
                       OPENBLAS_NUM_THREADS="1")

    def run(ranks, script, *arguments):
        try:
            done = subprocess.run([mpiexec, "-n", str(ranks), pvbatch, *script, *arguments], env=environment, check=False,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
        except subprocess.TimeoutExpired as late:
            return 1, f"{ranks} ranks did not come to an end: {late.stdout}"
        return done.returncode, done.stdout

    probe = os.path.join(folder, "ranksprobe.py")
    with open(probe, "w", encoding="utf-8") as file:
        file.write(PROBE)
    code, text = run(2, [probe])
    if code or "ranks 2" not in text:
        return None, f"mpiexec -n 2 pvbatch does not make two ranks here (exit code {code}): {text[-300:]}"
    return run, None
