# SPDX-License-Identifier: GPL-3.0-or-later
"""The accessor ``mesh.contours`` of PyVista's poly data and multi-block data, which PyVista finds by itself."""
from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any, Optional, Union

import numpy as np
import pyvista

from . import _methods
from ._core import Error
from ._data import Certificate, ContourMapping, Contours, ContourWarning, Surface, check_no_surface

def _text(values: Any) -> Any:
    """Texts as a list, numbers as an array."""
    array = np.asarray(values)
    return [str(value) for value in array] if array.dtype.kind in "USO" else array


def _cells(flat: Any) -> list[Any]:
    """Cells of an array that has the number of points before the points of each."""
    cells, start = [], 0
    array = np.asarray(flat)
    while start < len(array):
        cells.append(array[start + 1:start + 1 + array[start]])
        start += 1 + array[start]
    return cells


def contours_from_pyvista(mesh: pyvista.PolyData) -> Contours:
    """Vertices, lines and polygons of poly data as loops, in the order of its cells.

    Parameters
    ----------
    mesh : pyvista.PolyData
        Contours: what ``slice()`` and ``contour()`` give, or polylines.

    Raises
    ------
    Error
        Where the mesh is a surface.
    """
    vertices, lines, polygons = (_cells(flat) for flat in (mesh.verts, mesh.lines, mesh.faces))
    check_no_surface(polygons)
    # A vertex cell of many points is a loop a point, all of one cell.
    cells = [(cell[i:i + 1], number) for number, cell in enumerate(vertices) for i in range(len(cell))]
    cells += [(cell, len(vertices) + number) for number, cell in enumerate(lines + polygons)]
    closed = [False] * (len(cells) - len(lines) - len(polygons))
    closed += [len(cell) > 2 and cell[0] == cell[-1] for cell in lines] + [True] * len(polygons)
    repeats = [len(cell) > 2 and cell[0] == cell[-1] for cell, _ in cells]
    loops = [cell[:-1] if repeated else cell for (cell, _), repeated in zip(cells, repeats)]
    offsets = np.concatenate(([0], np.cumsum([len(loop) for loop in loops], dtype=np.int64)))
    of_cell = np.array([number for _, number in cells], dtype=np.int64)
    cell_data = {name: _text(np.asarray(mesh.cell_data[name])[of_cell]) for name in mesh.cell_data}
    field_data = {name: _text(mesh.field_data[name]) for name in mesh.field_data}
    report = field_data.pop("Report", [])
    return Contours(np.asarray(mesh.points), offsets, np.concatenate(loops) if loops else [], closed, cell_data,
                    field_data, report)


def _add(data: Any, values: dict[str, Any], report: Optional[list[str]] = None) -> None:
    for name, value in values.items():
        data[name] = np.atleast_1d(np.asarray(value))
    if report:
        data["Report"] = np.asarray(report)


def contours_to_pyvista(contours: Contours) -> pyvista.PolyData:
    """Loops as vertices and polylines; the first point of a closed one is its last as well."""
    vertices, lines = [], []
    order: tuple[list[int], list[int]] = ([], [])
    for i in range(len(contours)):
        loop = contours.connectivity[contours.offsets[i]:contours.offsets[i + 1]]
        if len(loop) == 1:
            vertices += [1, loop[0]]
        else:
            cell = np.append(loop, loop[:1]) if contours.closed[i] else loop
            lines += [len(cell), *cell]
        order[len(loop) > 1].append(i)
    mesh = pyvista.PolyData()
    mesh.points = contours.points
    mesh.verts = np.array(vertices, dtype=np.int64)
    mesh.lines = np.array(lines, dtype=np.int64)
    cells = np.array(order[0] + order[1], dtype=np.int64)
    _add(mesh.cell_data, {name: np.asarray(values)[cells] for name, values in contours.cell_data.items()})
    _add(mesh.field_data, contours.field_data, contours.report)
    return mesh


