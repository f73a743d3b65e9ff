# SPDX-License-Identifier: GPL-3.0-or-later
"""DICOM RT Structure Set Reader as a node: blocks, selection, report, errors. Its files have no preamble."""
import contourtesting as ct
import readertesting as rt
# Before the first object of the class: Python would know it by its base class only.
from contourreconstruction.DICOMReaders import vtkRTStructureSetReader

simple = ct.load_plugin()
TRIANGLE = [0.0, 0.0, 1.0, 4.0, 0.0, 1.0, 4.0, 3.5, 1.0]
TILTED = [0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0, 2.0, 0.0, 1.0, 1.0]
SET = rt.structure_set([
    (3, "Lt Lung", "ORGAN", "255\\128\\0", [("CLOSED_PLANAR", TRIANGLE), ("CLOSED_PLANAR", TILTED)]),
    (1, "Mixed", "", None, [("OPEN_PLANAR", TRIANGLE), ("POINT", [1.0, 2.0, 3.0]), ("CLOSEDPLANAR_XOR", TRIANGLE)]),
    (7, "Nothing", "MARKER", "0\\0\\1", [])])

reader = simple.DICOMRTStructureSetReader(FileName=rt.write("a set.dcm", SET))
output = ct.data(reader)
ct.check(output.IsA("vtkPartitionedDataSetCollection"), "the output is no collection")
blocks = dict(rt.blocks(output))
ct.check(list(blocks) == ["Lt Lung", "Mixed", "Nothing"], f"the blocks are {list(blocks)}")
lung, mixed, nothing = blocks.values()
ct.check(lung.GetNumberOfLines() == 2 and lung.GetNumberOfPoints() == 7, "the lung has other contours")
ct.check(rt.loops_are_closed(lung), "loops are not closed")
ct.check(lung.GetPoint(5) == (1, 1, 2), "a point of the tilted contour is elsewhere")
field = lung.GetFieldData()
ct.check(rt.strings(lung, "ROIName") == ["Lt Lung"] and rt.strings(lung, "ROIType") == ["ORGAN"], "name and type")
ct.check(field.GetArray("ROINumber").GetValue(0) == 3, "number")
ct.check(field.GetArray("ROIColor").GetTuple3(0) == (255, 128, 0), "colour")
ct.check(mixed.GetFieldData().GetArray("ROIColor") is None, "a colour that the file does not give")
# Vertices come before lines in a vtkPolyData.
kinds = mixed.GetCellData().GetAbstractArray("GeometricType")
numbers = mixed.GetCellData().GetArray("ContourNumber")
ct.check([kinds.GetValue(i) for i in range(3)] == ["POINT", "OPEN_PLANAR", "CLOSEDPLANAR_XOR"], "geometric types")
ct.check([numbers.GetValue(i) for i in range(3)] == [2, 1, 3], "contour numbers")
ct.check(mixed.GetNumberOfVerts() == 1 and mixed.GetNumberOfLines() == 2, "a vertex and two lines")
ct.check(mixed.GetCell(1).GetNumberOfPoints() == 3 and mixed.GetCell(2).GetNumberOfPoints() == 4, "open, then closed")
ct.check(nothing.GetNumberOfPoints() == 0, "the empty block is not empty")
sentence = 'ROI "Nothing": it has no contours.'
ct.check(rt.strings(nothing, "Report") == [sentence], "the empty block has no report")
ct.check(rt.strings(output, "Report") == [sentence], "the collection has no report")
ct.check(not rt.strings(lung, "Report"), "a report about nothing")

# Selection: all to begin with, then some, then none, and by name when the reader is made.
ct.check(list(reader.ROIs) == ["Lt Lung", "Mixed", "Nothing"], f"selected are {list(reader.ROIs)}")
reader.ROIs = ["Mixed"]
ct.check([name for name, _ in rt.blocks(ct.data(reader))] == ["Mixed"], "the selection is not followed")
reader.ROIs = []
ct.check(ct.data(reader).GetNumberOfPartitionedDataSets() == 0, "no ROI selected, and there are blocks")
reader.ROIs = ["Lt Lung", "Nothing"]
ct.check([name for name, _ in rt.blocks(ct.data(reader))] == ["Lt Lung", "Nothing"], "the second selection")
made = simple.DICOMRTStructureSetReader(FileName=ct.output("a set.dcm"), ROIs=["Mixed"])
ct.check([name for name, _ in rt.blocks(ct.data(made))] == ["Mixed"], "the selection at the making")
# Another file: its ROIs replace those of the first.
made.FileName = rt.write("other.dcm", rt.structure_set([(1, "Heart", "", None, [("CLOSED_PLANAR", TRIANGLE)])]))
ct.check([name for name, _ in rt.blocks(ct.data(made))] == ["Heart"], "the other file's ROI")
made.UpdatePropertyInformation()
ct.check(list(made.ROIs.Available) == ["Heart"], f"listed are {list(made.ROIs.Available)}")
# A name that the file does not have is told, by way of VTK as a program would.
direct = vtkRTStructureSetReader()
direct.SetFileName(ct.output("other.dcm"))
direct.GetROISelection().SetArraySetting("Hart", 1)
direct.Update()
ct.check(rt.strings(direct.GetOutputDataObject(0), "Report") == ['The selected ROI "Hart" is not in the file.'],
         "the unknown name is not told")

