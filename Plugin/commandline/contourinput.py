# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours out of files: those that the plugin reads, and those that ParaView reads by itself."""
import os

from contourstart import simple

from contourchecks import is_dicom
from contourcommon import CommandError, Watched, as_source, detached, new_node, note, run_proxy, strings, values
from contouroptions import PARAVIEW_FORMATS, READERS

OPEN_TYPES = ("POINT", "OPEN_PLANAR", "OPEN_NONPLANAR")


class Contours:
    """Contours of one region: a name, a vtkPolyData, and the unit of its coordinates where that is known."""

    def __init__(self, name, data, unit=None):
        self.name = name
        self.data = data
        self.unit = unit

    @property
    def nothing(self):
        """Why there is nothing to do for this region; empty where there is something."""
        if self.data is None or self.data.GetNumberOfCells() == 0:
            return "no contours"
        if self.data.GetNumberOfCells() == self.data.GetNumberOfVerts():
            return "points only"  # markers and isocentres of a structure set
        types = self.data.GetCellData().GetAbstractArray("GeometricType")
        if types and all(types.GetValue(i) in OPEN_TYPES for i in range(types.GetNumberOfValues())) \
                and not self._ends_meet():
            return "open contours only"
        return ""

    def _ends_meet(self):
        """Whether the last point of some line has the place of the first: it is closed, whatever its type."""
        for i in range(self.data.GetNumberOfVerts(), self.data.GetNumberOfCells()):
            cell = self.data.GetCell(i)
            last = cell.GetNumberOfPoints() - 1
            if last > 2 and cell.GetPoints().GetPoint(0) == cell.GetPoints().GetPoint(last):
                return True
        return False

    @property
    def empty(self):
        return bool(self.nothing)

    @property
    def number(self):
        """The ROI's number in its file, or None."""
        found = values(self.data, "ROINumber") if self.data is not None else []
        return int(found[0]) if found else None


def choose_rois(known, wanted, path):
    """The names of the file that the wanted ones mean: exact, or in another case where only one is."""
    chosen = []
    for name in wanted:
        same = [k for k in known if k == name] or [k for k in known if k.casefold() == name.casefold()]
        if not same:
            raise CommandError(f"{path} has no ROI '{name}'; it has: {', '.join(known)}.")
        if len(same) > 1:
            raise CommandError(f"{path} has {len(same)} ROIs that '{name}' may mean: {', '.join(same)}; write one as it is.")
        chosen.append(same[0])
    return chosen


def select_rois(reader, wanted, path):
    """Switch a reader to the ROIs, or the objects, of those names."""
    choice = next((name for name in ("ROIs", "Objects") if reader.GetProperty(name + "Info") is not None), None)
    if choice is None:
        raise CommandError(f"--roi needs a DICOM RT structure set, or a file of a tracing program, and {path} is none.")
    known = list(reader.GetProperty(choice + "Info").GetData() or [])[0::2]
    if not known:
        run_proxy(reader)  # says what is wrong with the file
        raise CommandError(f"{path} has no ROIs.")
    setattr(reader, choice, choose_rois(known, wanted, path))


def _open(path, drawings, spacing, pixel):
    """The reader of a file, by its extension or, of DICOM, its content."""
    extension = os.path.splitext(path)[1].lower()
    name = READERS.get(extension) or ("DICOMRTStructureSetReader" if is_dicom(path) else None)
    if name:
        reader = _new_reader(name, path, drawings)
        for option, value, known in (("--spacing", spacing, "SliceSpacing"), ("--pixel", pixel, "PixelSize")):
            if value is not None:
                if reader.GetProperty(known) is None:
                    raise CommandError(f"{option} is for files that do not tell where slices lie, and {path} does.")
                setattr(reader, known, value)
        return reader
    if extension not in PARAVIEW_FORMATS:
        raise CommandError(f"{path}: cannot read '{extension}' files; contours are read from "
                           f"{' '.join(list(READERS) + list(PARAVIEW_FORMATS))}.")
    try:
        reader = simple.OpenDataFile(path)
    except RuntimeError:
        reader = None
    if reader is None:
        raise CommandError(f"{path}: this ParaView has no reader for '{extension}' files.")
    return reader


def _new_reader(name, path, drawings):
    """The node, with its files: a drawing has several, a slice each."""
    if name == "SVGContourReader":
        return new_node(name, FileNames=drawings or [path])
    return new_node(name, FileName=[path] if name.startswith("XML") else path)