def surface_to_pyvista(surface: Surface) -> pyvista.PolyData:
    """Triangles as poly data, points in double precision."""
    mesh = pyvista.PolyData.from_regular_faces(surface.points, surface.triangles)
    _add(mesh.point_data, surface.point_data)
    _add(mesh.cell_data, surface.cell_data)
    _add(mesh.field_data, surface.field_data, surface.report)
    return mesh


def surface_from_pyvista(mesh: pyvista.PolyData) -> Surface:
    """The triangles of poly data; other polygons and strips are cut into such."""
    triangles = mesh.triangulate() if not mesh.is_all_triangles else mesh
    return Surface(np.asarray(triangles.points), triangles.regular_faces, report=[])


Data = Union[pyvista.PolyData, pyvista.MultiBlock]


@pyvista.register_dataset_accessor("contours", pyvista.MultiBlock)
@pyvista.register_dataset_accessor("contours", pyvista.PolyData)
class ContoursAccessor:
    """The package's functions on a mesh: poly data in, poly data out; of blocks, a result a block.

    A block that cannot be done is left out with a warning, and does not take the others with it.

    Parameters
    ----------
    mesh : pyvista.PolyData or pyvista.MultiBlock
        Closed lines, or loose pieces such as ``slice()`` gives.
    """

    def __init__(self, mesh: Data) -> None:
        self._mesh = mesh

    def _made(self, function: Callable[..., Any], *arguments: Any, **properties: Any) -> Data:
        if isinstance(self._mesh, pyvista.PolyData):
            return function(contours_from_pyvista(self._mesh), *arguments, **properties).to_pyvista()
        blocks = pyvista.MultiBlock()
        for name, block in zip(self._mesh.keys(), self._mesh):
            try:
                if not isinstance(block, pyvista.PolyData):
                    raise Error("it is no poly data.")
                blocks.append(function(contours_from_pyvista(block), *arguments, **properties).to_pyvista(), name)
            except Error as error:
                warnings.warn(f"Block {name!r} is left out: {error}", ContourWarning, stacklevel=3)
        return blocks

    def contour_hierarchy(self, **properties: Any) -> Data:
        """Clean, orient and nest: `contour_reconstruction.contour_hierarchy`, which has the properties."""
        return self._made(_methods.contour_hierarchy, **properties)

    def contour_mapping(self, **properties: Any) -> ContourMapping:
        """What belongs together: `contour_reconstruction.contour_mapping`, which has the properties."""
        return _methods.contour_mapping(self.to_contours(), **properties)

    def polyhedral_surface(self, **properties: Any) -> Data:
        """The closed surface through the contours: `contour_reconstruction.polyhedral_surface`, which has the
        properties."""
        return self._made(_methods.polyhedral_surface, **properties)

    def fair_surface(self, **properties: Any) -> Data:
        """A smooth closed surface near the contours: `contour_reconstruction.fair_surface`, which has the properties."""
        return self._made(_methods.fair_surface, **properties)

    def implicit_surface(self, **properties: Any) -> Data:
        """A smooth closed surface: `contour_reconstruction.implicit_surface`, which has the properties."""
        return self._made(_methods.implicit_surface, **properties)

    def contours_on_planes(self, planes: Any = None, **properties: Any) -> Data:
        """Contours on other planes: `contour_reconstruction.contours_on_planes`, which has the properties; `planes`
        may be poly data as well."""
        where = contours_from_pyvista(planes) if isinstance(planes, pyvista.PolyData) else planes
        return self._made(_methods.contours_on_planes, where, **properties)

    def certificate(self, contours: Any = None, **properties: Any) -> Certificate:
        """What may be trusted about this surface: `contour_reconstruction.certificate`; `contours` may be poly data
        as well."""
        drawn = contours_from_pyvista(contours) if isinstance(contours, pyvista.PolyData) else contours
        return _methods.certificate(surface_from_pyvista(self._mesh), drawn, **properties)

    def to_contours(self) -> Contours:
        """The loops of this poly data as numpy arrays."""
        if not isinstance(self._mesh, pyvista.PolyData):
            raise Error("Contours of several blocks were given: take one of them.")
        return contours_from_pyvista(self._mesh)
