# SPDX-License-Identifier: GPL-3.0-or-later
"""`./run gui` by clicks: open an RT structure set, save it as another, apply Polyhedral Surface, look at the picture."""
import os

import contourtesting as ct
import guitesting as gui
import readertesting as rt

simple = ct.load_plugin()
DRAWN, SAVED = ct.output("gui drawn.dcm"), ct.output("gui saved.dcm")
BASELINE = os.path.join(ct.SOURCE, "Testing", "Baseline", "GuiPolyhedralSurface.png")

pipe = simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))
writer = simple.DICOMRTStructureSetWriter(Input=pipe, FileName=DRAWN, ROIName="Pipe")
writer.GetClientSideObject().AddObserver("WarningEvent", lambda *_: None)  # that it has no patient
writer.UpdatePipeline()

if os.path.exists(SAVED):
    os.remove(SAVED)
gui.play("gui", [
    *gui.open_structure_set(DRAWN),
    gui.APPLY,
    *gui.save_data(SAVED, [
        ("WriterSettingsDialog/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget/ReferenceFileName/FileChooser/"
         "FileLineEdit", "set_string", DRAWN)]),
    *gui.apply_filter("PolyhedralSurface"),
    ("cameraToolbar/actionPositiveX", "activate", ""),
], f"--test-baseline={BASELINE}", "--test-threshold=25")
if ct.check(os.path.exists(SAVED), "File > Save Data has written the structure set"):
    names = [name for name, _ in rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=SAVED)))]
    ct.check(names == ["Pipe", "Pipe (2)"], f"the ROIs are {names}")
ct.finish()
