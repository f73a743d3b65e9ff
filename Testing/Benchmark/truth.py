# SPDX-License-Identifier: GPL-3.0-or-later
"""Both methods against the truth: real shapes cut by planes, reconstructed, and laid beside the shape again.

    ./run bench truth [NAME ...] [--method psm|fair|ism] [--told] [--markdown FILE] [--json FILE] [--set PROPERTY=VALUE ...]
                      [--check]

NAME is a part of a row's name. Rows: the cross-section sets that come with a reference surface; every closed mesh of the
shared test data, cut by 24 planes along x, y and z, at the middles of 24 equal slices of its bounding box. Figures:

- volume: error in percent of the reference's;
- mean, largest: distance of the two surfaces in the units of the set, both ways: of points spread evenly over the one
  surface (by area, with a fixed seed) and of its vertices from the other; the mean is that of the even points, half of it
  from either way;
- Euler: of the surface beside that of the reference; with --told (psm, fair) also where ExpectedPieces and ExpectedHandles are
  those of the reference, with the pairs of triangles that cross and the open edges of that surface where there are any;
- SI: pairs of triangles that cross or overlap, and edges where sheets cross; open: edges with one face, or more than two;
- seconds: processor time of the reconstruction (Polyhedral Surface, psm, and Fair Surface, fair: on one thread; Implicit
  Surface, ism: on all).

SlicerRT's and mask tools' figures were measured once on the same cuts. With --check the exit code says whether every row
is closed and free of self-intersections, nearer to the truth than SlicerRT (ism, fair: in the mean than any other tool) where that is
known, and, psm, of the true Euler number where it has been so. Reads the shared test data and says so where it is absent.
"""
import argparse
import json
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "truth"))
from truedata import SHARED, cases, certificate, distance, output, simple, value_of, volume

# (mean, largest, Euler) of SlicerRT's contour conversion, (mean, largest) of the best mask tool.
SLICERRT = {"eight_15": (0.0055, 0.068, -2), "hand_ok": (0.0049, 0.082, 0), "balloondog": (0.0064, 0.104, 6),
            "femur z": (0.0019, 0.038, 31), "pial_left x": (0.40, 10.0, -68)}
MASKS = {"eight_15": (0.0058, 0.050), "hand_ok": (0.0050, 0.053), "balloondog": (0.0063, 0.056),
         "femur z": (0.0018, 0.021), "pial_left x": (0.24, 2.3)}
# Rows whose surface has the topology of the truth, though no slice shows what is between two of them.
TRUE_EULER = {"eight_15", "hand_ok", "balloondog", "couplingdown x", "couplingdown z", "knot2 x", "knot2 y", "knot2 z",
              "elephant z", "fertility x", "fertility y", "fertility z", "kitten y", "kitten z"}


def node_of(method, contours, properties):
    if method == "ism":
        return simple.ImplicitSurface(Input=contours, **properties)
    if method == "fair":
        return simple.FairSurface(Input=contours, Threads=1, **properties)
    return simple.PolyhedralSurface(Input=contours, Threads=1, **properties)


