# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface Certificate on surfaces with known answers: field data, table, cell arrays, collections, errors."""
import json
import math

import contourtesting as ct
from certificateshapes import SIDES, box_corners, box_triangles, boxes, square_contour, surface

simple = ct.load_plugin()
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkIntArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkPartitionedDataSetCollection, vtkPolyData)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkStripper
from vtkmodules.vtkFiltersSources import vtkSphereSource


def source(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def certify(data, contours=None, **properties):
    """(surface, table of components, the proxy)"""
    inputs = {"Input": source(data)}
    if contours is not None:
        inputs["Contours"] = source(contours)
    proxy = simple.SurfaceCertificate(**inputs, **properties)
    return ct.data(proxy, 0), ct.data(proxy, 2), proxy


def figure(data, name):
    array = data.GetFieldData().GetArray(name)
    return array.GetTuple1(0) if array else None


def lines(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def cells(data, name):
    array = data.GetCellData().GetArray(name)
    return [int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())]


def cell(table, row, column):
    return table.GetValueByName(row, column).ToString()


CUBE = box_corners((0, 0, 0), (1, 1, 1))

# Contours on some levels tell a volume, a least and a most of their own; on one they do not.
slices = vtkAppendPolyData()
for height in (0.125, 0.375, 0.625, 0.875):
    slices.AddInputData(square_contour(height))
slices.Update()
out, table, proxy = certify(surface(CUBE, box_triangles()), slices.GetOutput())
ct.check([figure(out, name) for name in ("VolumeByContours", "LowestVolume", "HighestVolume")] == [1, 0.75, 1.25],
         "unit squares a quarter apart are of a cube, if it ends half way to the next ones")
ct.check([out.GetFieldData().GetArray("DoubtOffset").GetTuple1(i) for i in (0, 1)] == [0, 1] and
         out.GetFieldData().GetArray("DoubtWidth").GetTuple1(0) == 0.25, "the ends are what is open")
ct.check(json.loads(lines(out, "CertificateJSON")[0])["Doubts"][0] == {"Offset": 0, "Width": 0.25}, "also in JSON")
ct.check("Volume by the contours: 1 (0.75 to 1.25); another slice would tell most at 0 (50%) along the stack." in
         lines(out, "Certificate"), "and in words")
reading = ct.data(proxy, 1)
ct.check([reading.GetValue(row, 1).ToString() for row in range(reading.GetNumberOfRows())
          if reading.GetValue(row, 0).ToString() == "Volume by the contours"] == ["1 (0.75 to 1.25)"], "and in the table")

# A cube of triangles, with the contour it has at half its height.
out, table, proxy = certify(surface(CUBE, box_triangles()), square_contour(0.5))
for name, value in {"Sound": 1, "Closed": 1, "EdgeManifold": 1, "VertexManifold": 1, "Oriented": 1, "Outward": 1,
                    "Components": 1, "Points": 8, "Edges": 18, "Triangles": 12, "Euler": 2, "Genus": 0,
                    "OpenEdges": 0, "CrossingPairs": 0, "Volume": 1, "Area": 6, "CentroidX": 0.5, "HighZ": 1,
                    "SmallestAngle": 45, "FarthestContourVertex": 0, "WorstSectionPercent": 0,
                    "SectionOffset": 0.5, "SectionContourArea": 1, "SectionDifference": 0}.items():
    got = figure(out, name)
    ct.check(got is not None and abs(got - value) < 1e-12, f"{name} of the cube is {value}, not {got}")
ct.check(cells(out, "Defect") == [0] * 12 and cells(out, "ComponentId") == [0] * 12, "no defect anywhere")
ct.check(math.isnan(figure(out, "VolumeByContours")), "one level tells no volume")
ct.check(lines(out, "Certificate")[0].startswith("Sound:"), "the first line is the verdict")
document = json.loads(lines(out, "CertificateJSON")[0])
ct.check(document["Total"]["Volume"] == 1 and document["Sections"][0]["Percent"] == 0, "the JSON holds it too")
ct.check(table.GetNumberOfRows() == 2 and cell(table, 0, "Component") == "0" and
         cell(table, 1, "Component") == "Total", "a row a component and a total row")
ct.check(table.GetColumnByName("Block") is None, "no blocks, no column")
ct.check(math.isnan(table.GetValueByName(0, "WorstSectionPercent").ToDouble()) and
         table.GetValueByName(1, "WorstSectionPercent").ToDouble() == 0, "contours belong to the total row")


def read(proxy, column):
    """The table that people read, a column as (figure, text) in order."""
    lines = ct.data(proxy, 1)
    return [(cell(lines, r, "(figure)"), cell(lines, r, column)) for r in range(lines.GetNumberOfRows())]


ct.check(read(proxy, "Surface")[:3] == [("Verdict", "sound"), ("Found", "nothing wrong"), ("Volume", "1")],
         f"a row a figure, the verdict first: {read(proxy, 'Surface')}")
ct.check(("Worst section, %", "0") in read(proxy, "Surface"), "and how the contours fare")
proxy.SMProxy.UpdatePropertyInformation()
ct.check(proxy.GetProperty("Verdict").GetElement(0) == "sound, volume 1", f"the panel: {proxy.GetProperty('Verdict')}")
ct.check(out.GetCellData().GetScalars() is None, "nothing wrong, nothing to colour by")

# Without the contours there is nothing to say about them.
out, table, _ = certify(surface(CUBE, box_triangles()))
ct.check(figure(out, "WorstSectionPercent") is None and table.GetColumnByName("WorstSectionPercent") is None,
         "no contours, no figures of them")

# Polygons and strips are triangulated, loose lines left out; cell data comes along.
out, _, _ = certify(surface(CUBE, SIDES))
ct.check(out.GetNumberOfCells() == 12 and figure(out, "Sound") == 1 and len(cells(out, "Defect")) == 12,
         "six squares are twelve triangles")
stripper = vtkStripper()
sphere = vtkSphereSource()
stripper.SetInputConnection(sphere.GetOutputPort())
stripper.Update()
ct.check(stripper.GetOutput().GetNumberOfStrips() > 0, "the input has strips")
out, _, _ = certify(stripper.GetOutput())
ct.check(out.GetNumberOfStrips() == 0 and figure(out, "Sound") == 1, "strips of a sphere")

# One triangle gone: empty, not wrong.
out, table, proxy = certify(surface(CUBE, box_triangles()[:-1]), square_contour(0.5))
ct.check(out.GetCellData().GetScalars().GetName() == "Defect", "a view colours by what is wrong")
ct.check(dict(read(proxy, "Surface"))["Volume"] == "-", "no volume, and no number that looks like one")
ct.check(figure(out, "Closed") == 0 and figure(out, "OpenEdges") == 3 and figure(out, "Sound") == 0, "a hole")
ct.check(math.isnan(figure(out, "Volume")) and figure(out, "Genus") == -1, "no volume, no genus")
ct.check(sum(d & 1 for d in cells(out, "Defect")) == 3, "three triangles at the hole")
ct.check("3 open edges" in lines(out, "Certificate")[1], "and the second line names it")

# Two boxes that cross, one apart: where, by component and by Threshold.
broken = surface(*boxes(((0, 0, 0), (2, 2, 2)), ((1, 0.5, 0.25), (3, 1.5, 1.125)), ((5, 5, 5), (6, 6, 6))))
out, table, proxy = certify(broken)
ct.check(figure(out, "CrossingPairs") > 0 and figure(out, "Components") == 3, "boxes that cross")
ct.check(cell(table, 2, "CrossingPairs") == "0" and cell(table, 0, "CrossingPairs") == cell(table, 3, "CrossingPairs"),
         "counted for the components that take part")
bad = simple.Threshold(Input=simple.OutputPort(proxy, 0), Scalars=["CELLS", "Defect"], LowerThreshold=1,
                       UpperThreshold=511)
found = ct.data(bad)
ct.check(0 < found.GetNumberOfCells() < 36 and set(cells(found, "ComponentId")) == {0, 1},
         "Threshold shows the triangles that cross, and none of the third box")

# A surface without connectivity, as STL has it.
soup = surface([CUBE[i] for t in box_triangles() for i in t], [(3 * t, 3 * t + 1, 3 * t + 2) for t in range(12)])
out, _, _ = certify(soup)
ct.check(figure(out, "Components") == 12, "twelve loose triangles")
out, _, _ = certify(soup, Weld=1)
ct.check(figure(out, "Components") == 1 and figure(out, "Sound") == 1, "welded: a cube")

# Single precision: the contour's plane is a hair off the float's value.
low = surface(box_corners((0, 0, 0), (1, 1, 0.1)), box_triangles(), VTK_FLOAT)
out, _, _ = certify(low, square_contour(0.1))
ct.check(figure(out, "WorstSectionPercent") == 0, "faces in a plane survive single precision")

# A contour that is not on the surface.
out, _, _ = certify(surface(CUBE, box_triangles()), square_contour(0.5, x=0.25))
ct.check(abs(figure(out, "WorstSectionPercent") - 50) < 1e-12 and
         abs(figure(out, "FarthestContourVertex") - 0.25) < 1e-12, "a contour a quarter aside")


def collection(blocks):
    whole = vtkPartitionedDataSetCollection()
    for i, (name, data) in enumerate(blocks):
        whole.SetPartition(i, 0, data)
        if name:
            whole.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), name)
    return whole


