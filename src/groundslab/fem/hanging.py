"""Hanging nodes: middles of sides that are half of a neighbor's side, whose unknowns follow from its three nodes.

Along a side of the larger element a field is the parabola through its ends a, b and its middle m. At the middle of the
half between a and m it is 3/8 a + 3/4 m - 1/8 b. No corner hangs, so that nothing hangs on what hangs itself.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers, Memo
from groundslab.fem.mesh import SIDES, meeting_halves

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: What a hanging node takes from the end that is near to it, from the middle, and from the other end.
WEIGHTS = np.array([3.0, 6.0, -1.0]) / 8


def find_hanging(elements: Integers) -> Integers:
    """Return the hanging nodes of elements (m, 9), (h, 4).

    With each the end of the longer side that is near to it, that side's middle and its other end.
    """
    return _HANGING.get(elements, None, lambda: _find_hanging(elements))


def _find_hanging(elements: Integers) -> Integers:
    """Return the hanging nodes of elements (m, 9), (h, 4), as `find_hanging`."""
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
    found = np.zeros(len(halves), dtype=bool)
    for one, other in (ends.T, ends[:, ::-1].T):
        at = np.minimum(np.searchsorted(keys[order], one * n + other), len(keys) - 1)
        same = keys[order[at]] == one * n + other
        place[same], found = order[at[same]], found | same
    place = place[found]
    return np.column_stack([halves[found, 2], near[place], middle[place], far[place]])


#: Hanging nodes and what moves them, which are asked for again and again.
_HANGING: Memo[Integers] = Memo()
_CARRYING: Memo[csr_array | None] = Memo()


def carry(elements: Integers, values: Array) -> Array:
    """Return nodal values (n,) or (n, k) in which hanging nodes have those of the sides on which they hang."""
    carrying = _carrying(elements, len(values))
    return values if carrying is None else np.asarray(carrying @ values)


def collect(elements: Integers, forces: Array) -> Array:
    """Return nodal forces (n,) or (n, k) in which those of hanging nodes act on the nodes that move these."""
    carrying = _carrying(elements, len(forces))
    return forces if carrying is None else np.asarray(carrying.T @ forces)


def _carrying(elements: Integers, n: int) -> csr_array | None:
    """Return the matrix (n, n) by which nodes move hanging ones, and others themselves; None where none hangs."""
    return _CARRYING.get(elements, None, lambda: _make_carrying(elements, n))


def _make_carrying(elements: Integers, n: int) -> csr_array | None:
    """Return the matrix (n, n) of `_carrying`."""
    hanging = find_hanging(elements)
    if not len(hanging):
        return None
    from scipy.sparse import coo_array, csr_array

    others = np.setdiff1d(np.arange(n), hanging[:, 0])
    rows = np.concatenate([others, np.repeat(hanging[:, 0], 3)])
    columns = np.concatenate([others, hanging[:, 1:].ravel()])
    weights = np.concatenate([np.ones(len(others)), np.tile(WEIGHTS, len(hanging))])
    return csr_array(coo_array((weights, (rows, columns)), shape=(n, n)))


def connect(elements: Integers) -> tuple[Integers, Integers, Array]:
    """Return the nodes (m, 9) whose unknowns move each element, its kind (m,), and by kind what they move it by.

    In the place of a hanging node stands the far end of the side on which it hangs. The matrices (k, 9, 9) take values
    at these nodes to those at the element's own.
    """
    hanging = find_hanging(elements)
    if not len(hanging):
        return elements, np.zeros(len(elements), dtype=np.int64), np.eye(9)[None]
    near, far = (np.full(int(elements.max()) + 1, -1) for _ in range(2))
    node, near_end, _, far_end = hanging.T
    near[node], far[node] = near_end, far_end
    middles = elements[:, SIDES[:, 2]]
    hangs = far[middles] >= 0
    moving = elements.copy()
    moving[:, SIDES[:, 2]] = np.where(hangs, far[middles], middles)
    # which end of its own side is an end of the longer one, too: 1 the first, 2 the second, 0 where nothing hangs
    first = near[middles] == elements[:, SIDES[:, 0]]
    code = np.where(hangs, np.where(first, 1, 2), 0)
    kinds, kind = np.unique(code @ 3 ** np.arange(4), return_inverse=True)
    matrices = np.tile(np.eye(9), (len(kinds), 1, 1))
    for number, packed in enumerate(kinds):
        for side, (start, end, middle) in enumerate(SIDES):
            which = packed // 3**side % 3
            if which:
                ends = (start, end) if which == 1 else (end, start)
                matrices[number, middle, [*ends, middle]] = WEIGHTS
    return moving, kind, matrices
