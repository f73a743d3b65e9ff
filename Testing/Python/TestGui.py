# SPDX-License-Identifier: GPL-3.0-or-later
"""`./run gui` by clicks: open an RT structure set, save it as another, apply Polyhedral Surface, look at the picture."""
import os
import subprocess
from xml.sax.saxutils import quoteattr

import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
WINDOW = "pqClientMainWindow"
DRAWN, SAVED, CLICKS = ct.output("gui drawn.dcm"), ct.output("gui saved.dcm"), ct.output("gui.xml")
BASELINE = os.path.join(ct.SOURCE, "Testing", "Baseline", "GuiPolyhedralSurface.png")
APPLY = ("propertiesDock/propertiesPanel/Accept", "activate", "")

pipe = simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))
writer = simple.DICOMRTStructureSetWriter(Input=pipe, FileName=DRAWN, ROIName="Pipe")
writer.GetClientSideObject().AddObserver("WarningEvent", lambda *_: None)  # that it has no patient
writer.UpdatePipeline()

# ParaView's own reader of DICOM images claims every .dcm as well, so ParaView asks; ours is the first that it offers.
EVENTS = [
    ("menubar/menu_File", "activate", "actionFileOpen"),
    ("FileOpenDialog", "filesSelected", DRAWN),
    ("pqSelectReaderDialog/listWidget", "setCurrent", "0.0"),
    ("pqSelectReaderDialog/okButton", "activate", ""),
    APPLY,
    ("menubar/menu_File", "activate", "actionFileSaveData"),
    ("FileSaveDialog", "filesSelected", SAVED),
    ("WriterSettingsDialog/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget/ReferenceFileName/FileChooser/"
     "FileLineEdit", "set_string", DRAWN),
    ("WriterSettingsDialog/widget/OKButton", "activate", ""),
    ("menubar/menuFilters/pqProxyGroupMenuManager0/PolyhedralSurface", "activate", ""),
    APPLY,
    ("cameraToolbar/actionPositiveX", "activate", ""),
]
with open(CLICKS, "w", encoding="utf-8") as file:
    file.write("<pqevents>\n")
    for widget, command, arguments in EVENTS:
        file.write(f"  <pqevent object={quoteattr(WINDOW + '/' + widget)} command={quoteattr(command)} "
                   f"arguments={quoteattr(arguments)} />\n")
    file.write("</pqevents>\n")
if os.path.exists(SAVED):
    os.remove(SAVED)

environment = dict(os.environ, CONTOUR_BUILD_DIR=os.environ["CONTOUR_BINARY_DIR"])
environment.pop("PYTHONPATH")  # what a user does not have
try:
    run = subprocess.run(
        [os.path.join(ct.SOURCE, "run"), "gui", "--dr", f"--test-directory={ct.OUTPUT}", f"--test-script={CLICKS}",
         f"--test-baseline={BASELINE}", "--test-threshold=25", "--exit"],
        env=environment, capture_output=True, text=True, errors="replace", timeout=120)
    words, code = run.stdout + run.stderr, run.returncode
except subprocess.TimeoutExpired as error:
    words, code = f"no end after {error.timeout} s: {error.stdout}", 1
# Not the ERR| that would end this test before it can say what it was.
ct.check(code == 0, f"the clicks end in {code}: {words[-3000:].replace('ERR|', 'error')}")
ct.check("ERR|" not in words, f"ParaView complains: {words[-3000:].replace('ERR|', 'error')}")
if ct.check(os.path.exists(SAVED), "File > Save Data has written the structure set"):
    names = [name for name, _ in rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=SAVED)))]
    ct.check(names == ["Pipe", "Pipe (2)"], f"the ROIs are {names}")
ct.finish()
