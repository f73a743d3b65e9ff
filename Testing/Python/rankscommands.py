# SPDX-License-Identifier: GPL-3.0-or-later
"""What TestRanks.py lets a script do on an MPI server, whose first rank it is: save, report, gather slices.

    mpiexec -n N pvbatch rankscommands.py STRUCTURE_SET TUBE FOLDER
"""
import json
import os
import sys

from paraview import simple


def table(node, port):
    """Columns of a table as text, as the first rank has it."""
    data = node.GetClientSideObject().GetOutputDataObject(port)
    columns = [data.GetColumn(c) for c in range(data.GetNumberOfColumns())]
    return [[column.GetName()] + [str(column.GetVariantValue(r).ToString()) for r in range(data.GetNumberOfRows())]
            for column in columns]


def main(path, tube, folder):
    simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
    said = {}
    regions = simple.DICOMRTStructureSetReader(FileName=path)
    surface = simple.PolyhedralSurface(Input=regions)
    certificate = simple.SurfaceCertificate(Input=surface, Contours=regions)
    certificate.UpdatePipeline()
    certificate.UpdatePropertyInformation()
    said["verdict"] = certificate.GetProperty("Verdict").GetElement(0)
    said["tables"] = [table(certificate, 1), table(certificate, 2)]
    surface.UpdatePropertyInformation()
    said["report"] = surface.GetProperty("Report").GetElement(0)
    said["cells"] = surface.GetDataInformation().GetNumberOfCells()
    said["saved"] = []
    for name, source in (("regions.stl", surface), ("regions.brep", surface)):
        said["saved"].append(simple.SaveData(os.path.join(folder, name), source))
    # Where ParaView has a writer of its own for the ending, ours is named.
    simple.ContourTableWriter(Input=regions, FileName=os.path.join(folder, "regions.csv")).UpdatePipeline()
    simple.DICOMRTStructureSetWriter(Input=regions, FileName=os.path.join(folder, "regions.dcm"), ReferenceFileName=path).UpdatePipeline()
    one = simple.NUAGESContourReader(FileName=tube)
    said["saved"].append(simple.SaveData(os.path.join(folder, "one.cnt"), one))
    # A surface in pieces, whose slices are in pieces as well.
    ball = simple.Sphere(ThetaResolution=24, PhiResolution=24, Radius=10)
    slices = simple.Slice(Input=ball)
    slices.SliceType.Normal = [0, 0, 1]
    slices.SliceOffsetValues = [-8, -5, -2, 1, 4, 7]
    together = simple.PolyhedralSurface(Input=simple.ContourRegions(Input=slices))
    judged = simple.SurfaceCertificate(Input=together)
    judged.UpdatePipeline()
    judged.UpdatePropertyInformation()
    said["ball"] = judged.GetProperty("Verdict").GetElement(0)
    with open(os.path.join(folder, "said.json"), "w", encoding="utf-8") as file:
        json.dump(said, file)
    # Last, as it is an error on more than one rank.
    apart = simple.PolyhedralSurface(Input=slices)
    apart.UpdatePipeline()
    print("cells of slices in pieces:", apart.GetDataInformation().GetNumberOfCells(), flush=True)


main(*sys.argv[1:])
