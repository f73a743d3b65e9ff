# SPDX-License-Identifier: GPL-3.0-or-later
"""What the readers' pvpython tests share: small files of every format, arrays, and errors as a list.

Errors that a test provokes must not be printed, as a printed one fails the test: Errors listens to an
algorithm and its executive, which takes them off the terminal.
"""
import struct

import contourtesting as ct

NUAGES = "S 2\nv 7 z 0.25\n{\n0 0\n4 0\n4 4\n0 4\n}\n{\n1 1\n1 2\n2 1\n}\nv 3 z -15\n{\n1 0.5\n2 1\n3 7\n}\n"
CSL = "CSLC\n1 2\n\n1 4 1 0 0 1 -2\n\n0 0 2\n4 0 2\n4 4 2\n0 4 2\n\n4 1 0 1 2 3\n"
CONTOUR = ("1\n0 0 2 6\n6 7\n0 0 3\n1 0 3\n2 0 3\n2 1 3\n1 1 3\n0 1 3\n"
           "0 1 1 0\n1 2 2 0\n2 3 2 0\n3 4 2 0\n4 5 1 0\n5 0 1 0\n1 4 1 2\n")
RT_STRUCTURE_SET = "1.2.840.10008.5.1.4.1.1.481.3"
CT_IMAGE = "1.2.840.10008.5.1.4.1.1.2"


def write(name, content):
    """Write text or bytes to a file of the output folder and return its path."""
    path = ct.output(name)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    return path


def element(group, number, value):
    """An element of implicit VR little endian: value is text, or a list of items (bytes)."""
    if isinstance(value, list):
        data = b"".join(struct.pack("<HHL", 0xFFFE, 0xE000, len(item)) + item for item in value)
    else:
        data = value.encode("latin-1")
        data += b" " * (len(data) % 2)
    return struct.pack("<HHL", group, number, len(data)) + data


def structure_set(rois, sop_class=RT_STRUCTURE_SET):
    """A data set without preamble. rois: (number, name, type, colour or None, [(geometric type, [x, y, z, ...])]).

    A third entry of a contour is the instance UID of the CT image that it lies on.
    """
    listed, contours, observations = [], [], []
    for number, name, roi_type, color, items in rois:
        listed.append(element(0x3006, 0x22, str(number)) + element(0x3006, 0x26, name))
        roi = element(0x3006, 0x2A, color) if color else b""
        if items:
            roi += element(0x3006, 0x40, [
                b"".join(element(0x3006, 0x16, [element(0x0008, 0x1150, CT_IMAGE) + element(0x0008, 0x1155, uid)])
                         for uid in image) +
                element(0x3006, 0x42, kind) + element(0x3006, 0x46, str(len(data) // 3)) +
                element(0x3006, 0x50, "\\".join(map(repr, data))) for kind, data, *image in items])
        contours.append(roi + element(0x3006, 0x84, str(number)))
        observations.append(element(0x3006, 0x84, str(number)) + element(0x3006, 0xA4, roi_type))
    return (element(0x0008, 0x16, sop_class) + element(0x0008, 0x18, "1.2.3") +
            element(0x0008, 0x60, "RTSTRUCT") + element(0x3006, 0x20, listed) +
            element(0x3006, 0x39, contours) + element(0x3006, 0x80, observations))


class Errors:
    """The errors of an algorithm and its executive, kept off the terminal; those of the algorithm in `own`."""

    def __init__(self, proxy):
        self.algorithm = proxy.GetClientSideObject()
        self.own = []

        def keep(_, __, sentence):
            self.own.append(sentence)
        keep.CallDataType = "string0"
        self.algorithm.AddObserver("ErrorEvent", keep)
        self.algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)


def expect_error(proxy, part, what):
    """Update: one sentence of the algorithm with part in it, and an empty output."""
    errors = Errors(proxy)
    proxy.UpdatePipeline()
    output = proxy.GetClientSideObject().GetOutputDataObject(0)
    ct.check(len(errors.own) == 1, f"{what}: {len(errors.own)} errors instead of one: {errors.own}")
    ct.check(all(part in sentence for sentence in errors.own), f"{what}: '{part}' is not in {errors.own}")
    count = output.GetNumberOfPartitionedDataSets() if output.IsA("vtkPartitionedDataSetCollection") \
        else output.GetNumberOfCells() + output.GetNumberOfPoints()
    ct.check(count == 0, f"{what}: the output is not empty")
    ct.check(proxy.GetClientSideObject().GetErrorCode() != 0, f"{what}: no error code")


def strings(data, name):
    """The strings of a field data array; none where there is no such array."""
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def blocks(collection):
    """Name and data set of every block."""
    return [(collection.GetMetaData(i).Get(collection.NAME()), collection.GetPartition(i, 0))
            for i in range(collection.GetNumberOfPartitionedDataSets())]


def loops_are_closed(poly):
    """Whether every line's last point id is its first."""
    lines = poly.GetLines()
    from vtkmodules.vtkCommonCore import vtkIdList
    ids = vtkIdList()
    return all((lines.GetCellAtId(i, ids), ids.GetId(0) == ids.GetId(ids.GetNumberOfIds() - 1))[1]
               for i in range(lines.GetNumberOfCells()))
