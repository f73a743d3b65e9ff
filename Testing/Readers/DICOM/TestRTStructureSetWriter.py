# SPDX-License-Identifier: GPL-3.0-or-later
"""DICOM RT Structure Set Writer as a node: blocks, properties, warnings, refusals, and what others say of its files."""
import os
import shutil

import contourtesting as ct
import readertesting as rt
import structuresettesting as st

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

FOLDER = ct.output("structure set writer")
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)
SQUARE = [0.0, 0.0, 1.0, 4.0, 0.0, 1.0, 4.0, 3.5, 1.0, 0.0, 3.5, 1.0]
HOLE = [1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 2.0, 2.0, 1.0]
TILTED = [0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0, 2.0, 0.0, 1.0, 1.0]
SET = [(3, "Lt Lung", "ORGAN", "255\\128\\0", [("CLOSED_PLANAR", SQUARE), ("CLOSED_PLANAR", HOLE),
                                               ("CLOSED_PLANAR", TILTED)]),
       (1, "Marker", "MARKER", "0\\0\\1", [("POINT", [1.0, 2.0, 3.0]), ("OPEN_PLANAR", SQUARE)]),
       (7, "Exclusive", "", None, [("CLOSEDPLANAR_XOR", SQUARE), ("CLOSEDPLANAR_XOR", HOLE)])]


def path(name):
    return os.path.join(FOLDER, name)


class Messages:
    """Errors and warnings of a writer, kept off the terminal."""

    def __init__(self, proxy):
        self.algorithm = proxy.GetClientSideObject()
        self.errors, self.warnings = [], []
        for event, lines in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
            def keep(_, __, sentence, lines=lines):
                lines.append(sentence)
            keep.CallDataType = "string0"
            self.algorithm.AddObserver(event, keep)


def write(name, source, **properties):
    """Errors and warnings of writing source there."""
    writer = simple.DICOMRTStructureSetWriter(Input=source, FileName=path(name), **properties)
    messages = Messages(writer)
    writer.UpdatePipeline()
    code = messages.algorithm.GetErrorCode()
    ct.check((code != 0) == bool(messages.errors), f"{name}: error code {code} with errors {messages.errors}")
    simple.Delete(writer)
    return messages.errors, messages.warnings


def refused(part, source, **properties):
    before = sorted(os.listdir(FOLDER))
    errors, _ = write("refused.dcm", source, **properties)
    ct.check(len(errors) == 1 and part in errors[0], f"'{part}' is not the one error: {errors}")
    ct.check(sorted(os.listdir(FOLDER)) == before, f"'{part}': a file was left behind")


def read(name, *rois):
    reader = simple.DICOMRTStructureSetReader(FileName=path(name))
    if rois:
        reader.ROIs = list(rois)
    return reader


def source_of(points, lines=(), polygons=(), vertices=(), types=None):
    poly = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    for point in points:
        coordinates.InsertNextPoint(point)
    poly.SetPoints(coordinates)
    for cells, put in ((vertices, poly.SetVerts), (lines, poly.SetLines), (polygons, poly.SetPolys)):
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell))
            for p in cell:
                array.InsertCellPoint(p)
        if cells:
            put(array)
    if types:
        names = vtkStringArray()
        names.SetName("GeometricType")
        for kind in types:
            names.InsertNextValue(kind)
        poly.GetCellData().AddArray(names)
    producer = simple.PVTrivialProducer()
    producer.GetClientSideObject().SetOutput(poly)
    producer.UpdatePipeline()
    return producer


# A whole structure set passes through unchanged, and others can read it.
with open(path("reference.dcm"), "wb") as file:
    file.write(rt.structure_set(SET))
reader = read("reference.dcm")
errors, warnings = write("all.dcm", reader, StructureSetLabel="My label")
ct.check(not errors, f"errors {errors}")
ct.check(len(warnings) == 1 and "No reference is set" in warnings[0], f"without a reference: {warnings}")
st.check_validity(path("all.dcm"), known=["<CLOSEDPLANAR_XOR>"])
copy = read("all.dcm")
for (name, before), (other, after) in zip(rt.blocks(ct.data(reader)), rt.blocks(ct.data(copy))):
    ct.check(name == other, f"ROI {name} is {other}")
    ct.check(st.contours_of(before) == st.contours_of(after), f"contours of {name}")
    for array in ("ROINumber", "ROIColor"):
        first, second = before.GetFieldData().GetArray(array), after.GetFieldData().GetArray(array)
        # An ROI without a colour gets one.
        ct.check(first is None or first.GetTuple(0) == second.GetTuple(0), f"{array} of {name}")
    ct.check(rt.strings(before, "ROIType") == rt.strings(after, "ROIType"), f"type of {name}")
    kinds = [[b.GetCellData().GetAbstractArray("GeometricType").GetValue(i) for i in range(b.GetNumberOfCells())]
             for b in (before, after)]
    ct.check(kinds[0] == kinds[1], f"geometric types of {name}: {kinds}")
