# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers and writers of all formats."""
from __future__ import annotations

import os
import pathlib
import tempfile
from collections.abc import Iterable, Mapping
from typing import Any, Optional, Union

import numpy as np

from . import _core
from ._data import (Contours, ContoursLike, Progress, Regions, Surface, SurfaceLike, contours_of, given, make_contours,
                    make_surface, surface_of)
from ._properties import checked

Path = Union[str, "os.PathLike[str]"]


def _with_dictionary() -> None:
    _core.load_dictionary(str(pathlib.Path(__file__).with_name("dicom.dic")))


def read(path: Path, *, progress: Progress = None) -> Union[Contours, Regions]:
    """Read contours of any format, told by what is in the file.

    Parameters
    ----------
    path : str or path
        A NUAGES file (.cnt), a cross-section set or curve network (.csl, .contour), a DICOM RT structure set, or what
        `read_traces` reads.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    Contours or Regions
        Regions, Contours by name, where the file is a structure set or has several materials.

    Raises
    ------
    Error
        Where the file is none of these, or not whole; the sentence names file and place.
    """
    name = os.fspath(path)
    kind = _core.format_of(name)
    if kind == "NUAGES" or name.lower().endswith(".cnt"):
        return read_nuages(path, progress=progress)
    if kind == "CurveNetwork" or name.lower().endswith((".csl", ".contour")):
        return read_curve_network(path, progress=progress)
    _with_dictionary()
    if kind != "BRep" and (_core.is_structure_set(name) or name.lower().endswith(".dcm")):
        return read_structure_set(path, progress=progress)
    if not kind and _core.trace_format_of(name):
        return read_traces(path, progress=progress)
    if kind == "BRep" or name.lower().endswith(".brep"):
        raise _core.Error(f"Cannot read {name} as contours: it is a boundary representation, for read_brep.")
    what = "contours of a format that is known here" if os.path.exists(name) else "a file"
    raise _core.Error(f"Cannot read {name}: it is not {what} (.cnt, .csl, .contour, or a DICOM RT structure set).")


def read_nuages(path: Path, *, progress: Progress = None) -> Contours:
    """Read closed contours on slices perpendicular to z from a NUAGES file (.cnt), in its units.

    Parameters
    ----------
    path : str or path
        The file.
    progress : callable, optional
        See `contour_hierarchy`.

    Raises
    ------
    Error
        Where the file is not whole; the sentence names the line.
    """
    return make_contours(_core.read_nuages(os.fspath(path), progress))


def write_nuages(path: Path, contours: ContoursLike, *, progress: Progress = None) -> list[str]:
    """Write closed contours on planes perpendicular to z to a NUAGES file (.cnt), in full precision.

    Parameters
    ----------
    path : str or path
        The file to write; it is replaced when the new one is whole.
    contours : Contours or sequence of array_like of shape (k, 3)
        With the cell data Depth, outer walls are written clockwise and holes counterclockwise, as the format has it.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    list of str
        What was left out or moved.

    Raises
    ------
    Error
        Where a contour does not close or lies in another plane, or the file cannot be written; there is no file then.
    """
    source = contours_of(contours)
    depth = source.cell_data.get("Depth")
    depths = None if depth is None else np.ascontiguousarray(depth, dtype=np.int32)
    return _core.write_nuages(os.fspath(path), given(source), depths, progress)


def read_curve_network(path: Path, *, progress: Progress = None) -> Union[Contours, Regions]:
    """Read cross-sections with materials from a .csl or .contour file.

    Parameters
    ----------
    path : str or path
        The file.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    Contours or Regions
        Of one material; or by name ("Material 2") where there are several. The cell data Plane number the planes.

    Raises
    ------
    Error
        Where the file is neither, or not whole; the sentence names the line.
    """
    made = _core.read_curve_network(os.fspath(path), progress)
    materials = [make_contours(material) for material in made["materials"]]
    if len(materials) == 1:
        materials[0].report = made["report"]
        return materials[0]
    return Regions(((f"Material {each.field_data['Material']}", each) for each in materials), made["report"])


