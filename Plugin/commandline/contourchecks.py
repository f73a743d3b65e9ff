# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be said of a call before any work is done. Needs no ParaView."""
import os

from contouroptions import (CONTOUR_FORMATS, NO_CERTIFICATE, STRUCTURE_SET, SURFACE_FORMATS, UsageError, is_contours, is_structure_set,
                            outputs)


def is_dicom(path):
    """By content: the preamble's magic word, or, of files without a preamble, a first element of group 2 or 8."""
    try:
        with open(path, "rb") as file:
            head = file.read(132)
    except OSError:
        return False
    return head[128:132] == b"DICM" or head[:2] in (b"\x02\x00", b"\x08\x00")


def parse_offset(text):
    """Three numbers, or "auto"."""
    if text is None or text == "auto":
        return text
    try:
        numbers = [float(word) for word in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != 3:
        raise UsageError(f"--offset {text}: give X,Y,Z, or auto for the middle of the surface in whole numbers.")
    return numbers


def check_output(path):
    """Say that the output cannot be written before the work is done, not after it."""
    extension = os.path.splitext(path)[1].lower()
    if extension not in SURFACE_FORMATS + (STRUCTURE_SET,) + CONTOUR_FORMATS:
        raise UsageError(f"{path}: cannot write '{extension}' files; surfaces are written to "
                         f"{' '.join(SURFACE_FORMATS)}, contours to {STRUCTURE_SET} {' '.join(CONTOUR_FORMATS)}.")
    check_folder(path)


def check_folder(path):
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise UsageError(f"There is no folder {folder} to write {os.path.basename(path)} to.")
    if not os.access(folder, os.W_OK):
        raise UsageError(f"The folder {folder} is not writable.")


def check_call(options):
    """What holds for all files of a call."""
    for output in outputs(options):
        check_output(output)
    for path in (options.certificate, options.summary):
        if path and path != NO_CERTIFICATE:
            check_folder(path)
    if is_structure_set(options.output):
        _check_contours_out(options)
    elif options.reference or options.extrapolate:
        raise UsageError("--reference and --extrapolate are for an RT structure set (.dcm), and "
                         f"{options.output} is none.")
    if is_contours(options.output):
        _check_conversion(options)
    parse_offset(options.offset)


def _check_conversion(options):
    """Nothing is made on the way, so nothing can be set or examined."""
    for given, name in ((options.settings, "--set"), (options.offset, "--offset"),
                        (options.certificate not in (None, NO_CERTIFICATE), "--certificate")):
        if given:
            raise UsageError(f"{name} is about surfaces, and {options.output} will hold the contours as they are.")
    for path, output in zip(options.inputs, outputs(options)):
        if os.path.exists(path) and os.path.exists(output) and os.path.samefile(path, output):
            raise UsageError(f"{output} is read as well, and not overwritten; give another name.")


def _check_contours_out(options):
    if options.method != "ism":
        raise UsageError(f"{options.output}: contours on other slices are the implicit method's; add --method ism.")
    if options.certificate and options.certificate != NO_CERTIFICATE:
        raise UsageError(f"--certificate is about surfaces, and {options.output} will hold contours.")
    if options.offset:
        raise UsageError("--offset is for surfaces: contours in a structure set stay where the patient is.")


def checked_reference(options, path, output):
    """The file that patient and slices come from, of contours that are written; None of surfaces."""
    if not is_structure_set(output):
        return None
    reference = options.reference or (path if is_structure_set(path) or is_dicom(path) else None)
    if not reference:
        raise UsageError(f"{output} needs a patient and slices: give the RT structure set that the contours were drawn "
                         "in, or an image of the series, by --reference.")
    for read in (reference, path):
        if not os.path.exists(read):
            raise UsageError(f"There is no file {read}.")
        if os.path.exists(output) and os.path.samefile(read, output):
            raise UsageError(f"{output} is read as well, and not overwritten; give another name.")
    if os.path.exists(output) and not options.force:
        raise UsageError(f"{output} is there already; give another name, or --force to replace it.")
    return reference
