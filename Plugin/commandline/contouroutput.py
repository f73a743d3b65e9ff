# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces into files: their names, their precision, and never half a file."""
import os
import time
import unicodedata

from contourstart import simple

from contourcommon import CommandError, Watched, as_source, detached, new_node, note, run_proxy, uninterrupted
from contouroptions import SURFACE_FORMATS
from contourreplaced import replaced

SINGLE_PRECISION = (".stl",)
LONGEST_NAME = 100   # characters of a region's name in a file's
LONGEST_FILE = 240   # bytes: what file systems take (255), less what a file is called while it is written
# A move of the points by less than this part of the surface's diagonal is rounding that no triangle minds.
HARMLESS_MOVE = 1e-6


def _kept(letter):
    return letter in "._-" or unicodedata.category(letter)[0] in "LMN"


def _in_file_name(name):
    """The letters, marks and digits of a name, of any alphabet; all else, such as slashes, becomes one _."""
    plain = "".join(c if _kept(c) else " " for c in unicodedata.normalize("NFC", name))
    return "_".join(plain.split())[:LONGEST_NAME].strip("._") or "ROI"


def _cut(text, most):
    """The longest beginning that takes no more bytes than that; never half a letter."""
    while len(os.fsencode(text)) > most:
        text = text[:-1]
    return text


def output_paths(path, blocks):
    """A path a block: the path itself for one, else with the region's name, and its number where names are the same."""
    if len(blocks) == 1:
        return [path]
    folder, base = os.path.split(path)
    stem, extension = os.path.splitext(base)
    room = LONGEST_FILE - len(os.fsencode(f"{stem}-{extension}"))
    if room < 1:
        raise CommandError(f"{path}: the name is too long for a file a region.")
    names = [_cut(_in_file_name(block.name), room) for block in blocks]
    count = {}
    for name in names:
        count[name.casefold()] = count.get(name.casefold(), 0) + 1
    taken = {name.casefold() for name in names if count[name.casefold()] == 1}
    paths = []
    for i, (name, block) in enumerate(zip(names, blocks)):
        if count[name.casefold()] > 1:
            name = _numbered(name, block.number if block.number is not None else i + 1, room, taken)
        paths.append(os.path.join(folder, f"{stem}-{name}{extension}"))
    return paths


def _numbered(name, number, room, taken):
    """The name with the number, and one more where even that is taken (a number twice in a file)."""
    tail, more = f"-{number}", 1
    while True:
        candidate = _cut(name[:LONGEST_NAME - len(tail)], room - len(tail)) + tail
        if candidate.casefold() not in taken:
            taken.add(candidate.casefold())
            return candidate
        more += 1
        tail = f"-{number}-{more}"


def offset_of(surface, offset):
    """What is taken from coordinates, as three numbers."""
    if offset is None:
        return [0.0, 0.0, 0.0]
    if offset == "auto":
        bounds = surface.GetBounds()
        return [float(round((bounds[2 * a] + bounds[2 * a + 1]) / 2)) for a in range(3)]
    return list(offset)


def moved(data, offset):
    """The data with the offset taken from all points, in double precision."""
    if data is None or not any(offset):
        return data
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    places = vtk_to_numpy(data.GetPoints().GetData()).astype(float) - offset
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    copy = detached(data)
    copy.SetPoints(points)
    return copy


def single_precision_move(surface):
    """(farthest that a point moves when it is written in single precision, diagonal of the surface)."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if surface.GetNumberOfPoints() == 0:
        return 0.0, 0.0
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    moves = numpy.linalg.norm(points.astype(numpy.float32).astype(float) - points, axis=1)
    diagonal = numpy.linalg.norm(points.max(axis=0) - points.min(axis=0))
    return float(moves.max()), float(diagonal)


def _as_stored(surface):
    """The surface as single precision has it."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    rounded = vtk_to_numpy(surface.GetPoints().GetData()).astype(numpy.float32).astype(float)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(rounded, deep=True))
    copy = detached(surface)
    copy.SetPoints(points)
    return copy


