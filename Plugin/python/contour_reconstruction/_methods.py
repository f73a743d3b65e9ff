# SPDX-License-Identifier: GPL-3.0-or-later
"""The methods, a function a node, with the node's properties as keyword arguments and its defaults."""
from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from typing import Any, Optional, Union

import numpy.typing as npt

from . import _core
from ._data import (Certificate, ContourMapping, Contours, ContoursLike, ContourWarning, Progress, Surface, SurfaceLike,
                    contours_of, given, given_planes, inherited, make_contours, make_surface, surface_of)
from ._properties import checked

#: Where a larger part of the contours is left out, a line in the report is not enough.
WARN_BEYOND = 0.1

Choice = Union[str, int]
Pairs = Sequence[tuple[int, int]]


def contour_hierarchy(contours: ContoursLike, *, ParallelPlanesOnly: bool = False, HoleRule: Choice = "Automatic",
                      OpenLines: Choice = "Leave Out", PlaneTolerance: float = 0, SnapTolerance: float = 0,
                      progress: Progress = None) -> Contours:
    """Clean, orient and nest planar contours.

    Parameters
    ----------
    contours : Contours or sequence of array_like of shape (k, 3)
        Closed loops, or pieces that meet end to end, on planes of any orientation, in any order and direction.
    ParallelPlanesOnly : bool, default: False
        Keep only contours whose planes are parallel to those of most contours.
    HoleRule : {"Automatic", "Even-Odd", "Winding", "Keyhole"}
        Which contours of a plane are walls of holes.
    OpenLines : {"Leave Out", "Chord", "Border"}
        What becomes of lines that are open by more than the distance of their points.
    PlaneTolerance : float, default: 0
        Planes nearer than this, in the unit of the data, are one level; 0: 5% of the planes' median distance, and at
        most 0.1 mm in DICOM data.
    SnapTolerance : float, default: 0
        Within a plane points and edges nearer than this, in the unit of the data, become one; 0: a ten millionth of
        each contour's diagonal.
    progress : callable, optional
        Gets a fraction from 0 to 1 and the name of the stage, some twenty times a second; the work stops by `Aborted`
        where it returns False.

    Returns
    -------
    Contours
        Outer walls counterclockwise and holes clockwise about the normal of their plane, with the cell data Level,
        ContourId, Depth, Parent and SignedArea (square units), and the field data LevelNormal, LevelOffset,
        LevelThickness and LevelHoleRule.

    Raises
    ------
    Error
        Where not one usable contour is left, or a property has a value that it cannot have; the sentence says why.
    NothingToDo
        Where there are open lines only.
    """
    source = contours_of(contours)
    made = _core.contour_hierarchy(given(source), checked(locals()), progress)
    inherited(made, source)
    return make_contours(made)


def contour_mapping(contours: ContoursLike, *, OverlapThreshold: float = 0.1, ForcedJoins: Pairs = (),
                    ForbiddenJoins: Pairs = (), MaximumGap: float = 5, ExpectedPieces: int = -1,
                    ExpectedHandles: int = -1, AlignLevels: Choice = "Automatic",
                    HoleRule: Choice = "Automatic", OpenLines: Choice = "Leave Out", PlaneTolerance: float = 0,
                    SnapTolerance: float = 0, Threads: int = 0, progress: Progress = None) -> ContourMapping:
    """Find which contours of neighbouring planes belong together, and say why.

    Parameters
    ----------
    contours : Contours or sequence of array_like of shape (k, 3)
        On parallel planes.
    OverlapThreshold : float, default: 0.1
        The share of the smaller region's area that two regions must have in common to be joined, 0 to 1.
    ForcedJoins, ForbiddenJoins : sequence of pairs of int, optional
        Pairs of ContourId on neighbouring planes that are joined, or are not, whatever they share; forbidding wins.
    MaximumGap : float, default: 5
        Planes further apart than this many times the spacing beside them are not joined; 0 joins all.
    ExpectedPieces, ExpectedHandles : int, default: -1
        What the surface is to have, see `polyhedral_surface`.
    AlignLevels : {"Automatic", "Off", "On"}
        Whether levels of oblique shapes are shifted onto one another before they are compared.
    HoleRule, OpenLines, PlaneTolerance, SnapTolerance, progress
        See `contour_hierarchy`.
    Threads : int, default: 0
        0 takes all of the machine; the result is the same for any number.

    Returns
    -------
    ContourMapping
        The contours with the groups that they are in, and the table of decisions.

    Raises
    ------
    Error
        See `contour_hierarchy`.

    Notes
    -----
    2D shape similarity: chapter 3 of E. M. Vasquez Osorio, *Surface Reconstruction*, Universidad EAFIT, Medellin, 2003.
    """
    source = contours_of(contours)
    made = _core.contour_mapping(given(source), checked(locals(), OverlapThreshold=(0, 1)), progress)
    inherited(made, source)
    return ContourMapping(make_contours(made), made["joins"], made["report"])


