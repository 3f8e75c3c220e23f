"""Meshes that have corners only: their sides, the arcs these lie on, and the angles between them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Integers


class FixedSides(NamedTuple):
    """What must stay where the plan has it: sides on edges, with center and radius where these are arcs, and nodes."""

    ends: Integers  # (e, 2)
    centre: Array  # (e, 2)
    radius: Array  # (e,), 0 on straight edges
    points: Integers  # (p,)


class Cells(NamedTuple):
    """A mesh that has corners only: triangles and quadrilaterals."""

    nodes: Array  # (n, 2)
    triangles: Integers  # (t, 3)
    quadrilaterals: Integers  # (q, 4)
    drawn: FixedSides


def sides_of(cells: Integers, n: int) -> Integers:
    """Return a number for each side of each cell, the same one for the same two nodes whatever their order."""
    after = np.roll(cells, -1, axis=1)
    keys: Integers = np.minimum(cells, after) * n + np.maximum(cells, after)
    return keys


def keys_of(ends: Integers, n: int) -> Integers:
    """Return the numbers that `sides_of` gives to sides with these ends (e, 2)."""
    keys: Integers = ends.min(axis=1) * n + ends.max(axis=1)
    return keys


def middles_of(nodes: Array, keys: Integers, drawn: FixedSides) -> Array:
    """Return the middles (u, 2) of sides given by ascending keys (u,), on the arcs where there are any."""
    n = len(nodes)
    middles: Array = (nodes[keys // n] + nodes[keys % n]) / 2
    place = np.searchsorted(keys, keys_of(drawn.ends, n))
    place = np.minimum(place, len(keys) - 1)
    curved = (drawn.radius > 0) & (keys[place] == keys_of(drawn.ends, n))
    place = place[curved]
    middles[place] = project_onto(middles[place], drawn.centre[curved], drawn.radius[curved])
    return middles


def project_onto(places: Array, centre: Array, radius: float | Array) -> Array:
    """Return places moved onto circles, towards the center or away from it."""
    offset = places - centre
    moved: Array = centre + np.reshape(radius, (-1, 1)) * offset / np.linalg.norm(offset, axis=1)[:, None]
    return moved


def angles_of(nodes: Array, cells: Integers, drawn: FixedSides) -> Array:
    """Return the angles inside at the corners of cells [rad], between the tangents where sides are arcs."""
    keys, number = np.unique(sides_of(cells, len(nodes)), return_inverse=True)
    middle = middles_of(nodes, keys, drawn)[number.reshape(cells.shape)]
    here = nodes[cells]
    to = 4 * middle - 3 * here - np.roll(here, -1, axis=1)
    back = 4 * np.roll(middle, 1, axis=1) - 3 * here - np.roll(here, 1, axis=1)
    turn = np.arctan2(back[..., 1], back[..., 0]) - np.arctan2(to[..., 1], to[..., 0])
    angles: Array = np.mod(turn, 2 * math.pi)
    return angles


def least_sine(xy: Array) -> Array:
    """Return the least sine of the four angles of quadrilaterals (q, 4, 2), negative where one is inverted."""
    to = np.roll(xy, -1, axis=1) - xy
    back = np.roll(xy, 1, axis=1) - xy
    cross = to[..., 0] * back[..., 1] - to[..., 1] * back[..., 0]
    sine: Array = (cross / np.maximum(np.linalg.norm(to, axis=2) * np.linalg.norm(back, axis=2), 1e-300)).min(axis=1)
    return sine
