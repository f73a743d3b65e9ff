# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes that clang-tidy finds (the short list in .clang-tidy) in the core and the parsers.

    clang_tidy.py SOURCE_DIR BINARY_DIR [--all]

Without --all: the few that were changed last, of those that take it no more than two or three seconds each, as they include
nothing of CGAL, Eigen or DCMTK. All of them in the slow tests.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import house

FEW = 3
HEAVY = re.compile(r"#include <(CGAL|Eigen|dcmtk)/")


def sources(binary):
    """What the build compiles of the core and the parsers, in order."""
    with open(binary / "compile_commands.json", encoding="utf-8") as stream:
        compiled = {pathlib.Path(entry["file"]).resolve() for entry in json.load(stream)}
    return [path for path in house.files(".cxx", folders=("Filters/Core", "Readers")) if path in compiled]


def includes(path, seen):
    """Whether a file, or one of ours that it includes, includes something heavy."""
    if path in seen or not path.is_file():
        return False
    seen.add(path)
    text = path.read_text(encoding="utf-8")
    ours = (folder / name for name in re.findall(r'#include "([^"]+)"', text)
            for folder in (house.root() / "Filters" / "Core", house.root() / "Readers"))
    return bool(HEAVY.search(text)) or any(includes(other, seen) for other in ours)


def main():
    program = house.tool("clang-tidy")
    binary = pathlib.Path(sys.argv[2])
    if not (binary / "compile_commands.json").is_file():
        house.skip("this build wrote no compile_commands.json, so nothing was checked.")
    chosen = sources(binary)
    if "--all" not in sys.argv:
        light = [path for path in chosen if not includes(path, set())]
        chosen = sorted(light, key=lambda path: -path.stat().st_mtime)[:FEW]

    def judge(path):
        done = subprocess.run([program, "--quiet", "-p", str(binary), str(path)], capture_output=True, text=True, cwd=house.root(),
                              check=False)
        return [] if done.returncode == 0 else [line for line in done.stdout.splitlines() if re.search(r": (error|warning): ", line)] or [
            f"{house.name(path)}: clang-tidy fails: {done.stderr.strip()[-300:]}"]

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = sorted({line for lines in pool.map(judge, chosen) for line in lines})
    house.end(wrong, len(chosen))


main()
