# SPDX-License-Identifier: GPL-3.0-or-later
"""What `contour-reconstruct` takes: its options, its help and its manual page, all from one parser.

Needs no ParaView, so that help comes at once.
"""
import argparse
import glob
import os

SURFACE_FORMATS = (".vtp", ".stl", ".ply", ".brep")
STRUCTURE_SET = ".dcm"
CONTOUR_FORMATS = (".cnt", ".csv")  # contours as they are
READERS = {
    ".cnt": "NUAGESContourReader",
    ".csl": "CurveNetworkReader",
    ".contour": "CurveNetworkReader",
    ".dcm": "DICOMRTStructureSetReader",
    ".mod": "IMODModelReader",
    ".ser": "ReconstructSeriesReader",
    ".jser": "ReconstructSeriesReader",
    ".roi": "ImageJROIReader",
    ".zip": "ImageJROIReader",
    ".svg": "SVGContourReader",
    ".csv": "ContourTableReader",
    ".tsv": "ContourTableReader",
    ".txt": "ContourTableReader",
    ".vtp": "XMLPolyDataReader",
}
# What ParaView reads by itself, with whatever reader it has for it.
PARAVIEW_FORMATS = (".vtk", ".vtm", ".vtu", ".vtpc", ".obj", ".geojson", ".dxf", ".shp")
METHODS = {"psm": "PolyhedralSurface", "ism": "ImplicitSurface", "fair": "FairSurface"}
DRAWING = ".svg"
NAME = "{}"  # stands for the name of IN in OUT
NO_CERTIFICATE = "none"
UNITS = ("mm", "cm", "m", "km", "um", "nm", "in", "ft")

USAGE = "%(prog)s IN [IN ...] OUT [options]\n       %(prog)s [IN ...] --list [options]"
DESCRIPTION = "Turn planar contours into closed surfaces and print what they are worth."
EPILOG = """\
Of several ROIs each gets a file of its own: OUT with the ROI's name before the extension. So does each of several
files: {} in OUT stands for the name of IN without its extension; without {} that name goes before OUT's extension.

Examples:
  contour-reconstruct rtss.dcm lung.stl --roi "Lt Lung" --set EndCaps=Flat
  contour-reconstruct 'cohort/*/RS*.dcm' 'surfaces/{}.stl' --jobs 4 --summary cohort.json
  contour-reconstruct drawn.dcm all.dcm --method ism --roi Prostate
  contour-reconstruct slice1.svg slice2.svg slice3.svg solid.stl --stack --spacing 3
  contour-reconstruct cell.mod cell.csv
  contour-reconstruct rtss.dcm --list

Exit status: 0 all done (or nothing to do), 1 something failed and was named, 2 the options are wrong, 130 stopped by Ctrl-C."""


class UsageError(Exception):
    """One sentence about what was asked for."""


