"""Hanging nodes: middles of sides that are half of a neighbor's side, whose unknowns follow from its three nodes.

Along a side of the larger element a field is the parabola through its ends a, b and its middle m. At the middle of the
half between a and m it is 3/8 a + 3/4 m - 1/8 b. No corner hangs, so that nothing hangs on what hangs itself.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers, made_once, made_once_by
from groundslab.fem.mesh import SIDES, meeting_halves

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: What a hanging node takes from the end that is near to it, from the middle, and from the other end.
WEIGHTS = np.array([3.0, 6.0, -1.0]) / 8


@made_once
def find_hanging(elements: Integers) -> Integers:
    """Return the hanging nodes of elements (m, 9), (h, 4).

    With each the end of the longer side that is near to it, that side's middle and its other end.
    """
    both = meeting_halves(elements)
    if not both.any():
        return np.zeros((0, 4), dtype=np.int64)
    sides, n = elements[:, SIDES].reshape(-1, 3), len(both)
    start, end, middle = sides[both[sides[:, 2]]].T
    # both halves of the longer sides, from their ends to their middles
    near, far, middle = np.concatenate([start, end]), np.concatenate([end, start]), np.tile(middle, 2)
    keys = near * n + middle
    order = np.argsort(keys)
    halves = sides[both[sides[:, :2]].any(axis=1)]
    ends, place = np.sort(halves[:, :2], axis=1), np.zeros(len(halves), dtype=np.int64)
    hanging = np.zeros(len(halves), dtype=bool)
    for corner, other in (ends.T, ends[:, ::-1].T):
        at = np.minimum(np.searchsorted(keys[order], corner * n + other), len(keys) - 1)
        same = keys[order[at]] == corner * n + other
        place[same], hanging = order[at[same]], hanging | same
    place = place[hanging]
    return np.column_stack([halves[hanging, 2], near[place], middle[place], far[place]])


def carry(elements: Integers, values: Array) -> Array:
    """Return nodal values (n,) or (n, k) in which hanging nodes have those of the sides on which they hang."""
    carrying = _carrying(elements, len(values))
    return values if carrying is None else np.asarray(carrying @ values)


def collect(elements: Integers, forces: Array) -> Array:
    """Return nodal forces (n,) or (n, k) in which those of hanging nodes act on the nodes that move these."""
    carrying = _carrying(elements, len(forces))
    return forces if carrying is None else np.asarray(carrying.T @ forces)


@made_once_by(lambda elements, _: (elements,))
def _carrying(elements: Integers, n: int) -> csr_array | None:
    """Return the matrix (n, n) by which nodes move hanging ones, and others themselves; None where none hangs."""
    hanging = find_hanging(elements)
    if not len(hanging):
        return None
    from scipy.sparse import coo_array, csr_array

    stays = np.ones(n, dtype=bool)
    stays[hanging[:, 0]] = False
    others = np.flatnonzero(stays)
    rows = np.concatenate([others, np.repeat(hanging[:, 0], 3)])
    columns = np.concatenate([others, hanging[:, 1:].ravel()])
    weights = np.concatenate([np.ones(len(others)), np.tile(WEIGHTS, len(hanging))])
    return csr_array(coo_array((weights, (rows, columns)), shape=(n, n)))


def find_halves(elements: Integers) -> Integers:
    """Return which sides of elements (m, 9) are half of a neighbor's, (m, 4).

    1 where the longer side begins with the half's first end, -1 where it ends with the second one, 0 elsewhere.
    """
    near = np.full(int(elements.max()) + 1, -1)
    node, near_end, _, _ = find_hanging(elements).T
    near[node] = near_end
    ends = near[elements[:, SIDES[:, 2]]]
    return np.where(ends < 0, 0, np.where(ends == elements[:, SIDES[:, 0]], 1, -1))


def connect(elements: Integers) -> tuple[Integers, Integers, Array, Integers]:
    """Return the nodes (m, 9) whose unknowns move each element, its kind (m,), and by kind what they move it by.

    In the place of a hanging node stands the far end of the side on which it hangs. The matrices (k, 9, 9) take values
    at these nodes to those at the element's own; with them by kind the sides that are halves (k, 4), see `find_halves`.
    """
    hanging = find_hanging(elements)
    if not len(hanging):
        return elements, np.zeros(len(elements), dtype=np.int64), np.eye(9)[None], np.zeros((1, 4), dtype=np.int64)
    far = np.full(int(elements.max()) + 1, -1)
    far[hanging[:, 0]] = hanging[:, 3]
    middles, halves = elements[:, SIDES[:, 2]], find_halves(elements)
    moving = elements.copy()
    moving[:, SIDES[:, 2]] = np.where(halves != 0, far[middles], middles)
    _, first, kind = np.unique((halves + 1) @ 3 ** np.arange(4), return_index=True, return_inverse=True)
    kinds = halves[first]
    matrices = np.tile(np.eye(9), (len(kinds), 1, 1))
    for number, sides in enumerate(kinds):
        for half, (start, end, middle) in zip(sides, SIDES, strict=True):
            if half:
                ends = (start, end) if half > 0 else (end, start)
                matrices[number, middle, [*ends, middle]] = WEIGHTS
    return moving, kind, matrices, kinds
