# SPDX-License-Identifier: GPL-3.0-or-later
"""From contours to contours on the images of other people's series, on the command line.

The images once came out wrong: another frame of reference, a localizer among them, a damaged one, images beside
the contours.
"""
import os
import shutil
import subprocess

import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
SCRIPT = os.path.join(ct.SOURCE, "Plugin", "commandline", "reconstruct.py")
FAULTS = os.path.dirname(ct.shared("faults/rt/dupnum.dcm"))
OUT = ct.output("series.dcm")


def trace(source, *arguments):
    """Run the journey; the return code and all that it says."""
    if os.path.exists(OUT):
        os.remove(OUT)
    run = subprocess.run([shutil.which("pvpython"), "--force-offscreen-rendering", SCRIPT, os.path.join(FAULTS, source),
                          OUT, "--method", "ism", *arguments], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def written(name):
    """Heights of the contours of an ROI, and the frame of reference that they are in."""
    blocks = dict(rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=OUT))))
    block = blocks[name]
    heights = []
    for c in range(block.GetNumberOfCells()):
        bounds = block.GetCell(c).GetBounds()
        ct.check(bounds[5] - bounds[4] < 1e-6, f"contour {c} of {name} is in no slice: {bounds}")
        heights.append(round(bounds[4], 6))
    return sorted(heights), rt.strings(block, "FrameOfReferenceUID")


def expect(source, heights, line, name="Organ"):
    code, said = trace(source + "/drawn.dcm", "--reference", os.path.join(FAULTS, source, "ct", "CT000.dcm"))
    ct.check(code == 0, f"{source} returns {code}: {said}")
    ct.check(line in said, f"{source} says nothing of '{line}': {said}")
    got, _ = written(name)
    ct.check(got == heights, f"{source}: contours at {got} instead of {heights}")


SLICES = [float(z) for z in range(18, 73, 3)]
expect("localizer", SLICES, "CT090.dcm")
expect("offset", SLICES, "")
expect("badfile", [z for z in SLICES if z != 30], "CT010.dcm")

# OrganMR is drawn on images of the set's second frame of reference, every 4 mm.
MR = [float(z) for z in range(21, 70, 4)]
for reference in ([], ["--reference", os.path.join(FAULTS, "frames", "mr", "CT003.dcm")]):
    code, said = trace("frames/set.dcm", "--roi", "OrganMR", "--set", "CopyReferenceROIs=0", *reference)
    ct.check(code == 0, f"frames returns {code}: {said}")
    got, frame = written("OrganMR")
    ct.check(got == MR, f"OrganMR: contours at {got} instead of {MR}")
    ct.check(frame == ["1.2.826.0.1.3680043.8.498.77"], f"OrganMR is in {frame}")
code, said = trace("frames/set.dcm", "--roi", "OrganMR", "--reference", os.path.join(FAULTS, "frames", "ct", "CT000.dcm"))
ct.check(code != 0 and not os.path.exists(OUT), f"OrganMR is written on the CT: {said}")
ct.check("frame of reference" in said and "Traceback" not in said, f"OrganMR on the CT: {said}")

# What the reader left out is said in this journey as well.
code, said = trace("malformed_nan.dcm", "--roi", "Bad", "--reference", os.path.join(FAULTS, "leg", "ct", "CT000.dcm"))
ct.check(code == 0 and 'ROI "Bad", contour 6: left out' in said, f"malformed_nan returns {code}: {said}")
code, said = trace("dupnum.dcm", "--roi", "Lung", "--reference", os.path.join(FAULTS, "leg", "ct", "CT000.dcm"))
ct.check(code != 0 and '"Lung", "New2" have one number, 19' in said, f"dupnum returns {code}: {said}")

# The writer itself refuses as well.
organ = simple.DICOMRTStructureSetReader(FileName=os.path.join(FAULTS, "frames", "set.dcm"), ROIs=["OrganMR"])
writer = simple.DICOMRTStructureSetWriter(Input=organ, FileName=OUT, ReferenceFileName=os.path.join(
    FAULTS, "frames", "ct", "CT000.dcm"))
errors = rt.Errors(writer)
writer.UpdatePipeline()
ct.check(len(errors.own) == 1 and "whose coordinates have nothing to do with it" in errors.own[0], f"{errors.own}")
ct.check(not os.path.exists(OUT), "the writer wrote all the same")
ct.finish()
