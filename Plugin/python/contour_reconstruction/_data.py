# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes in and what comes out: arrays with names. Names and meanings of arrays are those of the nodes."""
from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._core import Error

if TYPE_CHECKING:
    import pyvista

Array = npt.NDArray[Any]
Progress = Optional[Callable[[float, str], Optional[bool]]]


class ContourWarning(UserWarning):
    """So much was left out that the result is not what was drawn."""


def points_of(points: npt.ArrayLike, what: str) -> Array:
    """An (n, 3) array of double precision, or an Error that says what is not one."""
    try:
        array = np.ascontiguousarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise Error(f"{what} are no numbers: give an array of shape (n, 3).") from None
    if array.size == 0:
        array = array.reshape(-1, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"{what} have the shape {array.shape}: give an array of shape (n, 3), x, y and z of each point.")
    return array


class Contours:
    """Loops of points, most of them closed, with data about each.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates, in the unit and the right-handed system of the data; DICOM's are millimetres of the patient.
    offsets : array_like, shape (m + 1,)
        Loop i consists of the points ``connectivity[offsets[i]:offsets[i + 1]]``.
    connectivity : array_like
        Numbers of points. The first point of a closed loop is not repeated.
    closed : bool or array_like, shape (m,), default: True
        Whether an edge joins the last point of a loop to the first. Open pieces that meet end to end become one loop
        where contours are read.
    cell_data : dict, optional
        Name -> a value a loop.
    field_data : dict, optional
        Name -> values about the whole.
    report : iterable of str, optional
        What was repaired or left out so far, a sentence each.

    Raises
    ------
    Error
        Where the arrays do not fit together.

    See Also
    --------
    Contours.from_loops : from one array a loop.
    """

    def __init__(self, points: npt.ArrayLike, offsets: npt.ArrayLike, connectivity: npt.ArrayLike,
                 closed: Union[bool, npt.ArrayLike] = True, cell_data: Optional[dict[str, Any]] = None,
                 field_data: Optional[dict[str, Any]] = None, report: Iterable[str] = ()) -> None:
        self.points = points_of(points, "The points of the contours")
        self.offsets = np.ascontiguousarray(offsets, dtype=np.int64)
        self.connectivity = np.ascontiguousarray(connectivity, dtype=np.int64)
        if self.offsets.ndim != 1 or self.offsets.size == 0 or self.connectivity.ndim != 1:
            raise Error("offsets and connectivity must have one dimension, and offsets begin with 0.")
        count = self.offsets.size - 1
        self.closed = np.ascontiguousarray(np.broadcast_to(np.asarray(closed, dtype=bool), (count,)))
        self.cell_data: dict[str, Any] = dict(cell_data or {})
        self.field_data: dict[str, Any] = dict(field_data or {})
        self.report: list[str] = list(report)
        for name, values in self.cell_data.items():
            if len(values) != count:
                raise Error(f"The cell data {name} have {len(values)} values, and there are {count} loops.")

    @classmethod
    def from_loops(cls, loops: Iterable[npt.ArrayLike], closed: Union[bool, npt.ArrayLike] = True) -> Contours:
        """One array of shape (k, 3) a loop; a repeated first point at the end of a closed loop does no harm.

        Parameters
        ----------
        loops : iterable of array_like, each of shape (k, 3)
            Points in order; loops come in any order and direction.
        closed : bool or array_like, default: True
            See `Contours`.
        """
        arrays = [points_of(loop, f"The points of loop {i}") for i, loop in enumerate(loops)]
        lengths = [len(array) for array in arrays]
        points = np.concatenate(arrays) if arrays else np.empty((0, 3))
        return cls(points, np.concatenate(([0], np.cumsum(lengths, dtype=np.int64))), np.arange(len(points)), closed)

    def __len__(self) -> int:
        return self.offsets.size - 1

    def __getitem__(self, index: int) -> Array:
        """Points of a loop, shape (k, 3)."""
        number = range(len(self))[index]
        return self.points[self.connectivity[self.offsets[number]:self.offsets[number + 1]]]

    def __iter__(self) -> Iterator[Array]:
        return (self[i] for i in range(len(self)))

    def __repr__(self) -> str:
        name = self.field_data.get("ROIName")
        return f"<Contours{f' {name!r}' if name else ''}: {len(self)} loops, {len(self.points)} points>"

    def to_pyvista(self) -> pyvista.PolyData:
        """The loops as lines of poly data, with all data; needs PyVista."""
        from ._pyvista import contours_to_pyvista

        return contours_to_pyvista(self)


