# SPDX-License-Identifier: GPL-3.0-or-later
"""Polyhedral, Fair and Implicit Surface, and Surface Certificate, in any ParaView from 5.11 on, over the Python package.

For a ParaView that this project's own plugin was not built for, such as Kitware's: Tools > Manage Plugins > Load New, and
pick this file (Documentation/python.md says how its Python finds the package). The nodes have the names, properties
and arrays of the compiled ones, so load only one of the two.
"""
import inspect
import re
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

try:
    import contour_reconstruction as cr
    from contour_reconstruction._data import check_no_surface
    from contour_reconstruction._properties import CHOICES, FLAGS, RANGES, TUPLES
except ImportError as error:
    raise ImportError("ParaView's Python does not find the package contour_reconstruction: put the folder that pip "
                      f"installed it to in PYTHONPATH ({error}).") from error

paraview_plugin_name = "Contour Reconstruction (Python)"
paraview_plugin_version = cr.__version__


def help_of(function, name):
    """What the function's documentation says of an argument."""
    text = inspect.cleandoc(function.__doc__)
    match = re.search(rf"^(?:\w+, )*{name}(?:, \w+)* : [^\n]*\n((?:[ ]{{4}}[^\n]*\n)+)", text, flags=re.MULTILINE)
    return " ".join(match.group(1).split()) if match else "See the documentation of Implicit Surface."


def property_xml(function, name, default):
    """A property as ParaView's XML has it, with the domain that the package checks."""
    domain, kind, numbers = "", "IntVectorProperty", default
    if name in CHOICES:
        numbers = CHOICES[name][default]
        entries = (f"<Entry value='{number}' text={quoteattr(text)}/>" for text, number in CHOICES[name].items())
        domain = f"<EnumerationDomain name='enum'>{''.join(entries)}</EnumerationDomain>"
    elif name in FLAGS:
        numbers, domain = int(default), "<BooleanDomain name='bool'/>"
    elif name == "Threads":
        domain = "<IntRangeDomain name='range' min='0'/>"
    else:
        kind = "DoubleVectorProperty"
        least, most = RANGES.get(name, (-np.inf, np.inf))
        least = min(least, default) if name not in TUPLES else least  # -1: automatic, of Fair Surface
        limits = (f" {word}='{limit}'" for word, limit in (("min", least), ("max", most)) if np.isfinite(limit))
        domain = f"<DoubleRangeDomain name='range'{''.join(limits)}/>"
    values = " ".join(map(str, numbers)) if name in TUPLES else numbers
    return (f"<{kind} name='{name}' command='Set{name}' number_of_elements='{TUPLES.get(name, 1)}' "
            f"default_values='{values}'>{domain}<Documentation>{escape(help_of(function, name))}</Documentation></{kind}>")


def with_properties_of(function):
    """Gives a class a setter for each keyword argument of a function of the package."""
    def decorate(node):
        node.properties = {name: argument.default for name, argument in inspect.signature(function).parameters.items()
                           if argument.kind is argument.KEYWORD_ONLY and name != "progress"
                           and argument.default != ()}
        for name, default in node.properties.items():
            def setter(self, *values, name=name):
                self.properties[name] = values[0] if len(values) == 1 else values
                self.Modified()
            setattr(node, f"Set{name}", smproperty.xml(property_xml(function, name, default))(setter))
        return node
    return decorate


def cells_of(cells):
    """The points of each cell."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    return np.split(vtk_to_numpy(cells.GetConnectivityArray()), offsets[1:-1]) if cells.GetNumberOfCells() else []


def arrays_of(data):
    """Arrays by name, texts as lists."""
    found = {}
    for array in (data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())):
        texts = isinstance(array, vtkStringArray)
        found[array.GetName()] = [array.GetValue(i) for i in range(array.GetNumberOfValues())] if texts else (
            vtk_to_numpy(array))
    return found


def contours_of(data):
    """Vertices, lines and polygons of poly data as loops."""
    if not data.GetNumberOfPoints():
        raise cr.Error("The input has no points: give contours as polylines, polygons or line segments.")
    lines, polygons = cells_of(data.GetLines()), cells_of(data.GetPolys())
    check_no_surface(polygons)
    loops = cells_of(data.GetVerts()) + lines + polygons
    repeats = [len(loop) > 2 and loop[0] == loop[-1] for loop in loops]
    first = len(loops) - len(polygons)
    field = arrays_of(data.GetFieldData())
    report = field.pop("Report", [])
    loops = [loop[:-1] if repeated else loop for loop, repeated in zip(loops, repeats)]
    offsets = np.concatenate(([0], np.cumsum([len(loop) for loop in loops])))
    return cr.Contours(vtk_to_numpy(data.GetPoints().GetData()), offsets, np.concatenate(loops) if loops else [],
                       repeats[:first] + [True] * len(polygons), arrays_of(data.GetCellData()), field, report)


def add_arrays(values, data):
    """Named arrays into point, cell or field data."""
    for name, value in values.items():
        array = np.atleast_1d(np.asarray(value))
        array = array.astype(np.int32) if array.dtype.kind == "b" else array
        if array.dtype.kind == "U":
            texts = vtkStringArray()
            for text in array:
                texts.InsertNextValue(str(text))
        else:
            texts = numpy_to_vtk(np.ascontiguousarray(array), deep=True)
        texts.SetName(name)
        data.RemoveArray(name)
        data.AddArray(texts)


def set_surface(surface, output):
    """Triangles with all their data as poly data."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(surface.points, deep=True))
    flat = np.column_stack((np.full(len(surface.triangles), 3), surface.triangles)).astype(np.int64).ravel()
    triangles = vtkCellArray()
    triangles.SetCells(len(surface.triangles), numpy_to_vtkIdTypeArray(flat, deep=True))
    output.SetPoints(points)
    output.SetPolys(triangles)
    add_arrays(surface.point_data, output.GetPointData())
    add_arrays(surface.cell_data, output.GetCellData())
    add_arrays(surface.field_data, output.GetFieldData())
    if surface.report:
        add_arrays({"Report": surface.report}, output.GetFieldData())