# Collections: surfaces find the contours of their name.
good, holed = surface(CUBE, box_triangles()), surface(CUBE, box_triangles()[:-1])
out, table, _ = certify(collection([("Heart", good), ("Nothing", vtkPolyData()), ("Lung", holed)]),
                        collection([("Lung", square_contour(0.25)), ("Heart", square_contour(0.5, x=0.5))]))
ct.check(out.IsA("vtkPartitionedDataSetCollection"), "a collection stays one")
heart = out.GetPartition(0, 0)
ct.check(abs(figure(heart, "WorstSectionPercent") - 100) < 1e-12, "Heart is compared with Heart's contours")
ct.check(figure(out.GetPartition(2, 0), "OpenEdges") == 3, "Lung has its hole")
ct.check(out.GetMetaData(2).Get(vtkCompositeDataSet.NAME()) == "Lung", "names stay")
ct.check([cell(table, r, "Block") + " " + cell(table, r, "Component") for r in range(table.GetNumberOfRows())] ==
         ["Heart 0", "Heart Total", "Nothing Total", "Lung 0", "Lung Total"], "a table of all blocks")
ct.check(lines(out.GetPartition(1, 0), "Certificate") == ["There is no surface."], "an empty block says so")
# Regions of a structure set are in millimetres.
regions = []
for name, number in (("Heart", 3), ("Lung", 4)):
    region = surface(box_corners((0, 0, 0), (10, 10, 20)), box_triangles())
    array = vtkIntArray()
    array.SetName("ROINumber")
    array.InsertNextValue(number)
    region.GetFieldData().AddArray(array)
    regions.append((name, region))
