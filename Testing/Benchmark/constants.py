# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of the core's constants: where each comes from, and what half and double of it change.

    ./run bench constants [--only TEXT] [--markdown FILE] [--sweep FILE] [--swept FILE]

Every `constexpr` number of Filters/Core with the comment above it, so that the page cannot lag behind the code. How it came to
its value is told from that comment: *measured* where it names a measurement, *by other names* where it is computed from other
constants, *mathematics* where it speaks of rounding or exactness, *reasoned* where it says what the number is for and no more,
*unsaid* where there is no word. The sorting goes by words, so that a row may be better founded than it says.

--sweep builds the core once more with all constants as variables (constants/variables.py; the product is not touched), runs
scenes on shapes whose truth is known with each constant halved and doubled (constants/bench_constants.cxx), and writes what it
saw to FILE, a line a run; some quarter of an hour. A page that --markdown replaces gives on its figures of constants that were
not swept this time and still have their value. Shapes are in two halves: what is chosen on the first can be held against the
second; further options (--scene TEXT, --shapes N a half, --half first|second, --phase P of the sections) make it shorter. --swept takes such a file and puts its figures into the page; --only: files whose name has one of the
texts in it, which commas part.
"""
import argparse
import collections
import math
import os
import re
import subprocess
import sys

SOURCE = os.environ.get("CONTOUR_SOURCE_DIR", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(SOURCE, "..", "shared", "data"))
CORE = os.path.join(SOURCE, "Filters", "Core")
CONSTANT = re.compile(r"^\s*(?:static )?(?:inline )?constexpr (?:double|int|std::size_t|std::int\d+_t|float|[A-Z]\w+) (\w+)"
                      r"(?:\[\] = |\{ | = )([^;]+?)(?: \})?;")
NUMBER = re.compile(r"\d")
MEASURED = re.compile(r"measured|Measured|tried|costs?\b|mean distance|takes? [\d.]+|nearest to the truth|of the volume|seconds?\b|GB|MB")
EXACT = re.compile(r"rounding|exact|bits|epsilon|digits|machine|power of two|size_t|Degrees|Pi\b")

# Less than this is noise: of figures (the truth is sampled at 4 000 points), and of processor time on a machine that others use.
FIGURE_NOISE = 0.01
TIME_NOISE = 0.25
# What a scene is judged by, the smaller the better; of `untidy` only whether it is the same.
JUDGED = {"polyhedral": "mean", "implicit": "mean", "preview": "mean", "iterative": "error/range", "reduced": "centres"}
HALVES = ("first", "second")


def constants(path):
    comment, told = [], False
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            said = re.match(r"\s*(?:///?<?|\*|/\*\*)\s?(.*)", line)
            found = CONSTANT.match(line)
            if found:
                beside = re.search(r"//+<?\s*(.*)", line)
                yield found.group(1), found.group(2).strip(), " ".join(comment + ([beside.group(1)] if beside else [])).strip()
                told = True
            elif said and not line.strip().startswith("*/"):
                # What stands above several constants in a row is about all of them.
                comment, told = ([] if told else comment) + [said.group(1).strip()], False
            elif not line.strip().startswith("*/"):
                comment = []


def origin(name, value, comment):
    if not NUMBER.search(value):
        return "by other names"
    if name in ("Pi", "RadiansPerDegree") or EXACT.search(comment + " " + name):
        return "mathematics, or arithmetic of doubles"
    return "measured" if MEASURED.search(comment) else "reasoned" if comment else "unsaid"


def rows(only):
    for folder, _, names in sorted(os.walk(CORE)):
        for name in sorted(names):
            if not name.endswith((".h", ".cxx")):
                continue
            path = os.path.join(folder, name)
            place = os.path.relpath(path, CORE)
            if any(text in place for text in only.split(",")):
                for constant, value, comment in constants(path):
                    yield place, constant, value, origin(constant, value, comment), comment.replace("|", "\\|")


Run = collections.namedtuple("Run", "scene shape half constant factor ending seconds figures")


def read_sweep(path):
    """Runs by constant, and the usual ones by scene and shape."""
    found, usual = collections.defaultdict(list), {}
    with open(path, encoding="utf-8") as stream:
        for line in stream:
            scene, shape, half, constant, _, factor, ending, seconds, *figures = line.rstrip("\n").split("\t")
            run = Run(scene, shape, half, constant, float(factor), ending, float(seconds),
                      {name: float(value) for name, value in (figure.split("=") for figure in figures)})
            if constant == "as they are":
                usual[scene, shape] = run
            else:
                found[constant].append(run)
    return found, usual


def mean_ratio(pairs):
    """The geometric mean of new to usual."""
    logarithms = [math.log(new / old) for new, old in pairs if new > 0 and old > 0]
    return math.exp(sum(logarithms) / len(logarithms)) if logarithms else 1.0


Effect = collections.namedtuple("Effect", "ratio time worse same")


def effect(runs, usual):
    """What a factor does on some shapes: ratios of figure and time, what got worse otherwise, whether nothing changed at all."""
    pairs, times, worse = [], [], []
    for run in runs:
        before = usual[run.scene, run.shape]
        times.append((run.seconds, before.seconds))
        if run.ending not in ("same", "other"):
            if before.ending != run.ending:
                worse.append(f"{run.shape}: {run.ending}")
            continue
        if run.ending == "same" or run.scene not in JUDGED:
            continue
        figures, old = run.figures, before.figures
        pairs.append((figures[JUDGED[run.scene]], old[JUDGED[run.scene]]))
        if figures.get("crossing", 0) > old.get("crossing", 0):
            worse.append(f"{run.shape}: {figures['crossing']:.0f} crossings")
        if "Euler" in figures and abs(figures["Euler"] - figures["truth"]) > abs(old["Euler"] - old["truth"]):
            worse.append(f"{run.shape} {run.scene}: Euler {figures['Euler']:.0f} for {old['Euler']:.0f}")
        if figures.get("angle", 90) < 0.7 * old.get("angle", 0) and old["angle"] > 0.5:
            worse.append(f"{run.shape}: angle {figures['angle']:.2g} for {old['angle']:.2g}")
    return Effect(mean_ratio(pairs), mean_ratio(times), worse, all(run.ending == "same" for run in runs))


def words(found):
    if found is None:
        return "–"
    said = []
    if abs(found.ratio - 1) >= 0.0005:
        said.append(f"×{found.ratio:.3f}")
    if abs(found.time - 1) > TIME_NOISE:
        said.append(f"time ×{found.time:.2f}")
    said += found.worse[:2] + ([f"and {len(found.worse) - 2} more"] if len(found.worse) > 2 else [])
    return "; ".join(said) if said else "=" if found.same else "±0"


def better(found):
    return found is not None and not found.worse and found.ratio < 1 - FIGURE_NOISE and found.time < 1 + TIME_NOISE


def quicker(found):
    return found is not None and not found.worse and found.time < 1 - TIME_NOISE and found.ratio < 1 + FIGURE_NOISE


def verdict(table):
    """table[half][factor] is an effect, or None where no scene of that half reads the constant."""
    all_of = [table[half][factor] for half in HALVES for factor in (0.5, 2.0) if table[half][factor] is not None]
    if not all_of:
        return "not read by any scene"
    if all(one.same and abs(one.time - 1) <= TIME_NOISE for one in all_of):
        return "no difference"
    for factor, name in ((0.5, "half"), (2.0, "double")):
        for test, what in ((better, "nearer"), (quicker, "quicker")):
            says = [half for half in HALVES if test(table[half][factor])]
            if len(says) == 2:
                return f"**{name} is {what} on both halves**"
            if says:
                other = table[HALVES[1 - HALVES.index(says[0])]][factor]
                return f"{name} is {what} on the {says[0]} half; the other " + ("has no run of it" if other is None else "does not agree")
    if all(not one.worse and abs(one.ratio - 1) <= FIGURE_NOISE and abs(one.time - 1) <= TIME_NOISE for one in all_of):
        return "within noise"
    return "holds: no better at half or double"


def judge(runs, usual):
    table = {half: {factor: None for factor in (0.5, 2.0)} for half in HALVES}
    for half in HALVES:
        for factor in (0.5, 2.0):
            some = [run for run in runs if run.half == half and run.factor == factor]
            if some:
                table[half][factor] = effect(some, usual)
    return table


SHAPES = "Scenes and shapes (of the shared test data, cut by 24 planes, where Implicit Surface is whole by 10): "
HEADING = """# The core's constants

