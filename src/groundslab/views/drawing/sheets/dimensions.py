"""Chains of dimensions below a plan and at its left."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

import numpy as np

from groundslab.arrays import Array
from groundslab.design.bars.positions import to_cut
from groundslab.languages import Translator
from groundslab.messages import Message
from groundslab.unit_systems import INCH, System
from groundslab.views.drawing.shapes import Line, Shape, Text
from groundslab.views.drawing.sheets.paper import LETTERS
from groundslab.views.drawing.sheets.placing import width_of

LAYER = "DIMENSIONS"
#: Points of a chain that are nearer to each other are one [m].
ALIKE = 1e-3
#: From a line to the number over it, from one level of numbers to the next, and half of a tick [mm].
OVER, LEVEL, TICK = 0.8, 3.3, 1.2


def points_of(values: Sequence[float]) -> list[float]:
    """Return the points of a chain in order, each once [m]."""
    ordered = np.unique(np.asarray(values, dtype=float))
    apart = np.concatenate([[True], np.diff(ordered) > ALIKE]) if len(ordered) else np.array([], dtype=bool)
    return [float(value) for value in ordered[apart]]


def written(length: float, units: System = "SI") -> str:
    """Return a length [m] in meters with two decimals, or three where it has so many, or in feet and inches.

    Those are given to an eighth of an inch.

    Examples
    --------
    >>> written(3.75), written(3.7592, "US"), written(0.1524, "US")
    ('3.75', '12\'-4"', '0\'-6"')
    """
    if units == "US":
        eighths = round(length / INCH * 8)
        feet, eighths = divmod(eighths, 96)
        inches, eighths = divmod(eighths, 8)
        return f"{feet}'-{inches}{f' {Fraction(eighths, 8)}' if eighths else ''}\""
    text = f"{length:.3f}"
    return text[:-1] if text.endswith("0") else text


def long_words(lengths: Sequence[float] | Array, units: System) -> str:
    """Return how long bars of lengths (k,) [m] are cut, in words."""
    low, high = (written(float(find(to_cut(np.asarray(lengths), units))), units) for find in (np.min, np.max))
    long = high if low == high else Message("{low} to {high}", low=low, high=high)
    if units == "US":
        return Message("l = {long}", long=long)
    return Message("l = {long} {unit}", long=long, unit="m")


def levels_of(points: Sequence[float], per_meter: float, units: System) -> list[int]:
    """Return on which level over the line each number stands, so that none covers another."""
    ends: list[float] = []  # of the last number on each level [mm]
    levels = []
    for low, high in pairwise(points):
        half = width_of(written(high - low, units), LETTERS) / 2
        middle = (low + high) / 2 * per_meter
        level = next((n for n, end in enumerate(ends) if middle - half >= end), len(ends))
        ends[level : level + 1] = [middle + half + 1.0]
        levels.append(level)
    return levels


def depth_of(points: Sequence[float], per_meter: float, units: System) -> float:
    """Return how much a chain needs across, with its numbers [mm]."""
    return OVER + LEVEL * (1 + max(levels_of(points, per_meter, units), default=0)) + TICK


def chain(
    points: Sequence[float],
    axis: int,
    at: float,
    origin: tuple[float, float],
    per_meter: float,
    units: System,
    say: Translator,
) -> Iterator[Shape]:
    """Yield a chain of dimensions between points [m] along an axis, its line at a place across [mm].

    Numbers stand over the line, or at its left.
    """
    places = [origin[axis] + point * per_meter for point in points]
    yield _line(axis, places[0], places[-1], at)
    for place in places:
        slash = TICK * np.array([[-1.0, -1.0], [1.0, 1.0]])
        yield Line(LAYER, _place(axis, place, at) + slash)
    levels = levels_of(points, per_meter, units)
    for (low, high), (start, end), level in zip(pairwise(places), pairwise(points), levels, strict=True):
        words = say(written(end - start, units))
        along = (low + high) / 2 - width_of(words, LETTERS) / 2
        across = OVER + level * LEVEL
        if axis == 0:
            yield Text(LAYER, (along, at + across), LETTERS, words)
        else:
            yield Text(LAYER, (at - across, along), LETTERS, words, 90.0)


def _place(axis: int, along: float, across: float) -> np.ndarray:
    return np.array([along, across] if axis == 0 else [across, along])


def _line(axis: int, start: float, end: float, at: float) -> Line:
    return Line(LAYER, np.array([_place(axis, start, at), _place(axis, end, at)]))