class ContourNode(VTKPythonAlgorithmBase):
    """What the nodes have in common: properties, progress, stop, and sentences instead of tracebacks."""

    properties = {}

    def __init__(self, inputs=1):
        super().__init__(nInputPorts=inputs, nOutputPorts=1, inputType="vtkPolyData", outputType="vtkPolyData")
        self.properties = dict(type(self).properties)

    def OnProgress(self, fraction, stage):
        self.SetProgressText(stage)
        self.UpdateProgress(fraction)
        return not self.GetAbortExecute()

    def RequestData(self, request, inputs, output):
        output = vtkPolyData.GetData(output)
        try:
            self.Make([vtkPolyData.GetData(port) for port in inputs], output)
        except cr.Aborted:
            output.Initialize()
        except ValueError as error:
            output.Initialize()
            vtkOutputWindow.GetInstance().DisplayErrorText(f"{type(self).__name__}: {error}\n")
        return 1


MENU = "<ShowInMenu category='Contour Reconstruction'/>"


@smproxy.filter(name="PolyhedralSurface", label="Polyhedral Surface")
@smhint.xml(MENU)
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData"])
@with_properties_of(cr.polyhedral_surface)
class PolyhedralSurface(ContourNode):
    def Make(self, inputs, output):
        contours = contours_of(inputs[0])
        set_surface(cr.polyhedral_surface(contours, progress=self.OnProgress, **self.properties), output)


@smproxy.filter(name="FairSurface", label="Fair Surface")
@smhint.xml(MENU)
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData"])
@with_properties_of(cr.fair_surface)
class FairSurface(ContourNode):
    def Make(self, inputs, output):
        contours = contours_of(inputs[0])
        set_surface(cr.fair_surface(contours, progress=self.OnProgress, **self.properties), output)


@smproxy.filter(name="ImplicitSurface", label="Implicit Surface")
@smhint.xml(MENU)
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData"])
@with_properties_of(cr.implicit_surface)
class ImplicitSurface(ContourNode):
    def Make(self, inputs, output):
        contours = contours_of(inputs[0])
        set_surface(cr.implicit_surface(contours, progress=self.OnProgress, **self.properties), output)
        output.GetPointData().SetActiveNormals("Normals")


@smproxy.filter(name="SurfaceCertificate", label="Surface Certificate")
@smhint.xml(MENU)
@smproperty.xml("<InputProperty name='Contours' command='SetInputConnection' port_index='1' null_on_empty='1'>"
                "<ProxyGroupDomain name='groups'><Group name='sources'/><Group name='filters'/></ProxyGroupDomain>"
                "<DataTypeDomain name='input_type'><DataType value='vtkPolyData'/></DataTypeDomain>"
                "<Hints><Optional/></Hints></InputProperty>")
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData"])
@with_properties_of(cr.certificate)
class SurfaceCertificate(ContourNode):
    def __init__(self):
        super().__init__(inputs=2)

    def FillInputPortInformation(self, port, info):
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData")
        if port == 1:
            info.Set(self.INPUT_IS_OPTIONAL(), 1)
        return 1

    def Make(self, inputs, output):
        surface = inputs[0]
        corners = cells_of(surface.GetPolys())
        if surface.GetNumberOfCells() != len(corners) or any(len(cell) != 3 for cell in corners):
            raise cr.Error("The surface has other cells than triangles: apply Triangulate first.")
        contours = contours_of(inputs[1]) if inputs[1] else None
        judged = cr.certificate((vtk_to_numpy(surface.GetPoints().GetData()), np.array(corners)), contours,
                                progress=self.OnProgress, **self.properties)
        output.ShallowCopy(surface)
        add_arrays({"Defect": judged.defect, "ComponentId": judged.component_id}, output.GetCellData())
        figures = {name: np.nan if value is None else value for name, value in judged.figures.items()}
        figures.update({"Certificate": judged.text, "CertificateJSON": judged.json})
        add_arrays(figures, output.GetFieldData())
