"""Straight lines through a mesh, element by element: where they cross its sides, and which element holds each piece."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.mesh import SIDES, Mesh, boxes_of, local_coordinates, locate
from groundslab.fem.shape_functions import gauss_line, q9_values

#: Nodes closer than this to the line, relative to its length, lie on it; shorter pieces are nothing but rounding.
ON_LINE = 1e-9
#: Gauss points of a piece: exact for products of two biquadratic functions where the elements are parallelograms.
PIECE_POINTS = 5


@dataclass(frozen=True, slots=True)
class Pieces:
    """Parts of a polyline that lie in one element each, in the order of the line; what lies off the mesh is left out.

    A piece runs from s = low to s = high [m], counted along the whole polyline, on the polyline's straight leg `leg`.
    """

    ends: Array  # (l, 2, 2): start and end of each leg [m]
    start: Array  # (l,): s at the start of each leg [m]
    leg: Integers  # (p,)
    low: Array  # (p,) [m]
    high: Array  # (p,) [m]
    element: Integers  # (p,)

    @property
    def length(self) -> Array:
        """Return the length of each piece (p,) [m]."""
        return self.high - self.low

    @property
    def along(self) -> Array:
        """Return the unit vector along each leg (l, 2)."""
        run = self.ends[:, 1] - self.ends[:, 0]
        unit: Array = run / np.linalg.norm(run, axis=1, keepdims=True)
        return unit

    def points(self, piece: Integers, s: Array) -> Array:
        """Return the places (k, 2) [m] at s (k,) [m] on pieces (k,)."""
        leg = self.leg[piece]
        places: Array = self.ends[leg, 0] + (s - self.start[leg])[:, None] * self.along[leg]
        return places

    def gauss(self) -> tuple[Integers, Array, Array]:
        """Return Gauss points on all pieces, (p PIECE_POINTS,): their piece, s [m] and weight [m]."""
        x, weights = gauss_line(PIECE_POINTS)
        s = ((self.low + self.high)[:, None] + self.length[:, None] * x) / 2
        ds = self.length[:, None] / 2 * weights
        return np.repeat(np.arange(len(self.low)), PIECE_POINTS), s.ravel(), ds.ravel()


def pieces(mesh: Mesh, ends: Array) -> Pieces:
    """Return the pieces of straight legs (l, 2, 2) [m], none of them of no length, in the mesh's elements.

    A piece along the common side of two elements belongs to one of them.
    """
    import shapely

    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    start = np.concatenate([[0.0], np.cumsum(length)[:-1]])
    boxes = boxes_of(mesh)
    leg, low, high = [], [], []
    for i, (a, b) in enumerate(ends):
        near = boxes.query(shapely.LineString([a, b]), predicate="dwithin", distance=ON_LINE * length[i])
        s = _crossings(mesh.nodes[mesh.elements[near]], a, b)
        leg.append(np.full(len(s) - 1, i))
        low.append(start[i] + s[:-1])
        high.append(start[i] + s[1:])
    legs, lows, highs = np.concatenate(leg), np.concatenate(low), np.concatenate(high)
    all_of_it = Pieces(ends, start, legs, lows, highs, np.full(len(legs), -1))
    element, _ = locate(mesh, all_of_it.points(np.arange(len(legs)), (lows + highs) / 2), boxes=boxes)
    on = element >= 0
    return Pieces(ends, start, legs[on], lows[on], highs[on], element[on])


def interpolation(mesh: Mesh, line: Pieces, piece: Integers, s: Array) -> tuple[Integers, Array]:
    """Return nodes and shape functions, (k, 9) each, at s (k,) [m] on pieces (k,), each by its own element.

    At the end of a piece this is the limit from within its element.
    """
    element = line.element[piece]
    N = q9_values(local_coordinates(mesh, element, line.points(piece, s)))
    return mesh.elements[element], N


def is_continuous(mesh: Mesh, line: Pieces) -> Flags:
    """Return for each piece (p,) whether it goes on from the one before in the same region of the mesh.

    It does if there is nothing between them and their elements have a node in common: across the border of two
    sections of a plate they have none.
    """
    on = np.zeros(len(line.low), dtype=bool)
    before, after = mesh.elements[line.element[:-1]], mesh.elements[line.element[1:]]
    shared = (before[:, :, None] == after[:, None, :]).any(axis=(1, 2))
    on[1:] = shared & (np.abs(line.low[1:] - line.high[:-1]) <= 10 * ON_LINE * line.high.max(initial=0))
    return on


def _crossings(xy: Array, a: Array, b: Array) -> Array:
    """Return ascending s (k,) [m] from 0 to the length, where a leg meets sides or corners of elements xy (m, 9, 2).

    Along a side the distance d from the leg is a quadratic in the side's own coordinate t, so that curved sides are
    met where they are.
    """
    length = np.linalg.norm(b - a)
    along = (b - a) / length
    normal = np.array([along[1], -along[0]])
    side = xy[:, SIDES].reshape(-1, 3, 2) - a
    d, s = side @ normal, side @ along
    near = np.abs(d) <= ON_LINE * length
    on = s[:, :2][near[:, :2]]
    c, slope, bend = d[:, 2], (d[:, 1] - d[:, 0]) / 2, (d[:, 0] + d[:, 1]) / 2 - d[:, 2]
    bend = np.where(np.abs(bend) <= ON_LINE * np.ptp(side, axis=1).max(axis=1, initial=0), 0.0, bend)
    root = slope**2 - 4 * bend * c
    q = -(slope + np.where(slope < 0, -1.0, 1.0) * np.sqrt(np.maximum(root, 0))) / 2
    nowhere = np.full_like(q, 2.0)
    t = np.stack([np.divide(c, q, out=nowhere, where=q != 0), np.divide(q, bend, out=nowhere.copy(), where=bend != 0)])
    crossed = (np.abs(t) <= 1) & (root >= 0) & ~near.all(axis=1)  # a side that lies on the leg is not crossed
    s_of_t = s[:, 2] + t * (s[:, 1] - s[:, 0]) / 2 + t**2 * ((s[:, 0] + s[:, 1]) / 2 - s[:, 2])
    crossings = np.unique(np.concatenate([on, s_of_t[crossed]]))
    inside = crossings[(crossings > ON_LINE * length) & (crossings < (1 - ON_LINE) * length)]
    apart = np.diff(inside, prepend=-np.inf) > ON_LINE * length
    return np.concatenate([[0.0], inside[apart], [length]])