# Every filter on vtkPolyData is applied to each block.
moved = simple.Transform(reader)
ct.check(len(rt.blocks(ct.data(moved))) == 2, "a filter on the collection")

# A region of points does not stop the others: one warning, and nothing is made of it.
tall = [("CLOSED_PLANAR", [0.0, 0.0, z, 4.0, 0.0, z, 4.0, 3.5, z]) for z in (0.0, 1.0, 2.0)]
mixture = simple.DICOMRTStructureSetReader(FileName=rt.write("points.dcm", rt.structure_set(
    [(1, "Isocentre", "ISOCENTER", None, [("POINT", [1.0, 2.0, 3.0]), ("POINT", [2.0, 2.0, 3.0])]),
     (2, "Organ", "ORGAN", None, tall)])))
for name in ("ContourHierarchy", "ContourMapping", "ContourTriangulation", "JointVoronoiDiagram", "PolyhedralSurface",
             "ImplicitConstraints", "ImplicitSurface"):
    node = getattr(simple, name)(Input=mixture)
    errors, warnings = rt.Errors(node), []

    def keep(_, __, sentence, warnings=warnings):
        warnings.append(sentence)
    keep.CallDataType = "string0"
    node.GetClientSideObject().AddObserver("WarningEvent", keep)
    blocks = dict(rt.blocks(ct.data(node)))
    ct.check(not errors.own, f"{name}: {errors.own}")
    ct.check(len(warnings) == 1 and 'Region "Isocentre" is points only' in warnings[0], f"{name} warns: {warnings}")
    ct.check(blocks["Isocentre"].GetNumberOfCells() == 0, f"{name} makes something of points")
    ct.check("points only" in rt.strings(blocks["Isocentre"], "Report")[-1], f"{name} does not report it")
    ct.check(blocks["Organ"].GetNumberOfPoints() > 0, f"{name} makes nothing of the organ")

# What the page on structure sets tells instead of servermanager.Fetch, which ParaView 5.11 fails at.
drawn = simple.DICOMRTStructureSetReader(FileName=rt.write("fetched.dcm", SET))
drawn.UpdatePipeline()
regions = drawn.GetClientSideObject().GetOutputDataObject(0)
first = regions.GetPartition(0, 0)
ct.check(first.GetNumberOfLines() == 2 and rt.strings(first, "ROIName") == ["Lt Lung"], "a script reaches a region's contours")

# A malformed contour costs that contour: a line in the report of its block, and of all.
for name, content, part in [
        ("nan.dcm", SET.replace(b"3.5", b"nan"), "expected a number"),
        ("two.dcm", SET.replace(b"\\3.5\\1.0", b"\\3.5    "), "three coordinates a point")]:
    kept = simple.DICOMRTStructureSetReader(FileName=rt.write(name, content))
    errors = rt.Errors(kept)
    lines = rt.strings(ct.data(kept), "Report")
    ct.check(not errors.own, f"{name}: {errors.own}")
    ct.check(any(part in line and "left out" in line for line in lines), f"{name}: {lines}")
    ct.check(any(part in line for _, block in rt.blocks(ct.data(kept)) for line in rt.strings(block, "Report")),
             f"{name}: no block reports it")
    ct.check(len(rt.blocks(ct.data(kept))) == len(rt.blocks(ct.data(simple.DICOMRTStructureSetReader(
        FileName=rt.write("whole.dcm", SET))))), f"{name} lost blocks")

# What is wrong with the file gives one sentence and nothing else.
for name, content, part in [
        ("truncated.dcm", SET[:len(SET) * 2 // 3], "truncated"),
        ("empty.dcm", b"", "the file is empty"),
        ("text.dcm", rt.NUAGES, "no DICOM file"),
        ("ct.dcm", rt.structure_set([(1, "A", "", None, [])], rt.CT_IMAGE), "CTImageStorage")]:
    rt.expect_error(simple.DICOMRTStructureSetReader(FileName=rt.write(name, content)), part, name)
rt.expect_error(simple.DICOMRTStructureSetReader(FileName=ct.output("absent.dcm")), "no such file", "absent")
rt.expect_error(simple.DICOMRTStructureSetReader(), "set FileName", "no name")
reader.FileName = ct.output("truncated.dcm")
rt.expect_error(reader, "truncated.dcm", "bad after good")
ct.finish()
