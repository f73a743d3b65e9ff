# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the table of certificates: a row a region of interest, reconstructed by the Polyhedral Surface.

    ./run certificates [--method psm|ism] [SHARED_DATA [OUTPUT.md]]

Rows are the contour files of Data/ and, where SHARED_DATA (default ../shared/data) is there, every region of
every structure set, NUAGES file and cross-section set of it. What cannot be reconstructed has a row
that says why. With --method ism by the Implicit Surface, into Data/CERTIFICATES_IMPLICIT.md; that takes a quarter of an hour.
"""
import argparse
import glob
import os
import sys
import time

import contourcli as cli

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TITLES = ["file", "region", "contours", "triangles", "components", "genus", "closed", "manifold", "outward",
          "crossing", "sheets", "overlapping", "touching", "smallest angle", "volume", "area", "vertex off", "edge off",
          "worst level, %", "notes", "seconds"]

# Of a method: its node, its table, the command that writes it, and the files that it takes beside those of Data/.
FILES = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "cnt/*.cnt", "csl/*.csl")
METHODS = {"psm": ("Polyhedral Surface", "CERTIFICATES.md", "./run certificates", FILES + ("ibsi/*.dcm",)),
           "ism": ("Implicit Surface", "CERTIFICATES_IMPLICIT.md", "./run certificates --method ism",
                   FILES + ("contour/*.contour",))}


def files(shared, patterns):
    """(path, as shown)"""
    own = sorted(glob.glob(os.path.join(SOURCE, "Data", "*.cnt")) + glob.glob(os.path.join(SOURCE, "Data", "*.csl")))
    others = []
    for pattern in patterns:
        others += sorted(glob.glob(os.path.join(shared, pattern)))
    return ([(path, "Data/" + os.path.basename(path)) for path in own] +
            [(path, os.path.relpath(path, shared)) for path in others])


def number(value, digits=6):
    return "" if value is None else f"{value:.{digits}g}"


def yes(value):
    return "yes" if value else "**no**"


def zero(count):
    return "0" if count == 0 else f"**{count}**"


def is_parallel(contours):
    """Whether all planes of the contours have one normal; contours that cannot be read at all count as parallel."""
    from paraview import simple
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(contours.data)
    hierarchy = simple.ContourHierarchy(Input=source)
    try:
        cli.run_proxy(hierarchy)
    except cli.CommandError:
        return True
    normals = hierarchy.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("LevelNormal")
    return normals is None or len({normals.GetTuple(i) for i in range(normals.GetNumberOfTuples())}) == 1


def row(shown, contours, method):
    if contours.empty:
        return [shown, contours.name, "0"] + ["no contours"] + [""] * (len(TITLES) - 4)
    if method == "psm" and not is_parallel(contours):
        return [shown, contours.name, str(contours.data.GetNumberOfCells()),
                "planes of several directions: for Implicit Surface"] + [""] * (len(TITLES) - 4)
    start = time.process_time()
    try:
        result = cli.reconstruct(contours, method)
    except cli.CommandError as error:
        return [shown, contours.name, str(contours.data.GetNumberOfCells()), str(error)] + [""] * (len(TITLES) - 4)
    total = result.certificate["JSON"]["Total"]
    along = result.certificate["JSON"]["Contours"]
    return [shown, contours.name, str(contours.data.GetNumberOfCells()), str(total["Triangles"]),
            str(total["Components"]), number(total["Genus"]), yes(total["Closed"]),
            yes(total["EdgeManifold"] and total["VertexManifold"] and total["Oriented"]), yes(total["Outward"]),
            zero(total["CrossingPairs"]), zero(total["CrossingEdges"]), zero(total["OverlappingPairs"]), str(total["TouchingPairs"]),
            number(total["SmallestAngle"], 2), number(total["Volume"]), number(total["Area"]),
            number(along["FarthestContourVertex"], 2), number(along["FarthestContourEdge"], 2),
            number(along["WorstSectionPercent"], 2), str(len(result.report)), f"{time.process_time() - start:.2f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--method", choices=sorted(METHODS), default="psm")
    parser.add_argument("shared", nargs="?", default=os.path.join(SOURCE, "..", "shared", "data"))
    parser.add_argument("output", nargs="?")
    options = parser.parse_args()
    node, table, command, patterns = METHODS[options.method]
    shared = os.path.abspath(options.shared)
    output = options.output or os.path.join(SOURCE, "Data", table)
    cli.load_plugin()
    rows = []
    for path, shown in files(shared, patterns):
        try:
            blocks, _ = cli.read_contours(path)
        except cli.CommandError as error:
            rows.append([shown, "", "", str(error).replace(path, shown)] + [""] * (len(TITLES) - 4))
            continue
        for contours in blocks:
            rows.append(row(shown, contours, options.method))
            print("  ".join(rows[-1]), file=sys.stderr, flush=True)
    with open(output, "w") as file:
        file.write(
            "# Certificates\n\n"
            f"Every region of interest, reconstructed by the {node} with default settings and examined "
            f"by the Surface Certificate. Written by `{command}`; units are those of the input, angles in "
            "degrees. *Crossing*, *overlapping* and *touching* count pairs of triangles, *sheets* edges at "
            "which sheets of the surface cross; touching is what a surface cut apart into a manifold leaves. *Vertex off* and *edge off* are the farthest that a contour vertex "
            "or edge is from the surface, those of contours that were left out included; *worst level* is the largest area, in percent of a level's contours, that "
            "belongs to the contours or to the surface's section alone; edges may be off by the width that sheets which touch are "
            "drawn apart (PinchGap); *notes* is the number of lines, a kind of repair each, in the surface's field data Report. Seconds are processor time of "
            "reconstruction and certificate.\n\n")
        file.write("| " + " | ".join(TITLES) + " |\n|" + "---|" * len(TITLES) + "\n")
        for cells in rows:
            file.write("| " + " | ".join(c.replace("|", "/") for c in cells) + " |\n")
    print(f"{len(rows)} rows in {output}", file=sys.stderr)


try:
    main()
except cli.CommandError as failure:
    sys.exit(f"certificates: {failure}")
