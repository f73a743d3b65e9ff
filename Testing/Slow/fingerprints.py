# SPDX-License-Identifier: GPL-3.0-or-later
"""Tell whether two builds make the same surfaces, to the last bit.

    CONTOUR_PLUGIN=.../ContourReconstruction.so pvpython fingerprints.py write OUT.json [--only TEXT] [--method psm|fair|ism]
        [--set PROPERTY=VALUE ...] [--keep FOLDER]
    python3 fingerprints.py compare OLD.json NEW.json
    pvpython fingerprints.py compare OLD.json NEW.json --kept OLD_FOLDER NEW_FOLDER

`write` reconstructs every region of Data/ and, where it is there, of the shared data, by both methods with
default settings, and writes a digest a region: of points and triangles, and of the lines of Report. The
implicit method runs at full detail up to FULL_DETAIL_POINTS contour points, and at Medium beyond, as
otherwise it would take an hour. `compare` names every region whose digest differs and exits with 1. Where the surfaces were kept it
also says by how much: of the volume in percent, and of the vertices of either from the other surface, as a part of its diagonal.
"""
import argparse
import glob
import hashlib
import json
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
SHARED = os.environ.get("CONTOUR_SHARED_DATA", os.path.join(SOURCE, "..", "shared", "data"))
FULL_DETAIL_POINTS = 3000
PATTERNS = ("rtstruct/*.dcm", "rtstruct/phantoms/*.dcm", "cnt/*.cnt", "csl/*.csl", "contour/*.contour", "ibsi/*.dcm")


def files(only):
    own = glob.glob(os.path.join(SOURCE, "Data", "*.cnt")) + glob.glob(os.path.join(SOURCE, "Data", "*.csl"))
    found = [("Data/" + os.path.basename(path), path) for path in sorted(own)]
    for pattern in PATTERNS:
        found += [(os.path.relpath(path, SHARED), path) for path in sorted(glob.glob(os.path.join(SHARED, pattern)))]
    return [(name, path) for name, path in found if only in name]


def digest(data):
    """(digest of geometry, digest of Report) of a surface."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    geometry = hashlib.sha256()
    if data.GetNumberOfPoints():
        geometry.update(vtk_to_numpy(data.GetPoints().GetData()).tobytes())
    if data.GetNumberOfPolys():
        geometry.update(vtk_to_numpy(data.GetPolys().GetConnectivityArray()).astype("int64").tobytes())
    lines = data.GetFieldData().GetAbstractArray("Report")
    report = "\n".join(lines.GetValue(i) for i in range(lines.GetNumberOfValues())) if lines else ""
    return geometry.hexdigest()[:16], hashlib.sha256(report.encode()).hexdigest()[:16]


def path_in(folder, key):
    return os.path.join(folder, re.sub(r"[^\w.-]+", "_", key) + ".vtp")


def keep(data, folder, key):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    os.makedirs(folder, exist_ok=True)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputDataObject(data)
    writer.SetFileName(path_in(folder, key))
    writer.SetDataModeToBinary()
    writer.Write()


def kept(folder, key):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path_in(folder, key))
    reader.Update()
    return reader.GetOutput()


def volume(data):
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    points = points - points.mean(axis=0)
    a, b, c = points[vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)].transpose(1, 0, 2)
    return float((a * numpy.cross(b, c)).sum() / 6)


def farthest(data, other):
    """The largest distance of a vertex of the one from the other surface."""
    from vtkmodules.vtkCommonCore import mutable
    from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator
    locator = vtkStaticCellLocator()
    locator.SetDataSet(other)
    locator.BuildLocator()
    cell, place, number_of, part, square = vtkGenericCell(), [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    largest = 0.0
    for i in range(data.GetNumberOfPoints()):
        locator.FindClosestPoint(data.GetPoint(i), place, cell, number_of, part, square)
        largest = max(largest, float(square))
    return largest ** 0.5


def apart(old, new):
    """(difference of the volumes in percent, largest distance as a part of the diagonal)"""
    before, after = volume(old), volume(new)
    return 100 * abs(after - before) / abs(before), max(farthest(old, new), farthest(new, old)) / old.GetLength()


def number(text):
    """A property's value as typed: whole numbers stay whole, as ParaView takes no other ones for switches."""
    if text.isdigit():
        return int(text)
    return float(text) if text.replace(".", "", 1).isdigit() else text