def warn_of_left_out(data: dict[str, Any]) -> None:
    """Warns the caller of a method where so many contours are left out that a line in the report is not enough."""
    if data["LeftOutCount"] > WARN_BEYOND * data["ContourCount"]:
        warnings.warn(f"{data['LeftOutCount']} of {data['ContourCount']} contours are left out of the surface: "
                      "its report says why.", ContourWarning, stacklevel=3)


def polyhedral_surface(contours: ContoursLike, *, Mapping: Choice = "Overlap", OverlapThreshold: float = 0.1,
                       EndCaps: Choice = "Tapered", IsolatedContours: Choice = "Extrude", InternalPoints: bool = True,
                       LiftInternalPoints: bool = True, ForcedJoins: Pairs = (), ForbiddenJoins: Pairs = (),
                       MaximumGap: float = 5, ExpectedPieces: int = -1, ExpectedHandles: int = -1,
                       AlignLevels: Choice = "Automatic", PinchGap: float = 0.001,
                       HoleRule: Choice = "Automatic", OpenLines: Choice = "Leave Out", PlaneTolerance: float = 0,
                       SnapTolerance: float = 0, Threads: int = 0, progress: Progress = None) -> Surface:
    """Make the closed surface that passes exactly through contours on parallel planes.

    Parameters
    ----------
    contours : Contours or sequence of array_like of shape (k, 3)
        On two or more parallel planes. The decisions of `contour_mapping` are followed where the contours are those
        that it returned.
    Mapping : {"Overlap", "Proximity"}
        Which contours of neighbouring levels may be joined: those whose areas overlap, or those that face each other.
    OverlapThreshold : float, default: 0.1
        The share of the smaller contour's area that two contours must have in common, 0 to 0.99.
    EndCaps : {"Tapered", "Flat", "HalfSlice", "Extrapolated", "None"}
        How the surface ends where a contour has no partner; Extrapolated goes on as the sections before it tell, None leaves
        it open.
    IsolatedContours : {"Extrude", "Drop"}
        What becomes of a contour with no partner at all: a slice of its own, or nothing, with a line in the report.
    InternalPoints : bool, default: True
        Add points inside contours so that the surface can branch there.
    LiftInternalPoints : bool, default: True
        Move these to where the branches are estimated to meet, between the levels.
    ForcedJoins, ForbiddenJoins : sequence of pairs of int, optional
        Pairs of ContourId (`contour_hierarchy`) on neighbouring levels that are joined, or are not, whatever the
        mapping says; forbidding wins.
    MaximumGap : float, default: 5
        Levels further apart than this many times the spacing beside them are not joined; 0 joins all.
    ExpectedPieces : int, default: -1
        How many pieces (closed sheets; the wall of a cavity is one) the surface has, where that is known; -1: as the
        contours show. The cheapest joins are made or parted for it; the report says which, and what cannot be met.
    ExpectedHandles : int, default: -1
        How many handles all pieces have together; those too many are parted or filled between two levels.
    AlignLevels : {"Automatic", "Off", "On"}
        Whether levels of oblique shapes are shifted onto one another before they are joined, and the surface back.
    PinchGap : float, default: 0.001
        Sheets that touch are drawn apart by this part of the median edge length; 0 leaves them in one place, a
        manifold by index only.
    HoleRule, OpenLines, PlaneTolerance, SnapTolerance, progress
        See `contour_hierarchy`.
    Threads : int, default: 0
        0 takes all of the machine; the result is the same for any number.

    Returns
    -------
    Surface
        Closed, oriented outward and manifold, in the unit and the coordinate system of the contours. Cell data: Slab,
        FaceKind (0 wall, 1 cap), MappingGroup, Piece; point data: PointKind (0 contour vertex, 1 added on an edge, 2
        internal); field data: EndCapVolume, IsolatedVolume (cubic units), ContourCount, LeftOutCount and the levels.

    Raises
    ------
    Error
        Where the contours span fewer than two levels, no contour is usable, or a property has a value that it cannot
        have; the sentence says what, where, and what to do.
    NothingToDo
        Where there are open lines only.
    Aborted
        Where `progress` returned False.

    Warns
    -----
    ContourWarning
        Where more than a tenth of the contours is left out.

    Notes
    -----
    J.-D. Boissonnat and B. Geiger, Three-dimensional reconstruction of complex shapes based on the Delaunay
    triangulation, 1993; with the corrections of E. M. Vasquez Osorio, *Surface Reconstruction*, 2003.

    Examples
    --------
    >>> import numpy as np, contour_reconstruction as cr
    >>> square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    >>> loops = [np.column_stack((square, np.full(4, z))) for z in (0, 1, 2)]
    >>> surface = cr.polyhedral_surface(loops, EndCaps="Flat")
    >>> cr.certificate(surface).figures["Volume"]
    2.0
    """
    source = contours_of(contours)
    made = _core.polyhedral_surface(given(source), checked(locals()), progress)
    inherited(made, source)
    warn_of_left_out(made["field_data"])
    return make_surface(made)


