"""Meshes that have corners only: their sides, the arcs these lie on, and the angles between them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers


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


def find_sides(keys: Integers, ends: Integers, n: int) -> tuple[Integers, Flags]:
    """Return places among ascending numbers of `sides_of` of sides with these ends (e, 2), and which are there."""
    if not len(keys):
        return np.zeros(len(ends), dtype=np.int64), np.zeros(len(ends), dtype=bool)
    wanted = ends.min(axis=1) * n + ends.max(axis=1)
    place = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
    return place, keys[place] == wanted


def sort_by_corners(polygons: Iterable[list[int]]) -> tuple[Integers, Integers]:
    """Return triangles (t, 3) and quadrilaterals (q, 4) apart."""
    kinds: dict[int, list[list[int]]] = {3: [], 4: []}
    for corners in polygons:
        kinds[len(corners)].append(corners)
    three, four = (np.array(rows, dtype=np.int64).reshape(-1, n) for n, rows in kinds.items())
    return three, four


def middles_of(nodes: Array, keys: Integers, drawn: FixedSides) -> Array:
    """Return the middles (u, 2) of sides given by ascending keys (u,), on the arcs where there are any."""
    n = len(nodes)
    middles: Array = (nodes[keys // n] + nodes[keys % n]) / 2
    place, fixed = find_sides(keys, drawn.ends, n)
    curved = (drawn.radius > 0) & fixed
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