rois = st.pydicom_rois(path("all.dcm"))
if rois is not None:
    ct.check({name: [(kind, data) for kind, data, _ in contours] for name, contours in rois.items()} ==
             {name: items for _, name, _, _, items in SET}, f"pydicom reads {rois}")

# Holes: two contours either way, which the hierarchy takes for an outline and a hole.
lung = read("reference.dcm", "Lt Lung")
for holes, kind in (("Separate Contours", "CLOSED_PLANAR"), ("XOR", "CLOSEDPLANAR_XOR")):
    write("holes.dcm", lung, Holes=holes)
    block = rt.blocks(ct.data(read("holes.dcm")))[0][1]
    kinds = block.GetCellData().GetAbstractArray("GeometricType")
    ct.check([kinds.GetValue(i) for i in range(3)] == [kind] * 3, f"{holes}: {[kinds.GetValue(i) for i in range(3)]}")
write("xor.dcm", read("reference.dcm", "Exclusive"), Holes="XOR")
hierarchy = ct.data(simple.ContourHierarchy(Input=read("xor.dcm")))
depth = rt.blocks(hierarchy)[0][1].GetCellData().GetArray("Depth")
ct.check(sorted(depth.GetValue(i) for i in range(depth.GetNumberOfTuples())) == [0, 1], "a hole comes back as a hole")

# Keyholes: one walk, which is an outline and a hole again where it is read.
square = [(0, 0, 2), (9, 0, 2), (9, 9, 2), (0, 9, 2)]
holes = [[(x, y, 2), (x + 1, y, 2), (x + 1, y + 1, 2), (x, y + 1, 2)] for x, y in ((1, 1), (4, 6), (7, 2))]
island = [(4.25, 6.25, 2), (4.75, 6.25, 2), (4.5, 6.75, 2)]
loops = [square] + holes + [island]
firsts = [sum(map(len, loops[:i])) for i in range(len(loops))]
swiss = source_of([p for loop in loops for p in loop],
                  lines=[[f + i for i in range(len(loop))] + [f] for f, loop in zip(firsts, loops)])
write("keyholes.dcm", swiss, Holes="Keyholes", ROIName="Swiss")
keyholes = read("keyholes.dcm")
block = rt.blocks(ct.data(keyholes))[0][1]
lengths = sorted(block.GetCell(i).GetNumberOfPoints() - 1 for i in range(block.GetNumberOfLines()))
ct.check(lengths == [3, 4 + 3 * 4 + 3 * 2], f"a walk of all four loops and three bridges, and the island: {lengths}")
st.check_validity(path("keyholes.dcm"))
before, after = (ct.data(simple.ContourHierarchy(Input=s)) for s in (swiss, keyholes))
after = rt.blocks(after)[0][1]
areas = [sorted(round(d.GetCellData().GetArray("SignedArea").GetValue(i), 9) for i in range(d.GetNumberOfCells()))
         for d in (before, after)]
ct.check(len(areas[0]) == 5 and areas[0] == areas[1], f"the hierarchy of the walk is that of the loops: {areas}")

# ParaView's own way, with a reference: its ROIs come along, the new one under another name.
write("part.dcm", lung, ReferenceFileName=path("reference.dcm"))
names = [name for name, _ in rt.blocks(ct.data(read("part.dcm")))]
ct.check(names == ["Lt Lung", "Marker", "Exclusive", "Lt Lung (2)"], f"the ROIs are {names}")
simple.SaveData(path("saved.dcm"), proxy=lung, ReferenceFileName=path("reference.dcm"), CopyReferenceROIs=0,
                ROIName="Lunge (geglättet)", ROIType="PTV", GenerationAlgorithm="Automatic")
blocks = rt.blocks(ct.data(read("saved.dcm")))
ct.check([name for name, _ in blocks] == ["Lunge (geglättet)"], f"the ROIs are {[name for name, _ in blocks]}")
ct.check(rt.strings(blocks[0][1], "ROIType") == ["PTV"], "the type that was asked for")
st.check_validity(path("saved.dcm"))