def fair_surface(contours: ContoursLike, *, Tolerance: float = -1, EdgeLength: float = 0, Tension: float = -1,
                 Mapping: Choice = "Overlap", OverlapThreshold: float = 0.1, EndCaps: Choice = "Tapered",
                 IsolatedContours: Choice = "Extrude", InternalPoints: bool = True, LiftInternalPoints: bool = True,
                 ForcedJoins: Pairs = (), ForbiddenJoins: Pairs = (), MaximumGap: float = 5,
                 ExpectedPieces: int = -1, ExpectedHandles: int = -1, AlignLevels: Choice = "Automatic", HoleRule: Choice = "Automatic", OpenLines: Choice = "Leave Out",
                 PlaneTolerance: float = 0, SnapTolerance: float = 0, Threads: int = 0,
                 progress: Progress = None) -> Surface:
    """Make a smooth closed surface near contours on parallel planes, of the topology of `polyhedral_surface`.

    Parameters
    ----------
    contours : Contours or sequence of array_like of shape (k, 3)
        On two or more parallel planes. The decisions of `contour_mapping` are followed where the contours are those
        that it returned.
    Tolerance : float, default: -1
        How far the surface may leave a drawn contour, in the unit of the contours; -1: half a step where contours follow
        pixels, a twentieth of the slices' distance where they were drawn.
    EdgeLength : float, default: 0
        Of the triangles, in the unit of the contours; 0: by the slices' distance, and longer where triangles would be
        very many.
    Tension : float, default: -1
        From 0, as smooth as may be, to 1, as `polyhedral_surface`; -1: automatic.
    Mapping, OverlapThreshold, EndCaps, IsolatedContours, InternalPoints, LiftInternalPoints : optional
        See `polyhedral_surface`.
    ForcedJoins, ForbiddenJoins, MaximumGap, ExpectedPieces, ExpectedHandles, AlignLevels : optional
        See `polyhedral_surface`.
    HoleRule, OpenLines, PlaneTolerance, SnapTolerance, progress
        See `contour_hierarchy`.
    Threads : int, default: 0
        0 takes all of the machine; the result is the same for any number.

    Returns
    -------
    Surface
        Closed, oriented outward, manifold, of even triangles. Field data: Tolerance, EdgeLength and Tension that were
        chosen, FarthestVertex (distance of a contour vertex), BeyondTolerance, ThinTriangles (an angle below 5 degrees),
        HeldBackPoints (not moved, so that nothing crosses), and those of `polyhedral_surface`.

    Raises
    ------
    Error, NothingToDo, Aborted
        As `polyhedral_surface`.

    Warns
    -----
    ContourWarning
        Where more than a tenth of the contours is left out.

    Notes
    -----
    M. Botsch and L. Kobbelt, An intuitive framework for real-time freeform modeling, 2004.
    """
    source = contours_of(contours)
    made = _core.fair_surface(given(source), checked(locals(), Tolerance=(-1, math.inf)), progress)
    inherited(made, source)
    warn_of_left_out(made["field_data"])
    return make_surface(made)


