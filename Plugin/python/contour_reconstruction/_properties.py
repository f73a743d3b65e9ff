# SPDX-License-Identifier: GPL-3.0-or-later
"""What the nodes' properties may be: the texts of choices and the ranges of numbers, as the ParaView XML has them."""
from __future__ import annotations

import math
from typing import Any

from ._core import Error

#: Property -> text -> number. Case, blanks and hyphens of a text do not count.
CHOICES: dict[str, dict[str, int]] = {
    "HoleRule": {"Automatic": 0, "Even-Odd": 1, "Winding": 2, "Keyhole": 3},
    "OpenLines": {"Leave Out": 0, "Chord": 1, "Border": 2},
    "Mapping": {"Proximity": 0, "Overlap": 1},
    "EndCaps": {"Flat": 0, "HalfSlice": 1, "Tapered": 2, "None": 3, "Extrapolated": 4},
    "IsolatedContours": {"Drop": 0, "Extrude": 1},
    "AlignLevels": {"Off": 0, "Automatic": 1, "On": 2},
    "Detail": {"Full": 0, "Medium": 1, "Coarse": 2},
    "Mode": {"Margins": 0, "Bounding Box Corners": 1},
    "Values": {"Unit": 0, "Distance": 1},
    "Normals": {"In Plane": 0, "Refined": 1},
    "Kernel": {"Triharmonic": 0, "Wendland": 1},
    "Solver": {"Automatic": 0, "LU": 1, "Direct": 2, "Iterative": 3},
    "GenerationAlgorithm": {"Automatic": 0, "Semiautomatic": 1, "Manual": 2},
    "Holes": {"Separate Contours": 0, "XOR": 1, "Keyholes": 2},
}

#: Property -> the least and the largest value.
RANGES: dict[str, tuple[float, float]] = {
    "PlaneTolerance": (0, math.inf),
    "SnapTolerance": (0, math.inf),
    "OverlapThreshold": (0, 0.99),
    "MaximumGap": (0, math.inf),
    "ExpectedPieces": (-1, math.inf),
    "ExpectedHandles": (-1, math.inf),
    "PinchGap": (0, 0.1),
    "MarginDistance": (0, math.inf),
    "MergeBox": (0, 0.999),
    "ResampleSpacing": (0, math.inf),
    "ResampleTolerance": (0, math.inf),
    "SupportRadius": (0, math.inf),
    "Tolerance": (0, math.inf),
    "CentreReduction": (0, math.inf),
    "Smoothing": (0, math.inf),
    "CellSize": (0, math.inf),
    "EndsBeyond": (0, math.inf),
    "EdgeLength": (0, math.inf),
    "Tension": (-1, 1),
    "Spacing": (0, math.inf),
    "MaximumCells": (1, math.inf),
    "SmallestArea": (-math.inf, math.inf),
    "SliceSpacing": (-math.inf, math.inf),
    "PixelSize": (0, math.inf),
}

#: Property -> how many numbers it has.
TUPLES: dict[str, int] = {"Bounds": 6, "PlaneNormal": 3, "Range": 2}

FLAGS = frozenset({
    "ParallelPlanesOnly", "InternalPoints", "LiftInternalPoints", "ReachAcrossSteps", "ThinOut", "FillLongEdges",
    "FollowDrawnPlanes", "UseBounds", "ClosedAtBounds", "CleanUp", "SnapToContours", "UseRange", "Weld",
    "Extrapolate",
    "CopyReferenceROIs",
})
#: Whole numbers among RANGES, as the core counts them.
WHOLE = frozenset({"ExpectedPieces", "ExpectedHandles"})
LARGEST_WHOLE = 2**31 - 1
PAIRS = frozenset({"ForcedJoins", "ForbiddenJoins"})
TEXTS = frozenset({"ReferenceFileName", "StructureSetLabel", "FrameOfReferenceUID"})
MOST_THREADS = 1024


def _plain(text: Any) -> str:
    return str(text).lower().replace(" ", "").replace("-", "")


def _choice(name: str, value: Any) -> int:
    choices = CHOICES[name]
    if isinstance(value, int) and not isinstance(value, bool) and value in choices.values():
        return value
    for text, number in choices.items():
        if _plain(text) == _plain(value):
            return number
    texts = list(choices)
    raise Error(f"{name} is {value!r}: give {', '.join(texts[:-1])} or {texts[-1]}.")


def _number(name: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise Error(f"{name} is {value!r}, which is no number.") from None
    if not math.isfinite(number):
        raise Error(f"{name} is {value!r}, which is no finite number.")
    return number


def _in_range(name: str, value: Any, limits: tuple[float, float]) -> float:
    number = _number(name, value)
    least, most = limits
    if not least <= number <= most:
        bounds = f"at least {least:g}" if math.isinf(most) else f"from {least:g} to {most:g}"
        raise Error(f"{name} is {number:g}: it must be {bounds}.")
    return number


def _whole(name: str, value: Any, limits: tuple[float, float]) -> int:
    number = _in_range(name, value, (limits[0], min(limits[1], LARGEST_WHOLE)))
    if number != int(number):
        raise Error(f"{name} is {value!r}, which is no whole number.")
    return int(number)


def _tuple(name: str, value: Any) -> tuple[float, ...]:
    try:
        numbers = tuple(_number(name, number) for number in value)
    except TypeError:
        numbers = ()
    if len(numbers) != TUPLES[name]:
        raise Error(f"{name} is {value!r}: it takes {TUPLES[name]} numbers.")
    return numbers


def _pairs(name: str, value: Any) -> list[tuple[int, int]]:
    try:
        return [(int(first), int(second)) for first, second in value]
    except (TypeError, ValueError):
        raise Error(f"{name} is {value!r}: give pairs of ContourId, such as [(3, 7)].") from None


def checked(values: dict[str, Any], **ranges: tuple[float, float]) -> dict[str, Any]:
    """The values as the core wants them.

    Parameters
    ----------
    values : dict
        Property -> what the user gave; names that are no property are left aside.
    **ranges : tuple of float
        Ranges that differ from those in `RANGES`.

    Raises
    ------
    Error
        Where a value is none that the property can have; the sentence says which it can.
    """
    limits = {**RANGES, **ranges}
    result: dict[str, Any] = {}
    for name, value in values.items():
        if name in CHOICES:
            result[name] = _choice(name, value)
        elif name in WHOLE:
            result[name] = _whole(name, value, limits[name])
        elif name in limits:
            result[name] = _in_range(name, value, limits[name])
        elif name in FLAGS:
            result[name] = bool(value)
        elif name in TUPLES:
            result[name] = _tuple(name, value)
        elif name in PAIRS:
            result[name] = _pairs(name, value)
        elif name in TEXTS:
            result[name] = str(value)
        elif name == "Threads":
            result[name] = _whole(name, value, (0, MOST_THREADS))
    return result
