# SPDX-License-Identifier: GPL-3.0-or-later
"""Witnesses of a written RT structure set that are not ours: dicom3tools' dciodvfy, and pydicom.

Both are Debian packages that `./run test` installs. Where one is missing the test says so and goes on; skipped()
tells at the end whether any was.
"""
import shutil
import subprocess

import contourtesting as ct

_missing = set()


def _note_missing(what, package):
    if what not in _missing:
        print(f"SKIPPED: the check by {what}, which is not there; install Debian's {package}.")
    _missing.add(what)


def check_validity(path, known=()):
    """No line of dciodvfy begins with Error; its warnings are printed.

    known: what it takes for errors and is none; its tables of 2022 lack the contour type CLOSEDPLANAR_XOR.
    """
    if not shutil.which("dciodvfy"):
        _note_missing("dciodvfy", "dicom3tools")
        return
    run = subprocess.run(["dciodvfy", path], capture_output=True, text=True, errors="replace")
    lines = (run.stdout + run.stderr).splitlines()
    ct.check("RTStructureSet" in lines, f"dciodvfy knows {path} as a structure set: {lines[:3]}")
    errors = sorted({line for line in lines if line.startswith("Error")
                     and not any(word in line for word in known)})
    ct.check(not errors, f"dciodvfy on {path}: {errors}")
    for line in sorted({line for line in lines if line.startswith("Warning")}):
        print(f"  dciodvfy: {line}")


def pydicom_rois(path):
    """What pydicom reads: {name: [(geometric type, [x, y, z, ...], [referred instances])]}; None without pydicom."""
    try:
        import pydicom
    except ImportError:
        _note_missing("pydicom", "python3-pydicom")
        return None
    data = pydicom.dcmread(path)
    names = {int(roi.ROINumber): str(roi.ROIName) for roi in data.StructureSetROISequence}
    rois = {name: [] for name in names.values()}
    for roi in data.ROIContourSequence:
        for contour in getattr(roi, "ContourSequence", []):
            images = [str(i.ReferencedSOPInstanceUID) for i in getattr(contour, "ContourImageSequence", [])]
            rois[names[int(roi.ReferencedROINumber)]].append(
                (str(contour.ContourGeometricType), [float(x) for x in contour.ContourData], images))
    return rois


def skipped():
    """Names of the witnesses that were missing."""
    return sorted(_missing)


def contours_of(poly):
    """[x, y, z, ...] of every cell, closed ones without the repeated first point."""
    from vtkmodules.vtkCommonCore import vtkIdList
    result, ids = [], vtkIdList()
    for c in range(poly.GetNumberOfCells()):
        poly.GetCellPoints(c, ids)
        points = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        if len(points) > 2 and points[0] == points[-1]:
            points.pop()
        result.append([x for p in points for x in poly.GetPoint(p)])
    return result


def largest_difference(a, b):
    """Largest difference of coordinates, mm; infinite where the contours are not the same in number and length."""
    if [len(x) for x in a] != [len(x) for x in b]:
        return float("inf")
    return max((abs(p - q) for x, y in zip(a, b) for p, q in zip(x, y)), default=0.0)