def read_contours(path, rois=None, unit=None, drawings=None, spacing=None, pixel=None):
    """All contours of a file, a Contours object a region; (list, seconds).

    unit, spacing and pixel are for files that do not tell them; drawings are all files of a stack, of which path is one.
    """
    for file in drawings or [path]:
        if not os.path.isfile(file):
            raise CommandError(f"There is no file {file}.")
    reader = _open(path, drawings, spacing, pixel)
    with Watched(reader.GetClientSideObject()) as watched:
        reader.UpdatePipelineInformation()
        watched.check()
    if rois:
        select_rois(reader, rois, path)
    seconds = run_proxy(reader)
    title = os.path.splitext(os.path.basename(path))[0]
    data = reader.GetClientSideObject().GetOutputDataObject(0)
    isDICOM = reader.GetXMLName() == "DICOMRTStructureSetReader"
    told = "mm" if isDICOM else "".join(strings(data, "LengthUnit")) or None
    if unit and told and unit != told:
        raise CommandError(f"--unit {unit}: the coordinates of {path} are in {told}.")
    blocks = _blocks(data, title, told or unit)
    if not blocks:
        raise CommandError(f"{path} holds no contours.")
    if not data.IsA("vtkPartitionedDataSetCollection") and len(blocks) > 1:
        blocks = _join_slices(blocks, title)
    _tell_of_the_file(data, blocks)
    return blocks, seconds


def _tell_of_the_file(data, blocks):
    """What the reader reports of the file as a whole, or of regions that nothing is made of."""
    of_regions = [line for block in blocks if not block.nothing for line in strings(block.data, "Report")]
    for line in strings(data, "Report"):
        if line not in of_regions and not line.endswith(": it has no contours."):
            note(line)


def _lines_of(data):
    """Poly data of a data set, or None for what has no lines and polygons."""
    if data is None or data.IsA("vtkPolyData"):
        return data
    source = as_source(data)
    surface = simple.ExtractSurface(Input=source)
    surface.UpdatePipeline()
    lines = detached(surface.GetClientSideObject().GetOutputDataObject(0))
    simple.Delete(surface)
    simple.Delete(source)
    return lines


def _blocks(data, title, unit):
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData
    if data.IsA("vtkDataSet"):
        return [Contours(title, _lines_of(data), unit)]
    blocks = []
    if data.IsA("vtkPartitionedDataSetCollection"):
        for i in range(data.GetNumberOfPartitionedDataSets()):
            name = f"{title} {i}"
            if data.HasMetaData(i) and data.GetMetaData(i).Has(vtkCompositeDataSet.NAME()):
                name = data.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
            count = data.GetNumberOfPartitions(i)
            part = vtkPolyData.SafeDownCast(data.GetPartition(i, 0)) if count else None
            blocks.append(Contours(name, part, unit))
        return blocks
    if not data.IsA("vtkCompositeDataSet"):
        raise CommandError(f"The input gives {data.GetClassName()}, not contours.")
    leaf = data.NewIterator()
    leaf.InitTraversal()
    while not leaf.IsDoneWithTraversal():
        name = f"{title} {len(blocks)}"
        if leaf.HasCurrentMetaData() and leaf.GetCurrentMetaData().Has(vtkCompositeDataSet.NAME()):
            name = leaf.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME())
        part = leaf.GetCurrentDataObject()
        if part.IsA("vtkDataSet"):
            blocks.append(Contours(name, _lines_of(part), unit))
        leaf.GoToNextItem()
    return blocks


def _is_flat(data):
    """Whether all points lie in one plane, up to what coordinates of single precision are rounded by."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    middle = points.mean(axis=0)
    spread = numpy.linalg.svd(points - middle, full_matrices=False, compute_uv=True)
    off = numpy.abs((points - middle) @ spread[2][-1]).max()
    size = numpy.abs(points - middle).max()
    return off <= 1e-6 * size + 2e-7 * numpy.abs(points).max()


def _join_slices(blocks, title):
    """Blocks that are a slice each are slices of one object, and become one region; others stay regions."""
    filled = [block for block in blocks if not block.empty]
    if len(filled) < 2 or not all(_is_flat(block.data) for block in filled):
        return blocks
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(1)  # double: ParaView's readers may mix both
    for block in filled:
        append.AddInputData(block.data)
    append.Update()
    note(f"{len(filled)} blocks lie in a plane each: taken as slices of one object.")
    return [Contours(title, append.GetOutput(), filled[0].unit)]
