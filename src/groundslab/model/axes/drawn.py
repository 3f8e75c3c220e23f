"""How axes are drawn in plan: how far they reach over the plates, and where the bubbles with their names are."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Place
from groundslab.model.axes.families import AnyAxes, Axis

#: Over the longer side of the plates: how far axes reach beyond them, and the radius of their bubbles.
OVER, BUBBLE = 0.02, 0.018
#: Where along a ring its bubble is, counterclockwise from x [rad], and the angle of the chords that it is drawn with.
AT_RING, CHORD = math.radians(22.5), math.radians(3)

#: A rectangle x0, x1, y0, y1 [m].
Bounds = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class DrawnAxis:
    """The name of an axis, the points (k, 2) that its line runs through, and the middle of its bubble [m]."""

    name: str
    points: Array
    bubble: Place
    radius: float


def drawn_axes(families: Iterable[AnyAxes], bounds: Bounds) -> list[DrawnAxis]:
    """Return how axes are drawn over plates within a rectangle x0, x1, y0, y1 [m]."""
    axes = [axis for family in families for axis in family.axes]
    return [_drawn(axis, axes, bounds) for axis in axes]


def limits_with_axes(limits: Bounds, families: Sequence[AnyAxes], bounds: Bounds) -> Bounds:
    """Return limits of a plan x0, x1, y0, y1 [m] that hold the bubbles of axes, too."""
    x0, x1, y0, y1 = limits
    for axis in drawn_axes(families, bounds):
        (x, y), off = axis.bubble, 1.3 * axis.radius
        x0, x1, y0, y1 = min(x0, x - off), max(x1, x + off), min(y0, y - off), max(y1, y + off)
    return x0, x1, y0, y1


def _drawn(axis: Axis, axes: Sequence[Axis], bounds: Bounds) -> DrawnAxis:
    """Return how one of some axes is drawn."""
    x0, x1, y0, y1 = bounds
    side = max(x1 - x0, y1 - y0)
    radius = BUBBLE * side
    x, y = axis.place
    if axis.direction is None:
        turns = np.linspace(0.0, 2 * math.pi, round(2 * math.pi / CHORD) + 1)
        circle = np.stack([x + axis.radius * np.cos(turns), y + axis.radius * np.sin(turns)], axis=1)
        return DrawnAxis(
            axis.name, circle, (x + axis.radius * math.cos(AT_RING), y + axis.radius * math.sin(AT_RING)), radius
        )
    u, v = _upwards(axis)
    corners = [((a - x) * u + (b - y) * v) for a in (x0, x1) for b in (y0, y1)]
    start, end = min(corners) - OVER * side, max(corners) + OVER * side
    if axis.ray:
        rings = [ring.radius for ring in axes if ring.direction is None and ring.place == axis.place]
        start, end = 0.0, max(rings) + 2 * OVER * side if rings else max(end, OVER * side)
    line = np.array([(x + start * u, y + start * v), (x + end * u, y + end * v)])
    return DrawnAxis(axis.name, line, (x + (end + radius) * u, y + (end + radius) * v), radius)


def _upwards(axis: Axis) -> Place:
    """Return the direction of a straight axis towards its bubble: upwards, or to the right; outwards of a ray."""
    assert axis.direction is not None
    u, v = axis.direction
    leading = v if abs(v) >= abs(u) else u
    return (u, v) if axis.ray or leading > 0 else (-u, -v)