def read_traces(path: Union[Path, Iterable[Path]], *, SliceSpacing: float = 1, PixelSize: float = 1,
                progress: Progress = None) -> Regions:
    """Read what tracing and drawing programs save, told by what is in the file.

    Parameters
    ----------
    path : str or path, or several of drawings
        An IMOD model, ROIs of ImageJ (.roi, .zip), a series of Reconstruct or PyReconstruct, drawings (.svg, a slice
        each), or a table with columns x, y and a slice or contour (.csv).
    SliceSpacing : float, default: 1
        Distance of the slices, in the unit of the result, where the file tells none; negative: towards -z.
    PixelSize : float, default: 1
        What one unit of the drawing is in the unit of the result, where the file tells none.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    Regions
        Contours by the name of their object, with the cell data GeometricType and Slice, and the field data ROIName,
        ROINumber, ROIColor and LengthUnit.

    Raises
    ------
    Error
        Where the file is none of these, or not whole; the sentence names file and place.
    """
    paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    if not paths:
        raise _core.Error("There is no file to read: give the name of one.")
    stack = checked({"SliceSpacing": SliceSpacing, "PixelSize": PixelSize})
    made = _core.read_traces([os.fspath(each) for each in paths], stack["SliceSpacing"], stack["PixelSize"], progress)
    objects = [make_contours(each) for each in made["objects"]]
    return Regions(((each.field_data["ROIName"], each) for each in objects), made["report"])


def list_rois(path: Path) -> list[dict[str, Any]]:
    """List the regions of interest of a DICOM RT structure set, without reading their contours.

    Parameters
    ----------
    path : str or path
        The structure set.

    Returns
    -------
    list of dict
        ROIName, ROINumber, ROIType, NumberOfContours, and where the file tells them FrameOfReferenceUID and ROIColor.

    Raises
    ------
    Error
        Where the file is no whole RT structure set.
    """
    _with_dictionary()
    return _core.list_rois(os.fspath(path))


def read_structure_set(path: Path, rois: Optional[Iterable[str]] = None, *, progress: Progress = None) -> Regions:
    """Read the contours of a DICOM RT structure set.

    Parameters
    ----------
    path : str or path
        The structure set, with preamble or without.
    rois : iterable of str, optional
        Names of the regions of interest that are wanted; all of them without it.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    Regions
        Contours by name, in millimetres of the DICOM patient coordinate system. Their field data are ROIName,
        ROINumber, ROIType, ROIColor and FrameOfReferenceUID, their cell data GeometricType and ContourNumber.

    Raises
    ------
    Error
        Where the file is no whole RT structure set, or has no region of a name that is wanted. What is wrong with one
        contour costs that contour, and is in the report.
    """
    _with_dictionary()
    wanted = None if rois is None else [rois] if isinstance(rois, str) else list(rois)
    made = _core.read_structure_set(os.fspath(path), wanted, progress)
    regions = Regions(((roi["field_data"]["ROIName"], make_contours(roi)) for roi in made["rois"]), made["report"])
    unknown = [name for name in wanted or () if name not in regions]
    if unknown:
        there = ", ".join(repr(roi["ROIName"]) for roi in list_rois(path))
        raise _core.Error(f"There is no ROI {unknown[0]!r} in {os.fspath(path)}: it has {there}.")
    return regions


def _described(name: str, contours: Contours, roi_type: str) -> dict[str, Any]:
    data = contours.field_data
    color = data.get("ROIColor")
    return {
        "ROIName": name, "ROIType": roi_type or str(data.get("ROIType", "")),
        "FrameOfReferenceUID": str(data.get("FrameOfReferenceUID", "")), "ROINumber": int(data.get("ROINumber", 0)),
        "ROIColor": None if color is None else [int(value) for value in np.ravel(color)[:3]],
        "loops": given(contours), "types": [str(kind) for kind in contours.cell_data.get("GeometricType", ())],
    }


def write_structure_set(path: Path, contours: Union[ContoursLike, Mapping[str, ContoursLike]], *,
                        ReferenceFileName: Path = "", CopyReferenceROIs: bool = True, ROIName: str = "",
                        ROIType: str = "", StructureSetLabel: str = "Reconstruction",
                        GenerationAlgorithm: Union[str, int] = "Semiautomatic",
                        Holes: Union[str, int] = "Separate Contours", progress: Progress = None) -> list[str]:
    """Write contours to a DICOM RT structure set, one region of interest or one for each name.

    Parameters
    ----------
    path : str or path
        The file to write.
    contours : Contours, sequence of array_like of shape (k, 3), or mapping of str to these
        Millimetres of the DICOM patient coordinate system; written with six decimals.
    ReferenceFileName : str or path, default: ""
        Where patient, study, frame of reference and images come from: an RT structure set, or one image of a series.
    CopyReferenceROIs : bool, default: True
        Write the regions of the reference as well, unchanged.
    ROIName : str, default: ""
        Name of the region, where there is one; empty: the one that the data have, or "Contours".
    ROIType : str, default: ""
        Interpreted type of the regions, such as "ORGAN"; empty keeps what the data say.
    StructureSetLabel : str, default: "Reconstruction"
        At most 16 characters.
    GenerationAlgorithm : {"Semiautomatic", "Automatic", "Manual"}
        How the new regions came about.
    Holes : {"Separate Contours", "XOR", "Keyholes"}
        How holes are written.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    list of str
        What was left out or changed.

    Raises
    ------
    Error
        Where there is nothing to write, a contour cannot be written, or the reference cannot be used or would be
        overwritten; there is no file then.
    """
    _with_dictionary()
    ReferenceFileName = os.fspath(ReferenceFileName)
    properties = checked(locals())
    if isinstance(contours, Mapping):
        regions = {name: contours_of(region) for name, region in contours.items()}
        if ROIName and len(regions) > 1:
            raise _core.Error(f"ROIName names one ROI, and there are {len(regions)} regions: leave it empty.")
    else:
        region = contours_of(contours)
        regions = {str(region.field_data.get("ROIName", "")) or "Contours": region}
    rois = [_described(ROIName or name, region, ROIType) for name, region in regions.items()]
    return _core.write_structure_set(os.fspath(path), rois, properties, progress)


