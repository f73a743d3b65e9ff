# SPDX-License-Identifier: GPL-3.0-or-later
"""An optional second input can be connected, and cleared again, of every filter and writer that has one."""
import os

import contourtesting as ct

simple = ct.load_plugin()
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkCommonCore import vtkIntArray

contours = simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))


def figure(proxy, name):
    array = ct.data(proxy).GetFieldData().GetArray(name)
    return array.GetTuple1(0) if array else None


surface = simple.PolyhedralSurface(Input=contours)
certificate = simple.SurfaceCertificate(Input=surface, Contours=contours)
ct.check(figure(certificate, "FarthestContourVertex") is not None, "with contours the certificate has their distance")
certificate.Contours = None
ct.check(figure(certificate, "FarthestContourVertex") is None, "without them it has not")
certificate.Contours = contours
ct.check(figure(certificate, "FarthestContourVertex") is not None, "and with them again it has")


def forbidding():
    table = vtkTable()
    for name, value in (("LowerContour", 0), ("UpperContour", 2), ("Join", 0)):
        column = vtkIntArray()
        column.SetName(name)
        column.InsertNextValue(value)
        table.AddColumn(column)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(table)
    return producer


def cells(proxy):
    return ct.data(proxy).GetNumberOfCells()


whole = cells(surface)
surface.Overrides = forbidding()
cut = cells(surface)
surface.Overrides = None
ct.check(cells(surface) == whole != cut, "Polyhedral Surface forgets a table that is cleared")

mapping = simple.ContourMapping(Input=contours)


def joins_made():
    ct.data(mapping)
    table = mapping.GetClientSideObject().GetOutputDataObject(1)
    return sum(table.GetValueByName(r, "Joined").ToInt() for r in range(table.GetNumberOfRows()))


all_joins = joins_made()
mapping.Overrides = forbidding()
fewer = joins_made()
mapping.Overrides = None
ct.check(joins_made() == all_joins == fewer + 1, "Contour Mapping forgets a table that is cleared")

model = simple.ImplicitFunction(Input=simple.ImplicitConstraints(Input=contours))
traced = simple.ImplicitContours(Input=model, Spacing=2.0)


def planes():
    return ct.data(traced).GetFieldData().GetArray("LevelOffset").GetNumberOfTuples()


by_spacing = planes()
traced.Planes = contours
ct.check(planes() <= 4, "Implicit Contours takes the planes of its second input")
traced.Planes = None
ct.check(planes() == by_spacing > 4, "and its own again where that is cleared")

import xml.etree.ElementTree as ET
inputs = 0
for path in sorted(os.listdir(os.path.join(ct.SOURCE, "Plugin"))):
    if path.endswith(".xml"):
        for element in ET.parse(os.path.join(ct.SOURCE, "Plugin", path)).getroot().iter("InputProperty"):
            if element.find("Hints/Optional") is not None:
                inputs += 1
                ct.check(element.get("null_on_empty") == "1", f"{path}: {element.get('name')} can be cleared")
ct.check(inputs >= 5, "there are optional inputs")
ct.finish()
