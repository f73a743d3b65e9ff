# SPDX-License-Identifier: GPL-3.0-or-later
"""How long Polyhedral Surface takes to follow one changed contour, through the pipeline; `./run bench` calls it.

    ./run bench editing [FILE.cnt] [--edits N] [--check]

Of the head, or of the contours of another file, one contour after another is moved a little, and the node brought up to date: wall
and processor time, medians, beside those of a node that has seen no other contours. With --check the exit code says whether a
change took less than MOST_SECONDS of wall time and less than MOST_SHARE of a new node's processor time.
"""
import argparse
import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["CONTOUR_PLUGIN"], remote=False, ns=simple.__dict__)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

MOST_SECONDS = 0.1
MOST_SHARE = 0.6
HERE = os.path.dirname(os.path.abspath(__file__))


def read(path, roi):
    if path.endswith(".cnt"):
        reader = simple.NUAGESContourReader(FileName=path)
    else:
        reader = simple.MergeBlocks(Input=simple.DICOMRTStructureSetReader(FileName=path, ROIs=[roi]), OutputDataSetType="Polygonal Mesh")
    reader.UpdatePipeline()
    return reader.GetClientSideObject().GetOutputDataObject(0)


def seconds_of(work):
    wall, cpu = time.perf_counter(), time.process_time()
    work()
    return time.perf_counter() - wall, time.process_time() - cpu


def median(numbers):
    return sorted(numbers)[len(numbers) // 2]


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("file", nargs="?", default=os.path.join(HERE, "..", "..", "Data", "head.cnt"))
parser.add_argument("--roi", default="", help="of a structure set")
parser.add_argument("--edits", type=int, default=20)
parser.add_argument("--check", action="store_true")
options = parser.parse_args()

contours = read(options.file, options.roi)
producer = simple.TrivialProducer()
edited, fresh = [], []
node = None
for edit in range(options.edits + 1):
    changed = vtkPolyData()
    changed.DeepCopy(contours)  # with all changes before
    contours = changed
    if edit > 0:
        cell = changed.GetCell(edit * changed.GetNumberOfCells() // (options.edits + 1))
        points = vtk_to_numpy(changed.GetPoints().GetData())
        points[cell.GetPointId(0)] = (points[cell.GetPointId(0)] + points[cell.GetPointId(1)]) / 2
    producer.GetClientSideObject().SetOutput(changed)
    producer.MarkModified(producer)
    if node is None:
        node = simple.PolyhedralSurface(Input=producer)
        node.UpdatePipeline()
        continue
    edited.append(seconds_of(node.UpdatePipeline))
    other = simple.PolyhedralSurface(Input=producer)
    fresh.append(seconds_of(other.UpdatePipeline))
    simple.Delete(other)
(wall, cpu), (fresh_wall, fresh_cpu) = ([median(column) for column in zip(*rows)] for rows in (edited, fresh))
print(f"{contours.GetNumberOfCells()} contours, {options.edits} changes of one: {wall:.3f} s ({cpu:.3f} processor seconds), "
      f"from nothing {fresh_wall:.3f} s ({fresh_cpu:.3f})")
sys.stdout.flush()
if options.check:
    sys.exit(0 if wall < MOST_SECONDS and cpu < MOST_SHARE * fresh_cpu else 1)