def warn_of_precision(path, surface):
    """What is written is what was certified: say so where single precision makes it another surface."""
    move, diagonal = single_precision_move(surface)
    if move <= HARMLESS_MOVE * diagonal:
        return
    source = as_source(_as_stored(surface))
    certificate = new_node("SurfaceCertificate", Input=source)
    run_proxy(certificate)
    figures = certificate.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    crossing = int(figures.GetArray("CrossingPairs").GetValue(0) + figures.GetArray("OverlappingPairs").GetValue(0))
    flat = int(figures.GetArray("DegenerateTriangles").GetValue(0))
    simple.Delete(certificate)
    simple.Delete(source)
    what = f"{crossing} pairs of triangles cross in the file; " if crossing else ""
    what += f"{flat} triangles have no area in the file; " if flat else ""
    note(f"{path}: STL has single precision, which moves points by up to {move:.3g} at coordinates this large; {what}"
         "write .vtp, .ply or .brep, or add --offset auto.")


def write_surface(path, result, offset=None):
    """Write a surface by the file's extension, under another name first, so that no half file is left."""
    extension = os.path.splitext(path)[1].lower()
    if extension not in SURFACE_FORMATS:
        raise CommandError(f"{path}: cannot write '{extension}' files; surfaces are written to "
                           f"{' '.join(SURFACE_FORMATS)}.")
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise CommandError(f"There is no folder {folder} to write {os.path.basename(path)} to.")
    start = time.perf_counter()
    taken = offset_of(result.surface, offset)
    surface, contours = moved(result.surface, taken), moved(result.contours.data, taken)
    if any(taken):
        note(f"{path}: coordinates are those of the contours less ({', '.join(f'{x:.15g}' for x in taken)}).")
    if extension in SINGLE_PRECISION:
        warn_of_precision(path, surface)
    with uninterrupted():
        try:
            with replaced(path) as part:
                _write(part, extension, surface, contours)
                if not os.path.exists(part) or os.path.getsize(part) == 0:
                    raise CommandError(f"{path} could not be written: is the disk full, or the folder write-protected?")
        except OSError as error:
            raise CommandError(f"{path} could not be written: {error.strerror}.")
    return time.perf_counter() - start


def _write_brep(path, surface, contours):
    sources = as_source(surface), as_source(contours)
    writer = new_node("BRepWriter", Input=sources[0], Contours=sources[1], FileName=path)
    with Watched(writer.GetClientSideObject()) as watched:
        writer.UpdatePipeline()
        watched.check()
    for proxy in (writer,) + sources:
        simple.Delete(proxy)


def _write_ply(path, surface):
    """Binary, in double precision, which VTK's own writer has not."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype("<f8")
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    faces = numpy.empty(len(corners), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"] = 3
    faces["corners"] = corners
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode("ascii"))
        file.write(numpy.ascontiguousarray(points).tobytes())
        file.write(faces.tobytes())


def _run_writer(writer, path):
    with Watched(writer) as watched:
        writer.Write()
        watched.check()
    if writer.GetErrorCode():
        raise CommandError(f"{os.path.basename(path)} could not be written (VTK error code {writer.GetErrorCode()}).")


def _write_vtp(path, surface):
    """By way of memory: VTK's writer ends the program on a full disk."""
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    writer = vtkXMLPolyDataWriter()
    writer.SetInputDataObject(surface)
    # Inline: data appended behind the XML trips VTK's reader with the expat of today's Debian 12.
    writer.SetDataModeToBinary()
    writer.WriteToOutputStringOn()
    _run_writer(writer, path)
    with open(path, "w", encoding="utf-8") as file:
        file.write(writer.GetOutputString())


def _write(path, extension, surface, contours):
    if extension == ".brep":
        _write_brep(path, surface, contours)
        return
    if extension == ".ply":
        _write_ply(path, surface)
        return
    if extension == ".vtp":
        _write_vtp(path, surface)
        return
    from vtkmodules.vtkIOGeometry import vtkSTLWriter
    writer = vtkSTLWriter()
    writer.SetInputDataObject(surface)
    writer.SetFileName(path)
    writer.SetFileTypeToBinary()
    _run_writer(writer, path)
