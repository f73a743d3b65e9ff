# SPDX-License-Identifier: GPL-3.0-or-later
"""Every real RT structure set opens by itself and has the ROIs, contours and points of its table."""
import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
# ROIs, contours with points, points
TABLE = {"dicompyler_rtss": (10, 441, 88158), "dicomexport_rs": (11, 281, 140724), "cerr_ibsi": (1, 26, 9661),
         "rtutils_keyholes": (4, 12, 2104), "rtutils_single_slice_hole": (1, 2, 12),
         "pydicom_no_preamble_points": (3, 5, 19), "pyorthanc_cone_02mm": (2, 121, 22694),
         "template_no_contour_data": (1, 0, 0)}


def open_set(name):
    reader = simple.OpenDataFile(ct.shared(f"rtstruct/{name}.dcm"))
    ct.check(reader.GetXMLName() == "DICOMRTStructureSetReader", f"{name}: opened by {reader.GetXMLName()}")
    return reader


for name, expected in TABLE.items():
    output = ct.data(open_set(name))
    blocks = [block for _, block in rt.blocks(output)]
    found = (len(blocks), sum(b.GetNumberOfCells() for b in blocks), sum(b.GetNumberOfPoints() for b in blocks))
    ct.check(found == expected, f"{name}: {found} instead of {expected}")
    ct.check(all(rt.loops_are_closed(b) for b in blocks), f"{name}: loops are not closed")

lungs = open_set("dicompyler_rtss")
output = ct.data(lungs)
blocks = dict(rt.blocks(output))
ct.check(blocks["Lt Lung"].GetNumberOfLines() == 165, "Lt Lung has 165 contours")
ct.check(rt.strings(output, "Report") == ['ROI "Areola": it has no contours.'], "Areola is empty and reported")
lungs.ROIs = ["Lt Lung", "Heart"]
ct.check([name for name, _ in rt.blocks(ct.data(lungs))] == ["Heart", "Lt Lung"], "two ROIs of ten")

points = dict(rt.blocks(ct.data(open_set("pydicom_no_preamble_points"))))
ct.check(points["Isocenter 1"].GetNumberOfVerts() == 1 and points["patient"].GetNumberOfLines() == 3,
         "no preamble: two isocentres are points")
ct.check("no contour data" in rt.strings(ct.data(open_set("template_no_contour_data")), "Report")[0],
         "the item without data is reported")

for shape in ("Cone", "Cylinder", "RtCone", "RtCylinder", "Sphere"):
    for spacing in (10, 20, 30):
        name = f"phantoms/{shape}_{spacing}_0"
        blocks = [block for _, block in rt.blocks(ct.data(open_set(name)))]
        contours = sum(b.GetNumberOfLines() for b in blocks)
        ct.check(len(blocks) == 2 and 9 <= contours <= 25, f"{name}: {len(blocks)} ROIs, {contours} contours")
        ct.check(min(b.GetNumberOfPoints() for b in blocks) == 0, f"{name}: POI_1 is empty")
ct.finish()
