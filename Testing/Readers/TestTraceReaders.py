# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of tracing and drawing programs through ParaView: blocks, choice, colours, surfaces, and one sentence for damage."""
import json
import os
import struct
import zipfile

import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
FOLDER = ct.output("traces")
os.makedirs(FOLDER, exist_ok=True)


def write(name, content):
    path = os.path.join(FOLDER, name)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    return path


def square(size, z=None):
    corners = [(0, 0), (size, 0), (size, size), (0, size)]
    return corners if z is None else [(x, y, z) for x, y in corners]


def imod():
    """Two objects on five sections, pixels of 2 nm, sections 5 pixels apart."""
    def contour(points):
        return b"CONT" + struct.pack(">4i", len(points), 0, 0, 0) + b"".join(struct.pack(">3f", *p) for p in points)

    def thing(name, contours):
        return (b"OBJT" + struct.pack(">64s16x48x2i2i3fi8B2i", name, len(contours), 0, 0, 0, 1, 0.5, 0, 0, *[0] * 8, 0, 0) +
                b"".join(contours))
    header = b"IMODV1.2" + struct.pack(">128s4i5i3f3f5ifii3f", b"model", 9, 9, 9, 2, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 5,
                                       0, 0, 0, 0, 0, 2, -9, 0, 0, 0, 0)
    return (header + thing(b"box", [contour(square(4, z)) for z in range(5)]) +
            thing(b"core", [contour(square(2, z)) for z in range(1, 4)]) + b"IEOF")


def roi(size, position):
    """A polygon of ImageJ."""
    points = square(size)
    return (struct.pack(">4shbb4hH16xh4xIIhhhhii", b"Iout", 228, 0, 0, 0, 0, size, size, 4, 0, 0, 0, 0, 0, 0, 0, position, 0) +
            struct.pack(">8h", *[p[0] for p in points], *[p[1] for p in points]))


def drawing(size):
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="10mm" viewBox="0 0 10 10"><rect width="{size}" height="{size}"/></svg>'


def section(index):
    points = ", ".join(f"{x} {y}" for x, y in square(3))
    return (f'<Section index="{index}" thickness="2"><Transform dim="0" xcoef="0 1 0 0 0 0" ycoef="0 0 1 0 0 0">'
            f'<Contour name="box" closed="true" border="1 0 0" points="{points}"/></Transform></Section>')


for number in range(1, 5):
    write(f"series.{number}", section(number))
with zipfile.ZipFile(os.path.join(FOLDER, "set.zip"), "w", zipfile.ZIP_DEFLATED) as archive:
    for number in range(1, 5):
        archive.writestr(f"{number}.roi", roi(3, number))
table = "object,slice,x,y\n" + "".join(f"{name},{z},{x},{y}\n" for name in ("box", "core") for z in range(4)
                                        for x, y in square(3 if name == "box" else 1))
TRACE = [[p[0] for p in square(3)], [p[1] for p in square(3)], [255, 0, 0], True, False, False, [], []]
JSER = {"series": {"alignment": "default"},
        "sections": {str(n): {"thickness": 2, "tforms": {"default": [1, 0, 0, 0, 1, 0]}, "contours": {"box": [TRACE]}}
                     for n in range(4)}}
FILES = {  # name: (reader, blocks, volume of the first block's surface with flat ends, unit)
    write("model.mod", imod()): (simple.IMODModelReader, ["box", "core"], 8 * 8 * 40, "nm"),
    write("series.ser", '<Series units="microns"/>'): (simple.ReconstructSeriesReader, ["box"], 3 * 3 * 6, "um"),
    write("series.jser", json.dumps(JSER)): (simple.ReconstructSeriesReader, ["box"], 3 * 3 * 6, "um"),
    os.path.join(FOLDER, "set.zip"): (simple.ImageJROIReader, ["set"], 3 * 3 * 6, ""),
    write("table.csv", table): (simple.ContourTableReader, ["box", "core"], 3 * 3 * 6, ""),
}


def volume(source):
    surface = simple.PolyhedralSurface(Input=source, EndCaps="Flat")
    certificate = simple.SurfaceCertificate(Input=surface)
    return ct.data(certificate)


def check(reader, names, size, unit, where):
    blocks = rt.blocks(ct.data(reader))
    ct.check([name for name, _ in blocks] == names, f"{where} has the blocks {[name for name, _ in blocks]}")
    first = blocks[0][1]
    ct.check(rt.loops_are_closed(first) and rt.strings(first, "ROIName") == [names[0]], f"{where}: {first}")
    ct.check("".join(rt.strings(first, "LengthUnit")) == unit, f"{where} is in {rt.strings(first, 'LengthUnit')}")
    ct.check(rt.strings(first, "GeometricType") == [] and
             first.GetCellData().GetAbstractArray("GeometricType").GetValue(0) == "CLOSED_PLANAR", f"{where} tells types")
    result = rt.blocks(volume(reader))[0][1]
    found = result.GetFieldData().GetArray("Volume").GetValue(0)
    ct.check(abs(found - size) < 1e-6 * size, f"{where} has the volume {found} instead of {size}")


def all_points(reader):
    """By object its contours, each as its points from the smallest one on."""
    found = {}
    for name, data in rt.blocks(ct.data(reader)):
        loops = []
        for i in range(data.GetNumberOfCells()):
            points = [data.GetCell(i).GetPoints().GetPoint(k) for k in range(data.GetCell(i).GetNumberOfPoints() - 1)]
            first = points.index(min(points))
            loops.append(points[first:] + points[:first])
        found[name] = loops
    return found


