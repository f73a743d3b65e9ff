# SPDX-License-Identifier: GPL-3.0-or-later
"""What every polyhedral surface promises, on contours of other people, and once more behind an STL file.

    TestPromises.py [all] [--only TEXT] [--json FILE]

Every region (with `all` of every set of the shared data, else of a few small ones) is reconstructed with default settings.
The surface must be closed, manifold, oriented outward and never cross itself; every contour vertex must be on it, and every
contour edge but for rounding; no contour may be left out but those that enclose nothing. Then it is written as STL, whose points are
in single precision and have no numbers, and read again with equal points taken for one: still closed, manifold, oriented,
without crossings, and no two sheets touch.

Regions that there can be no surface of are told with the sentence that says why, and counted apart; so are those with planes of several
directions, where the contours of the others are left out with a line in Report: there only the surface itself is judged.
"""
import argparse
import glob
import json
import os
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import contourtesting as ct

simple = ct.load_plugin()
sys.path.insert(0, os.path.join(ct.SOURCE, "Plugin", "commandline"))
import contourcli as cli  # noqa: E402

PATTERNS = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "ibsi/*.dcm", "cnt/*.cnt", "csl/*.csl", "contour/*.contour")
FEW = ("rtstruct/rtutils_keyholes.dcm", "cnt/manytomany.cnt", "csl/SideBishop.csl")
# A contour edge may be this part of the surface's diagonal off it, as added points lie in the plane to the last bit and drawn ones need not;
ROUNDING = 1e-10
# and this part of the median edge, by which added points of sheets that touch are drawn apart (PinchGap).
GAP = 1e-3
# What a region that the method is not for is told; any other refusal is a failure.
SEVERAL_DIRECTIONS = "Implicit Surface takes contours of planes of any direction"
NOT_FOR_IT = ("one plane only", SEVERAL_DIRECTIONS)


def files(everything, only):
    own = sorted(glob.glob(ct.own("") + "*.cnt") + glob.glob(ct.own("") + "*.csl"))
    found = [("Data/" + os.path.basename(path), path) for path in own if everything]
    patterns = PATTERNS if everything else FEW
    shared = os.environ["CONTOUR_SHARED_DATA"]
    for pattern in patterns:
        found += [(os.path.relpath(path, shared), path) for path in sorted(glob.glob(os.path.join(shared, pattern)))]
    return [(name, path) for name, path in found if only in name]


def soundness(figures):
    """What is wrong with a surface, by its certificate's figures; nothing where it is sound."""
    wanted = {"Closed": True, "EdgeManifold": True, "VertexManifold": True, "Oriented": True, "Outward": True, "CrossingPairs": 0,
              "CrossingEdges": 0, "OverlappingPairs": 0, "DegenerateTriangles": 0, "DuplicateTriangles": 0}
    return [f"{name} is {figures[name]}" for name, value in wanted.items() if figures[name] != value]


def diagonal(figures):
    return sum((high - low) ** 2 for low, high in zip(corner(figures, "Low"), corner(figures, "High"))) ** 0.5


def median_edge(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData())
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return numpy.median(numpy.linalg.norm(points[corners] - points[numpy.roll(corners, -1, axis=1)], axis=2))


def corner(figures, name):
    return [figures[name + axis] for axis in "XYZ"]


def of_contours(result, size):
    """What is wrong between a surface of that diagonal and the contours it was made from."""
    along, said = result.certificate["JSON"]["Contours"], []
    if along["FarthestContourVertex"] > 0:
        said.append(f"a contour vertex is {along['FarthestContourVertex']:.3g} off the surface")
    if along["FarthestContourEdge"] > ROUNDING * size + GAP * median_edge(result.surface):
        said.append(f"a contour edge is {along['FarthestContourEdge']:.3g} off the surface")
    left_out = cli.values(result.surface, "LeftOutCount")
    if left_out and left_out[0]:
        said.append(f"{left_out[0]:.0f} contours are left out")
    return said


def of_stl(result):
    """The surface through a file; a point that is two sheets' makes it pinched or an edge overused."""
    path = ct.output("TestPromises.stl")
    cli.write_surface(path, result)
    reader = simple.STLReader(FileNames=[path])
    certificate = simple.SurfaceCertificate(Input=reader, Weld=1)
    cli.run_proxy(certificate)
    data = certificate.GetClientSideObject().GetOutputDataObject(0)
    total = json.loads(cli.strings(data, "CertificateJSON")[0])["Total"]
    simple.Delete(certificate)
    simple.Delete(reader)
    said = soundness(total)
    if total["TouchingPairs"]:
        said.append(f"{total['TouchingPairs']} pairs of triangles touch")
    if total["Triangles"] != result.triangles:
        said.append(f"{total['Triangles']} triangles of {result.triangles}")
    return said


def judge(region, contours):
    """A row of the table: the region, what kind of end it came to, and what was wrong."""
    try:
        result = cli.reconstruct(contours)
    except cli.CommandError as error:
        known = any(words in str(error) for words in NOT_FOR_IT)
        return {"region": region, "end": "none" if known else "refused", "said": [str(error)]}
    total = result.certificate["JSON"]["Total"]
    parallel = not any("not parallel" in line for line in result.report)
    return {"region": region, "end": "surface" if parallel else "several directions", "triangles": result.triangles,
            "wrong": soundness(total) + (of_contours(result, diagonal(total)) if parallel else []), "stl": of_stl(result),
            "said": [line for line in result.report if "left out" in line]}


def regions(options):
    for shown, path in files(options.all == "all", options.only):
        blocks, _ = cli.read_contours(path)
        for block in blocks:
            if not block.empty:
                yield f"{shown} {block.name}", block


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("all", nargs="?", choices=["all"])
    parser.add_argument("--only", default="", help="files whose name has this in it")
    parser.add_argument("--json")
    options = parser.parse_args()
    ct.shared("cnt/manytomany.cnt")
    rows = []
    for region, block in regions(options):
        with cli.Notes.kept(printed=False):
            row = judge(region, block)
        rows.append(row)
        print(row, flush=True)
        ct.check(row["end"] != "refused", f"{region}: {row['said'][0] if row['said'] else ''}")
        for where in ("wrong", "stl"):
            ct.check(not row.get(where), f"{region}, {where}: {', '.join(row.get(where, []))}")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)
    count = {end: sum(row["end"] == end for row in rows) for end in ("surface", "several directions", "none")}
    bad = [row for row in rows if row.get("wrong") or row.get("stl")]
    print(f"{count['surface']} surfaces, and {count['several directions']} of one direction of several; {len(bad)} with an exception; "
          f"{count['none']} regions without a surface")
    ct.check(count["surface"], "a surface was made")
    ct.finish()


main()
