# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours as they are, from one format into another."""
import os

from contourstart import simple

from contourcommon import CommandError, as_source, new_node, run_proxy, uninterrupted
from contouroutput import output_paths

WRITERS = {".cnt": "NUAGESContourWriter", ".csv": "ContourTableWriter"}
ONE_FILE = (".csv",)  # for all regions, by their names


def collection_of(blocks):
    """Blocks of contours as one data object that has their names."""
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPartitionedDataSetCollection
    collection = vtkPartitionedDataSetCollection()
    for i, block in enumerate(blocks):
        collection.SetPartition(i, 0, block.data)
        collection.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), block.name)
    return collection


def _write(path, extension, data):
    source = as_source(data)
    writer = new_node(WRITERS[extension], Input=source, FileName=path)
    try:
        with uninterrupted():
            run_proxy(writer)
    finally:
        simple.Delete(writer)
        simple.Delete(source)


def closed_count(data):
    """Lines and polygons: points are no contours."""
    return data.GetNumberOfCells() - data.GetNumberOfVerts()


def write_contours(path, blocks):
    """(block, path, contours, what went wrong) a block; the nodes that write leave a whole file or none."""
    extension = os.path.splitext(path)[1].lower()
    if extension in ONE_FILE:
        _write(path, extension, collection_of(blocks))
        return [(block, path, closed_count(block.data), None) for block in blocks]
    rows = []
    for block, name in zip(blocks, output_paths(path, blocks)):
        try:
            _write(name, extension, block.data)
            rows.append((block, name, closed_count(block.data), None))
        except CommandError as error:
            rows.append((block, name, 0, error))
    return rows
