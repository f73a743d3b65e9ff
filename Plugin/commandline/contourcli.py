# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line tools share: reading contours, reconstructing, certifying, writing, printing.

Runs in pvpython with the plugin's path in CONTOUR_PLUGIN. Every failure is a CommandError whose text is
one sentence for the user.
"""
import json
import math
import os
import re
import sys
import time

from paraview import simple

READERS = {
    ".cnt": "NUAGESContourReader",
    ".csl": "CurveNetworkReader",
    ".contour": "CurveNetworkReader",
    ".dcm": "DICOMRTStructureSetReader",
    ".vtp": "XMLPolyDataReader",
}
METHODS = {"psm": "PolyhedralSurface", "ism": "ImplicitSurface"}
SURFACE_FORMATS = (".vtp", ".stl", ".ply", ".brep")
STRUCTURE_SET = ".dcm"


class CommandError(Exception):
    """One sentence for the user."""


def load_plugin():
    """Load the plugin named by CONTOUR_PLUGIN; its nodes are then in paraview.simple."""
    path = os.environ.get("CONTOUR_PLUGIN", "")
    if not os.path.exists(path):
        raise CommandError(f"The plugin is not at '{path}': build it with ./run build, or set CONTOUR_PLUGIN.")
    try:
        simple.LoadPlugin(path, remote=False, ns=simple.__dict__)
    except RuntimeError:
        raise CommandError(f"ParaView cannot load the plugin {path}; it must be built against this ParaView.")


class ProgressBar:
    """A bar on standard error where that is a terminal, nothing otherwise."""

    def __init__(self, title):
        self.title = title
        self.shown = sys.stderr.isatty()

    def update(self, fraction, stage):
        if not self.shown:
            return
        width = 30
        filled = int(round(width * min(max(fraction, 0.0), 1.0)))
        bar = "#" * filled + "." * (width - filled)
        sys.stderr.write(f"\r\x1b[K{self.title} [{bar}] {100 * fraction:3.0f}% {stage or ''}"[:160])
        sys.stderr.flush()

    def clear(self):
        if self.shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


def _sentence(message):
    """The text of a VTK error without file, line and object."""
    text = message.strip()
    match = re.search(r"\(0x[0-9a-fA-F]+\): (.*)", text, re.DOTALL)
    return " ".join((match.group(1) if match else text).split())


class _Watched:
    """Collects the errors of an algorithm, which pvpython raises nothing for, and shows its progress."""

    def __init__(self, algorithm, bar=None):
        self.errors = []
        self.warnings = []
        self.tags = []

        def on_error(_, __, message):
            self.errors.append(_sentence(message))

        on_error.CallDataType = "string0"

        def on_warning(_, __, message):
            self.warnings.append(_sentence(message))

        on_warning.CallDataType = "string0"

        def on_executive_error(_, __, message):
            # "Algorithm ... returned failure" says nothing that the algorithm itself did not.
            if not self.errors:
                self.errors.append(_sentence(message))

        on_executive_error.CallDataType = "string0"
        self._observe(algorithm, "ErrorEvent", on_error)
        self._observe(algorithm, "WarningEvent", on_warning)
        executive = algorithm.GetExecutive() if hasattr(algorithm, "GetExecutive") else None
        if executive is not None:
            self._observe(executive, "ErrorEvent", on_executive_error)
        if bar is not None:
            self._observe(algorithm, "ProgressEvent",
                          lambda source, _: bar.update(source.GetProgress(), source.GetProgressText()))

    def _observe(self, target, event, function):
        self.tags.append((target, target.AddObserver(event, function)))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for target, tag in self.tags:
            target.RemoveObserver(tag)

    def check(self):
        if self.errors:
            raise CommandError(self.errors[0])
        for warning in self.warnings:
            print("Note: " + warning, file=sys.stderr)


def run_proxy(proxy, bar=None):
    """Bring a source or filter up to date; its errors become a CommandError. Returns seconds."""
    start = time.perf_counter()
    with _Watched(proxy.GetClientSideObject(), bar) as watched:
        proxy.UpdatePipeline()
        watched.check()
    return time.perf_counter() - start


def _new(name, **arguments):
    if not hasattr(simple, name):
        raise CommandError(f"This build of the plugin has no node {name}.")
    return getattr(simple, name)(**arguments)


class Contours:
    """Contours of one region: a name and a vtkPolyData."""

    def __init__(self, name, data):
        self.name = name
        self.data = data

    @property
    def empty(self):
        # Markers and isocentres of a structure set are vertices only.
        return self.data is None or self.data.GetNumberOfCells() == self.data.GetNumberOfVerts()


def select_rois(reader, wanted, path):
    """Switch a structure set reader to the ROIs of those names."""
    info = reader.GetProperty("ROIsInfo")
    if info is None:
        raise CommandError(f"--roi needs a DICOM RT structure set, and {path} is none.")
    known = list(info.GetData())[0::2]
    for name in wanted:
        if name not in known:
            raise CommandError(f"{path} has no ROI '{name}'; it has: {', '.join(known)}.")
    reader.ROIs = list(wanted)


def read_contours(path, rois=None):
    """All contours of a file, a Contours object a block; (list, seconds)."""
    extension = os.path.splitext(path)[1].lower()
    if not os.path.isfile(path):
        raise CommandError(f"There is no file {path}.")
    if extension not in READERS:
        raise CommandError(f"{path}: cannot read '{extension}' files; contours are read from {' '.join(READERS)}.")
    name = READERS[extension]
    reader = _new(name, FileName=[path] if name.startswith("XML") else path)
    with _Watched(reader.GetClientSideObject()) as watched:
        reader.UpdatePipelineInformation()
        watched.check()
    if rois:
        select_rois(reader, rois, path)
    seconds = run_proxy(reader)
    title = os.path.splitext(os.path.basename(path))[0]
    blocks = _blocks(reader.GetClientSideObject().GetOutputDataObject(0), title)
    if not blocks:
        raise CommandError(f"{path} holds no contours.")
    return blocks, seconds


def _blocks(data, title):
    if data.IsA("vtkPolyData"):
        return [Contours(title, data)]
    if not data.IsA("vtkPartitionedDataSetCollection"):
        raise CommandError(f"The input gives {data.GetClassName()}, not contours.")
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData
    blocks = []
    for i in range(data.GetNumberOfPartitionedDataSets()):
        name = f"{title} {i}"
        if data.HasMetaData(i) and data.GetMetaData(i).Has(vtkCompositeDataSet.NAME()):
            name = data.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
        count = data.GetNumberOfPartitions(i)
        part = vtkPolyData.SafeDownCast(data.GetPartition(i, 0)) if count else None
        blocks.append(Contours(name, part))
    return blocks


def apply_settings(proxies, settings):
    """settings: list of PROPERTY=VALUE, each for those of the proxies that have it."""
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not equals:
            raise CommandError(f"--set {setting}: write PROPERTY=VALUE.")
        hidden = ("Input", "Planes", "FileName", "ReferenceFileName")
        known = {p.GetXMLLabel(): [q for q in p.ListProperties() if q not in hidden] for p in proxies}
        having = [p for p in proxies if name in known[p.GetXMLLabel()]]
        if not having:
            raise CommandError("; ".join(f"{label} has no property '{name}'; it has: {', '.join(names)}"
                                         for label, names in known.items()) + ".")
        words = [word.strip() for word in value.split(",")]
        values = [_number(word) for word in words]
        for proxy in having:
            try:
                setattr(proxy, name, values if len(values) > 1 else values[0])
            except (TypeError, ValueError, RuntimeError) as error:
                raise CommandError(f"--set {setting}: {' '.join(str(error).split())}.")


def _number(word):
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return {"on": 1, "true": 1, "off": 0, "false": 0}.get(word.lower(), word)


class Result:
    """A surface with what is known about it."""

    def __init__(self, contours, surface, seconds, certificate, report):
        self.contours = contours
        self.surface = surface
        self.seconds = seconds  # list of (stage, seconds)
        self.certificate = certificate  # dictionary
        self.report = report  # lines

    @property
    def name(self):
        return self.contours.name

    @property
    def triangles(self):
        return self.surface.GetNumberOfPolys()


def _strings(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def _values(data, name):
    array = data.GetFieldData().GetArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def as_source(data):
    producer = simple.PVTrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def _detached(data):
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    return copy


def reconstruct(contours, method="psm", settings=(), bar=None):
    """Contours to a certified surface."""
    source = as_source(contours.data)
    node = _new(METHODS[method], Input=source)
    apply_settings([node], settings)
    total = run_proxy(node, bar)
    surface = _detached(node.GetClientSideObject().GetOutputDataObject(0))
    report = _strings(surface, "Report")
    if surface.GetNumberOfPolys() == 0:
        why = report[-1] if report else "no reason was given."
        raise CommandError(f"{contours.name}: no surface came out: {why}")
    stages = list(zip(_strings(surface, "StageName"), _values(surface, "StageSeconds")))
    if not stages:
        stages = [("surface", total)]
    else:
        stages.insert(0, ("clean contours", max(0.0, total - sum(s for _, s in stages))))
    certificate, seconds = certify(surface, source, bar)
    stages.append(("certificate", seconds))
    simple.Delete(node)
    simple.Delete(source)
    return Result(contours, surface, stages, certificate, report)


def slices_within(slices, contours):
    """Those of the rectangles whose planes lie between the outermost points of the contours, as poly data.

    A contour belongs to a slice that it lies beside, so a slice may lie beyond the outermost ones by as much.
    """
    from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkPolygon
    tolerance = _values(slices, "ContourTolerance")[0]
    within = vtkPolyData()
    within.SetPoints(slices.GetPoints())
    within.Allocate()
    normal, corner = [0.0] * 3, [0.0] * 3
    points = [contours.GetPoint(p) for p in range(contours.GetNumberOfPoints())]
    for i in range(slices.GetNumberOfCells()):
        rectangle = slices.GetCell(i)
        vtkPolygon.ComputeNormal(rectangle.GetPoints(), normal)
        rectangle.GetPoints().GetPoint(0, corner)
        heights = [sum(n * (x - c) for n, x, c in zip(normal, point, corner)) for point in points]
        if min(heights) < tolerance and max(heights) > -tolerance:
            within.InsertNextCell(slices.GetCellType(i), rectangle.GetPointIds())
    return within


class StructureSetWriter:
    """Traces contours on the slices of a reference, and writes them, a region of interest a block."""

    def __init__(self, path, reference, settings=(), extrapolate=False):
        self.writer = _new("DICOMRTStructureSetWriter", FileName=path, ReferenceFileName=reference)
        self.reference = reference
        self.settings = settings
        self.extrapolate = extrapolate
        self.traced = []
        self.rows = []  # of the table: name, contours drawn, contours written, slices, seconds
        self.slices = {}  # by frame of reference
        self.on_slices = not any(setting.partition("=")[0] in ("Spacing", "Range", "UseRange") for setting in settings)
        if self.on_slices:
            self._slices_in("")  # what is wrong with the reference is said before anything is computed

    def _slices_in(self, frame):
        """The reference's slices in a frame of reference, in its first one where that is empty."""
        if frame not in self.slices:
            planes = _new("DICOMSlicePlanes", FileName=self.reference, FrameOfReferenceUID=frame)
            run_proxy(planes)
            self.slices[frame] = planes.GetClientSideObject().GetOutputDataObject(0)
        return self.slices[frame]

    def _planes(self, block):
        if not self.on_slices:
            return {}
        known = self._slices_in("".join(_strings(block.data, "FrameOfReferenceUID")))
        slices = known if self.extrapolate else slices_within(known, block.data)
        if slices.GetNumberOfCells() == 0:
            raise CommandError(f"none of the {known.GetNumberOfCells()} slices that the reference "
                               "tells meets its contours: are they of the same patient?")
        return {"Planes": as_source(slices)}

    def trace(self, block, bar=None):
        """Fit an implicit function to a block, and take its contours."""
        source = as_source(block.data)
        constraints = _new("ImplicitConstraints", Input=source)
        function = _new("ImplicitFunction", Input=constraints)
        try:
            planes = self._planes(block)
        except CommandError as error:
            raise CommandError(f"{block.name}: {error}")
        contours = _new("ImplicitContours", Input=function, **planes)
        stages = [constraints, function, contours]
        apply_settings(stages + [self.writer], self.settings)
        try:
            seconds = sum(run_proxy(stage, bar) for stage in stages)
        except CommandError as error:
            raise CommandError(f"{block.name}: {error}")
        data = _detached(contours.GetClientSideObject().GetOutputDataObject(0))
        slices = data.GetFieldData().GetArray("LevelOffset").GetNumberOfTuples()
        self.rows.append([block.name, block.data.GetNumberOfCells(), data.GetNumberOfCells(), slices, f"{seconds:.2f}"])
        self.traced.append(Contours(block.name, data))
        for proxy in list(reversed(stages)) + [source] + list(planes.values()):
            simple.Delete(proxy)

    def write(self):
        """Write all that was traced; the node leaves a whole file or none. What it has to say is printed."""
        from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPartitionedDataSetCollection
        collection = vtkPartitionedDataSetCollection()
        for i, block in enumerate(self.traced):
            collection.SetPartition(i, 0, block.data)
            collection.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), block.name)
        self.writer.Input = as_source(collection)
        run_proxy(self.writer)