def make_parser():
    parser = argparse.ArgumentParser(
        prog=os.environ.get("CONTOUR_PROGRAM", "contour-reconstruct"),
        usage=USAGE,
        description=DESCRIPTION, epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", metavar="IN ... OUT", nargs="*",
                        help="IN: contours, " + " ".join(list(READERS) + list(PARAVIEW_FORMATS)) +
                             ", structure sets also without .dcm; several files, or patterns with * ? [] and ** in quotes. "
                             "OUT: a surface, " + " ".join(SURFACE_FORMATS) +
                             "; or, of --method ism, contours on all slices as an RT structure set: .dcm; "
                             "or the contours as they are: " + " ".join(CONTOUR_FORMATS))
    parser.add_argument("--method", choices=sorted(METHODS), default="psm",
                        help="psm: polyhedral, exactly through parallel contours (default); "
                             "fair: as that, but smooth, within a tolerance of them; "
                             "ism: implicit, smooth, contours on any planes")
    parser.add_argument("--roi", nargs="+", metavar="NAME", default=[],
                        help="the ROIs of a structure set, or the objects of a tracing program, to take, in any case where only one is "
                             "meant; all without this")
    parser.add_argument("--set", action="append", metavar="PROPERTY=VALUE", default=[], dest="settings",
                        help="a property of a node on the way, such as EndCaps=Flat; repeatable; --list tells them all")
    parser.add_argument("--unit", choices=UNITS,
                        help="the unit of the coordinates, where the file does not tell it; volumes are in it, those of mm in cm3")
    parser.add_argument("--spacing", metavar="S", type=float,
                        help="the distance of slices, for files that do not tell it (.svg .roi .zip .csv); negative where they "
                             "follow towards -z (default: 1)")
    parser.add_argument("--pixel", metavar="S", type=float,
                        help="what one unit of such a drawing is in the unit of the slices' distance (default: 1)")
    parser.add_argument("--stack", action="store_true", help="each IN is a drawing (.svg) of one slice of one object, in this order")
    parser.add_argument("--offset", metavar="X,Y,Z",
                        help="take this from all coordinates that are written, for formats of single precision (.stl); "
                             "auto: the middle of the surface, in whole numbers")
    parser.add_argument("--force", action="store_true", help="replace OUT.dcm where it is there already")
    parser.add_argument("--reference", metavar="FILE",
                        help="for OUT.dcm: the RT structure set that the contours were drawn in, or one image of their "
                             "series; it gives patient, study and slices (IN, where that is one)")
    parser.add_argument("--extrapolate", action="store_true",
                        help="for OUT.dcm: also on slices beyond the outermost drawn points, where the surface closes")
    parser.add_argument("--list", action="store_true",
                        help="list the regions of each IN and the properties that --set takes, with their values, and write "
                             "nothing; without IN the properties alone")
    parser.add_argument("--certificate", metavar="FILE.json",
                        help="write everything that is known about the surfaces; none: do not examine them at all, which "
                             "saves most of the time of large ones")
    parser.add_argument("--summary", metavar="FILE.json",
                        help="write what became of each file and region: status, output, figures, notes, what went wrong")
    parser.add_argument("--jobs", metavar="N", type=int, default=1,
                        help="work on so many files at once (0: one a processor); the surfaces are the same")
    return parser


def expand(patterns):
    """Paths that the patterns mean, each once, in the order given; a pattern that meets nothing stays, and fails by its name."""
    found, seen = [], set()
    for pattern in patterns:
        meant = [pattern] if os.path.exists(pattern) else sorted(glob.glob(pattern, recursive=True)) or [pattern]
        for path in meant:
            if os.path.realpath(path) not in seen:
                seen.add(os.path.realpath(path))
                found.append(path)
    return found


def parse(arguments):
    """Options with inputs (a list), output (None of --list) and many (whether each file has a name of its own in OUT)."""
    parser = make_parser()
    options = parser.parse_intermixed_args(arguments)
    for path in options.paths[:-1] if options.stack else []:
        if os.path.splitext(path)[1].lower() != DRAWING:
            parser.error(f"--stack is for drawings ({DRAWING}), and {path} is none.")
    if options.jobs < 0:
        parser.error("--jobs takes 0 and above.")
    if options.list:
        options.inputs, options.output = expand(options.paths), None
        return options
    if len(options.paths) < 2:
        parser.error("give IN and OUT, the file to write, or --list.")
    options.output = options.paths[-1]
    options.inputs = expand(options.paths[:-1])
    # Also where a pattern meets one file only: what a script's outputs are called must not go by how many there are.
    options.many = not options.stack and (
        len(options.inputs) > 1 or NAME in options.output or options.inputs != options.paths[:-1])
    return options


def is_contours(path):
    return os.path.splitext(path)[1].lower() in CONTOUR_FORMATS


def is_structure_set(path):
    return os.path.splitext(path)[1].lower() == STRUCTURE_SET


def _unique(wanted, taken):
    name, number = wanted, 1
    while name.casefold() in taken:
        number += 1
        name = f"{wanted}-{number}"
    taken.add(name.casefold())
    return name


def outputs(options):
    """A path to write to for each input."""
    if not options.many:
        return [options.output]
    stems = [os.path.splitext(os.path.basename(path))[0] for path in options.inputs]
    folded = [stem.casefold() for stem in stems]
    # Patients' files often have one name, each in a folder of its own.
    stems = [os.path.basename(os.path.dirname(os.path.abspath(path))) + "-" + stem if folded.count(stem.casefold()) > 1 else stem
             for path, stem in zip(options.inputs, stems)]
    taken = set()
    names = [_unique(stem, taken) for stem in stems]
    if NAME in options.output:
        return [options.output.replace(NAME, name) for name in names]
    root, extension = os.path.splitext(options.output)
    return [f"{root}-{name}{extension}" for name in names]
