# SPDX-License-Identifier: GPL-3.0-or-later
"""What people do in the window, by clicks; what they save is read back.

Session 1: open a structure set, choose three regions, bring them to all slices, save them as a structure set, make
surfaces, examine them with the contours that are chosen in the panel, save them as .brep.
Session 2: forbid a join in Contour Mapping.
Session 3: slice a mesh and get it back, by both methods.
Session 4: from an empty window to coloured surfaces of three regions with what they are worth, in ten clicks at most.
"""
import glob
import math
import os
import re
import sys

import contourtesting as ct
import guitesting as gui
import readertesting as rt

simple = ct.load_plugin()
FILES = {name: ct.output("window " + name)
         for name in ("drawn.dcm", "all.dcm", "regions.brep", "cut.brep", "sliced.stl", "smooth.stl", "walk.pvsm")}


def circle(radius, z, x=0.0):
    return [c for i in range(24)
            for c in (x + radius * math.cos(i * math.pi / 12), radius * math.sin(i * math.pi / 12), z)]


def drawn(radius_at, x):
    """On four of the body's slices."""
    return [("CLOSED_PLANAR", circle(radius_at(z), z, x), f"1.2.3.{int(z / 3) + 11}") for z in (-12.0, -6.0, 6.0, 12.0)]


def regions_of(pattern):
    """Triangles, contours and connected pieces of .brep files, by region."""
    found = {}
    for path in glob.glob(pattern):
        data = ct.data(simple.BRepReader(FileName=path))
        region = os.path.splitext(path)[0].rsplit("-", 1)[1]
        shells = data.GetCellData().GetArray("ShellId")
        pieces = len({shells.GetTuple1(i) for i in range(shells.GetNumberOfTuples())})
        found[region] = (data.GetNumberOfPolys(), data.GetNumberOfLines(), pieces)
    return found


body = [("CLOSED_PLANAR", circle(60.0, 3.0 * i - 30), f"1.2.3.{i + 1}") for i in range(21)]
with open(FILES["drawn.dcm"], "wb") as file:
    file.write(rt.structure_set([
        (1, "Body", "EXTERNAL", "0\\255\\0", body), (2, "Ball", "PTV", "255\\0\\0", drawn(lambda z: math.sqrt(400 - z * z), 0)),
        (3, "Rod", "ORGAN", "0\\0\\255", drawn(lambda _: 8.0, 35)), (4, "Wire", "ORGAN", "255\\255\\0", drawn(lambda _: 5.0, -40))]))
for path in glob.glob(ct.output("window *-*.brep")) + [path for name, path in FILES.items() if name != "drawn.dcm"]:
    if os.path.exists(path):
        os.remove(path)
OPEN = gui.open_structure_set(FILES["drawn.dcm"])
ROIS = gui.PANEL + "/ROIs/ArraySelectionWidget"  # Ball, Body, Rod, Wire

if "1" in sys.argv[1:] or len(sys.argv) == 1:
    gui.play("window 1", [
        *OPEN, (ROIS, "setCheckState", "1.0,0"), gui.APPLY,
        *gui.apply_filter("ContoursOnSlices"),
        *gui.save_data(FILES["all.dcm"]),
        *gui.apply_filter("PolyhedralSurface"),
        gui.apply_filter("SurfaceCertificate")[0],
        (gui.PANEL + "/Contours/1QComboBox0", "set_string", "ContoursonSlices1"), gui.APPLY,
        *gui.save_data(FILES["regions.brep"], None),
    ])
    blocks = dict(rt.blocks(ct.data(simple.DICOMRTStructureSetReader(FileName=FILES["all.dcm"])))) \
        if os.path.exists(FILES["all.dcm"]) else {}
    ct.check(list(blocks) == ["Body", "Ball", "Rod", "Wire", "Ball (2)", "Rod (2)", "Wire (2)"], f"ROIs: {list(blocks)}")
    ct.check(all(blocks[name].GetNumberOfCells() == 9 for name in blocks if "(2)" in name), "on the nine slices between")
    regions = regions_of(ct.output("window regions-*.brep"))
    ct.check(sorted(regions) == ["Ball", "Rod", "Wire"], f"a file a region: {regions}")
    ct.check(all(region[1] == 9 for region in regions.values()), f"with the contours that it was made from: {regions}")

