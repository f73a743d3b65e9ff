# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView picks the right reader by extension and content, and each reader knows its own files only."""
import os

import contourtesting as ct
import readertesting as rt
from contourreconstruction.CurveNetworkReaders import vtkCurveNetworkReader
from contourreconstruction.DICOMReaders import vtkRTStructureSetReader
from contourreconstruction.NUAGESReaders import vtkNUAGESReader

simple = ct.load_plugin()
SET = rt.structure_set([(1, "A", "", None, [("CLOSED_PLANAR", [0.0, 0, 0, 1, 0, 0, 1, 1, 0])])])
FILES = {"n s.cnt": (rt.NUAGES, "NUAGESContourReader"), "c s.csl": (rt.CSL, "CurveNetworkReader"),
         "c n.contour": (rt.CONTOUR, "CurveNetworkReader"), "r t.dcm": (SET, "DICOMRTStructureSetReader"),
         "p r.dcm": (bytes(128) + b"DICM" + SET, "DICOMRTStructureSetReader")}
READERS = {"NUAGESContourReader": vtkNUAGESReader, "CurveNetworkReader": vtkCurveNetworkReader,
           "DICOMRTStructureSetReader": vtkRTStructureSetReader}
for name, (content, expected) in FILES.items():
    opened = simple.OpenDataFile(rt.write(name, content))
    ct.check(opened.GetXMLName() == expected, f"{name}: opened by {opened.GetXMLName()}")
    # Whatever its name, by content.
    other = rt.write(name + ".txt", content)
    for label, reader in READERS.items():
        ct.check(bool(reader.CanReadFile(other)) == (label == expected), f"{label} about {name}")
# Structure sets by any name, in a folder of any name.
for name in ["RS.1.2.3", "RTSTRUCT", "1.2.840.11.5", "IM000001", "set", "a set.ima", "RS.1.2.x"]:
    for folder in ["folder.vtk", "no digits"]:
        os.makedirs(ct.output(folder), exist_ok=True)
        opened = simple.OpenDataFile(rt.write(os.path.join(folder, name), SET))
        ct.check(opened.GetXMLName() == "DICOMRTStructureSetReader", f"{name}: opened by {opened.GetXMLName()}")
        opened.UpdatePipeline()
        ct.check(opened.GetDataInformation().GetNumberOfCells() == 1, f"{name} has no contour")
for name, content in [("text", "Some text\n"), ("none", ""), ("bytes", bytes(range(256)) * 8),
                      ("ct", rt.structure_set([(1, "A", "", None, [])], rt.CT_IMAGE))]:
    path = rt.write("not ours " + name, content)
    for label, reader in READERS.items():
        ct.check(not reader.CanReadFile(path), f"{label} would read {name}")
        ct.check(not reader.CanReadFile(ct.output("absent")), f"{label} would read a file that is absent")
# A damaged file of an extension that is ours alone comes to its reader, whose sentence says what is wrong.
for name, expected in (("damaged.cnt", "NUAGESContourReader"), ("damaged.CSL", "CurveNetworkReader"),
                       ("damaged.contour", "CurveNetworkReader"), ("damaged.brep", "BRepReader")):
    opened = simple.OpenDataFile(rt.write(name, "Some text\n"))
    if ct.check(opened is not None and opened.GetXMLName() == expected, f"{name}: opened by {opened}"):
        ct.check(name in ct.errors_of(opened.UpdatePipeline), f"{name}: the reader says what is wrong")
ct.finish()