def certify(surface, contours_proxy, bar=None):
    """The certificate as a dictionary (its field data by name, and JSON), and the seconds it took."""
    source = as_source(surface)
    node = _new("SurfaceCertificate", Input=source, Contours=contours_proxy)
    seconds = run_proxy(node, bar)
    data = node.GetClientSideObject().GetOutputDataObject(0)
    certificate = {}
    for i in range(data.GetFieldData().GetNumberOfArrays()):
        array = data.GetFieldData().GetArray(i)
        if array is not None and array.GetNumberOfValues() == 1:
            certificate[array.GetName()] = array.GetValue(0)
    certificate["Lines"] = _strings(data, "Certificate")
    certificate["JSON"] = json.loads(_strings(data, "CertificateJSON")[0])
    simple.Delete(node)
    simple.Delete(source)
    return certificate, seconds


def write_surface(path, result):
    """Write a surface by the file's extension, under another name first, so that no half file is left."""
    extension = os.path.splitext(path)[1].lower()
    if extension not in SURFACE_FORMATS:
        raise CommandError(f"{path}: cannot write '{extension}' files; surfaces are written to "
                           f"{' '.join(SURFACE_FORMATS)}.")
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise CommandError(f"There is no folder {folder} to write {os.path.basename(path)} to.")
    part = os.path.join(folder, f".{os.path.basename(path)}.part{extension}")
    start = time.perf_counter()
    try:
        _write(part, extension, result)
        if not os.path.exists(part) or os.path.getsize(part) == 0:
            raise CommandError(f"{path} could not be written: is the disk full, or the folder write-protected?")
        os.replace(part, path)
    except OSError as error:
        raise CommandError(f"{path} could not be written: {error.strerror}.")
    finally:
        if os.path.exists(part):
            os.remove(part)
    return time.perf_counter() - start