def implicit_surface(contours: ContoursLike, *, Detail: Choice = "Full", Mode: Choice = "Margins",
                     Values: Choice = "Distance", Normals: Choice = "Refined", MarginDistance: float = 0,
                     ReachAcrossSteps: bool = False, MergeBox: float = 0, ThinOut: bool = True,
                     FillLongEdges: bool = True, FollowDrawnPlanes: bool = True, ResampleSpacing: float = 0,
                     ResampleTolerance: float = 0, Kernel: Choice = "Triharmonic", SupportRadius: float = 0,
                     Solver: Choice = "Automatic", Tolerance: float = 0, CentreReduction: float = 0,
                     Smoothing: float = 0, CellSize: float = 0, EndsBeyond: float = 0.4, UseBounds: bool = False,
                     Bounds: Sequence[float] = (0, 1, 0, 1, 0, 1), ClosedAtBounds: bool = True, CleanUp: bool = True,
                     SnapToContours: bool = False, MaximumCells: float = 4000000, HoleRule: Choice = "Automatic",
                     OpenLines: Choice = "Leave Out", PlaneTolerance: float = 0, SnapTolerance: float = 0,
                     Threads: int = 0, progress: Progress = None) -> Surface:
    """Make a smooth closed surface from contours on planes of any orientation, also only a few of them.

    Parameters
    ----------
    contours : Contours or sequence of array_like of shape (k, 3)
        On two or more planes.
    Detail : {"Full", "Medium", "Coarse"}
        The last two are quick previews.
    Mode : {"Margins", "Bounding Box Corners"}
        Where the function is told inside from outside.
    Values : {"Distance", "Unit"}
        What the margins are told.
    Normals : {"Refined", "In Plane"}
        Whether margins know from a first fit how oblique the surface is to the planes.
    MarginDistance : float, default: 0
        Of the margins from the contours, in the unit of the data; 0: a third of the usual distance between points.
    ReachAcrossSteps : bool, default: False
        Margins reach as far as the next slice is away where that says otherwise, for flat ends and steps.
    MergeBox : float, default: 0
        Points of crossing planes in a box of this part of the bounding box become one, 0 to 0.999.
    ThinOut : bool, default: True
        Leave out points that stand closer than the gap between the contours is worth.
    FillLongEdges : bool, default: True
        Put points on straight edges longer than twice the gap between the contours.
    FollowDrawnPlanes : bool, default: True
        Add constraints where the function is on another side than what was drawn.
    ResampleSpacing, ResampleTolerance : float, default: 0
        First resample the contours to about this distance, or leave out points where the contour moves by less, in
        the unit of the data; 0 keeps the points.
    Kernel : {"Triharmonic", "Wendland"}
        The radial basis function.
    SupportRadius : float, default: 0
        How far Wendland's function reaches, in the unit of the data; 0: a quarter of the bounding box's diagonal.
    Solver : {"Automatic", "Direct", "Iterative", "LU"}
        How the system is solved.
    Tolerance : float, default: 0
        Largest misfit that the iterative solver is content with, in the unit of the values; 0: a hundred thousandth
        of half their range.
    CentreReduction : float, default: 0
        0 makes each constraint a centre; larger: the fewest centres that miss no constraint by more.
    Smoothing : float, default: 0
        0 passes exactly through the contours; 1e-6 to 1e-3 iron out shaky drawing.
    CellSize : float, default: 0
        About the edge of the surface's triangles, in the unit of the data; 0 chooses it from the contours.
    EndsBeyond : float, default: 0.4
        Slices along an axis: how far beyond the outermost ones the solid ends at the latest, in slice distances.
    UseBounds : bool, default: False
        Follow the surface within `Bounds`: xmin, xmax, ymin, ymax, zmin, zmax.
    Bounds : sequence of 6 float
        See `UseBounds`.
    ClosedAtBounds : bool, default: True
        Close the solid where it reaches the bounds.
    CleanUp : bool, default: True
        Merge and turn triangles until none is a sliver.
    SnapToContours : bool, default: False
        Make contour points points of the mesh, where they are not closer than its cells.
    MaximumCells : float, default: 4000000
        More cells are refused.
    HoleRule, OpenLines, PlaneTolerance, SnapTolerance, progress
        See `contour_hierarchy`.
    Threads : int, default: 0
        0 takes all of the machine; the result is the same for any number.

    Returns
    -------
    Surface
        Closed, manifold and oriented outward, in the unit and the coordinate system of the contours. Point data:
        Normals; field data: CellSize, SmallestAngle (degrees), FarContourPoints, Residual, MarginDistance and
        ConstraintCount.

    Raises
    ------
    Error
        Where all contours lie in one plane, the system or the mesh would be too large, or a property has a value that
        it cannot have; the sentence says what to do.
    Aborted
        Where `progress` returned False.

    Notes
    -----
    G. Turk and J. F. O'Brien, Shape transformation using variational implicit functions, 1999; with E. M. Vasquez
    Osorio, *Surface Reconstruction*, 2003, part III.
    """
    source = contours_of(contours)
    made = _core.implicit_surface(given(source), checked(locals()), progress)
    inherited(made, source)
    return make_surface(made)


