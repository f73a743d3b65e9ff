# SPDX-License-Identifier: GPL-3.0-or-later
"""Ten thousand stacks of contours, each surface judged by two witnesses that know nothing of each other.

    ./run bench collection [SOURCE ...] [--count N] [--part K/N] [--minutes M] [--jobs J] [--again] [--markdown FILE] [--check]

SOURCE is a part of a source's name. Cases: closed meshes of others, cut along three axes and an oblique direction, at eight
spacings and three offsets; label maps; every region of the shared contour files; random nested stacks with random
options; closed meshes cut by planes of any direction, for the implicit method. They are shuffled by a fixed seed, so
that any first part of them is like the whole. What a run finished is kept beside the build and not done again, but with --again.

The first witness is the certificate, with what README promises beside it: closed, manifold by index and by coordinates,
oriented outward, no crossing, every contour vertex a point of the surface or named in Report. The second is manifold3d, from
PyPI, which takes the mesh as a manifold without error and finds the same volume up to ALIKE; up to rounding but where it turns edges of
triangles that it takes for degenerate, which the table counts. Meshes are read where their packages
have them (numpy, trimesh and manifold3d from PyPI do that, in an environment of this tool's own). A case that ends
its worker, or takes longer than LIMIT seconds, is unsound. With --check the exit code says whether none is.
"""
import argparse
import collections
import concurrent.futures
import glob
import json
import os
import random
import re
import select
import shutil
import subprocess
import sys
import threading
import time

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.environ["CONTOUR_SOURCE_DIR"]
WORKER = os.path.join(os.environ["CONTOUR_BIN_DIR"], "bench_collection")
FOLDER = os.path.join(os.environ["CONTOUR_BIN_DIR"], "..", "collection")
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(SOURCE, "..", "shared", "data"))
LIMIT = 300  # seconds
ALIKE = 1e-3  # of the volume
TURNED = "agrees, with edges turned"
SEED = 20
SLICES = (4, 6, 8, 11, 15, 20, 27, 36)
SHIFTS = ("0.5", "0", "0.3819660112501051")
STEPS = (1, 2, 3, 5)
LABELS, NESTED, NETWORKS = 1200, 2000, 1000
PATTERNS = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "ibsi/*.dcm", "cnt/*.cnt", "csl/*.csl", "contour/*.contour")
FIELDS = ("verdict", "seconds", "points", "levels", "mesh_points", "triangles", "volume", "area", "diagonal", "off", "reason")


def enter_environment():
    """Goes on in a Python of its own, without what leads Python to ParaView's modules."""
    folder = os.path.join(FOLDER, "environment")
    python = os.path.join(folder, "bin", "python")
    if sys.executable and os.path.abspath(sys.prefix) == os.path.abspath(folder):
        return
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LD_", "VTK"))}
    stamp = os.path.join(folder, "complete")
    if not os.path.exists(stamp):
        host = shutil.which("python3") or sys.exit("collection: there is no python3 to make an environment with.")
        for step in ([host, "-m", "venv", "--clear", folder],
                     [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "numpy", "trimesh", "manifold3d"]):
            subprocess.run(step, env=clean, check=True)
        open(stamp, "w", encoding="utf-8").close()
    os.execve(python, [python, "-B", os.path.abspath(__file__), *sys.argv[1:]], clean)


def shuffled(cases, word):
    random.Random(f"{SEED} {word}").shuffle(cases)
    return cases


def regions():
    for pattern in PATTERNS:
        for path in sorted(glob.glob(os.path.join(SHARED, pattern))):
            name = os.path.relpath(path, SHARED)
            listed = subprocess.run([WORKER, "--list", path], capture_output=True, text=True, check=False)
            if listed.returncode != 0:
                print(f"{name} is left out: {listed.stderr.strip() or 'listing its regions ended the program'}")
                continue
            for number in range(len(listed.stdout.splitlines())):
                kind = "structure sets" if path.endswith(".dcm") else "contour files"
                yield (f"shared {kind}", f"{name} {number}", ("region", path, number))


def all_cases(count):
    """(source, key, words); the same for the same sources."""
    sys.path.insert(0, os.path.join(HERE, "collection"))
    import meshes
    found = meshes.collect(SHARED, FOLDER)
    cuts = [(m["source"], f"{m['name']} {direction} {slices} {shift}", ("cut", m["file"], direction, slices, shift))
            for m in found["meshes"] for direction in range(4) for slices in SLICES for shift in SHIFTS]
    labels = [(r["source"], f"{r['name']} {r['label']} {axis} {step}", ("label", r["file"], r["label"], axis, step))
              for r in found["labels"] for axis in range(3) for step in STEPS]
    cases = shuffled(labels, "labels")[:LABELS] + list(regions())
    cases += [("random nested stacks", str(seed), ("nested", seed)) for seed in range(1, NESTED + 1)]
    if found["meshes"]:
        cases += [("networks of planes", f"{m['name']} {seed}", ("network", m["file"], seed))
                  for seed in range(1, NETWORKS + 1) for m in [found["meshes"][seed % len(found["meshes"])]]]
    cases += shuffled(cuts, "cuts")[:max(0, count - len(cases))]
    return shuffled(cases, "all")[:count], found["licences"]