# Poly data of any kind: loose segments as Slice gives them, a polygon, points.
sphere = simple.Sphere(Radius=20, ThetaResolution=40, PhiResolution=40)
cut = simple.Slice(Input=sphere, SliceType="Plane")
cut.SliceType.Normal = [0, 0, 1]
cut.SliceOffsetValues = [-5.05, 0.05, 5.05]
write("slices.dcm", cut, ROIName="Ball")
block = rt.blocks(ct.data(read("slices.dcm")))[0][1]
ct.check(block.GetNumberOfLines() == 3 and rt.loops_are_closed(block), "segments are three closed contours")
st.check_validity(path("slices.dcm"))
corners = [(0, 0, 0), (5, 0, 0), (5, 5, 0), (0, 5, 0)]
write("polygon.dcm", source_of(corners, polygons=[(0, 1, 2, 3)]))
name, block = rt.blocks(ct.data(read("polygon.dcm")))[0]
ct.check(name == "Contours" and block.GetNumberOfPoints() == 4, f"a polygon is a contour of {name}")
write("points.dcm", source_of(corners, vertices=[(0,), (1,)]))
ct.check(rt.blocks(ct.data(read("points.dcm")))[0][1].GetNumberOfVerts() == 2, "vertices alone are points")
_, warnings = write("stray.dcm", source_of(corners, lines=[(0, 1, 2, 3, 0)], vertices=[(0,)]))
ct.check(any("1 loose vertices" in line for line in warnings), f"a vertex among contours is no point: {warnings}")
write("open.dcm", source_of(corners, lines=[(0, 1, 2, 3)], types=["OPEN_PLANAR"]))
kinds = rt.blocks(ct.data(read("open.dcm")))[0][1].GetCellData().GetAbstractArray("GeometricType")
ct.check(kinds.GetValue(0) == "OPEN_PLANAR", "a line that is meant to be open")

# The planes that Implicit Contours wants, from the images that something is drawn on.
with open(path("drawn.dcm"), "wb") as file:
    file.write(rt.structure_set([(1, "Body", "EXTERNAL", None, [
        ("CLOSED_PLANAR", [0.0, 0.0, z, 30.0, 0.0, z, 30.0, 20.0, z], f"1.2.3.{i}") for i, z in ((1, 5.0), (2, 2.5))])]))
planes = simple.DICOMSlicePlanes(FileName=path("drawn.dcm"))
output = ct.data(planes)
uids = output.GetCellData().GetAbstractArray("SOPInstanceUID")
ct.check([uids.GetValue(i) for i in range(2)] == ["1.2.3.2", "1.2.3.1"], "images by height")
ct.check(output.GetBounds() == (-1, 31, -1, 21, 2.5, 5), f"rectangles around the contours: {output.GetBounds()}")
rt.expect_error(simple.DICOMSlicePlanes(FileName=path("all.dcm")), "tells no slices", "no images")
rt.expect_error(simple.DICOMSlicePlanes(FileName=path("absent.dcm")), "no such file", "absent")
rt.expect_error(simple.DICOMSlicePlanes(), "set FileName", "no name")

# Refusals: one sentence, no file.
refused("does not close", source_of(corners, lines=[(0, 1, 2, 3)]))
refused("is a surface", sphere)
refused("is not planar", source_of([(0, 0, 0), (5, 0, 0), (5, 5, 3), (0, 5, 0)], lines=[(0, 1, 2, 3, 0)]))
refused("not a number", source_of([(0, 0, 0), (5, 0, 0), (5, float("nan"), 0)], lines=[(0, 1, 2, 0)]))
refused("no contours to write", source_of([]))
refused("ROIName names one ROI", reader, ROIName="One")
refused("no such file", lung, ReferenceFileName=path("absent.dcm"))
refused("contours are poly data",
        simple.GroupDatasets(Input=[simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2])]))
with open(path("truncated.dcm"), "wb") as file:
    file.write(rt.structure_set(SET)[:300])
refused("truncated", lung, ReferenceFileName=path("truncated.dcm"))
with open(path("ct.dcm"), "wb") as file:
    file.write(rt.structure_set([(1, "A", "", None, [])], rt.CT_IMAGE))
refused("CTImageStorage", lung, ReferenceFileName=path("ct.dcm"))
with open(path("reference.dcm"), "rb") as file:
    before = file.read()
errors, _ = write("reference.dcm", lung, ReferenceFileName=path("reference.dcm"))
ct.check(len(errors) == 1 and "the reference itself" in errors[0], f"over the reference: {errors}")
with open(path("reference.dcm"), "rb") as file:
    ct.check(file.read() == before, "the reference is untouched")
writer = simple.DICOMRTStructureSetWriter(Input=lung)
messages = Messages(writer)
writer.UpdatePipeline()
ct.check(len(messages.errors) == 1 and "FileName" in messages.errors[0], f"no name: {messages.errors}")
ct.check(not any(name.startswith(".") for name in os.listdir(FOLDER)), f"parts are left: {os.listdir(FOLDER)}")

# Abort: no file.
writer = simple.DICOMRTStructureSetWriter(Input=lung, FileName=path("aborted.dcm"))
algorithm = writer.GetClientSideObject()
algorithm.AddObserver("ProgressEvent", lambda *_: algorithm.SetAbortExecute(1))
writer.UpdatePipeline()
ct.check(not os.path.exists(path("aborted.dcm")), "aborting writes nothing")
if st.skipped():
    print(f"SKIPPED in part: {st.skipped()} not there")
ct.finish()