def contours_on_planes(contours: ContoursLike, planes: Union[Contours, npt.ArrayLike, None] = None, *,
                       Extrapolate: bool = False, SmallestArea: float = 0, PlaneNormal: Sequence[float] = (0, 0, 1), UseRange: bool = False,
                       Range: Sequence[float] = (0, 1), Spacing: float = 0, Mode: Choice = "Margins",
                       Values: Choice = "Distance", Normals: Choice = "Refined", MarginDistance: float = 0,
                       ReachAcrossSteps: bool = False, MergeBox: float = 0, ThinOut: bool = True,
                       FillLongEdges: bool = True, FollowDrawnPlanes: bool = True, ResampleSpacing: float = 0,
                       ResampleTolerance: float = 0, Kernel: Choice = "Triharmonic", SupportRadius: float = 0,
                       Solver: Choice = "Automatic", Tolerance: float = 0, CentreReduction: float = 0,
                       Smoothing: float = 0, CellSize: float = 0, UseBounds: bool = False,
                       Bounds: Sequence[float] = (0, 1, 0, 1, 0, 1), MaximumCells: float = 4000000,
                       HoleRule: Choice = "Automatic", OpenLines: Choice = "Leave Out", PlaneTolerance: float = 0,
                       SnapTolerance: float = 0, Threads: int = 0, progress: Progress = None) -> Contours:
    """Trace contours on any planes through the smooth surface of contours on others.

    Implicit Constraints, Implicit Function and Implicit Contours in one.

    Parameters
    ----------
    contours : Contours or sequence of array_like of shape (k, 3)
        On two or more planes of any orientation.
    planes : Contours or array_like of shape (n, 4), optional
        The planes of such contours (`read_slice_planes` gives those of a DICOM series); or a, b, c, d of each plane,
        whose points x have the product ``x @ (a, b, c) / |(a, b, c)|`` equal to d. Without it, parallel planes by the
        next four arguments.
    Extrapolate : bool, default: False
        Trace also on those of `planes` that lie beyond the outermost contour points, where nobody drew anything.
    SmallestArea : float, default: 0
        Contours that enclose less, in square units, are left out; 0: those that are smaller than a pixel of the
        images, where `planes` tell it, and than half of any contour that was drawn; negative: none.
    PlaneNormal : sequence of 3 float, default: (0, 0, 1)
        Normal of the parallel planes, of any length.
    UseRange : bool, default: False
        Planes within `Range`, offsets along the normal in the unit of the data; otherwise through all contours.
    Range : sequence of 2 float
        See `UseRange`.
    Spacing : float, default: 0
        Distance of the parallel planes, in the unit of the data; 0: a twentieth of the range.
    CellSize : float, default: 0
        Size of the squares in which contours are followed, in the unit of the data; 0 chooses it.
    Mode, Values, Normals, MarginDistance, ReachAcrossSteps, MergeBox, ThinOut, FillLongEdges, FollowDrawnPlanes, \
ResampleSpacing, ResampleTolerance, Kernel, SupportRadius, Solver, Tolerance, CentreReduction, Smoothing, UseBounds, \
Bounds, MaximumCells, HoleRule, OpenLines, PlaneTolerance, SnapTolerance, Threads, progress
        See `implicit_surface`.

    Returns
    -------
    Contours
        Closed, oriented and nested, with the data that `contour_hierarchy` gives.

    Raises
    ------
    Error
        Where no plane meets the surface, and as `implicit_surface` does.
    """
    source = contours_of(contours)
    if planes is None or isinstance(planes, Contours):
        where: Any = given_planes(planes) if isinstance(planes, Contours) else None
    else:
        where = [[float(number) for number in plane] for plane in planes]  # type: ignore[union-attr]
        if any(len(plane) != 4 for plane in where):
            raise _core.Error("Planes are four numbers each: a normal and an offset along it.")
    made = _core.contours_on_planes(given(source), where, checked(locals()), progress)
    del made["source"]  # what is said of a drawn contour is not said of a traced one
    inherited(made, source)
    return make_contours(made)


def certificate(surface: SurfaceLike, contours: Optional[ContoursLike] = None, *, Weld: bool = False,
                Threads: int = 0, progress: Progress = None) -> Certificate:
    """Say what may be trusted about a surface, and where it is wrong; nothing is moved or repaired.

    Parameters
    ----------
    surface : Surface or tuple (points, triangles)
        Triangles made by this package or by anything else: points of shape (n, 3), triangles of shape (m, 3).
    contours : Contours or sequence of array_like of shape (k, 3), optional
        What the surface was made from, for distances and sections.
    Weld : bool, default: False
        Take points of equal coordinates for one, for surfaces from formats without connectivity.
    Threads : int, default: 0
        0 takes all of the machine; the result is the same for any number.
    progress : callable, optional
        See `contour_hierarchy`.

    Returns
    -------
    Certificate
        Every figure by its name, of the whole and of each connected component.

    Raises
    ------
    Error
        Where a triangle names a point that there is not, or a coordinate is not finite.
    """
    points, triangles, rounding = surface_of(surface)
    source = None if contours is None else contours_of(contours)
    made = _core.certificate(points, triangles, None if source is None else given(source), rounding,
                             checked(locals()), progress)
    del made["warning"]
    return Certificate(**made)