if "2" in sys.argv[1:] or len(sys.argv) == 1:
    JOINS = gui.PANEL + "/ForbiddenJoins/ScalarValueList/"
    gui.play("window 2", [
        *OPEN, (ROIS, "setCheckState", "0.0,0"), (ROIS, "setCheckState", "1.0,0"), gui.APPLY,
        gui.apply_stage("ContourMapping")[0],
        ("propertiesDock/propertiesPanel/SearchBox/AdvancedButton", "set_boolean", "true"),
        (JOINS + "Add", "activate", ""),
        # Contours 0 and 1, the two lowest ones of each region.
        (JOINS + "Table", "edit", "0.0"), (JOINS + "Table", "editAccepted", "0.0,0"),
        (JOINS + "Table", "edit", "0.1"), (JOINS + "Table", "editAccepted", "0.1,1"), gui.APPLY,
        *gui.apply_filter("PolyhedralSurface"),
        *gui.save_data(FILES["cut.brep"], None),
    ])
    regions = regions_of(ct.output("window cut-*.brep"))
    ct.check(sorted(regions) == ["Rod", "Wire"], f"a file a region: {regions}")
    ct.check(all(region[2] == 2 for region in regions.values()), f"in two pieces, as the join is forbidden: {regions}")

if "3" in sys.argv[1:] or len(sys.argv) == 1:
    SLICES = gui.PANEL + "/ContourValues/ScalarValueList/"
    SERIES = SLICES + "SeriesGeneratorDialog/"
    gui.play("window 3", [
        ("menubar/menuSources/Alphabetical", "activate", "SphereSource"), gui.APPLY,
        ("menubar/menuFilters/Alphabetical", "activate", "Cut"),
        (SLICES + "RemoveAll", "activate", ""), (SLICES + "AddRange", "activate", ""),
        (SERIES + "min", "set_string", "-0.45"), (SERIES + "max", "set_string", "0.45"),
        (SERIES + "nsamples", "set_int", "10"), (SERIES + "buttonBox/1QPushButton0", "activate", ""), gui.APPLY,
        *gui.apply_filter("PolyhedralSurface"), *gui.save_data(FILES["sliced.stl"]),
        ("propertiesDock/propertiesPanel/Delete", "activate", ""),
        *gui.apply_filter("ImplicitSurface"), *gui.save_data(FILES["smooth.stl"]),
    ])
    for name in ("sliced.stl", "smooth.stl"):
        if ct.check(os.path.exists(FILES[name]), f"{name} is written"):
            figures = ct.data(simple.SurfaceCertificate(Input=simple.STLReader(FileNames=[FILES[name]]))).GetFieldData()
            volume = figures.GetArray("Volume").GetTuple1(0)
            # ParaView's sphere of eight sides has 0.4.
            ct.check(figures.GetArray("Sound").GetTuple1(0) == 1 and 0.3 < volume < 0.55, f"{name}: volume {volume}")
if "4" in sys.argv[1:] or len(sys.argv) == 1:
    WALK = [*OPEN, (ROIS, "setCheckState", "1.0,0"), gui.APPLY, *gui.apply_filter("PolyhedralSurface")]
    # Ours is the first reader that is offered, and chosen already; of ten regions it would be three clicks more.
    clicks = sum(command != "setCurrent" for _, command, _ in WALK)
    ct.check(clicks + 3 <= 10, f"{clicks + 3} clicks to three surfaces")
    gui.play("window 4", [
        *WALK, ("menubar/menu_File", "activate", "actionFileSaveServerState"),
        ("FileSaveServerStateDialog", "filesSelected", FILES["walk.pvsm"])])
    if ct.check(os.path.exists(FILES["walk.pvsm"]), "the state is saved"):
        with open(FILES["walk.pvsm"], encoding="utf-8") as file:
            state = file.read()
        shown = re.findall(r'<Property name="BlockColors" id="[\d.a-zA-Z]*" number_of_elements="(\d+)"', state)
        ct.check(shown.count("12") == 2, f"contours and surfaces have the colours of three regions: {shown}")
        ct.check('<Property name="BlockColorsDistinctValues"' in state and "vtkBlockColors" not in re.findall(
            r'<Property name="ColorArrayName".*?</Property>', state, flags=re.DOTALL), "and no others")
        ct.check('type="ScalarBarWidgetRepresentation"' not in state, "without a legend of blocks")
ct.finish()