def read_slice_planes(path: Path, *, FrameOfReferenceUID: str = "", progress: Progress = None) -> Contours:
    """Read the planes of the images of a DICOM series, for `contours_on_planes`.

    Parameters
    ----------
    path : str or path
        An RT structure set, or one image of the series, whose other images are in the same folder.
    FrameOfReferenceUID : str, default: ""
        The frame of reference that the slices must be in; empty: the only one of the file, or the first.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    Contours
        A rectangle an image, in millimetres of the patient coordinate system, with the cell data SOPInstanceUID and
        PixelArea (mm2).

    Raises
    ------
    Error
        Where the file is neither, damaged, in other frames of reference, or tells no plane.
    """
    _with_dictionary()
    return make_contours(_core.read_slice_planes(os.fspath(path), FrameOfReferenceUID, progress))


def read_brep(path: Path, *, progress: Progress = None) -> tuple[Surface, Contours]:
    """Read shells of triangles, and the contours that lie in them, from a boundary representation (.brep).

    Parameters
    ----------
    path : str or path
        The file.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    surface : Surface
        With the cell data ShellId and ShellSet.
    contours : Contours
        Loops along edges of the surface, of its own points.

    Raises
    ------
    Error
        Where the file does not follow the grammar or does not hold together; the sentence says where.
    """
    made = _core.read_brep(os.fspath(path), progress)
    return make_surface(made["surface"]), make_contours(made["contours"])


def write_brep(path: Path, surface: SurfaceLike, contours: Optional[ContoursLike] = None, *,
               progress: Progress = None) -> list[str]:
    """Write a surface, and contours that lie in it, as a boundary representation (.brep), in full precision.

    Parameters
    ----------
    path : str or path
        The file to write.
    surface : Surface or tuple (points, triangles)
        An oriented manifold; its cell data ShellSet are followed.
    contours : Contours or sequence of array_like of shape (k, 3), optional
        Those that run along edges of the surface are written; make the surface with ``PinchGap=0`` to keep all.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    list of str
        What was left out.

    Raises
    ------
    Error
        Where the surface is no oriented manifold, or the file cannot be written; there is no file then.
    """
    points, triangles, _ = surface_of(surface)
    sets = surface.cell_data.get("ShellSet") if isinstance(surface, Surface) else None
    shell_sets = None if sets is None else np.ascontiguousarray(sets, dtype=np.int32)
    loops = None if contours is None else given(contours_of(contours))
    return _core.write_brep(os.fspath(path), points, triangles, shell_sets, loops, progress)


def write_stl(path: Path, surface: SurfaceLike) -> None:
    """Write triangles to a binary STL file, in single precision, as the format has it.

    Parameters
    ----------
    path : str or path
        The file to write; it is replaced when the new one is whole.
    surface : Surface or tuple (points, triangles)
        Any triangles.

    Raises
    ------
    Error
        Where a triangle names a point that there is not, or the file cannot be written.
    """
    points, triangles, _ = surface_of(surface)
    if triangles.size and (triangles.min() < 0 or triangles.max() >= len(points)):
        raise _core.Error(f"A triangle names a point that is not among the {len(points)} points.")
    rows = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    rows["corners"] = points[triangles]
    first, second, third = (points[triangles[:, i]] for i in range(3))
    normals = np.cross(second - first, third - first)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    rows["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    name = os.fspath(path)
    part = ""
    try:
        with tempfile.NamedTemporaryFile(dir=os.path.dirname(name) or ".", suffix=".part", delete=False) as file:
            part = file.name
            file.write(b"contour_reconstruction".ljust(80) + np.uint32(len(rows)).tobytes() + rows.tobytes())
        os.chmod(part, 0o666 & ~_umask())
        os.replace(part, name)
    except OSError as error:
        if part:
            os.unlink(part)
        raise _core.Error(f"Cannot write {name}: {error.strerror}.") from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
