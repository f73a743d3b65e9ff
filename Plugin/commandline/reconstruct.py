# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours to closed surfaces on the command line; run it as `./run reconstruct` or `contour-reconstruct`."""
import signal

signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C ends it, without the stack of whatever library it is in
import argparse
import contextlib
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contourcli as cli


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog=os.environ.get("CONTOUR_PROGRAM", "contour-reconstruct"),
        description="Turn planar contours into closed surfaces and print what they are worth.",
        epilog="Of several ROIs each gets a file of its own: OUT with the ROI's name before the extension.")
    parser.add_argument("input", metavar="IN",
                        help="contours: " + " ".join(list(cli.READERS) + list(cli.PARAVIEW_FORMATS)) +
                             "; structure sets also without .dcm")
    parser.add_argument("output", metavar="OUT", nargs="?",
                        help="surface: " + " ".join(cli.SURFACE_FORMATS) +
                             "; or, of --method ism, contours on all slices as an RT structure set: .dcm")
    parser.add_argument("--method", choices=sorted(cli.METHODS), default="psm",
                        help="psm: polyhedral, exactly through parallel contours (default); "
                             "ism: implicit, smooth, contours on any planes")
    parser.add_argument("--roi", nargs="+", metavar="NAME", default=[],
                        help="the ROIs of a structure set to take; all without this")
    parser.add_argument("--set", action="append", metavar="PROPERTY=VALUE", default=[], dest="settings",
                        help="a property of a node on the way, such as EndCaps=Flat; repeatable; a name that no node has "
                             "lists those that they have")
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
                        help="list the regions of IN and the properties that --set takes, with their values, and write nothing")
    parser.add_argument("--certificate", metavar="FILE.json",
                        help="write everything that is known about the surfaces")
    options = parser.parse_args(arguments)
    if not options.output and not options.list:
        parser.error("give OUT, the file to write, or --list.")
    return options


def check_output(path):
    """Say that the output cannot be written before the work is done, not after it."""
    extension = os.path.splitext(path)[1].lower()
    if extension not in cli.SURFACE_FORMATS + (cli.STRUCTURE_SET,):
        raise cli.CommandError(f"{path}: cannot write '{extension}' files; surfaces are written to "
                               f"{' '.join(cli.SURFACE_FORMATS)}, contours to {cli.STRUCTURE_SET}.")
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise cli.CommandError(f"There is no folder {folder} to write {os.path.basename(path)} to.")
    if not os.access(folder, os.W_OK):
        raise cli.CommandError(f"The folder {folder} is not writable.")


def write_certificate(path, results):
    content = {r.name: r.certificate["JSON"] for r in results}
    part = path + ".part"
    try:
        with open(part, "w", encoding="utf-8") as file:
            json.dump(content, file, indent=2)
            file.write("\n")
        os.replace(part, path)
    except OSError as error:
        raise cli.CommandError(f"{path} could not be written: {error.strerror}.")


def is_structure_set(path):
    return os.path.splitext(path)[1].lower() == cli.STRUCTURE_SET


def is_dicom(path):
    return is_structure_set(path) or cli.is_dicom(path)


def check_structure_set(options):
    """What can be said about OUT.dcm before any work. Returns the reference."""
    if options.method != "ism":
        raise cli.CommandError(f"{options.output}: contours on other slices are the implicit method's; "
                               "add --method ism.")
    if options.certificate:
        raise cli.CommandError(f"--certificate is about surfaces, and {options.output} will hold contours.")
    reference = options.reference or (options.input if is_dicom(options.input) else None)
    if not reference:
        raise cli.CommandError(f"{options.output} needs a patient and slices: give the RT structure set that the "
                               "contours were drawn in, or an image of the series, by --reference.")
    if not os.path.exists(reference):
        raise cli.CommandError(f"There is no file {reference}.")
    for path in (reference, options.input):
        if os.path.exists(options.output) and os.path.samefile(path, options.output):
            raise cli.CommandError(f"{options.output} is read as well, and not overwritten; give another name.")
    if os.path.exists(options.output) and not options.force:
        raise cli.CommandError(f"{options.output} is there already; give another name, or --force to replace it.")
    return reference