def check_round_trip(reader, unit, where):
    """What Contour Table Writer writes Contour Table Reader reads, to the last bit."""
    copy = os.path.join(FOLDER, "copy.csv")
    writer = simple.ContourTableWriter(Input=reader, FileName=copy)
    ct.check("ERR" not in ct.errors_of(writer.UpdatePipeline), f"{where} is written as a table")
    again = simple.ContourTableReader(FileName=copy)
    ct.check(all_points(again) == all_points(reader), f"{where} comes back from a table")
    ct.check("".join(rt.strings(rt.blocks(ct.data(again))[0][1], "LengthUnit")) == unit, f"{where} keeps its unit")


for path, (reader, names, size, unit) in FILES.items():
    node = reader(FileName=path)
    if reader in (simple.ImageJROIReader, simple.ContourTableReader):
        node.SliceSpacing = 2.0
    check(node, names, size, unit, os.path.basename(path))
    check_round_trip(node, unit, os.path.basename(path))
    opened = simple.OpenDataFile(path)
    ct.check(opened is not None and opened.GetXMLName() == node.GetXMLName() or path.endswith(".csv"),
             f"{path} is opened by {opened.GetXMLName() if opened else None}")
    # Damage: the last third is missing.
    with open(path, "rb") as file:
        whole = file.read()
    if not path.endswith((".ser", ".csv")):
        cut = write("cut" + os.path.splitext(path)[1], whole[:2 * len(whole) // 3])
        rt.expect_error(reader(FileName=cut), "Cannot read", f"{os.path.basename(path)} cut short")

# What is no structure set and not in millimetres has no cm3.
model = simple.IMODModelReader(FileName=os.path.join(FOLDER, "model.mod"))
certificate = simple.SurfaceCertificate(Input=simple.PolyhedralSurface(Input=model, EndCaps="Flat"))
certificate.UpdatePipeline()
certificate.UpdatePropertyInformation()
told = certificate.GetProperty("Verdict").GetElement(0)
ct.check(told.startswith("box: sound, volume 2560"), f"a model in nm has the volume {told}")

drawings = simple.SVGContourReader(FileNames=[write(f"slice{n}.svg", drawing(3)) for n in range(4)], SliceSpacing=2.0)
check(drawings, ["slice0"], 3 * 3 * 6, "mm", "four drawings")
rt.expect_error(simple.SVGContourReader(FileNames=[write("none.svg", "<svg")]), "no well-formed XML", "a damaged drawing")
rt.expect_error(simple.ContourTableReader(FileName=write("bad.csv", "x,y,z\n1,2,a\n")), "line 2: expected a number for z",
                "a damaged table")

# One object of a file, and its colour.
chosen = simple.IMODModelReader(FileName=os.path.join(FOLDER, "model.mod"))
chosen.UpdatePipelineInformation()
known = list(chosen.GetProperty("ObjectsInfo").GetData())[0::2]
ct.check(known == ["box", "core"], f"the objects are {known}")
chosen.Objects = ["core"]
blocks = rt.blocks(ct.data(chosen))
ct.check([name for name, _ in blocks] == ["core"], "one object can be chosen")
color = blocks[0][1].GetFieldData().GetArray("ROIColor")
ct.check([color.GetComponent(0, c) for c in range(3)] == [255, 128, 0], "the colour is the file's")
ct.check(ct.data(simple.ContourTableReader(FileName=os.path.join(FOLDER, "table.csv"))).GetNumberOfPartitionedDataSets() == 2,
         "objects of a table are blocks")

# What regions are: by an array, by blocks, by slices.
loops = ct.closed_polylines([square(3, z) for z in (0, 1, 2)] + [square(1, z) for z in (0, 1)])
from vtkmodules.vtkCommonCore import vtkIntArray
label = vtkIntArray()
label.SetName("Label")
for value in (7, 7, 7, 9, 9):
    label.InsertNextValue(value)
loops.GetCellData().AddArray(label)
source = simple.PVTrivialProducer()
source.GetClientSideObject().SetOutput(loops)
split = simple.ContourRegions(Input=source, SplitBy="Label")
blocks = rt.blocks(ct.data(split))
ct.check([(name, data.GetNumberOfCells(), data.GetNumberOfPoints()) for name, data in blocks] == [("7", 3, 12), ("9", 2, 8)],
         f"an array makes regions: {[(name, data.GetNumberOfCells()) for name, data in blocks]}")
ct.check(rt.strings(ct.data(split), "Report") == ["Split by Label into 2 regions."], "Report says so")
ct.check(len(rt.blocks(ct.data(simple.PolyhedralSurface(Input=split)))) == 2, "each becomes a surface")
node = simple.ContourRegions(Input=source, SplitBy="Colour")
ct.check("There is no cell array Colour to split the contours by; there are: Label." in ct.errors_of(node.UpdatePipeline),
         "an array that is not there is named")
ct.check(len(rt.blocks(ct.data(simple.ContourRegions(Input=split, Blocks="Regions")))) == 2, "regions stay")
joined = ct.data(simple.ContourRegions(Input=split, Blocks="Slices"))
ct.check(joined.GetNumberOfPartitionedDataSets() == 1 and joined.GetPartition(0, 0).GetNumberOfCells() == 5,
         "blocks are slices where that is asked for")
ct.finish()