_, _, proxy = certify(collection(regions))
ct.check(dict(read(proxy, "Lung"))["Volume, cm3"] == "2", f"a column a region: {read(proxy, 'Lung')}")
proxy.SMProxy.UpdatePropertyInformation()
ct.check(proxy.GetProperty("Verdict").GetElement(0) == "Heart: sound, 2 cm3\nLung: sound, 2 cm3", "and in the panel")
_, _, proxy = certify(collection(regions + [("Heart", good)]))
ct.check(dict(read(proxy, "Heart (2)"))["Volume"] == "1", "one of another unit takes the unit from all, and its name stays")
out, _, _ = certify(collection([("", good), ("", good)]),
                    collection([("", square_contour(0.5)), ("", square_contour(0.5, x=0.25))]))
ct.check([figure(out.GetPartition(i, 0), "WorstSectionPercent") for i in (0, 1)] == [0, 50],
         "without names the position decides")

# What cannot be: one sentence, no output.
nan = float("nan")
hopeless = [
    ("Point 3 of the surface", surface(CUBE[:3] + [(nan, 0, 0)] + CUBE[4:], box_triangles()), None),
    ("No usable contour", surface(CUBE, box_triangles()), surface(CUBE[:2], [(0, 1)])),
    ("has the name of a surface", collection([("Heart", good)]),
     collection([("Lung", square_contour(0.5)), ("Liver", square_contour(0.5))])),
]
for sentence, data, contours in hopeless:
    results = []
    said = ct.errors_of(lambda: results.append(certify(data, contours)))
    ct.check(sentence in said, f"'{sentence}' is said: {said}")
    ct.check(results and results[0][1].GetNumberOfRows() == 0, f"no table with '{sentence}'")
out, table, _ = certify(vtkPolyData())
ct.check(figure(out, "Sound") == 0 and table.GetNumberOfRows() == 1, "an empty surface is certified as such")

# Progress rises to 1, and abort leaves nothing behind.
proxy = simple.SurfaceCertificate(Input=simple.Sphere(ThetaResolution=200, PhiResolution=200))
algorithm = proxy.GetClientSideObject()
seen = []
tag = algorithm.AddObserver("ProgressEvent", lambda o, _: seen.append(o.GetProgress()))
out = ct.data(proxy)
ct.check(figure(out, "Sound") == 1 and len(seen) > 2 and seen == sorted(seen) and seen[-1] == 1, f"progress: {seen}")
algorithm.RemoveObserver(tag)
algorithm.AddObserver("ProgressEvent", lambda o, _: o.SetAbortExecute(1) if o.GetProgress() < 1 else None)
algorithm.Modified()
algorithm.Update()
ct.check(algorithm.GetOutputDataObject(0).GetNumberOfElements(0) == 0 and
         algorithm.GetOutputDataObject(1).GetNumberOfRows() == algorithm.GetOutputDataObject(2).GetNumberOfRows() == 0,
         "aborted: no output")
ct.finish()