@dataclass(repr=False)
class Surface:
    """Triangles by index, with data about points, triangles and the whole.

    Attributes
    ----------
    points : ndarray, shape (n, 3)
        Coordinates in the unit of the contours, double precision.
    triangles : ndarray, shape (m, 3)
        Numbers of points, counterclockwise seen from outside.
    point_data, cell_data, field_data : dict
        Arrays by name, as the nodes have them.
    report : list of str
        What was repaired or left out, a sentence each.
    """

    points: Array
    triangles: Array
    point_data: dict[str, Any] = field(default_factory=dict)
    cell_data: dict[str, Any] = field(default_factory=dict)
    field_data: dict[str, Any] = field(default_factory=dict)
    report: list[str] = field(default_factory=list)

    def __repr__(self) -> str:
        return f"<Surface: {len(self.triangles)} triangles, {len(self.points)} points>"

    def to_pyvista(self) -> pyvista.PolyData:
        """The triangles as poly data, with all data; needs PyVista."""
        from ._pyvista import surface_to_pyvista

        return surface_to_pyvista(self)


@dataclass(repr=False)
class ContourMapping:
    """What belongs together, and why.

    Attributes
    ----------
    contours : Contours
        With the cell data MappingGroupBelow and MappingGroupAbove. `polyhedral_surface` follows the decisions that
        come with them.
    joins : dict of str to ndarray or list of str
        A table, column by column, a row a decision: Slab, LowerContour, UpperContour (ContourId; -1 where a region has
        no partner), LowerContours, UpperContours, OverlapArea (square units), LowerRatio, UpperRatio, Solid, Rule,
        Joined and Words, a sentence that says it all.
    report : list of str
        What was repaired, left out, or asked for in vain.
    """

    contours: Contours
    joins: dict[str, Any]
    report: list[str]

    def __repr__(self) -> str:
        return f"<ContourMapping: {len(self.contours)} contours, {len(self.joins['Slab'])} decisions>"


@dataclass(repr=False)
class Certificate:
    """What may be trusted about a surface.

    Attributes
    ----------
    sound : bool
        Closed, manifold, oriented outward; no triangles cross or overlap, no sheets cross.
    figures : dict
        Of the whole by name, such as ``figures["Volume"]``: bool, int or float, None where one has no meaning. Lengths
        are in the unit of the data, areas in its square, volumes in its cube, angles in degrees.
    components : list of dict
        The same of each connected component.
    contour_figures : dict
        How the contours fare, and the volume that they tell (``VolumeByContours``, between ``LowestVolume`` and
        ``HighestVolume``; of parallel ones); all None without contours.
    sections : dict of str to ndarray
        A value a level of the contours.
    doubts : dict of str to ndarray
        Where along the stack another slice would tell more about the volume (``DoubtOffset``, in the unit of the data), and
        how much of ``HighestVolume`` less ``LowestVolume`` of `contour_figures` comes from there (``DoubtWidth``), the most first.
    defect, component_id : ndarray of int
        A value a triangle: bits of what is wrong (1 open edge, 2 edge with more than two faces, 4 orientation, 8
        pinched vertex, 16 duplicate, 32 degenerate, 64 crossing, 128 overlap, 256 inside out, 512 touching), and the
        number of its component.
    text : list of str
        A few lines for people.
    json : str
        Everything but what is said a triangle.
    report : list of str
        What was repaired about the contours before the comparison.
    """

    sound: bool
    figures: dict[str, Any]
    components: list[dict[str, Any]]
    contour_figures: dict[str, Any]
    sections: dict[str, Array]
    doubts: dict[str, Array]
    defect: Array
    component_id: Array
    text: list[str]
    json: str
    report: list[str]

    def __repr__(self) -> str:
        return f"<Certificate: {self.text[0] if self.text else 'empty'}>"


class Regions(dict[str, Contours]):
    """Contours by the name of their region of interest or material, in the order of the file.

    Attributes
    ----------
    report : list of str
        What was odd about the file, a sentence each.
    """

    def __init__(self, regions: Iterable[tuple[str, Contours]] = (), report: Iterable[str] = ()) -> None:
        super().__init__(regions)
        self.report = list(report)


ContoursLike = Union[Contours, Sequence[npt.ArrayLike]]
SurfaceLike = Union[Surface, tuple[npt.ArrayLike, npt.ArrayLike]]


def contours_of(contours: ContoursLike, what: str = "Contours") -> Contours:
    """Contours as they are, or made from arrays a loop."""
    if isinstance(contours, Contours):
        return contours
    if isinstance(contours, Regions):
        names = ", ".join(repr(name) for name in contours)
        raise Error(f"{what} of several regions were given: take one of them ({names}).")
    if isinstance(contours, (str, bytes)) or not isinstance(contours, Iterable):
        raise Error(f"{what} must be Contours, or a sequence of arrays of shape (k, 3), not "
                    f"{type(contours).__name__}.")
    return Contours.from_loops(contours)


