# SPDX-License-Identifier: GPL-3.0-or-later
"""Every real structure set, written with itself as reference: valid, and read back to 1e-6 mm."""
import glob
import os

import contourtesting as ct
import readertesting as rt
import structuresettesting as st

simple = ct.load_plugin()
folder = os.path.dirname(ct.shared("rtstruct/dicompyler_rtss.dcm"))
FILES = sorted(glob.glob(os.path.join(folder, "*.dcm")) + glob.glob(os.path.join(folder, "phantoms", "*_30_0.dcm")))
written = 0
for path in FILES:
    name = os.path.basename(path)
    reader = simple.DICOMRTStructureSetReader(FileName=path)
    before = [(roi, block) for roi, block in rt.blocks(ct.data(reader)) if block.GetNumberOfCells() > 0]
    if not before:
        continue
    copy = ct.output("copy of " + name)
    simple.SaveData(copy, proxy=reader, ReferenceFileName=path, CopyReferenceROIs=0)
    st.check_validity(copy)
    after = rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=copy)))
    ct.check([roi for roi, _ in before] == [roi for roi, _ in after], f"{name}: the ROIs are {[r for r, _ in after]}")
    for (roi, old), (_, new) in zip(before, after):
        difference = st.largest_difference(st.contours_of(old), st.contours_of(new))
        ct.check(difference <= 1e-6, f"{name}, {roi}: {difference} mm")
    written += 1
print(f"{written} structure sets")
ct.check(written >= 12, f"only {written} structure sets have contours")

# The lung's 77 holes as keyholes: the regions are the same.
def regions(proxy):
    """Contours by depth, and the area that they enclose, mm2."""
    data = rt.blocks(ct.data(simple.ContourHierarchy(Input=proxy)))[0][1].GetCellData()
    depths = [data.GetArray("Depth").GetValue(i) for i in range(data.GetNumberOfTuples())]
    areas = [data.GetArray("SignedArea").GetValue(i) for i in range(data.GetNumberOfTuples())]
    return [depths.count(depth) for depth in range(max(depths) + 1)], sum(areas)


path = ct.shared("rtstruct/dicompyler_rtss.dcm")
lung = simple.DICOMRTStructureSetReader(FileName=path, ROIs=["Lt Lung"])
copy = ct.output("lung with keyholes.dcm")
simple.SaveData(copy, proxy=lung, ReferenceFileName=path, CopyReferenceROIs=0, Holes="Keyholes")
st.check_validity(copy)
keyholes = simple.DICOMRTStructureSetReader(FileName=copy)
(depths, area), (other_depths, other_area) = regions(lung), regions(keyholes)
contours = rt.blocks(ct.data(keyholes))[0][1].GetNumberOfCells()
print(f"lung: contours by depth {depths}, {area:.6f} mm2; as {contours} keyhole contours {other_depths}, "
      f"{other_area:.6f} mm2")
ct.check(contours < sum(depths), f"{contours} contours instead of {sum(depths)}")
ct.check(abs(other_area / area - 1) < 1e-6, f"the area is {other_area} instead of {area}")
ct.check(other_depths == depths, f"contours by depth {other_depths} instead of {depths}")
if st.skipped():
    print(f"SKIPPED in part: {st.skipped()} not there")
ct.finish()
