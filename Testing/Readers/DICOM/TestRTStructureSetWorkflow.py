# SPDX-License-Identifier: GPL-3.0-or-later
"""What a physician does: 4 contours of a real heart drawn, all its slices back as a structure set of the same patient.

The heart of dicompyler's set (33 slices, 3 mm) is cut down to 4 of its contours. Implicit Contours on the slices that
the structure set shows are written with it as reference, judged by dciodvfy, and read back by pydicom and by us.
"""
import os

import contourtesting as ct
import readertesting as rt
import structuresettesting as st

simple = ct.load_plugin()
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData

REFERENCE = ct.shared("rtstruct/dicompyler_rtss.dcm")
WRITTEN = ct.output("heart from four contours.dcm")
TOLERANCE = 1e-6  # mm


def source_of(poly):
    producer = simple.PVTrivialProducer()
    producer.GetClientSideObject().SetOutput(poly)
    producer.UpdatePipeline()
    return producer


def height(poly, cell):
    return poly.GetCell(cell).GetBounds()[4]


def subset(poly, cells):
    """Those cells only, with the field data of the ROI."""
    part = vtkPolyData()
    part.SetPoints(poly.GetPoints())
    part.Allocate()
    for c in cells:
        part.InsertNextCell(poly.GetCellType(c), poly.GetCell(c).GetPointIds())
    part.GetFieldData().ShallowCopy(poly.GetFieldData())
    clean = vtkCleanPolyData()
    clean.PointMergingOff()
    clean.SetInputData(part)
    clean.Update()
    return clean.GetOutput()


reader = simple.DICOMRTStructureSetReader(FileName=REFERENCE, ROIs=["Heart"])
heart = rt.blocks(ct.data(reader))[0][1]
order = sorted(range(heart.GetNumberOfCells()), key=lambda c: height(heart, c))
ct.check(len(order) == 33, f"the heart has {len(order)} contours")
drawn = subset(heart, [order[i] for i in (0, 11, 21, 32)])
ct.check(drawn.GetNumberOfCells() == 4, "4 contours are drawn")

constraints = simple.ImplicitConstraints(Input=source_of(drawn))
function = simple.ImplicitFunction(Input=constraints)
contours = simple.ImplicitContours(Input=function, Planes=simple.DICOMSlicePlanes(FileName=REFERENCE))
result = ct.data(contours)
levels = result.GetFieldData().GetArray("LevelOffset").GetNumberOfTuples()
ct.check(levels >= 30, f"contours on {levels} slices")
ct.check(rt.strings(result, "ROIName") == ["Heart"], "the name has come through the pipeline")


def volume_of_drawn_slices(contours_proxy):
    """Area of all slices that the heart is drawn on times their distance, mm3; how it goes on beyond, nobody drew."""
    hierarchy = ct.data(simple.ContourHierarchy(Input=contours_proxy))
    areas = hierarchy.GetCellData().GetArray("SignedArea")
    inside = [c for c in range(hierarchy.GetNumberOfCells()) if LOWEST - 0.01 < height(hierarchy, c) < HIGHEST + 0.01]
    return 3.0 * sum(areas.GetValue(c) for c in inside)


LOWEST, HIGHEST = height(heart, order[0]), height(heart, order[-1])
volumes = volume_of_drawn_slices(source_of(heart)), volume_of_drawn_slices(contours)
print(f"volume of all 33 drawn slices {volumes[0] / 1000:.1f} cm3, from 4 of them {volumes[1] / 1000:.1f} cm3")
ct.check(abs(volumes[1] / volumes[0] - 1) < 0.05, f"the contours are those of the heart: {volumes}")

if os.path.exists(WRITTEN):
    os.remove(WRITTEN)
simple.SaveData(WRITTEN, proxy=contours, ReferenceFileName=REFERENCE)
ct.check(os.path.exists(WRITTEN), "the structure set is written")
st.check_validity(WRITTEN)

# Our own reader.
written = dict(rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=WRITTEN))))
ct.check("Heart" in written and "Heart (2)" in written and len(written) == 11, f"the ROIs are {list(written)}")
expected = st.contours_of(result)
difference = st.largest_difference(expected, st.contours_of(written["Heart (2)"]))
print(f"{len(expected)} contours on {levels} slices, {sum(map(len, expected)) // 3} points; "
      f"our reader gives them back to {difference:.2g} mm")
ct.check(difference <= TOLERANCE, f"our reader: {difference} mm")
ct.check(st.contours_of(written["Heart"]) == st.contours_of(heart), "the drawn heart is as it was")
ct.check(rt.strings(written["Heart (2)"], "ROIType") == rt.strings(heart, "ROIType"), "the type is kept")

# pydicom, which also tells the images: each contour refers to that of the drawn contour in its plane.
rois = st.pydicom_rois(WRITTEN)
if rois is not None:
    difference = st.largest_difference(expected, [data for _, data, _ in rois["Heart (2)"]])
    print(f"pydicom gives them back to {difference:.2g} mm")
    ct.check(difference <= TOLERANCE, f"pydicom: {difference} mm")
    ct.check(all(kind == "CLOSED_PLANAR" for kind, _, _ in rois["Heart (2)"]), "all contours are closed")
    image_at = {round(data[2], 3): images for _, data, images in rois["BODY"]}
    ct.check(all(images == image_at[round(data[2], 3)] for _, data, images in rois["Heart (2)"]),
             "every contour refers to the image of its slice")
    import pydicom
    before, after = pydicom.dcmread(REFERENCE), pydicom.dcmread(WRITTEN)
    for name in ("PatientName", "PatientID", "StudyInstanceUID", "StudyDate"):
        ct.check(getattr(before, name) == getattr(after, name), f"{name} is that of the reference")
    for name in ("SOPInstanceUID", "SeriesInstanceUID"):
        ct.check(getattr(before, name) != getattr(after, name), f"{name} is new")
    ct.check(after.ApprovalStatus == "UNAPPROVED", "nobody has approved it")
if st.skipped():
    print(f"SKIPPED in part: {st.skipped()} not there")
ct.finish()
