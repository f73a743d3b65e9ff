# SPDX-License-Identifier: GPL-3.0-or-later
"""Planar contours in, closed surfaces out: numpy arrays both ways, without VTK.

The methods are those of the ParaView plugin of the same project, and give the same bytes; keyword arguments have the
names of its nodes' properties. With PyVista installed, meshes have them as ``mesh.contours``.

Examples
--------
>>> import contour_reconstruction as cr
>>> contours = cr.read("brain.cnt")
>>> surface = cr.polyhedral_surface(contours)
>>> print("\\n".join(cr.certificate(surface, contours).text))
>>> cr.write_stl("brain.stl", surface)
"""
from ._core import Aborted, Error, NothingToDo, __version__
from ._data import Certificate, ContourMapping, Contours, ContourWarning, Regions, Surface
from ._files import (list_rois, read, read_brep, read_curve_network, read_nuages, read_slice_planes,
                     read_structure_set, read_traces, write_brep, write_nuages, write_stl, write_structure_set)
from ._methods import (certificate, contour_hierarchy, contour_mapping, contours_on_planes, fair_surface,
                       implicit_surface, polyhedral_surface)

__all__ = [
    "Aborted", "Certificate", "ContourMapping", "ContourWarning", "Contours", "Error", "NothingToDo", "Regions",
    "Surface", "__version__", "certificate", "contour_hierarchy", "contour_mapping", "contours_on_planes",
    "fair_surface", "implicit_surface", "list_rois", "polyhedral_surface", "read", "read_brep", "read_curve_network",
    "read_nuages", "read_slice_planes", "read_structure_set", "read_traces", "write_brep", "write_nuages", "write_stl", "write_structure_set",
]
