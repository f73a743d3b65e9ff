# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours to closed surfaces on the command line; run it as `./run reconstruct` or `contour-reconstruct`."""
import argparse
import json
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contourcli as cli


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog=os.environ.get("CONTOUR_PROGRAM", "contour-reconstruct"),
        description="Turn planar contours into closed surfaces and print what they are worth.",
        epilog="Of several ROIs each gets a file of its own: OUT with the ROI's name before the extension.")
    parser.add_argument("input", metavar="IN", help="contours: " + " ".join(cli.READERS))
    parser.add_argument("output", metavar="OUT",
                        help="surface: " + " ".join(cli.SURFACE_FORMATS) +
                             "; or, of --method ism, contours on all slices as an RT structure set: .dcm")
    parser.add_argument("--method", choices=sorted(cli.METHODS), default="psm",
                        help="psm: polyhedral, exactly through parallel contours (default); "
                             "ism: implicit, smooth, contours on any planes")
    parser.add_argument("--roi", nargs="+", metavar="NAME", default=[],
                        help="the ROIs of a structure set to take; all without this")
    parser.add_argument("--set", action="append", metavar="PROPERTY=VALUE", default=[], dest="settings",
                        help="a property of the node (Polyhedral Surface or Implicit Surface); repeatable")
    parser.add_argument("--reference", metavar="FILE",
                        help="for OUT.dcm: the RT structure set that the contours were drawn in, or one image of their "
                             "series; it gives patient, study and slices (IN, where that is one)")
    parser.add_argument("--extrapolate", action="store_true",
                        help="for OUT.dcm: also on slices beyond the outermost drawn points, where the surface closes")
    parser.add_argument("--certificate", metavar="FILE.json",
                        help="write everything that is known about the surfaces")
    return parser.parse_args(arguments)


def output_path(path, name, several):
    if not several:
        return path
    stem, extension = os.path.splitext(path)
    return f"{stem}-{re.sub(r'[^A-Za-z0-9._-]+', '_', name)}{extension}"


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


def check_structure_set(options):
    """What can be said about OUT.dcm before any work. Returns the reference."""
    if options.method != "ism":
        raise cli.CommandError(f"{options.output}: contours on other slices are the implicit method's; "
                               "add --method ism.")
    if options.certificate:
        raise cli.CommandError(f"--certificate is about surfaces, and {options.output} will hold contours.")
    reference = options.reference or (options.input if is_structure_set(options.input) else None)
    if not reference:
        raise cli.CommandError(f"{options.output} needs a patient and slices: give the RT structure set that the "
                               "contours were drawn in, or an image of the series, by --reference.")
    if not os.path.exists(reference):
        raise cli.CommandError(f"There is no file {reference}.")
    for path in (reference, options.input):
        if os.path.exists(options.output) and os.path.samefile(path, options.output):
            raise cli.CommandError(f"{options.output} is read as well, and not overwritten; give another name.")
    return reference


def write_structure_set(options, blocks, reference):
    writer = cli.StructureSetWriter(options.output, reference, options.settings, options.extrapolate)
    for block in blocks:
        bar = cli.ProgressBar(block.name)
        try:
            writer.trace(block, bar)
        finally:
            bar.clear()
    writer.write()
    print(cli.format_table(writer.rows, ["", "contours drawn", "written", "slices", "seconds"]))
    print("\nWritten: " + options.output)


def run(options):
    check_output(options.output)
    reference = check_structure_set(options) if is_structure_set(options.output) else None
    if (options.reference or options.extrapolate) and not reference:
        raise cli.CommandError("--reference and --extrapolate are for an RT structure set (.dcm), and "
                               f"{options.output} is none.")
    cli.load_plugin()
    blocks, reading = cli.read_contours(options.input, options.roi)
    filled = [block for block in blocks if not block.empty]
    for block in blocks:
        if block.empty:
            print(f"{block.name}: no contours, nothing to do.")
    if not filled:
        raise cli.CommandError(f"{options.input} holds no contours.")

    if reference:
        write_structure_set(options, filled, reference)
        return

    results, failures, files, writing = [], [], [], 0.0
    for block in filled:
        bar = cli.ProgressBar(block.name)
        try:
            result = cli.reconstruct(block, options.method, options.settings, bar)
            path = output_path(options.output, block.name, len(filled) > 1)
            if path in files:
                raise cli.CommandError(f"another ROI has the file name {path} already; take them one by one with --roi.")
            writing += cli.write_surface(path, result)
            results.append(result)
            files.append(path)
        except cli.CommandError as error:
            failures.append((block.name, str(error)))
        finally:
            bar.clear()

    if results:
        cli.print_results(results, [("read", reading), ("write", writing)])
        print("\nWritten: " + ", ".join(files))
    if options.certificate and results:
        write_certificate(options.certificate, results)
        print("Written: " + options.certificate)
    if len(filled) == 1 and failures:
        raise cli.CommandError(failures[0][1])
    if failures:
        raise cli.CommandError(f"{len(failures)} of {len(filled)} ROIs gave no surface: "
                               + "; ".join(f"{name}: {why}" for name, why in failures))


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