Made by `./run bench constants --swept FILE --markdown Data/CONSTANTS.md`, which keeps figures of earlier sweeps; its docstring, in `Testing/Benchmark/constants.py`, says how.
{summary}

*Half* and *double*: what the constant at half and at double of its value makes of the first and of the second half of the shapes,
from `./run bench constants --sweep FILE` (one constant at a time, all others as they are). **×** is the mean distance to the truth (for the solver: its
error; for fewer centres: their number) beside that with the value as it is, geometric mean over the scenes whose output changes; *time* the same of processor
time where it differs by more than {time:.0%}; then what became worse otherwise. **=**: the same to the bit; **±0**: a difference that does not
show in the figure; **–**: no scene of that half reads it, or none was run. A row without any: not swept.
{shapes}.
Figures within {noise:.0%} are noise. Constants that the compiler must know, or that are no matter of taste, are not swept.

- *No difference* on tidy cuts of closed meshes says nothing against a tolerance: most of those in `Contours/` and `Planar/` are for input that is not tidy, and
  the tests of faults ask for them.
- The meshes are cut at the middles of equal slices, so each ends just half a slice beyond its last contour, while scans begin anywhere. So the longer ends
  that the sweep favours were looked at with sections elsewhere in their slices, too (`--phase 0.2` and `0.8`): `HighestOutermostEnd` 0.5 instead of 0.25 is nearer to the
  truth there as well, on 7 of 8 cuts of femur z, knot2 x (first half), fertility z and couplingdown x (second half), by .4 to 5.6%, and .7% farther on one; volumes are nearer on all.
  It is not changed yet: every surface would be.
