# SPDX-License-Identifier: GPL-3.0-or-later
"""What `./run bench constants` stands on: the copy of the core differs from the core in its constants alone, and the page says of
made-up runs what is so of them. Every constant of the core has a word beside or above it that says what it is."""
import pathlib
import re
import subprocess
import sys
import tempfile

import house

BENCHMARK = house.root() / "Testing" / "Benchmark"
sys.path.insert(0, str(BENCHMARK))
import constants

CORE = house.root() / "Filters" / "Core"
ADDED = re.compile(r"^(\s*)(?:static |inline )*const (?:auto|[\w:]+)& (\w+) = variables::Add\w*<.*?>\(\"([^\"]+)\", \"(\w+)\", (.*)\);")
LEAST_VARIABLES = 150


def plain(line):
    """A line without what tells a constant from a variable, however it was declared."""
    found = ADDED.match(line)
    if found:
        return found.group(2) + re.sub(r"[\s{}]", "", found.group(5))
    found = re.match(r"^\s*(?:static |inline )?constexpr [\w:]+ (\w+)(?:\[\])?(?: = |\{ )(.*?)\s*\}?;", line)
    if found:
        return found.group(1) + re.sub(r"[\s{}]", "", found.group(2))
    return line.replace("constexpr std::array", "const std::array")


def copied(wrong):
    with tempfile.TemporaryDirectory() as place:
        subprocess.run([sys.executable, str(BENCHMARK / "constants" / "variables.py"), str(CORE), place], check=True)
        variables = 0
        for path in sorted(CORE.rglob("*")):
            if path.suffix not in (".h", ".cxx"):
                continue
            ours = path.read_text(encoding="utf-8").split("\n")
            made = (pathlib.Path(place) / path.relative_to(CORE)).read_text(encoding="utf-8").split("\n")
            variables += sum("variables::Add" in line for line in made)
            made = [line for line in made if line != '#include "Variable.h"']
            wrong += [f"{house.name(path)}: the copy has '{theirs}' for '{line}'."
                      for line, theirs in zip(ours, made) if plain(line) != plain(theirs)]
            wrong += [f"{house.name(path)}: the copy has {len(made)} lines for {len(ours)}."] * (len(made) != len(ours))
        if variables < LEAST_VARIABLES:
            wrong.append(f"Only {variables} constants became variables: this looks in the wrong place.")
    return variables


def run(half, factor, mean, ending="other", seconds=1.0, crossing=0):
    figures = {"mean": mean, "crossing": crossing, "Euler": 2, "truth": 2, "angle": 20}
    return constants.Run("implicit", f"shape {half}", half, "X.cxx:Y", factor, ending, seconds, figures)


def judged(*runs):
    usual = {("implicit", f"shape {half}"): run(half, 1, 1.0, "same") for half in constants.HALVES}
    return constants.verdict(constants.judge(list(runs), usual))


def verdicts(wrong):
    same = [run(half, factor, 1.0, "same") for half in constants.HALVES for factor in (0.5, 2.0)]
    worse = [run(half, factor, 1.2) for half in constants.HALVES for factor in (0.5, 2.0)]
    cases = (("no difference", same), ("holds: no better at half or double", worse), ("not read by any scene", []),
             ("**half is nearer on both halves**", [run("first", 0.5, 0.9), run("second", 0.5, 0.8), *worse[1:2], *worse[3:]]),
             ("half is nearer on the first half; the other does not agree", [run("first", 0.5, 0.9), worse[2]]),
             ("half is nearer on the first half; the other has no run of it", [run("first", 0.5, 0.9)]),
             ("holds: no better at half or double", [run("first", 0.5, 0.9, crossing=3), run("second", 0.5, 0.8, crossing=3)]),
             ("holds: no better at half or double", [run("first", 2.0, 0.9, "ends by signal 6"), worse[3]]))
    for expected, runs in cases:
        said = judged(*runs)
        if said != expected:
            wrong.append(f"The verdict is '{said}', not '{expected}'.")


SOURCE = """/// Part of the diagonal.
constexpr double One = 0.5;
constexpr double Other = 0.25;
// About the third alone.
constexpr int Third = 3;

constexpr int Fourth = 4; ///< beside it
constexpr int Fifth = 5;
"""
WORDS = {"One": "Part of the diagonal.", "Other": "Part of the diagonal.", "Third": "About the third alone.", "Fourth": "beside it", "Fifth": ""}


def words_of_constants(wrong):
    with tempfile.TemporaryDirectory() as place:
        path = pathlib.Path(place) / "Made.h"
        path.write_text(SOURCE, encoding="utf-8")
        said = {name: comment for name, _, comment in constants.constants(path)}
        if said != WORDS:
            wrong.append(f"The words of constants are read as {said}.")
    wrong += [f"{row[0]}: {row[1]} has no word that says what it is." for row in constants.rows("") if row[3] == "unsaid"]


def page_keeps_figures(wrong):
    """Of a constant that keeps its value, also where another sweep knows nothing of it."""
    with tempfile.TemporaryDirectory() as place:
        path = str(pathlib.Path(place) / "page.md")
        row = ("X.cxx", "Y", "0.5", "reasoned", "a part")
        usual = {("implicit", f"shape {half}"): run(half, 1, 1.0, "same") for half in constants.HALVES}
        constants.write_page(path, [row], ({"X.cxx:Y": [run("first", 0.5, 1.2)]}, usual))
        before = pathlib.Path(path).read_text(encoding="utf-8")
        constants.write_page(path, [row], None)
        if pathlib.Path(path).read_text(encoding="utf-8") != before or "×1.200" not in before:
            wrong.append("A page without a new sweep loses the figures of the last one.")
        constants.write_page(path, [("X.cxx", "Y", "0.75", "reasoned", "a part")], None)
        if "×1.200" in pathlib.Path(path).read_text(encoding="utf-8"):
            wrong.append("A page gives the figures of another value.")


def main():
    wrong = []
    variables = copied(wrong)
    verdicts(wrong)
    words_of_constants(wrong)
    page_keeps_figures(wrong)
    house.end(wrong[:20], variables)


main()
