# SPDX-License-Identifier: GPL-3.0-or-later
"""What TestRanks.py lets every rank do: pipelines over regions, and what of their outputs this rank has, as JSON.

    mpiexec -n N pvbatch --sym ranksjob.py STRUCTURE_SET TUBE OTHER_TUBE FOLDER
"""
import hashlib
import json
import os
import sys

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkParallelCore import vtkMultiProcessController

# Wall time, which is another in every run.
TIMES = ("StageSeconds",)


def array_bytes(array):
    if array.IsA("vtkStringArray"):
        return "\n".join(array.GetValue(i) for i in range(array.GetNumberOfValues())).encode()
    return vtk_to_numpy(array).tobytes()


def fingerprint(data):
    """Of points, cells and all arrays of poly data, an unstructured grid or a table."""
    total = hashlib.sha256()
    if data.IsA("vtkTable"):
        arrays = [data.GetRowData()]
    else:
        total.update(array_bytes(data.GetPoints().GetData()))
        if data.IsA("vtkPolyData"):
            kinds = (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips())
        else:
            kinds = (data.GetCells(),)
        for cells in kinds:
            total.update(array_bytes(cells.GetConnectivityArray()) + array_bytes(cells.GetOffsetsArray()))
        arrays = [data.GetPointData(), data.GetCellData()]
    arrays.append(data.GetFieldData())
    for attributes in arrays:
        # Their order is another where a block has come from another rank.
        named = {attributes.GetAbstractArray(i).GetName(): attributes.GetAbstractArray(i) for i in range(attributes.GetNumberOfArrays())}
        for name in sorted(set(named) - set(TIMES)):
            total.update(name.encode() + array_bytes(named[name]))
    return total.hexdigest()


def size(data):
    return data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfCells()


def seen(data):
    """Blocks as (name, cells, fingerprint or None where there is nothing)."""
    if not data.IsA("vtkPartitionedDataSetCollection"):
        return [["", size(data), fingerprint(data) if size(data) else None]]
    found = []
    for i in range(data.GetNumberOfPartitionedDataSets()):
        name = data.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
        for p in range(data.GetNumberOfPartitions(i)):
            block = data.GetPartitionAsDataObject(i, p)
            cells = size(block) if block else 0
            found.append([name, cells, fingerprint(block) if cells else None])
    return found


def outputs(node, ports=1):
    node.UpdatePipeline()
    return [seen(node.GetClientSideObject().GetOutputDataObject(port)) for port in range(ports)]


def nodes(reader, planes):
    """Every stage over a source, by name."""
    mapping = simple.ContourMapping(Input=reader)
    constraints = simple.ImplicitConstraints(Input=reader)
    function = simple.ImplicitFunction(Input=constraints)
    surface = simple.PolyhedralSurface(Input=reader)
    return {"reader": (reader, 1), "hierarchy": (simple.ContourHierarchy(Input=reader), 1), "mapping": (mapping, 2),
            "triangulation": (simple.ContourTriangulation(Input=reader), 2),
            "diagram": (simple.JointVoronoiDiagram(Input=reader), 2), "surface": (surface, 1),
            "overridden": (simple.PolyhedralSurface(Input=reader, Overrides=planes["joins"]), 1),
            "fair": (simple.FairSurface(Input=reader), 1), "constraints": (constraints, 1),
            "function": (function, 1), "implicit": (simple.ImplicitSurface(Input=reader), 1),
            "contours": (simple.ImplicitContours(Input=function, Planes=planes["planes"]), 1),
            "certificate": (simple.SurfaceCertificate(Input=surface, Contours=reader), 3)}


def main(path, tube, other_tube, folder):
    simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
    controller = vtkMultiProcessController.GetGlobalController()
    rank = controller.GetLocalProcessId()
    one = simple.NUAGESContourReader(FileName=tube)
    # Contours that only the first rank reads are planes, and their joins overrides, for the regions of all.
    beside = {"planes": one, "joins": simple.OutputPort(simple.ContourMapping(Input=one), 1)}
    found = {}
    regions = simple.DICOMRTStructureSetReader(FileName=path)
    for name, (node, ports) in nodes(regions, beside).items():
        found["regions: " + name] = outputs(node, ports)
    judged = simple.SurfaceCertificate(Input=simple.PolyhedralSurface(Input=one), Contours=one)
    found["one: certificate"] = outputs(judged, 3)
    found["one: split"] = outputs(simple.ContourRegions(Input=simple.ContourHierarchy(Input=one), SplitBy="Level"))
    found["regions: of blocks"] = outputs(simple.ContourRegions(Input=regions))
    # Other regions, and another file: no rank waits for another.
    regions.ROIs = ["big", "small"]
    found["regions: chosen"] = outputs(simple.PolyhedralSurface(Input=regions))
    one.FileName = other_tube
    found["one: another file"] = outputs(judged, 3)
    with open(os.path.join(folder, f"rank{rank}.json"), "w", encoding="utf-8") as file:
        json.dump(found, file)


main(*sys.argv[1:])