class Worker:
    """A process of bench_collection, made anew after a case that it does not outlive."""

    def __init__(self):
        self.process = None

    def read(self, count, until):
        """So many bytes, or up to the end of a line where that is None; nothing where there come no more in time."""
        data = b""
        while (count is None and not data.endswith(b"\n")) or (count is not None and len(data) < count):
            if not select.select([self.process.stdout], [], [], max(0, until - time.monotonic()))[0]:
                return None
            more = os.read(self.process.stdout.fileno(), 1 if count is None else min(1 << 20, count - len(data)))
            if not more:
                return None
            data += more
        return data

    def ask(self, words):
        """The answer's fields, and bytes of the mesh."""
        if self.process is None:
            self.process = subprocess.Popen([WORKER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0)
        until = time.monotonic() + LIMIT
        self.process.stdin.write(("\t".join(map(str, words)) + "\n").encode())
        line = self.read(None, until)
        answer = dict(zip(FIELDS, line.decode(errors="replace").rstrip("\n").split("\t"))) if line else None
        data = self.read(24 * int(answer["mesh_points"]) + 12 * int(answer["triangles"]), until) if answer else None
        if data is None:
            late = time.monotonic() >= until
            self.end()
            return {"verdict": "unsound", "reason": f"took more than {LIMIT} s" if late else "ended the program", "seconds": LIMIT if late else 0,
                    "points": 0, "triangles": 0}, b""
        return {k: v if k in ("verdict", "reason") else float(v) for k, v in answer.items()}, data

    def end(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process = None


def second_witness(answer, data):
    """What manifold3d says of it."""
    import manifold3d
    import numpy
    points = numpy.frombuffer(data, float, 3 * int(answer["mesh_points"])).reshape(-1, 3)
    triangles = numpy.frombuffer(data, numpy.int32, offset=points.nbytes).reshape(-1, 3)
    body = manifold3d.Manifold(manifold3d.Mesh64(vert_properties=points.copy(), tri_verts=triangles.astype(numpy.uint64)))
    if body.status() != manifold3d.Error.NoError:
        return f"manifold3d: {body.status().name}"
    rounding = 1e-11 * float(numpy.abs(points).max()) * answer["area"] + 1e-9 * abs(answer["volume"])
    apart = abs(body.volume() - answer["volume"])
    if apart <= rounding:
        return "agrees"
    return TURNED if apart <= rounding + ALIKE * abs(answer["volume"]) else f"manifold3d: volume {body.volume():.9g} for {answer['volume']:.9g}"


def do_all(cases, options, results):
    """Appends an answer a case to the results."""
    done = set()
    if os.path.exists(results):
        with open(results, encoding="utf-8") as file:
            done = {(r["source"], r["case"]) for r in map(json.loads, file)}
    wanted = iter([c for c in cases if c[:2] not in done])
    lock, until = threading.Lock(), time.monotonic() + 60 * options.minutes

    def work(file):
        worker, count = Worker(), 0
        try:
            while time.monotonic() < until:
                with lock:
                    case = next(wanted, None)
                if case is None:
                    break
                source, key, words = case
                answer, data = worker.ask(words)
                if data:
                    answer["witness"] = second_witness(answer, data)
                with lock:
                    file.write(json.dumps({"source": source, "case": key, "words": words, **answer}) + "\n")
                    file.flush()
                count += 1
                if verdict_of(answer) == "unsound":
                    print(f"{source}: {key}: {answer['reason']} {answer.get('witness', '')}", flush=True)
        finally:
            worker.end()
        return count

    with open(results, "a", encoding="utf-8") as file, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        return sum(pool.map(work, [file] * options.jobs))


def kind_of(reason):
    """A sentence without the numbers and names in it."""
    reason = re.sub(r"'[^']*'|\"[^\"]*\"", "'...'", reason)
    return re.sub(r"-?\d+(\.\d+)?(e[+-]?\d+)?", "N", reason)


def verdict_of(r):
    return r["verdict"] if r.get("witness", "agrees").startswith("agrees") else "unsound"


def table(results, licences, wanted):
    """Markdown, and the number of those that are unsound."""
    with open(results, encoding="utf-8") as file:
        records = {(r["source"], r["case"]): r for r in map(json.loads, file)}
    records = [r for key, r in records.items() if key in wanted]
    by_source = collections.defaultdict(list)
    for r in records:
        by_source[r["source"]].append(r)
    median = {}
    for is_network in (False, True):
        times = sorted(r["seconds"] / r["points"] for r in records
                       if r["points"] >= 100 and (r["source"] == "networks of planes") == is_network)
        median[is_network] = times[len(times) // 2] if times else 0
    head = ("source", "licence", "stacks", "sound", "told", "refused", "unsound", "slow", "CPU s", "slowest")
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    counts = collections.Counter()
    for source, mine in sorted(by_source.items()):
        count = collections.Counter(verdict_of(r) for r in mine)
        slow = sum(r["seconds"] > 10 * median[source == "networks of planes"] * max(100, r["points"]) for r in mine)
        slowest = max(mine, key=lambda r: r["seconds"])
        count.update(stacks=len(mine), slow=slow)
        counts.update(count)
        lines.append("| " + " | ".join(map(str, (
            source, licences.get(source, ""), *(count[k] for k in ("stacks", "sound", "told", "refused", "unsound", "slow")),
            f"{sum(r['seconds'] for r in mine):.0f}",
            f"{slowest['seconds']:.1f} s, {slowest['points']:.0f} points: {os.path.basename(slowest['case'])}"))) + " |")
    lines.append("| all | | " + " | ".join(str(counts[k]) for k in ("stacks", "sound", "told", "refused", "unsound", "slow")) +
                 f" | {sum(r['seconds'] for r in records):.0f} | |")
    turned = sum(r.get("witness") == TURNED for r in records)
    lines += ["", f"The second witness found the same volume up to rounding, but for {turned} surfaces of which it turned edges.", "",
              f"{counts['stacks']} of {len(wanted)} were run. Median time a contour point: {1e6 * median[False]:.0f} µs, of networks {1e6 * median[True]:.0f} µs.", ""]
    for title, verdicts in (("Refused", ("refused",)), ("Told", ("told",)), ("Unsound", ("unsound",))):
        reasons = collections.defaultdict(list)
        for r in records:
            if verdict_of(r) in verdicts:
                reasons[kind_of(r["reason"] + " " + re.sub("^agrees.*", "", r.get("witness", ""))).strip()].append(r)
        if reasons:
            lines += [f"## {title}", "", "| how often | reason | for example |", "|---|---|---|"]
            lines += [f"| {len(rs)} | {reason.replace('|', '/')} | {rs[0]['source']}: {os.path.basename(rs[0]['case'])} |"
                      for reason, rs in sorted(reasons.items(), key=lambda x: -len(x[1]))] + [""]
    slow = sorted((r for r in records if r["seconds"] > 10 * median[r["source"] == "networks of planes"] * max(100, r["points"])),
                  key=lambda r: -r["seconds"])[:12]
    if slow:
        lines += ["## Slowest of the slow", "", "| CPU s | points | triangles | which |", "|---|---|---|---|"]
        lines += [f"| {r['seconds']:.1f} | {r['points']:.0f} | {r['triangles']:.0f} | {r['source']}: {os.path.basename(r['case'])} |" for r in slow] + [""]
    return "\n".join(lines), counts["unsound"]


PREFACE = """# The collection

Stacks of contours from everywhere, and what became of each: `./run bench collection --markdown Data/COLLECTION.md`, whose docstring, in
`Testing/Benchmark/collection.py`, says what is cut and who judges. *Told*: sound by its indices, but sheets touch in places that Report counts. *Slow*: more
than ten times the median time a contour point (of 100 points at least). No mesh and no label map of others is in this repository.

"""


def main():
    enter_environment()
    parser = argparse.ArgumentParser(prog="collection", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sources", nargs="*", metavar="SOURCE")
    parser.add_argument("--count", type=int, default=10000)
    parser.add_argument("--part", default="1/1", metavar="K/N")
    parser.add_argument("--minutes", type=float, default=1e6)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--markdown")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    os.makedirs(FOLDER, exist_ok=True)
    cases, licences = all_cases(options.count)
    wanted = {c[:2] for c in cases}
    part, parts = map(int, options.part.split("/"))
    cases = [c for c in cases[part - 1::parts] if not options.sources or any(s in c[0] for s in options.sources)]
    results = os.path.join(FOLDER, "results.jsonl")
    if options.again and os.path.exists(results):
        os.remove(results)
    print(f"{do_all(cases, options, results)} of {len(cases)} done now")
    text, unsound = table(results, licences, wanted)
    print(text)
    if options.markdown:
        with open(options.markdown, "w", encoding="utf-8") as file:
            file.write(PREFACE + text)
    return 1 if options.check and unsound else 0


sys.exit(main())
