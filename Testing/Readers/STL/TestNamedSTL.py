# SPDX-License-Identifier: GPL-3.0-or-later
"""Named STL Writer: Save Data of a collection gives a file a region, by name; what it warns of and refuses."""
import os
import shutil
import struct

import contourtesting as ct
import readertesting as rt
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (vtkCellArray, vtkCompositeDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection,
                                           vtkPolyData)

simple = ct.load_plugin()
FOLDER = ct.output("named_stl")
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)


def place(name):
    return os.path.join(FOLDER, name)


def triangles(path):
    """Of a binary STL file whose length fits their number."""
    with open(path, "rb") as file:
        head = file.read(84)
        size = len(head) + len(file.read())
    count = struct.unpack("<I", head[80:])[0]
    ct.check(size == 84 + 50 * count, f"{path} is a whole binary STL file")
    return count


def tetrahedron(corners):
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for corner in corners:
        points.InsertNextPoint(corner)
    for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)):
        cells.InsertNextCell(3, face)
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def collection(**blocks):
    made = vtkPartitionedDataSetCollection()
    for i, (name, data) in enumerate(blocks.items()):
        part = vtkPartitionedDataSet()
        part.SetPartition(0, data)
        made.SetPartitionedDataSet(i, part)
        made.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), name)
    return made


def write(name, data):
    """The writer's error code, and what it said."""
    proxy = simple.servermanager.writers.NamedSTLWriter()
    algorithm = proxy.GetClientSideObject()
    heard = ct.silent(algorithm)
    algorithm.SetInputDataObject(0, data)
    proxy.FileName = place(name)
    proxy.UpdateVTKObjects()
    algorithm.Write()
    return algorithm.GetErrorCode(), "".join(heard["ErrorEvent"]), "".join(heard["WarningEvent"])


# As in the window: a structure set, its surfaces, Save Data as .stl.
square = [(0, 0), (20, 0), (20, 20), (0, 20)]
contours = [("CLOSED_PLANAR", [c for x, y in square for c in (x, y, z)]) for z in (0, 5, 10)]
with open(place("set.dcm"), "wb") as file:
    file.write(rt.structure_set([(1, "Lt Lung", "ORGAN", None, contours), (2, "Heart", "ORGAN", None, contours), (3, "Iso", "", None, [])]))
surfaces = simple.PolyhedralSurface(Input=simple.DICOMRTStructureSetReader(FileName=place("set.dcm")))
simple.SaveData(place("organs.stl"), surfaces)
found = sorted(name for name in os.listdir(FOLDER) if name.endswith(".stl"))
ct.check(found == ["organs-Heart.stl", "organs-Lt_Lung.stl"], f"each region has a file by its name: {found}")
blocks = [ct.data(surfaces).GetPartition(i, 0).GetNumberOfPolys() for i in (0, 1)]
ct.check([triangles(place(name)) for name in reversed(found)] == blocks, "all their triangles, and no lines, are there")
back = simple.SurfaceCertificate(Input=simple.STLReader(FileNames=[place("organs-Heart.stl")]), Weld=1)
back.UpdatePipeline()
ct.check(back.FieldData["Closed"].GetRange()[0] == 1, "read and welded again, the surface is closed")

# A single surface is ParaView's own writer's business.
single = simple.CreateWriter(place("one.stl"), simple.Sphere())
ct.check(single.GetXMLName() != "NamedSTLWriter", f"one surface is written by {single.GetXMLName()}")

unit = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
far = tuple(tuple(c + 1e9 for c in corner) for corner in unit)
code, errors, warnings = write("far.stl", collection(near=tetrahedron(unit), far=tetrahedron(far)))
ct.check(code == 0 and not errors and "\"far\": 4 triangles have no area in single precision" in warnings,
         f"what single precision takes is said: {code} {errors} {warnings}")
ct.check(triangles(place("far-near.stl")) == 4 and triangles(place("far-far.stl")) == 4, "both files are there")
huge = tuple(tuple(c * 1e40 for c in corner) for corner in unit)
code, errors, _ = write("huge.stl", collection(near=tetrahedron(unit), huge=tetrahedron(huge)))
ct.check(code != 0 and "\"huge\": Point 1 has a coordinate that single precision, and so STL, cannot hold." in errors
         and os.path.exists(place("huge-near.stl")) and not os.path.exists(place("huge-huge.stl")),
         f"a region that cannot be written costs that one: {errors}")
code, errors, _ = write("none.stl", collection(empty=vtkPolyData()))
ct.check(code != 0 and "No block of the collection has a surface to write." in errors, f"nothing to write is said: {errors}")
code, errors, _ = write("nowhere/organs.stl", collection(a=tetrahedron(unit)))
ct.check(code != 0 and "nowhere" in errors, f"a folder that is not there is said: {errors}")
ct.check(not [name for name in os.listdir(FOLDER) if ".part" in name], "no half file is left")
ct.finish()