class Failures:
    """What could not be done, a region each; the others are done all the same."""

    def __init__(self, count, what):
        self.count = count
        self.what = what
        self.found = []

    def add(self, name, error):
        words = str(error)
        self.found.append((name, words[len(name) + 2:] if words.startswith(name + ": ") else words))

    def check(self):
        if self.found and self.count == 1:
            name, why = self.found[0]
            raise cli.CommandError(f"{name}: {why}")
        if self.found:
            raise cli.CommandError(f"{len(self.found)} of {self.count} ROIs gave no {self.what}: "
                                   + "; ".join(f"{name}: {why}" for name, why in self.found))


@contextlib.contextmanager
def attempt(block, failures):
    """A progress bar while a region is worked on; what goes wrong with it is noted, and the others go on."""
    bar = cli.ProgressBar(block.name)
    try:
        yield bar
    except cli.SettingError:
        raise
    except cli.NothingToDo as reason:
        bar.clear()
        print(f"{block.name}: nothing to do: {reason}")
    except cli.CommandError as error:
        failures.add(block.name, error)
    finally:
        bar.clear()


def write_structure_set(options, blocks, reference):
    writer = cli.StructureSetWriter(options.output, reference, options.settings, options.extrapolate)
    failures = Failures(len(blocks), "contours")
    for block in blocks:
        with attempt(block, failures) as bar:
            writer.trace(block, bar)
    if writer.traced:
        writer.write()
        print(cli.format_table(writer.rows, ["", "contours drawn", "written", "slices", "seconds"]))
        print("\nWritten: " + options.output)
    failures.check()


def write_surfaces(options, blocks, reading):
    results, files, writing = [], [], 0.0
    failures = Failures(len(blocks), "surface")
    offset = cli.parse_offset(options.offset)
    settings = cli.settings_for(options.output, options.method, options.settings)
    for block, path in zip(blocks, cli.output_paths(options.output, blocks)):
        with attempt(block, failures) as bar:
            result = cli.reconstruct(block, options.method, settings, bar)
            bar.clear()
            writing += cli.write_surface(path, result, offset)
            results.append(result)
            files.append(path)
    if results:
        cli.print_results(results, [("read", reading), ("write", writing)])
        print("\nWritten: " + ", ".join(files))
    if options.certificate and results:
        write_certificate(options.certificate, results)
        print("Written: " + options.certificate)
    failures.check()


def check_options(options):
    """What can be said before any work. Returns the reference of a structure set, None for surfaces."""
    check_output(options.output)
    reference = check_structure_set(options) if is_structure_set(options.output) else None
    if (options.reference or options.extrapolate) and not reference:
        raise cli.CommandError("--reference and --extrapolate are for an RT structure set (.dcm), and "
                               f"{options.output} is none.")
    if options.offset and reference:
        raise cli.CommandError("--offset is for surfaces: contours in a structure set stay where the patient is.")
    cli.parse_offset(options.offset)
    return reference


def list_all(options):
    """What --roi and --set may name."""
    cli.load_plugin()
    blocks, _ = cli.read_contours(options.input, options.roi)
    rows = [[block.name, 0 if block.data is None else block.data.GetNumberOfCells(), block.nothing] for block in blocks]
    print(cli.format_table(rows, ["region", "contours", ""]))
    for name in (cli.METHODS[options.method], "SurfaceCertificate"):
        node = cli.new_node(name, Input=cli.as_source(blocks[0].data))
        print(f"\n{node.GetXMLLabel()}")
        for line in cli.describe(node):
            print("  " + line)


def run(options):
    if options.list:
        list_all(options)
        return
    reference = check_options(options)
    cli.load_plugin()
    blocks, reading = cli.read_contours(options.input, options.roi)
    filled = [block for block in blocks if not block.nothing]
    for block in blocks:
        if block.nothing:
            print(f"{block.name}: {block.nothing}, nothing to do.")
    if not filled:
        if any(block.nothing != "no contours" for block in blocks):
            return  # points and open contours, which are nothing to be reconstructed
        raise cli.CommandError(f"{options.input} holds no contours.")
    if reference:
        write_structure_set(options, filled, reference)
    else:
        write_surfaces(options, filled, reading)


def main():
    options = parse(sys.argv[1:])
    try:
        run(options)
    except cli.CommandError as error:
        print(f"contour-reconstruct: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    code = main()
    sys.stdout.flush()
    sys.exit(code)
