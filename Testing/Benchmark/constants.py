# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of the core's tuned constants, from the sources themselves.

    ./run bench constants [--markdown FILE] [--only FOLDER]

Every `constexpr` number of Filters/Core with the comment above it, so that the page cannot lag behind the code. How it came to
its value is told from that comment: *measured* where it names a measurement, *by other names* where it is computed from other
constants, *mathematics* where it speaks of rounding or exactness, *unsaid* where it gives none of these: those are the ones to
derive, to find a source for, or to sweep. The sorting goes by words, so that a row may be better founded than it says.
"""
import argparse
import os
import re

SOURCE = os.environ.get("CONTOUR_SOURCE_DIR", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
CORE = os.path.join(SOURCE, "Filters", "Core")
CONSTANT = re.compile(r"^\s*(?:static )?(?:inline )?constexpr (?:double|int|std::size_t|std::int\d+_t|float) (\w+)(?:\[\])? = ([^;]+);")
NUMBER = re.compile(r"\d")
MEASURED = re.compile(r"measured|Measured|tried|costs?\b|mean distance|takes? [\d.]+|nearest to the truth|of the volume|seconds?\b|GB|MB")
EXACT = re.compile(r"rounding|exact|bits|epsilon|digits|machine|power of two|size_t|Degrees|Pi\b")


def constants(path):
    comment = []
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            said = re.match(r"\s*(?:///?<?|\*|/\*\*)\s?(.*)", line)
            found = CONSTANT.match(line)
            if found:
                beside = re.search(r"///<\s*(.*)", line)
                yield found.group(1), found.group(2).strip(), " ".join(comment + ([beside.group(1)] if beside else [])).strip()
            elif said and not line.strip().startswith("*/"):
                comment.append(said.group(1).strip())
            else:
                comment = []


def origin(name, value, comment):
    if not NUMBER.search(value):
        return "by other names"
    if name in ("Pi", "DegreesPerRadian", "RadiansPerDegree") or EXACT.search(comment + " " + name):
        return "mathematics, or arithmetic of doubles"
    return "measured" if MEASURED.search(comment) else "unsaid"


def rows(only):
    for folder, _, names in sorted(os.walk(CORE)):
        for name in sorted(names):
            if not name.endswith((".h", ".cxx")):
                continue
            path = os.path.join(folder, name)
            place = os.path.relpath(path, CORE)
            if place.startswith(only):
                for constant, value, comment in constants(path):
                    yield place, constant, value, origin(constant, value, comment), comment.replace("|", "\\|")


def main():
    parser = argparse.ArgumentParser(prog="./run bench constants", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--markdown", metavar="FILE")
    parser.add_argument("--only", default="", metavar="FOLDER")
    options = parser.parse_args()
    found = list(rows(options.only))
    counts = {}
    for row in found:
        counts[row[3]] = counts.get(row[3], 0) + 1
    summary = f"{len(found)} constants: " + ", ".join(f"{count} {kind}" for kind, count in sorted(counts.items())) + "."
    print(summary)
    for row in found:
        if row[3] == "unsaid" and not options.markdown:
            print(f"{row[0]}: {row[1]} = {row[2]}: {row[4]}")
    if not options.markdown:
        return
    with open(options.markdown, "w", encoding="utf-8") as stream:
        stream.write("# The core's constants\n\nMade by `./run bench constants --markdown`; its docstring, in "
                     "`Testing/Benchmark/constants.py`, says how. " + summary + "\n\n**Not done:** no constant has been swept to half "
                     "and double of its value on two halves of the sets; *measured* means that the comment names a measurement, mostly on "
                     "the sets that claims are made on as well. *Unsaid* are those to begin with.\n\n"
                     "| file | constant | value | origin | what the source says |\n|---|---|---|---|---|\n")
        stream.writelines(f"| {place} | `{constant}` | `{value}` | {kind} | {comment} |\n"
                          for place, constant, value, kind, comment in found)


main()
