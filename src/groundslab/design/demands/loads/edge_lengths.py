"""The plate's edge inside a part of the plate: its nodes, and the length that each of them has there."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.arrays import Array, Integers, made_once_by
from groundslab.design.demands.perimeters import SIDE_CHORDS
from groundslab.fem.mesh import SIDES, sides_on_boundary
from groundslab.fem.shape_functions import gauss_line, lagrange
from groundslab.geometry.places import same_place
from groundslab.results.plate_result import PlateResult

if TYPE_CHECKING:
    from shapely import Polygon

#: Parts of the plate's edge that lie so near to a polygon are in it, over the rounding of places.
ON_EDGE = 2.0
#: A side is curved if its middle lies off its chord by more than this, over its length.
CURVED = 1e-9


class _Edge(NamedTuple):
    """The sides of elements along a plate's edge, and boxes around them."""

    sides: Integers  # (s, 3): end, middle, end
    low: Array  # (s, 2) [m]
    high: Array  # (s, 2) [m]
    rounding: float  # places closer than this are one [m]


def edge_inside(plate: PlateResult, part: Polygon) -> tuple[Integers, Array]:
    """Return the nodes (e,) on the plate's edge inside a polygon, and int N ds (e,) [m] over the edge there."""
    edge = _edge(plate)
    x0, y0, x1, y1 = part.bounds
    (low_x, low_y), (high_x, high_y) = edge.low.T, edge.high.T
    sides = edge.sides[(low_x <= x1) & (low_y <= y1) & (high_x >= x0) & (high_y >= y0)]
    total = np.zeros(len(plate.nodes))
    if len(sides):
        places = plate.nodes[sides]
        side, low, high = _intervals(places, part.buffer(ON_EDGE * edge.rounding))
        np.add.at(total, sides[side], _shares(places[side], low, high))
    nodes = np.flatnonzero(total)
    return nodes, total[nodes]


@made_once_by(attrgetter("nodes", "elements"))
def _edge(plate: PlateResult) -> _Edge:
    sides = _edge_sides(plate)
    places = plate.nodes[sides]
    (low_x, low_y), (high_x, high_y) = plate.nodes.min(axis=0), plate.nodes.max(axis=0)
    return _Edge(sides, places.min(axis=1), places.max(axis=1), same_place(low_x, high_x, low_y, high_y))


def _edge_sides(plate: PlateResult) -> Integers:
    # the border of two sections is no edge: its nodes stand once for each section, at exactly the same place
    _, same = np.unique(plate.nodes + 0.0, axis=0, return_inverse=True)
    elements = same.reshape(-1)[plate.elements]
    on_edge = np.isin(elements[:, SIDES[:, 2]], sides_on_boundary(elements)[:, 2])
    sides: Integers = plate.elements[:, SIDES][on_edge][:, [0, 2, 1]]
    return sides


def _intervals(x: Array, part: Polygon) -> tuple[Integers, Array, Array]:
    """Return which of the sides (s, 3, 2) lie inside a polygon (k,), and from where to where in t of -1 to 1 (k,)."""
    off = np.abs(x[:, 1] - (x[:, 0] + x[:, 2]) / 2).max(axis=1)
    curved = off > CURVED * np.ptp(x, axis=1).max(axis=1)
    chords = ((1, np.flatnonzero(~curved)), (SIDE_CHORDS, np.flatnonzero(curved)))
    intervals = [(sides, *_intervals_of_chords(x[sides], part, n)) for n, sides in chords if len(sides)]
    side = np.concatenate([sides[which] for sides, which, _, _ in intervals])
    low, high = (np.concatenate([interval[i] for interval in intervals]) for i in (2, 3))
    return side, low, high


def _intervals_of_chords(x: Array, part: Polygon, n: int) -> tuple[Integers, Array, Array]:
    """Return the intervals of sides (s, 3, 2), each followed by n chords, as `_intervals` does."""
    from shapely import get_coordinates, get_num_coordinates, get_parts, intersection, length, linestrings

    t = np.linspace(-1, 1, n + 1)
    points = lagrange(t)[0] @ x
    ends = np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 2)
    pieces, chord = get_parts(intersection(linestrings(ends), part), return_index=True)
    solid = length(pieces) > 0
    pieces, chord = pieces[solid], chord[solid]
    last = np.cumsum(get_num_coordinates(pieces)) - 1
    first = np.concatenate([[0], last[:-1] + 1])[: len(last)]
    a, run = ends[chord, 0], ends[chord, 1] - ends[chord, 0]
    offsets = get_coordinates(pieces)[np.stack([first, last])] - a
    low, high = np.sort((offsets * run).sum(axis=2) / (run * run).sum(axis=1), axis=0)
    start, step = t[chord % n], 2 / n
    return chord // n, start + step * low, start + step * high


def _shares(x: Array, low: Array, high: Array) -> Array:
    """Return int N ds (k, 3) [m] of sides (k, 3, 2) from t = low (k,) to t = high (k,)."""
    t, weights = gauss_line(3)
    half = (high - low)[:, None] / 2
    N, dN = lagrange((low + high)[:, None] / 2 + half * t)
    ds = np.linalg.norm(dN @ x, axis=2) * weights * half
    return np.asarray(np.einsum("kp,kpa->ka", ds, N))