def surface_of(surface: SurfaceLike) -> tuple[Array, Array, float]:
    """Points, triangles, and what a coordinate may be off because it was stored in single precision."""
    points, triangles = (surface.points, surface.triangles) if isinstance(surface, Surface) else surface
    single = getattr(points, "dtype", None) == np.float32
    places = points_of(points, "The points of the surface")
    try:
        corners = np.ascontiguousarray(triangles, dtype=np.int32)
    except (OverflowError, TypeError, ValueError):
        raise Error("The triangles are no whole numbers: give an array of shape (m, 3).") from None
    if corners.size == 0:
        corners = corners.reshape(-1, 3)
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise Error(f"The triangles have the shape {corners.shape}: give an array of shape (m, 3).")
    largest = float(np.abs(places).max()) if single and places.size else 0.0
    return places, corners, float(np.finfo(np.float32).eps) * largest


def check_no_surface(polygons: Sequence[Array]) -> None:
    """An Error where two polygons have an edge in common, as contours do not."""
    edges = [np.sort(np.column_stack((cell, np.roll(cell, -1))), axis=1) for cell in polygons]
    every = np.concatenate(edges) if edges else np.empty((0, 2))
    if len(np.unique(every, axis=0)) < len(every):
        raise Error("The input is a surface, not contours: cut it with Slice first.")


def _ints(values: Any) -> Array:
    return np.ascontiguousarray(values, dtype=np.int32)


def _add_levels(contours: Contours, given: dict[str, Any]) -> None:
    names = ("LevelNormal", "LevelOffset", "LevelThickness")
    if "Level" not in contours.cell_data or not all(name in contours.field_data for name in names):
        return
    given["level"] = _ints(contours.cell_data["Level"])
    given["level_normal"] = points_of(contours.field_data["LevelNormal"], "LevelNormal")
    given["level_offset"] = np.ascontiguousarray(contours.field_data["LevelOffset"], dtype=np.float64)
    given["level_thickness"] = np.ascontiguousarray(contours.field_data["LevelThickness"], dtype=np.float64)


def given(contours: Contours) -> dict[str, Any]:
    """Contours as the core takes them, with what earlier steps found out about them."""
    result: dict[str, Any] = {
        "points": contours.points, "offsets": contours.offsets, "connectivity": contours.connectivity,
        "closed": contours.closed,
    }
    types = contours.cell_data.get("GeometricType")
    if types is not None:
        result["exclusive_or"] = np.array([kind == "CLOSEDPLANAR_XOR" for kind in types], dtype=bool)
    _add_levels(contours, result)
    if all(name in contours.field_data for name in ("JoinLower", "JoinUpper", "JoinJoined")):
        for name, key in (("JoinLower", "join_lower"), ("JoinUpper", "join_upper"), ("JoinJoined", "join_joined")):
            result[key] = _ints(contours.field_data[name])
        if "ContourId" in contours.cell_data:
            result["contour_id"] = _ints(contours.cell_data["ContourId"])
    return result


def given_planes(planes: Contours) -> dict[str, Any]:
    """The same of contours whose planes are wanted, with what those of a series tell of its images."""
    tolerance = planes.field_data.get("ContourTolerance")
    pixels = np.ravel(planes.cell_data.get("PixelArea", 0.0))
    return {**given(planes), "pixel_area": float(pixels[0]) if pixels.size else 0.0,
            "tolerance": None if tolerance is None else float(np.ravel(tolerance)[0])}


def _taken(values: Any, source: Array) -> Any:
    return values[source] if isinstance(values, np.ndarray) else [values[i] for i in source]


def inherited(made: dict[str, Any], source: Contours) -> None:
    """Adds what the input said to what was made of it, as the nodes pass it on."""
    for name, values in source.field_data.items():
        made["field_data"].setdefault(name, values)
    made["report"] = source.report + made["report"]
    if "source" in made:
        for name, values in source.cell_data.items():
            made["cell_data"].setdefault(name, _taken(values, made["source"]))
    if made.get("warning"):
        warnings.warn(made["warning"], ContourWarning, stacklevel=4)


def make_contours(made: dict[str, Any]) -> Contours:
    """Contours from what the core hands back."""
    return Contours(made["points"], made["offsets"], made["connectivity"], made["closed"].astype(bool),
                    made.get("cell_data"), made.get("field_data"), made.get("report", ()))


def make_surface(made: dict[str, Any]) -> Surface:
    """A surface from what the core hands back."""
    return Surface(made["points"], made["triangles"], made.get("point_data", {}), made.get("cell_data", {}),
                   made.get("field_data", {}), made.get("report", []))
