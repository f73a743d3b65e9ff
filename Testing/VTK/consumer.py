# SPDX-License-Identifier: GPL-3.0-or-later
"""Documentation/example-vtk is a stranger's project over the installed VTK modules: it builds, and makes a closed brain.

    consumer.py SOURCE BINARY
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE, BINARY = map(pathlib.Path, sys.argv[1:3])
LEAST_TRIANGLES = 10000


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    if done.returncode:
        sys.exit(f"{done.stdout}\nFAILED: {' '.join(map(str, command))}")
    return done.stdout


def check_closed(stl):
    """Each edge of the triangles is met by its opposite."""
    corners = re.findall(r"^\s*vertex (.*)$", stl.read_text(encoding="ascii"), flags=re.MULTILINE)
    edges = collections.Counter()
    for i in range(0, len(corners), 3):
        a, b, c = corners[i:i + 3]
        edges.update({(a, b): 1, (b, c): 1, (c, a): 1})
    if len(corners) < 3 * LEAST_TRIANGLES:
        sys.exit(f"FAILED: the brain has {len(corners) // 3} triangles.")
    if any(edges[b, a] != count for (a, b), count in edges.items()):
        sys.exit("FAILED: the brain is not closed.")


with tempfile.TemporaryDirectory() as folder:
    place = pathlib.Path(folder)
    run("cmake", "--install", BINARY, "--prefix", place / "prefix")
    for config in (place / "prefix").rglob("*.cmake"):
        text = config.read_text(encoding="utf-8")
        if str(SOURCE) in text or str(BINARY) in text:
            sys.exit(f"FAILED: {config.name} names a place of this build.")
    run("cmake", "-S", SOURCE / "Documentation/example-vtk", "-B", place / "build",
        f"-DCMAKE_PREFIX_PATH={place / 'prefix'}", "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", place / "build")
    run(place / "build/vtk-surface", SOURCE / "Data/brain.cnt", place / "brain.stl")
    check_closed(place / "brain.stl")
    missing = subprocess.run([place / "build/vtk-surface", "nothing.cnt", place / "nothing.stl"], check=False,
                             capture_output=True)
    if missing.returncode == 0:
        sys.exit("FAILED: a missing file is no error.")
print("A stranger's program is built and run.")