- A row without figures has its reason in the last column. *Reasoned* says what the number is for; that it is the best one is not claimed.
- Scenes that are not named above were not run (`./run bench constants --sweep FILE --scene NAME` runs one), so what only they read is not swept yet.
- A factor below 1 that becomes more than 1 when it is doubled (`ShrinkStep`) ends nothing: that is a value that makes no sense, not a finding.

"""


def page_before(path):
    """The figures that a page has already, by file, constant and value, and its line about shapes."""
    figures, shapes = {}, ""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as stream:
            for line in stream:
                cells = line.rstrip("\n").split(" | ")
                if line.startswith("| ") and len(cells) == 8 and cells[6].strip():
                    figures[cells[0][2:], cells[1].strip("`"), cells[2].strip("`")] = cells[4:7]
                elif line.startswith(SHAPES):
                    shapes = line[len(SHAPES):].strip().rstrip(".")
    return figures, shapes


def write_page(path, found, sweep):
    runs, usual = sweep or ({}, {})
    figures, shapes = page_before(path)
    if usual:
        shapes = "; then ".join(part for part in (shapes, shapes_of(usual)) if part)
    for place, constant, value, _, _ in found:
        if f"{place}:{constant}" in runs:
            table = judge(runs[f"{place}:{constant}"], usual)
            figures[place, constant, value] = [", ".join(words(table[half][factor]) for half in HALVES) for factor in (0.5, 2.0)] + [verdict(table)]
    figures = {row[:3]: figures[row[:3]] for row in found if row[:3] in figures}
    summary = summary_of(found)
    if figures:
        verdicts = collections.Counter(re.sub(r"(half|double) is .*", "one of the halves would rather have another value",
                                              columns[2].strip("*")) for columns in figures.values())
        summary += f" Swept: {len(figures)}: " + ", ".join(f"{count} {what}" for what, count in verdicts.most_common()) + "."
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(HEADING.format(summary=summary, noise=FIGURE_NOISE, time=TIME_NOISE, shapes=SHAPES + shapes))
        stream.write("| file | constant | value | origin | half: first, second | double: first, second | verdict | what the source says |\n"
                     "|---|---|---|---|---|---|---|---|\n")
        for place, constant, value, kind, comment in found:
            swept = figures.get((place, constant, value), ["", "", ""])
            stream.write(f"| {place} | `{constant}` | `{value}` | {kind} | " + " | ".join(swept) + f" | {comment} |\n")


def shapes_of(usual):
    of_scene = collections.defaultdict(list)
    for (scene, shape), run in usual.items():
        of_scene[scene, run.half].append(shape)
    return "; ".join(f"{scene}, {half} half: {', '.join(shapes)}" for (scene, half), shapes in of_scene.items())


def summary_of(found):
    counts = collections.Counter(row[3] for row in found)
    return f"{len(found)} constants: " + ", ".join(f"{count} {kind}" for kind, count in sorted(counts.items())) + "."


def sweep(path, only, rest):
    build = os.path.dirname(os.environ["CONTOUR_BIN_DIR"])
    if subprocess.call(["cmake", "--build", build, "--target", "bench_constants"], stdout=subprocess.DEVNULL) != 0:
        sys.exit("bench_constants cannot be built.")
    program = os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_constants")
    with open(path, "w", encoding="utf-8") as stream:
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
        if subprocess.call([program, os.path.join(SHARED, "mesh"), "--only", only, *rest], stdout=stream, env=environment) != 0:
            sys.exit("bench_constants failed (above: why).")


def main():
    parser = argparse.ArgumentParser(prog="./run bench constants", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--markdown", metavar="FILE")
    parser.add_argument("--only", default="", metavar="TEXT")
    parser.add_argument("--sweep", metavar="FILE")
    parser.add_argument("--swept", metavar="FILE")
    options, rest = parser.parse_known_args()
    if rest and not options.sweep:
        parser.error(f"there is no option {rest[0]}")
    if options.sweep:
        if not os.path.isdir(SHARED):
            print(f"SKIPPED: {SHARED} is not there")
            sys.exit(77)
        sweep(options.sweep, options.only, rest)
    found = list(rows(options.only))
    print(summary_of(found))
    swept = options.swept or options.sweep
    if options.markdown:
        write_page(options.markdown, found, read_sweep(swept) if swept else None)
        return
    if swept:
        runs, usual = read_sweep(swept)
        for constant in sorted(runs):
            table = judge(runs[constant], usual)
            print(f"{constant}: half {', '.join(words(table[half][0.5]) for half in HALVES)}; "
                  f"double {', '.join(words(table[half][2.0]) for half in HALVES)}: {verdict(table)}")
        return
    for row in found:
        if row[3] == "unsaid":
            print(f"{row[0]}: {row[1]} = {row[2]}: {row[4]}")


if __name__ == "__main__":
    main()