def write(options):
    sys.path.insert(0, os.path.join(SOURCE, "Plugin", "commandline"))
    import contourcli as cli
    from paraview import simple
    cli.load_plugin()
    found = {}
    for name, path in files(options.only):
        try:
            blocks, _ = cli.read_contours(path)
        except cli.CommandError as error:
            found[name] = ["refused", str(error).replace(path, name)]
            continue
        for block in blocks:
            if block.empty:
                continue
            for method in options.method or ["psm", "ism"]:
                node = getattr(simple, cli.METHODS[method])(Input=cli.as_source(block.data))
                for name_of, _, value in (setting.partition("=") for setting in options.set):
                    if name_of in node.ListProperties():
                        setattr(node, name_of, number(value))
                if method == "ism" and block.data.GetNumberOfPoints() > FULL_DETAIL_POINTS:
                    node.Detail = "Medium"
                key = f"{name} {block.name} {method}"
                try:
                    cli.run_proxy(node)
                    data = node.GetClientSideObject().GetOutputDataObject(0)
                    found[key] = [data.GetNumberOfPolys(), *digest(data)]
                    if options.keep:
                        keep(data, options.keep, key)
                except cli.CommandError as error:
                    found[key] = ["refused", str(error).replace(path, name)]
                print(key, found[key][0], file=sys.stderr, flush=True)
                simple.Delete(node)
    with open(options.out, "w", encoding="utf-8") as file:
        json.dump(found, file, indent=1, sort_keys=True)
    print(f"{len(found)} regions in {options.out}")


def compare(options):
    old, new = (json.load(open(path, encoding="utf-8")) for path in (options.old, options.new))
    same, different, most = 0, [], [(0.0, ""), (0.0, "")]
    for key in sorted(set(old) | set(new)):
        a, b = old.get(key), new.get(key)
        if a is None or b is None:
            different.append(f"{key}: only in the {'new' if a is None else 'old'} one")
        elif a[:2] != b[:2]:
            different.append(f"{key}: {a[0]} triangles were, {b[0]} are; or other coordinates"
                             if "refused" not in (a[0], b[0]) else f"{key}: {a[:2]} was, {b[:2]} is")
            if options.kept and "refused" not in (a[0], b[0]):
                by = apart(kept(options.kept[0], key), kept(options.kept[1], key))
                different[-1] += f"; volume by {by[0]:.2g}%, vertices by {by[1]:.2g} of the diagonal"
                most = [max(known, (figure, key)) for known, figure in zip(most, by)]
        else:
            same += 1
            if a[2:] != b[2:]:
                different.append(f"{key}: the same surface, another Report")
    print("\n".join(different))
    print(f"{same} surfaces the same to the last bit, {len(different)} lines above")
    if options.kept:
        print(f"at most: volume by {most[0][0]:.2g}% ({most[0][1]}), vertices by {most[1][0]:.2g} of the diagonal ({most[1][1]})")
    return 1 if different else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    writing = commands.add_parser("write")
    writing.add_argument("out")
    writing.add_argument("--only", default="", help="files whose name has this in it")
    writing.add_argument("--method", action="append", choices=["psm", "fair", "ism"])
    writing.add_argument("--set", action="append", default=[], metavar="PROPERTY=VALUE",
                         help="a property of the node, where it has it: to tell a default from a method")
    writing.add_argument("--keep", metavar="FOLDER", help="write the surfaces there, too")
    comparing = commands.add_parser("compare")
    comparing.add_argument("old")
    comparing.add_argument("new")
    comparing.add_argument("--kept", nargs=2, metavar="FOLDER", help="where `write --keep` left the surfaces of both")
    options = parser.parse_args()
    sys.exit(write(options) if options.command == "write" else compare(options))


main()
