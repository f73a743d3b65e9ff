# SPDX-License-Identifier: GPL-3.0-or-later
"""The module of 3D Slicer as TestWheel.py runs it: in an environment with the wheel and slicer-core, without a window.

    slicercases.py RESULT.npz SOURCE SHARED

Writes what became of the lung of SHARED, where it is, under the names of wheelcases.py, in DICOM's coordinates again.
"""
import os
import sys
import tempfile

import numpy as np
import slicer
import vtk
from vtk.util.numpy_support import vtk_to_numpy

RESULT, SOURCE, SHARED = sys.argv[1:4]
sys.path.insert(0, os.path.join(SOURCE, "Plugin/slicer"))

import ContourSurfaces

import contour_reconstruction as cr

SURFACE = slicer.vtkSegmentationConverter.GetClosedSurfaceRepresentationName()
VOXELS = slicer.vtkSegmentationConverter.GetBinaryLabelmapRepresentationName()
LARGEST_DIFFERENCE = 0.05  # of the volume of a surface that Slicer has made voxels of
arrays = {}


def new_node(scene):
    return scene.AddNewNodeByClass("vtkMRMLSegmentationNode")


def segments_of(node):
    """Segments by name."""
    segmentation = node.GetSegmentation()
    found = [segmentation.GetNthSegment(i) for i in range(segmentation.GetNumberOfSegments())]
    return {segment.GetName(): segment for segment in found}


def mesh_of(segment):
    """Points in DICOM's coordinates and triangles."""
    data = segment.GetRepresentation(SURFACE)
    return (vtk_to_numpy(data.GetPoints().GetData()) * (-1, -1, 1),
            vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def structure_set(folder):
    """Two regions that become surfaces, each with its colour, and one on a single plane, which cannot."""
    regions = {name: cr.read(os.path.join(SOURCE, "Data", file)) for name, file in
               (("Pipe", "branching_pipe.cnt"), ("Brain", "brain.cnt"))}
    regions["Pipe"].field_data["ROIColor"] = np.array([255, 0, 51])
    square = [[0, 0, 7], [10, 0, 7], [10, 10, 7], [0, 10, 7]]
    regions["Leaf"] = cr.Contours.from_loops([square])
    path = os.path.join(folder, "regions.dcm")
    cr.write_structure_set(path, regions)
    return path


def check_regions(path, scene):
    node, heard = new_node(scene), []
    lines = ContourSurfaces.ContourSurfacesLogic().reconstruct(
        path, node, EndCaps="Flat", progress=lambda fraction, text: heard.append((fraction, text)))
    there = segments_of(node)
    assert list(there) == ["Pipe", "Brain"], list(there)
    assert any(line.startswith("Leaf: left out. ") for line in lines), lines
    assert any(line.startswith("Brain: Sound: closed") for line in lines), lines
    assert node.GetSegmentation().GetSourceRepresentationName() == SURFACE
    assert np.allclose(there["Pipe"].GetColor(), (1, 0, 0.2)), there["Pipe"].GetColor()
    for i, name in enumerate(("Pipe", "Brain", "Leaf")):
        parts = [fraction for fraction, text in heard if text.startswith(f"{name}: ")]
        assert parts or name == "Leaf", f"nothing is heard of {name}"
        assert all(i / 3 <= part <= (i + 1) / 3 for part in parts), (name, parts)
    drawn = cr.read(path)
    for name, segment in there.items():
        points, triangles = mesh_of(segment)
        surface = cr.polyhedral_surface(drawn[name], EndCaps="Flat")
        assert np.array_equal(points, surface.points) and np.array_equal(triangles, surface.triangles), name
        text = vtk.reference("")
        assert segment.GetTag(ContourSurfaces.REPORT, text) and "closed" in str(text), str(text)


def check_voxels(path, scene):
    """Slicer itself takes the surfaces for closed: its voxels of them have their volume."""
    # Slicer's window knows the rule from its start.
    rule = slicer.vtkClosedSurfaceToBinaryLabelmapConversionRule()
    slicer.vtkSegmentationConverterFactory.GetInstance().RegisterConverterRule(rule)
    node = new_node(scene)
    ContourSurfaces.ContourSurfacesLogic().reconstruct(path, node, regions=["Brain"], method="Fair Surface")
    assert node.GetSegmentation().CreateRepresentation(VOXELS), "Slicer makes no voxels of the surface"
    voxels = segments_of(node)["Brain"].GetRepresentation(VOXELS)
    inside = np.count_nonzero(vtk_to_numpy(voxels.GetPointData().GetScalars())) * np.prod(voxels.GetSpacing())
    volume = cr.certificate(mesh_of(segments_of(node)["Brain"])).figures["Volume"]
    print(f"the brain has {volume:.0f} as a surface and {inside:.0f} as Slicer's voxels")
    assert volume > 0 and abs(inside / volume - 1) < LARGEST_DIFFERENCE, (inside, volume)


def check_stop(path, scene):
    node = new_node(scene)
    try:
        ContourSurfaces.ContourSurfacesLogic().reconstruct(path, node, progress=lambda fraction, text: False)
        raise AssertionError("it goes on where the user has stopped it")
    except cr.Aborted:
        assert not segments_of(node)
    try:
        ContourSurfaces.ContourSurfacesLogic().reconstruct(path + ".none", node)
        raise AssertionError("a file that is not there is read")
    except cr.Error as error:
        assert "regions.dcm.none" in str(error), error


def keep_lung(scene):
    path = os.path.join(SHARED, "rtstruct/dicompyler_rtss.dcm")
    if os.path.exists(path):
        node = new_node(scene)
        ContourSurfaces.ContourSurfacesLogic().reconstruct(path, node, regions=["Lt Lung"])
        arrays["rtss lung/mesh/points"], arrays["rtss lung/mesh/triangles"] = mesh_of(segments_of(node)["Lt Lung"])


scene = slicer.vtkMRMLScene()
with tempfile.TemporaryDirectory() as folder:
    regions = structure_set(folder)
    for check in (check_regions, check_voxels, check_stop):
        check(regions, scene)
keep_lung(scene)
np.savez(RESULT, **arrays)
print(len(arrays), "arrays")