def _write(path, extension, result):
    if extension == ".brep":
        surface = as_source(result.surface)
        contours = as_source(result.contours.data)
        writer = _new("BRepWriter", Input=surface, Contours=contours, FileName=path)
        algorithm = writer.GetClientSideObject()
        with _Watched(algorithm) as watched:
            writer.UpdatePipeline()
            watched.check()
        for proxy in (writer, surface, contours):
            simple.Delete(proxy)
        return
    if extension == ".vtp":
        from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter as Writer
    elif extension == ".stl":
        from vtkmodules.vtkIOGeometry import vtkSTLWriter as Writer
    else:
        from vtkmodules.vtkIOPLY import vtkPLYWriter as Writer
    writer = Writer()
    writer.SetInputDataObject(result.surface)
    writer.SetFileName(path)
    if extension == ".vtp":
        # Inline: data appended behind the XML trips VTK's reader with the expat of today's Debian 12.
        writer.SetDataModeToBinary()
    else:
        writer.SetFileTypeToBinary()
    with _Watched(writer) as watched:
        writer.Write()
        watched.check()
    if writer.GetErrorCode():
        raise CommandError(f"{os.path.basename(path)} could not be written (VTK error code {writer.GetErrorCode()}).")


def contour_count(result):
    """Contours that the surface was made from."""
    used = _values(result.surface, "ContourCount")
    return int(used[0]) if used else result.contours.data.GetNumberOfCells()


def _yes(value):
    return "yes" if value else "NO"


def _quantity(value):
    if value is None or math.isnan(value):
        return "-"
    return f"{value:.7g}"


def format_table(rows, titles):
    """Columns as wide as their widest entry; the first is left-aligned."""
    cells = [titles] + [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[c]) for row in cells) for c in range(len(titles))]
    lines = []
    for row in cells:
        rest = "  ".join(cell.rjust(width) for cell, width in zip(row[1:], widths[1:]))
        lines.append((row[0].ljust(widths[0]) + "  " + rest).rstrip())
    lines.insert(1, "-" * max(len(line) for line in lines))
    return "\n".join(lines)


def print_results(results, extra_stages=()):
    """The table: a row a surface, then seconds by stage, then what was left out or repaired."""
    rows = []
    for r in results:
        c = r.certificate
        manifold = c["EdgeManifold"] and c["VertexManifold"] and c["Oriented"]
        rows.append([r.name, contour_count(r), r.triangles, _yes(c["Closed"]), _yes(manifold),
                     int(c["CrossingPairs"]), _quantity(c["Volume"]), f"{sum(s for _, s in r.seconds):.2f}"])
    titles = ["", "contours", "triangles", "closed", "manifold", "crossings", "volume", "seconds"]
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
