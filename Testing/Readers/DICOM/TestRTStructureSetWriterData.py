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
if st.skipped():
    print(f"SKIPPED in part: {st.skipped()} not there")
ct.finish()
