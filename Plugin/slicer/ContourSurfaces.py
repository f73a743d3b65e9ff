# SPDX-License-Identifier: GPL-3.0-or-later
"""A module of 3D Slicer: the regions of an RT structure set as a segmentation of closed surfaces.

Over the Python package contour_reconstruction (Documentation/slicer.md says how both come into Slicer). The logic needs
no window, and works as well with the classes of the package slicer-core alone.
"""
import os

import slicer
import vtk
from vtk.util.numpy_support import numpy_to_vtk

try:
    import ctk
    import qt
    from slicer.ScriptedLoadableModule import (ScriptedLoadableModule, ScriptedLoadableModuleLogic,
                                               ScriptedLoadableModuleWidget)
except ImportError:  # slicer-core has no window
    ScriptedLoadableModule = ScriptedLoadableModuleLogic = ScriptedLoadableModuleWidget = object

METHODS = {"Polyhedral Surface": "polyhedral_surface", "Fair Surface": "fair_surface",
           "Implicit Surface": "implicit_surface"}
REPORT = "ContourReconstruction.Report"  # the tag of a segment that says what was repaired or left out


class ContourSurfaces(ScriptedLoadableModule):
    """What Slicer lists."""

    def __init__(self, parent):
        super().__init__(parent)
        parent.title = "Contour Surfaces"
        parent.categories = ["Segmentation"]
        parent.contributors = ["The Contour Reconstruction authors"]
        parent.helpText = "The regions of a DICOM RT structure set as closed surfaces of a segmentation."


def package():
    """The package contour_reconstruction, or a sentence that says how Slicer gets it."""
    try:
        import contour_reconstruction
    except ImportError as error:
        raise ImportError("Slicer's Python has no package contour_reconstruction: type in the Python console "
                          f"slicer.util.pip_install('the path of its wheel') ({error}).") from error
    return contour_reconstruction


def poly_data(surface):
    """A surface in Slicer's coordinates: right, anterior, superior, where DICOM has left, posterior, superior."""
    points, triangles, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(surface.points * (-1, -1, 1), deep=True))
    triangles.SetData(3, numpy_to_vtk(surface.triangles.ravel(), deep=True, array_type=vtk.VTK_ID_TYPE))
    data.SetPoints(points)
    data.SetPolys(triangles)
    return data


class ContourSurfacesLogic(ScriptedLoadableModuleLogic):
    """Structure set in, segmentation node out."""

    def segment(self, region, method, progress, properties):
        """A closed surface with the colour of its region, and a sentence about it."""
        cr = package()
        surface = getattr(cr, METHODS[method])(region, progress=progress, **properties)
        certificate = cr.certificate(surface, region)
        segment = slicer.vtkSegment()
        segment.AddRepresentation(slicer.vtkSegmentationConverter.GetClosedSurfaceRepresentationName(),
                                  poly_data(surface))
        if "ROIColor" in region.field_data:
            segment.SetColor(*(float(part) / 255 for part in region.field_data["ROIColor"]))
        segment.SetTag(REPORT, "\n".join(surface.report + certificate.text))
        return segment, certificate.text[0]

    def reconstruct(self, path, node, regions=None, method="Polyhedral Surface", progress=None, **properties):
        """Adds a segment to a segmentation for each region of a structure set.

        Parameters
        ----------
        path : str
            A DICOM RT structure set.
        node : vtkMRMLSegmentationNode
            Its source representation becomes the closed surface.
        regions : iterable of str, optional
            Names of the regions that are wanted; all of them without it.
        method : str
            A key of METHODS; its properties are further keyword arguments.
        progress : callable, optional
            Gets a fraction and a text; the work ends with contour_reconstruction.Aborted where it returns False.

        Returns
        -------
        list of str
            A line for each region, also for one of which no surface can be made: the others are not lost by it.
        """
        cr = package()
        segmentation = node.GetSegmentation()
        segmentation.SetSourceRepresentationName(
            slicer.vtkSegmentationConverter.GetClosedSurfaceRepresentationName())
        drawn = cr.read_structure_set(path, regions)
        lines = list(drawn.report)
        for i, (name, region) in enumerate(drawn.items()):
            part = progress and (lambda done, stage, i=i, name=name:
                                 progress((i + done) / len(drawn), f"{name}: {stage}"))
            try:
                segment, verdict = self.segment(region, method, part, properties)
            except cr.Error as error:
                lines.append(f"{name}: left out. {error}")
                continue
            segment.SetName(name)
            segmentation.AddSegment(segment)
            lines.append(f"{name}: {verdict}")
        return lines


class ContourSurfacesWidget(ScriptedLoadableModuleWidget):
    """A file, a method, and a button."""

    def setup(self):
        super().setup()
        form = qt.QFormLayout()
        self.path = ctk.ctkPathLineEdit()
        self.path.filters = ctk.ctkPathLineEdit.Files
        self.method = qt.QComboBox()
        self.method.addItems(list(METHODS))
        self.lines = qt.QPlainTextEdit()
        self.lines.readOnly = True
        button = qt.QPushButton("Make surfaces")
        button.connect("clicked()", self.on_button)
        for label, widget in (("RT structure set:", self.path), ("Method:", self.method), ("", button), ("", self.lines)):
            form.addRow(label, widget)
        self.layout.addLayout(form)

    def on_button(self):
        def heard(fraction, text):
            dialog.value, dialog.labelText = int(100 * fraction), text
            slicer.app.processEvents()
            return not dialog.wasCanceled

        path, dialog = self.path.currentPath, slicer.util.createProgressDialog(autoClose=False)
        node = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLSegmentationNode", os.path.basename(path))
        with slicer.util.tryWithErrorDisplay("Not all surfaces could be made.", waitCursor=True):
            try:
                node.CreateDefaultDisplayNodes()
                lines = ContourSurfacesLogic().reconstruct(path, node, method=self.method.currentText, progress=heard)
                self.lines.plainText = "\n".join(lines)
            finally:
                dialog.close()
                if not node.GetSegmentation().GetNumberOfSegments():
                    slicer.mrmlScene.RemoveNode(node)
