# SPDX-License-Identifier: GPL-3.0-or-later
"""The example of Documentation/example is a stranger's project: it uses what is installed, and no ParaView.

Arguments: source directory, build directory. Installs the build's development files into a new place, builds the
example against them with neither ParaView nor VTK to be found, reconstructs Data/brain.cnt with it, and counts the
edges of the .stl that comes out.
"""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import house

SOURCE, BINARY = house.root(), pathlib.Path(sys.argv[2])
wrong = []


def check(condition, sentence):
    print("ok" if condition else "FAILED", sentence)
    if not condition:
        wrong.append(sentence)


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    if done.returncode:
        sys.exit(f"{done.stdout}\nFAILED: {' '.join(map(str, command))}")
    return done.stdout


def install(prefix):
    run("cmake", "--install", BINARY, "--prefix", prefix, "--component", "Development")
    headers = {path.relative_to(prefix).as_posix() for path in prefix.rglob("*.h")}
    check("include/ContourReconstruction/Contours/ContourSet.h" in headers, "headers have a folder of their own")
    check("include/ContourReconstruction/NUAGES/NUAGESParser.h" in headers, "the parsers' headers are there, too")
    includes = [line for path in prefix.rglob("*.h") for line in path.read_text(encoding="utf-8").splitlines()
                if line.startswith("#include")]
    check(not any("vtk" in line for line in includes), "none of them includes one of VTK")
    for file in prefix.rglob("*.cmake"):
        text = file.read_text(encoding="utf-8")
        check(str(SOURCE) not in text and str(BINARY) not in text, f"{file.name} names no place of this build")


def check_exceptions(prefix):
    """Each library of a program that links the core throws, and catches, one and the same type."""
    [library] = prefix.rglob("libContourCore.a")
    symbols = run("readelf", "-sW", library)
    for name in ("Error", "Aborted"):
        entries = re.findall(rf".* _ZTIN5recon{len(name)}{name}E$", symbols, flags=re.MULTILINE)
        check(entries and all(" DEFAULT " in entry for entry in entries), f"the type of {name} is visible")


def build(prefix, place):
    lines = (SOURCE / "Documentation/example/CMakeLists.txt").read_text(encoding="utf-8").splitlines()
    check(len(lines) <= 10, f"the example's CMakeLists.txt has {len(lines)} lines, ten at most")
    log = run("cmake", "-G", "Ninja", "-S", SOURCE / "Documentation/example", "-B", place,
              f"-DCMAKE_PREFIX_PATH={prefix}",
              "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS={os.environ.get('CONTOUR_CXX_FLAGS', '')}",
              "-DCMAKE_DISABLE_FIND_PACKAGE_ParaView=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON")
    # CMake says of a variable that nothing asked for it: nobody looks for ParaView or VTK.
    check("CMAKE_DISABLE_FIND_PACKAGE_ParaView" in log and "CMAKE_DISABLE_FIND_PACKAGE_VTK" in log,
          "nobody asks for ParaView or VTK")
    run("cmake", "--build", place)
    return place / "brain-surface"


def check_surface(file):
    corners = re.findall(r"^vertex (.*)$", file.read_text(encoding="ascii"), flags=re.MULTILINE)
    triangles = [corners[i:i + 3] for i in range(0, len(corners), 3)]
    edges = collections.Counter()
    for a, b, c in triangles:
        edges.update({(a, b): 1, (b, c): 1, (c, a): 1})
    check(len(triangles) > 10000, f"the brain has {len(triangles)} triangles")
    check(all(edges[b, a] == count for (a, b), count in edges.items()), "each edge is met by its opposite: closed")


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        install(folder / "prefix")
        check_exceptions(folder / "prefix")
        program = build(folder / "prefix", folder / "build")
        words = run(program, SOURCE / "Data/brain.cnt", folder / "brain.stl")
        print(words)
        check("Sound: closed, manifold" in words, "the surface is sound")
        check_surface(folder / "brain.stl")
        done = subprocess.run([program, "nothing.cnt", folder / "nothing.stl"], capture_output=True, text=True,
                              check=False)
        check(done.returncode == 1 and "nothing.cnt" in done.stderr, f"a missing file is a sentence: {done.stderr}")
    house.end(wrong, 1)


main()
