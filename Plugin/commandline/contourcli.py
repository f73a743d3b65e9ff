# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line tools share: reconstructing, certifying, printing; reading and writing are beside it.

Runs in pvpython with the plugin's path in CONTOUR_PLUGIN. Every failure is a CommandError whose text is
one sentence for the user.
"""
import json
import math
import os
import sys

from contourstart import simple

# What scripts that use this module find here.
from contourcommon import (CommandError, Notes, NothingToDo, ProgressBar, as_source, detached, load_plugin, new_node, note,  # noqa: F401
                           run_proxy, strings, values)
from contourconvert import collection_of
from contourinput import Contours, read_contours  # noqa: F401
from contouroptions import METHODS, PARAVIEW_FORMATS, READERS, STRUCTURE_SET, SURFACE_FORMATS  # noqa: F401
from contouroutput import output_paths, write_surface  # noqa: F401
from contoursettings import SettingError, apply_settings, describe, settable  # noqa: F401
from contourtable import format_table, quantity, volume, yes


class Result:
    """A surface with what is known about it."""

    def __init__(self, contours, surface, seconds, certificate, report):
        self.contours = contours
        self.surface = surface
        self.seconds = seconds  # list of (stage, seconds)
        self.certificate = certificate  # dictionary; None where the surface was not examined
        self.report = report  # lines

    @property
    def name(self):
        return self.contours.name

    @property
    def triangles(self):
        return self.surface.GetNumberOfPolys()


def settings_for(path, method, settings):
    """The settings with what the format asks for: a .brep has indices, so touching sheets need no gap there, and
    with one the contours at it would no longer run along edges of the surface."""
    given = any(setting.partition("=")[0].casefold() == "pinchgap" for setting in settings)
    brep = os.path.splitext(path)[1].lower() == ".brep"
    return list(settings) + (["PinchGap=0"] if brep and method == "psm" and not given else [])


def reconstruct(contours, method="psm", settings=(), bar=None, examine=True):
    """Contours to a surface, with a certificate unless it is not to be examined."""
    source = as_source(contours.data)
    node = new_node(METHODS[method], Input=source)
    examiner = new_node("SurfaceCertificate", Input=source, Contours=source)
    apply_settings([node, examiner], settings)
    total = run_proxy(node, bar)
    surface = detached(node.GetClientSideObject().GetOutputDataObject(0))
    report = strings(surface, "Report")
    if surface.GetNumberOfPolys() == 0:
        # Whatever went wrong was an error, and has left this function already.
        raise NothingToDo(report[-1] if report else "There is nothing to make a surface of.")
    stages = list(zip(strings(surface, "StageName"), values(surface, "StageSeconds")))
    if not stages:
        stages = [("surface", total)]
    else:
        stages.insert(0, ("clean contours", max(0.0, total - sum(s for _, s in stages))))
    certificate = None
    if examine:
        certificate, seconds = certify(surface, source, bar, examiner)
        stages.append(("certificate", seconds))
    simple.Delete(node)
    simple.Delete(source)
    return Result(contours, surface, stages, certificate, report)


class StructureSetWriter:
    """Traces contours on the slices of a reference, and writes them, a region of interest a block."""

    def __init__(self, path, reference, settings=(), extrapolate=False):
        self.writer = new_node("DICOMRTStructureSetWriter", FileName=path, ReferenceFileName=reference)
        self.reference = reference
        self.settings = settings
        self.extrapolate = extrapolate
        self.traced = []
        self.rows = []  # of the table: name, contours drawn, contours written, slices, seconds
        self.slices = {}  # by frame of reference
        self.on_slices = not any(setting.partition("=")[0].casefold() in ("spacing", "range", "userange") for setting in settings)
        if self.on_slices:
            self._slices_in("")  # what is wrong with the reference is said before anything is computed

    def _slices_in(self, frame):
        """The reference's slices in a frame of reference, in its first one where that is empty."""
        if frame not in self.slices:
            planes = new_node("DICOMSlicePlanes", FileName=self.reference, FrameOfReferenceUID=frame)
            run_proxy(planes)
            self.slices[frame] = planes.GetClientSideObject().GetOutputDataObject(0)
        return self.slices[frame]

    def _planes(self, block):
        if not self.on_slices:
            return {}
        known = self._slices_in("".join(strings(block.data, "FrameOfReferenceUID")))
        return {"Planes": as_source(known), "Extrapolate": int(self.extrapolate)}

    def trace(self, block, bar=None):
        """Fit an implicit function to a block, and take its contours."""
        source = as_source(block.data)
        constraints = new_node("ImplicitConstraints", Input=source)
        function = new_node("ImplicitFunction", Input=constraints)
        try:
            planes = self._planes(block)
        except CommandError as error:
            raise CommandError(f"{block.name}: {error}")
        contours = new_node("ImplicitContours", Input=function, **planes)
        stages = [constraints, function, contours]
        apply_settings(stages + [self.writer], self.settings)
        try:
            seconds = sum(run_proxy(stage, bar) for stage in stages)
        except CommandError as error:
            raise CommandError(f"{block.name}: {error}")
        data = detached(contours.GetClientSideObject().GetOutputDataObject(0))
        fitted = strings(function.GetClientSideObject().GetOutputDataObject(0), "Report")
        for line in strings(block.data, "Report") + strings(data, "Report")[len(fitted):]:
            note(line)
        slices = len(values(data, "LevelOffset"))
        if not slices:
            raise NothingToDo((strings(data, "Report") or ["There is nothing to make contours of."])[-1])
        self.rows.append([block.name, block.data.GetNumberOfCells(), data.GetNumberOfCells(), slices, f"{seconds:.2f}"])
        self.traced.append(Contours(block.name, data))
        for proxy in list(reversed(stages)) + [source] + [planes[name] for name in ("Planes",) if name in planes]:
            simple.Delete(proxy)

    def write(self):
        """Write all that was traced; the node leaves a whole file or none. What it has to say is printed."""
        self.writer.Input = as_source(collection_of(self.traced))
        run_proxy(self.writer)