def told(method, contours, truth, properties):
    """What comes of it where the pieces and handles of the truth are asked for."""
    asked = {"ExpectedPieces": truth["Components"], "ExpectedHandles": truth["Components"] - truth["Euler"] // 2}
    made = certificate(output(node_of(method, contours, {**properties, **asked})))
    bad = {what: made[what] for what in ("CrossingPairs", "OverlappingPairs", "CrossingEdges", "OpenEdges", "OverusedEdges")}
    met = made["Components"] == asked["ExpectedPieces"] and made["Euler"] == truth["Euler"]
    return {"Euler": made["Euler"], "pieces": made["Components"], "met": met, "bad": {k: n for k, n in bad.items() if n}}


def measure(method, name, contours, reference, properties, with_told):
    contours.UpdatePipeline()
    node = node_of(method, contours, properties)
    start = time.process_time()
    made = output(node)
    seconds = time.process_time() - start
    total = certificate(made)
    mean, largest, ways = distance(made, reference)
    slicer, mask = SLICERRT.get(name), MASKS.get(name)
    truth = certificate(reference)
    return {"name": name, "told": told(method, contours, truth, properties) if with_told else None, "triangles": made.GetNumberOfCells(), "volume": 100 * (volume(made) / volume(reference) - 1),
            "mean": mean, "largest": largest, "out": ways[0], "back": ways[1], "Euler": total["Euler"],
            "truth": truth["Euler"], "pieces": total["Components"],
            "truepieces": truth["Components"],
            "SI": total["CrossingPairs"] + total["OverlappingPairs"] + total["CrossingEdges"], "touching": total["TouchingPairs"],
            "open": total["OpenEdges"] + total["OverusedEdges"], "seconds": seconds,
            "SlicerRT": slicer, "masks": mask}


def of_other(figures):
    return "" if figures is None else f"{figures[0]:.4g} / {figures[1]:.3g}" + (
        f" / {figures[2]}" if len(figures) > 2 else "")


COLUMNS = (("input", lambda r: r["name"]), ("triangles", lambda r: str(r["triangles"])),
           ("volume %", lambda r: f"{r['volume']:+.2f}"), ("mean", lambda r: f"{r['mean']:.3g}"),
           ("largest", lambda r: f"{r['largest']:.3g}"), ("Euler (truth)", lambda r: f"{r['Euler']} ({r['truth']})"),
           ("SI", lambda r: str(r["SI"])), ("open", lambda r: str(r["open"])), ("seconds", lambda r: f"{r['seconds']:.2f}"),
           ("SlicerRT: mean / largest / Euler", lambda r: of_other(r["SlicerRT"])),
           ("masks: mean / largest", lambda r: of_other(r["masks"])))


def of_told(row):
    """The Euler number where pieces and handles were asked for, and how far it is met."""
    if not row["told"]:
        return ""
    euler, pieces = row["told"]["Euler"], row["told"]["pieces"]
    missed = f"{pieces} pieces, {pieces - euler // 2} handles for {row['truepieces']}, {row['truepieces'] - row['truth'] // 2}"
    words = [str(euler)] + ([] if row["told"]["met"] else [missed])
    return ", ".join(words + [f"{count} {what}" for what, count in row["told"]["bad"].items()])


def complaints(method, row):
    """What a row does not keep of its promises."""
    said = [f"{row[what]} {what}" for what in ("SI", "open") if row[what]]
    if method in ("ism", "fair"):
        others = [figures[0] for figures in (row["SlicerRT"], row["masks"]) if figures]
        return said + [f"mean {row['mean']:.5f} is not below {other}" for other in others if row["mean"] >= other]
    if row["SlicerRT"]:
        mean, largest, euler = row["SlicerRT"]
        said += [f"{what} {row[what]:.5f} is not below SlicerRT's {other}"
                 for what, other in (("mean", mean), ("largest", largest)) if row[what] > other]
        # Where SlicerRT has the true number there is nothing to be ahead of.
        if abs(row["Euler"] - row["truth"]) > abs(euler - row["truth"]):
            said.append(f"Euler {row['Euler']} is further from the truth than SlicerRT's {euler}")
    if row["name"] in TRUE_EULER and row["Euler"] != row["truth"]:
        said.append(f"Euler {row['Euler']} was {row['truth']}, as the truth's")
    return said


HEADINGS = {"psm": """# Beside the truth

Polyhedral Surface with its default settings on contours whose true surface is known: cross-section sets that come with one,
and closed meshes cut by 24 planes, at the middles of 24 equal slices, along each axis. Written by `./run bench truth --told --markdown
Data/TRUTH.md`; the implicit method's are in [TRUTH_IMPLICIT.md](TRUTH_IMPLICIT.md). *Mean* and *largest* are distances between the two
surfaces, both ways, in the units of the set; *SI* pairs of triangles
that cross or overlap and edges where sheets cross; *told* the Euler number where `ExpectedPieces` and `ExpectedHandles` are those of the truth
([pieces and handles](../Documentation/topology.md)); *open* edges without two faces; *seconds* processor time on one thread. Figures of
SlicerRT's contour conversion and the best of the mask tools were measured on the same cuts. Masks filled from distances interpolated
between slices mostly have the smaller largest distance: they are smooth across slices, where this surface is made of flat triangles that pass
through every contour vertex.

""", "ism": """# The implicit method beside the truth

Implicit Surface with its default settings, on the same contours and measured in the same way as Polyhedral Surface in [TRUTH.md](TRUTH.md).
Written by `./run bench truth --method ism --markdown Data/TRUTH_IMPLICIT.md`. *Seconds* is processor time on all processors.

""", "fair": """# The fair surface beside the truth

Fair Surface with its default settings, on the same contours and measured in the same way as Polyhedral Surface in [TRUTH.md](TRUTH.md).
Written by `./run bench truth --method fair --markdown Data/TRUTH_FAIR.md`. *Seconds* is processor time on one thread.

"""}


def main():
    parser = argparse.ArgumentParser(prog="run bench truth")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--method", choices=("psm", "fair", "ism"), default="psm")
    parser.add_argument("--told", action="store_true")
    parser.add_argument("--markdown", metavar="FILE")
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--set", action="append", default=[], metavar="PROPERTY=VALUE")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.told and options.method == "ism":
        parser.error("--told: the implicit method takes no pieces and handles.")
    if not os.path.isdir(SHARED):
        print(f"SKIPPED: {SHARED} is not there")
        return 77
    properties = {name: value_of(text) for name, text in (s.split("=", 1) for s in options.set)}
    columns = list(COLUMNS)
    if options.told:
        columns.insert(6, ("told", of_told))
    lines = [[title for title, _ in columns]]
    rows = []
    for name, contours, reference in cases(options.names):
        row = measure(options.method, name, contours, reference, properties, options.told)
        rows.append(row)
        lines.append([text(row) for _, text in columns])
        print("  ".join(lines[-1]), "; ".join(complaints(options.method, row)), flush=True)
    if options.markdown:
        with open(options.markdown, "w") as file:
            file.write(HEADINGS[options.method] + "| " + " | ".join(lines[0]) + " |\n|" + "---|" * len(columns) + "\n")
            file.writelines("| " + " | ".join(cells) + " |\n" for cells in lines[1:])
    if options.json:
        with open(options.json, "w") as file:
            json.dump(rows, file, indent=1)
    return 1 if options.check and any(complaints(options.method, row) for row in rows) else 0


sys.exit(main())
