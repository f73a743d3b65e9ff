# SPDX-License-Identifier: GPL-3.0-or-later
"""Each region of an RT structure set as a surface of its own: names, volumes, files.

    pvpython regions_of_a_structure_set.py FILE.dcm
"""
import re
import sys

from paraview.simple import *


def surfaces(path, regions=None):
    """(name, surface as poly data) of each region; of those named only, where there are names."""
    reader = DICOMRTStructureSetReader(FileName=path)
    if regions:
        reader.ROIs = regions
    surface = PolyhedralSurface(Input=reader, EndCaps="HalfSlice")  # as planning systems count volumes
    certificate = SurfaceCertificate(Input=surface)
    certificate.UpdatePipeline()
    # servermanager.Fetch() fails on collections in ParaView 5.11; this is the same where there is no server.
    collection = certificate.GetClientSideObject().GetOutputDataObject(0)
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        yield collection.GetMetaData(i).Get(collection.NAME()), collection.GetPartition(i, 0)


def main(path):
    for name, data in surfaces(path):
        if data.GetNumberOfCells() == 0:
            print(f"{name}: nothing to make a surface of")
            continue
        volume = data.GetFieldData().GetArray("Volume").GetValue(0)
        source = PVTrivialProducer()
        source.GetClientSideObject().SetOutput(data)
        file = re.sub(r"\W+", "_", name) + ".stl"
        SaveData(file, source)
        print(f"{name}: {volume / 1000:.2f} cm3, {file}")


if __name__ == "__main__" and len(sys.argv) > 1:
    main(sys.argv[1])