def certify(surface, contours_proxy, bar=None, node=None):
    """The certificate as a dictionary (its field data by name, and JSON), and the seconds it took.

    node: a Surface Certificate with settings of its own; it is used up.
    """
    source = as_source(surface)
    node = node or new_node("SurfaceCertificate", Input=source)
    node.Input = source
    node.Contours = contours_proxy
    seconds = run_proxy(node, bar)
    data = node.GetClientSideObject().GetOutputDataObject(0)
    certificate = {}
    for i in range(data.GetFieldData().GetNumberOfArrays()):
        array = data.GetFieldData().GetArray(i)
        if array is not None and array.GetNumberOfValues() == 1:
            certificate[array.GetName()] = array.GetValue(0)
    certificate["Lines"] = strings(data, "Certificate")
    certificate["JSON"] = json.loads(strings(data, "CertificateJSON")[0])
    simple.Delete(node)
    simple.Delete(source)
    return certificate, seconds


def contour_count(result):
    """Contours that the surface was made from."""
    used = values(result.surface, "ContourCount")
    return int(used[0]) if used else result.contours.data.GetNumberOfCells()


def figures(result):
    """What there is to say of a surface, by name; None where it was not examined."""
    known = {"Name": result.name, "Contours": contour_count(result), "Triangles": result.triangles,
             "Seconds": round(sum(s for _, s in result.seconds), 3), "Notes": result.report}
    c = result.certificate
    told = ("VolumeByContours", "LowestVolume", "HighestVolume")
    if c is None:
        return {**known, "Closed": None, "Manifold": None, "CrossingPairs": None, "Volume": None, "Area": None,
                **dict.fromkeys(told)}
    return {**known, "Closed": bool(c["Closed"]), "Manifold": bool(c["EdgeManifold"] and c["VertexManifold"] and c["Oriented"]),
            "CrossingPairs": int(c["CrossingPairs"]), "Volume": _finite(c["Volume"]), "Area": _finite(c["Area"]),
            **{name: _finite(c.get(name)) for name in told}}


def _finite(value):
    return value if value is not None and math.isfinite(value) else None


def print_results(results, extra_stages=()):
    """The table: a row a surface, then seconds by stage, then what was left out or repaired."""
    units = {r.contours.unit for r in results}
    unit = units.pop() if len(units) == 1 else None
    rows = []
    for r in results:
        f = figures(r)
        crossings = "-" if f["CrossingPairs"] is None else f["CrossingPairs"]
        rows.append([r.name, f["Contours"], f["Triangles"], yes(f["Closed"]), yes(f["Manifold"]), crossings,
                     quantity(volume(f["Volume"], unit)[0]), f"{sum(s for _, s in r.seconds):.2f}"])
    titles = ["", "contours", "triangles", "closed", "manifold", "crossings", f"volume/{volume(None, unit)[1]}", "seconds"]
    print(format_table(rows, titles))
    print()
    print_stages(results, extra_stages)
    notes = [(r.name, line) for r in results for line in r.report]
    if notes:
        print(f"\n{len(notes)} notes on contours:")
        for name, line in notes[:20]:
            print(f"  {name}: {line}")
        if len(notes) > 20:
            print(f"  ... and {len(notes) - 20} more, in the field data Report of the surface.")
    sys.stdout.flush()


def print_stages(results, extra_stages=()):
    names = []
    for r in results:
        names += [stage for stage, _ in r.seconds if stage not in names]
    rows = [[stage] + [f"{dict(r.seconds).get(stage, 0.0):.3f}" for r in results] for stage in names]
    rows += [[stage, f"{seconds:.3f}"] + [""] * (len(results) - 1) for stage, seconds in extra_stages]
    if len(results) <= 6:
        print(format_table(rows, ["seconds"] + [r.name for r in results]))
        return
    sums = [[stage, f"{sum(dict(r.seconds).get(stage, 0.0) for r in results):.3f}"] for stage in names]
    sums += [[stage, f"{seconds:.3f}"] for stage, seconds in extra_stages]
    print(format_table(sums, ["seconds", "all"]))
