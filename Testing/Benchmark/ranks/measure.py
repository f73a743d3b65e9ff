# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of `./run bench ranks`: times of this rank, as JSON in FOLDER.

    mpiexec -n N pvbatch --sym measure.py STRUCTURE_SET FOLDER
"""
import json
import os
import sys
import time

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

path, folder = sys.argv[1:]
simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
controller = vtkMultiProcessController.GetGlobalController()
reader = simple.DICOMRTStructureSetReader(FileName=path)
# A rank that waits for another one in MPI is busy, which is in its seconds.
stages = {"read": reader, "surfaces": simple.PolyhedralSurface(Input=reader, Threads=1)}
said = {}
for name, node in stages.items():
    controller.Barrier()
    wall, cpu = time.perf_counter(), time.process_time()
    node.UpdatePipeline()
    said[name] = [time.perf_counter() - wall, time.process_time() - cpu]
blocks = [stages["surfaces"].GetClientSideObject().GetOutputDataObject(0).GetPartition(i, 0)
          for i in range(stages["surfaces"].GetClientSideObject().GetOutputDataObject(0).GetNumberOfPartitionedDataSets())]
said["triangles"] = sum(block.GetNumberOfCells() for block in blocks)
contours = reader.GetClientSideObject().GetOutputDataObject(0)
said["points"] = sum(contours.GetPartition(i, 0).GetNumberOfPoints() for i in range(contours.GetNumberOfPartitionedDataSets()))
with open(os.path.join(folder, f"rank{controller.GetLocalProcessId()}.json"), "w", encoding="utf-8") as file:
    json.dump(said, file)
