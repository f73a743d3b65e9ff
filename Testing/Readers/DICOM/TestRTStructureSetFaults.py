# SPDX-License-Identifier: GPL-3.0-or-later
"""Other people's structure sets that once came out wrong: what is wrong with a part costs that part only."""
import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
GOOD, BAD, NEW, OTHER = 13549.89, 9409.64, 11385.67, 18442.9  # mm3 of the prisms, of which the files are made


def volumes(reader):
    """The volume of each block's surface; None where there is no surface."""
    result = {}
    for name, block in rt.blocks(ct.data(simple.PolyhedralSurface(Input=reader, EndCaps="Flat"))):
        result[name] = None
        if block.GetNumberOfPolys() > 0:
            producer = simple.PVTrivialProducer()
            producer.GetClientSideObject().SetOutput(block)
            certificate = ct.data(simple.SurfaceCertificate(Input=producer))
            result[name] = certificate.GetFieldData().GetArray("Volume").GetValue(0)
    return result


FILES = {"dupnum.dcm": {"Heart": GOOD, "Lung": None, "New1": NEW, "New2": None},
         "malformed_nan.dcm": {"Good": GOOD, "Bad": BAD, "Other": OTHER},
         "malformed_trail.dcm": {"Good": GOOD, "Bad": BAD, "Other": OTHER}}
for name, expected in FILES.items():
    reader = simple.DICOMRTStructureSetReader(FileName=ct.shared("faults/rt/" + name))
    errors = rt.Errors(reader)
    got = volumes(reader)
    print(name, got, rt.strings(ct.data(reader), "Report"))
    ct.check(not errors.own, f"{name}: {errors.own}")
    ct.check(list(got) == list(expected), f"{name}: the ROIs are {list(got)}")
    for roi, volume in expected.items():
        ct.check((got[roi] is None) == (volume is None), f"{name}, {roi}: {got[roi]}")
        ct.check(not volume or abs(got[roi] / volume - 1) < 1e-4, f"{name}, {roi}: {got[roi]} instead of {volume}")

report = rt.strings(ct.data(simple.DICOMRTStructureSetReader(FileName=ct.shared("faults/rt/dupnum.dcm"))), "Report")
ct.check(any('"Lung", "New2" have one number, 19' in line for line in report), f"the report is {report}")
bad = simple.DICOMRTStructureSetReader(FileName=ct.shared("faults/rt/malformed_nan.dcm"), ROIs=["Bad"])
for data in (ct.data(bad), rt.blocks(ct.data(bad))[0][1]):
    report = rt.strings(data, "Report")
    ct.check(len(report) == 1 and 'ROI "Bad", contour 6: left out' in report[0], f"the report is {report}")

# Names in JIS, and a file without .dcm.
names = simple.DICOMRTStructureSetReader(FileName=ct.shared("faults/rt/names_jis.dcm"), ROIs=["心臓"])
ct.check([name for name, _ in rt.blocks(ct.data(names))] == ["心臓"], "names in JIS")
opened = simple.OpenDataFile(ct.shared("faults/rt/no_extension/RS.1.2.3"))
ct.check([name for name, _ in rt.blocks(ct.data(opened))] == ["Heart"], "a file without .dcm")

# Each block tells the frame of reference that it is drawn in.
frames = simple.DICOMRTStructureSetReader(FileName=ct.shared("faults/rt/frames/set.dcm"))
frames = {name: rt.strings(block, "FrameOfReferenceUID") for name, block in rt.blocks(ct.data(frames))}
ct.check(frames["OrganMR"] == frames["BodyMR"] != frames["OrganCT"] == frames["BODY"], f"frames: {frames}")
ct.check(frames["OrganMR"] == ["1.2.826.0.1.3680043.8.498.77"], f"frames: {frames}")
ct.finish()
