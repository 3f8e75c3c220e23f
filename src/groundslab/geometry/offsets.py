"""Edges and closed curves at a distance beside others."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import FLAT, Place, Ring, Segment

#: Edges that meet at a smaller angle [rad] run on smoothly: both have the same corner beside them.
SMOOTH = 1e-6
#: Steps of Newton's method towards a corner between arcs, of which a few are enough if there is one.
STEPS = 30


class NoRoomError(Exception):
    """There is no curve at a distance beside an edge, as it is too short or too tightly bent."""

    def __init__(self, number: int | None) -> None:
        super().__init__(number)
        self.number = number  # of the edge, from 1; None if the curve meets itself


def parallel(edge: Segment, distance: float) -> Segment:
    """Return the edge at a distance to the left of another one, to the right if that is negative [m]."""
    ends = np.array([0.0, 1.0])
    start, end = map(tuple, (edge.at(ends) + distance * edge.left(ends)).tolist())
    return replace(edge, start=start, end=end, radius=_radius_beside(edge, distance))


def _radius_beside(edge: Segment, distance: float) -> float:
    """Return the radius at a distance to the left of an edge [m], 0 of a straight one."""
    return 0.0 if edge.straight else edge.radius - math.copysign(distance, distance * edge.sweep)


def counterclockwise(ring: Ring) -> tuple[Segment, ...]:
    """Return the edges of a closed curve in their order, each in the direction that has the inside to its left."""
    edges = ring.segments()
    return edges if ring.signed_area > 0 else tuple(map(_reverse, edges))


def _reverse(edge: Segment) -> Segment:
    return replace(edge, start=edge.end, end=edge.start, angle=edge.angle + edge.sweep, sweep=-edge.sweep)


def inset(ring: Ring, distance: float) -> Ring:
    """Return the closed curve at a distance [m] inside another one, counterclockwise, its corners mitered.

    Raises
    ------
    NoRoomError
        If an edge has none at this distance, or if the curve meets itself.
    """
    edges = counterclockwise(ring)
    numbers = list(range(1, 1 + len(edges)))
    if ring.signed_area < 0:
        edges, numbers = edges[::-1], numbers[::-1]
    corners = [_corner(edges[k - 1], edges[k], distance, numbers[k]) for k in range(len(edges))]
    ends = zip(corners, [*corners[1:], corners[0]], strict=True)
    bulges = [
        _bulge(edge, start, end, distance, number)
        for edge, (start, end), number in zip(edges, ends, numbers, strict=True)
    ]
    beside = Ring(tuple(corners), tuple(bulges) if any(bulges) else ())
    if not beside.polygon(FLAT * max(ring.sides)).is_valid:
        raise NoRoomError(None)
    return beside


def _corner(before: Segment, after: Segment, distance: float, number: int) -> Place:
    """Return the corner to the left of where two edges meet."""
    here = np.array(after.start)
    normal_before, normal_after = before.left(np.array([1.0]))[0], after.left(np.array([0.0]))[0]
    cosine = float(normal_before @ normal_after)
    place: Array = here + distance * (normal_before + normal_after) / (1 + cosine)
    turns = abs(math.remainder(after.direction(0.0) - before.direction(1.0), 2 * math.pi)) > SMOOTH
    if turns and not (before.straight and after.straight):
        place = _meet((before, after), distance, place, number)
    return _on_axes((before, after), distance, place)


def _meet(edges: Sequence[Segment], distance: float, place: Array, number: int) -> Array:
    """Return where the curves beside two edges meet near a place, by Newton's method."""
    size = max(edge.length for edge in edges)
    for _ in range(STEPS):
        off, normals = zip(*(_beside(edge, distance, place) for edge in edges), strict=True)
        jacobian = np.array(normals)
        if abs(np.linalg.det(jacobian)) < SMOOTH:
            break
        step = np.linalg.solve(jacobian, np.array(off))
        place = place - step
        if np.linalg.norm(step) <= 1e-14 * size:
            return place
    raise NoRoomError(number)


def _beside(edge: Segment, distance: float, place: Array) -> tuple[float, Array]:
    """Return how far a place is off the curve beside an edge [m], and the direction in which that grows."""
    if edge.straight:
        normal: Array = edge.left(np.array([0.0]))[0]
        return float((place - np.array(edge.start)) @ normal) - distance, normal
    outwards = place - np.array(edge.centre)
    radius = float(np.linalg.norm(outwards))
    return radius - _radius_beside(edge, distance), outwards / radius


def _on_axes(edges: Sequence[Segment], distance: float, place: Array) -> Place:
    """Return a place on the lines beside those of two edges that run along x or y, to the last digit."""
    x, y = place.tolist()
    for edge in edges:
        if edge.straight and edge.start[0] == edge.end[0]:
            x = edge.start[0] - math.copysign(distance, edge.end[1] - edge.start[1])
        elif edge.straight and edge.start[1] == edge.end[1]:
            y = edge.start[1] + math.copysign(distance, edge.end[0] - edge.start[0])
    return x, y


def _bulge(edge: Segment, start: Place, end: Place, distance: float, number: int) -> float:
    """Return the bulge of the curve beside an edge between two corners, which runs as the edge does."""
    if edge.straight:
        along = np.array(edge.end) - np.array(edge.start)
        if float(along @ (np.array(end) - np.array(start))) <= 0:
            raise NoRoomError(number)
        return 0.0
    if _radius_beside(edge, distance) <= 0:
        raise NoRoomError(number)
    angles = (math.atan2(y - edge.centre[1], x - edge.centre[0]) for x, y in (start, end))
    at_start, at_end = (
        math.remainder(angle - old, 2 * math.pi)
        for angle, old in zip(angles, (edge.angle, edge.angle + edge.sweep), strict=True)
    )
    sweep = edge.sweep + at_end - at_start
    if sweep * edge.sweep <= 0:
        raise NoRoomError(number)
    return math.tan(sweep / 4)
