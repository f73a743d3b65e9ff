# SPDX-License-Identifier: GPL-3.0-or-later
"""`./run gui` by clicks: names of widgets, and a player that tells what went wrong."""
import os
import subprocess
from xml.sax.saxutils import quoteattr

import contourtesting as ct

WINDOW = "pqClientMainWindow"
PANEL = ("propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/"
         "ProxyPanel")
APPLY = ("propertiesDock/propertiesPanel/Accept", "activate", "")


def apply_filter(name):
    """A node of the menu Filters, Contour Reconstruction, with what its panel says."""
    return [(f"menubar/menuFilters/pqProxyGroupMenuManager0/{name}", "activate", ""), APPLY]


def apply_stage(name):
    """The same of a node that is no button: ParaView 5.13 does not hear a click on those by way of the toolbars' menu."""
    return [("menubar/menuFilters/Alphabetical", "activate", name), APPLY]


def open_structure_set(path):
    """ParaView's own reader of DICOM images claims every .dcm as well, so ParaView asks; ours is the first that it offers."""
    return [("menubar/menu_File", "activate", "actionFileOpen"),
            ("FileOpenDialog", "filesSelected", path),
            ("pqSelectReaderDialog/listWidget", "setCurrent", "0.0"),
            ("pqSelectReaderDialog/okButton", "activate", "")]


def save_data(path, settings=()):
    """settings: events in the dialog that asks for the properties of the writer; None where it has none to ask for."""
    dialog = [] if settings is None else [*settings, ("WriterSettingsDialog/widget/OKButton", "activate", "")]
    return [("menubar/menu_File", "activate", "actionFileSaveData"), ("FileSaveDialog", "filesSelected", path), *dialog]


def play(name, events, *options):
    """Starts ParaView with the plugin, clicks, and ends it; what went wrong is a failed check."""
    clicks = ct.output(name + ".xml")
    with open(clicks, "w", encoding="utf-8") as file:
        file.write("<pqevents>\n")
        for widget, command, arguments in events:
            file.write(f"  <pqevent object={quoteattr(WINDOW + '/' + widget)} command={quoteattr(command)} "
                       f"arguments={quoteattr(arguments)} />\n")
        file.write("</pqevents>\n")
    environment = dict(os.environ, CONTOUR_BUILD_DIR=os.environ["CONTOUR_BINARY_DIR"])
    environment.pop("PYTHONPATH")  # what a user does not have
    try:
        run = subprocess.run(
            [os.path.join(ct.SOURCE, "run"), "gui", "--dr", f"--test-directory={ct.OUTPUT}",
             f"--test-script={clicks}", *options, "--exit"],
            env=environment, capture_output=True, text=True, errors="replace", timeout=300)
        words, code = run.stdout + run.stderr, run.returncode
    except subprocess.TimeoutExpired as error:
        words, code = f"no end after {error.timeout} s: {error.stdout}", 1
    # Not the ERR| that would end this test before it can say what it was.
    ct.check(code == 0, f"{name}: the clicks end in {code}: {words[-3000:].replace('ERR|', 'error')}")
    ct.check("ERR|" not in words, f"{name}: ParaView complains: {words[-3000:].replace('ERR|', 'error')}")
